// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/frame.h"

#include <algorithm>
#include <regex>

#include "page/html.h"
#include "page/packing_data.h"
#include "page/web_files.h"
#include "reading/data_error.h"
#include "rodpack/version.h"

namespace rodpack {

std::string page_html(const Page& page) {
  std::string contents, body;
  for (const auto& section : page.sections) {
    contents += "<li><a href=\"#" + section.id + "\">" + section.heading + "</a></li>\n";
    body += "<section id=\"" + section.id + "\" aria-labelledby=\"" + section.id +
            "-heading\">\n<h2 id=\"" + section.id + "-heading\">" + section.heading + "</h2>\n" +
            section.content + "</section>\n";
  }
  std::string script;
  for (const char* name :
       {"decode.js", "view.js", "pixels.js", "draw.js", "details.js", "viewer.js", "page.js"})
    script += web_file(name);
  return filled(web_file("page.html"), {{"title", escaped(page.title)},
                                        {"lead", page.lead},
                                        {"contents", contents},
                                        {"sections", body},
                                        {"version", escaped(version())},
                                        {"commit", escaped(commit())},
                                        {"style", std::string(web_file("report.css"))},
                                        {"script", script}});
}

std::string viewer_html(const std::vector<ShownPacking>& packings) {
  std::string options, data;
  std::vector<Note> missing;
  for (std::size_t k = 0; k < packings.size(); ++k) {
    const std::string id = "packing-" + std::to_string(k);
    try {
      data += data_element(id, packing_data(packings[k].run_folder));
      options += "<option value=\"" + id + "\">" + escaped(packings[k].name) + "</option>\n";
    } catch (const DataError& reason) {
      missing.push_back({packings[k].name, reason.what()});
    }
  }
  std::string html = missing.empty() ? "" : "<p>Not shown:</p>\n" + notes_html(missing);
  if (options.empty()) return html;
  return filled(web_file("viewer.html"), {{"options", options}}) + html + data;
}

std::string notes_html(const std::vector<Note>& notes) {
  struct Item {
    std::string pattern, text;
    std::vector<std::string> about;
    bool other_numbers = false;
  };
  const std::regex number("[0-9][0-9.]*");
  std::vector<Item> items;  // in order of appearance
  for (const auto& note : notes) {
    const auto pattern =
        note.about.empty() ? note.text : std::regex_replace(note.text, number, "#");
    auto found = std::find_if(items.begin(), items.end(),
                              [&](const Item& item) { return item.pattern == pattern; });
    if (found == items.end()) found = items.insert(items.end(), {pattern, note.text, {}, false});
    found->other_numbers |= found->text != note.text;
    auto& about = found->about;
    if (!note.about.empty() && std::find(about.begin(), about.end(), note.about) == about.end())
      about.push_back(note.about);
  }
  std::string html = "<ul class=\"notes\">\n";
  for (const auto& item : items) {
    html += "<li>" + escaped(item.text);
    for (std::size_t k = 0; k < item.about.size(); ++k)
      html += (k == 0 ? " <span class=\"about\">(" : ", ") + escaped(item.about[k]);
    if (!item.about.empty()) html += ")</span>";
    html += item.other_numbers ? " <span class=\"about\">and alike with other numbers</span></li>\n"
                               : "</li>\n";
  }
  return html + "</ul>\n";
}

}  // namespace rodpack
