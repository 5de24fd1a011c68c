// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/frame.h"

#include <algorithm>
#include <utility>

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
  for (const char* name : {"decode.js", "view.js", "draw.js", "details.js", "viewer.js", "page.js"})
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
  std::vector<std::pair<std::string, std::vector<std::string>>> texts;  // in order of appearance
  for (const auto& note : notes) {
    auto found = std::find_if(texts.begin(), texts.end(),
                              [&](const auto& text) { return text.first == note.text; });
    if (found == texts.end()) found = texts.insert(texts.end(), {note.text, {}});
    if (!note.about.empty()) found->second.push_back(note.about);
  }
  std::string html = "<ul class=\"notes\">\n";
  for (const auto& [text, about] : texts) {
    html += "<li>" + escaped(text);
    for (std::size_t k = 0; k < about.size(); ++k)
      html += (k == 0 ? " <span class=\"about\">(" : ", ") + escaped(about[k]);
    html += about.empty() ? "</li>\n" : ")</span></li>\n";
  }
  return html + "</ul>\n";
}

}  // namespace rodpack
