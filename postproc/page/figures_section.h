// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_FIGURES_SECTION_H
#define RODPACK_PAGE_FIGURES_SECTION_H

#include <filesystem>
#include <string>
#include <vector>

namespace rodpack {

/// What is said below a figure.
struct FigureText {
  std::string stem;     // of the files, without .png or .svg
  std::string title;    // HTML, begins the caption and describes the picture to who cannot see it
  std::string caption;  // HTML
  bool wide = false;    // takes the width of the page
};

/// Puts all figures of `folder` into HTML, the files themselves in base64, each as .svg or .png,
/// whichever is smaller: first those of `texts`, in their order, then the others by name.
/// `number`: of the last figure before; counted on. `wide`: the others take the width of the page.
/// @throws DataError when a file cannot be read.
std::string figures_html(const std::filesystem::path& folder, const std::vector<FigureText>& texts,
                         int& number, bool wide = false);

}  // namespace rodpack

#endif
