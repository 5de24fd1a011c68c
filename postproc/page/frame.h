// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_FRAME_H
#define RODPACK_PAGE_FRAME_H

#include <string>
#include <vector>

namespace rodpack {

/// A part of a page, with its heading; listed at the top of the page.
struct PageSection {
  std::string id;
  std::string heading;  // HTML
  std::string content;  // HTML
};

/// What a page consists of, all in HTML. Its style and scripts come from page/web/.
struct Page {
  std::string title;  // plain text
  std::string lead;   // the paragraph below the title
  std::vector<PageSection> sections;
};

/// Writes the page as one HTML document that needs no other file and no network.
std::string page_html(const Page& page);

/// A packing that the viewer of a page can show.
struct ShownPacking {
  std::string name;        // plain text
  std::string run_folder;  // whose last frame it is
};
/// The viewer for these packings, with their data. One that cannot be shown is left out, and a line
/// says which and why.
std::string viewer_html(const std::vector<ShownPacking>& packings);

/// A list of notes; those about runs or cases that are equal, numbers aside, stand once, with the
/// names they belong to.
struct Note {
  std::string about;  // a run or case, plain text; may be empty
  std::string text;   // plain text
};
std::string notes_html(const std::vector<Note>& notes);

}  // namespace rodpack

#endif
