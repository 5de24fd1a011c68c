// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/figures_section.h"

#include <algorithm>
#include <regex>
#include <set>

#include "figures/packings/base64.h"
#include "page/html.h"
#include "reading/data_error.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

/// Stems of all pictures, numbers in them in the order of their values: fig2 before fig10.
std::vector<std::string> stems_in(const fs::path& folder) {
  std::set<std::string> stems;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    const auto extension = entry.path().extension();
    if (extension == ".png" || extension == ".svg") stems.insert(entry.path().stem().string());
  }
  const auto key = [](const std::string& stem) {
    std::string padded, digits;
    for (const char c : stem + '\0') {
      if (c >= '0' && c <= '9') {
        digits += c;
        continue;
      }
      if (!digits.empty())
        padded += std::string(digits.size() < 8 ? 8 - digits.size() : 0, '0') + digits;
      digits.clear();
      padded += c;
    }
    return padded;
  };
  std::vector<std::string> sorted(stems.begin(), stems.end());
  std::sort(sorted.begin(), sorted.end(),
            [&](const std::string& a, const std::string& b) { return key(a) < key(b); });
  return sorted;
}

// "data:..." of the smaller one of the two files.
std::string picture(const fs::path& folder, const std::string& stem) {
  const fs::path svg = folder / (stem + ".svg"), png = folder / (stem + ".png");
  std::error_code none;
  const bool take_svg =
      fs::exists(svg) && (!fs::exists(png) || fs::file_size(svg, none) < fs::file_size(png, none));
  const auto content = read_text((take_svg ? svg : png).string());
  if (content.empty())
    throw DataError((take_svg ? svg : png).string() + ": empty, or it cannot be read");
  return std::string("data:image/") + (take_svg ? "svg+xml" : "png") + ";base64," + base64(content);
}

std::string without_tags(const std::string& html) {
  return std::regex_replace(html, std::regex("<[^>]*>"), "");
}

std::string figure_html(const fs::path& folder, const FigureText& text, int number) {
  return "<figure" + std::string(text.wide ? " class=\"across\"" : "") + " id=\"figure-" +
         escaped(text.stem) + "\"><img alt=\"" + without_tags(text.title) + "\" src=\"" +
         picture(folder, text.stem) + "\">\n<figcaption><b>Figure " + std::to_string(number) +
         ".</b> " + text.title + ". " + text.caption + "</figcaption></figure>\n";
}

}  // namespace

std::string figures_html(const fs::path& folder, const std::vector<FigureText>& texts, int& number,
                         bool wide) {
  auto stems = stems_in(folder);
  std::string html;
  for (const auto& text : texts) {
    const auto found = std::find(stems.begin(), stems.end(), text.stem);
    if (found == stems.end()) continue;
    html += figure_html(folder, text, ++number);
    stems.erase(found);
  }
  for (const auto& stem : stems) {
    std::string words = stem;
    std::replace(words.begin(), words.end(), '_', ' ');
    html += figure_html(folder, {stem, escaped(words), "", wide}, ++number);
  }
  return html.empty() ? html : "<div class=\"figures\">\n" + html + "</div>\n";
}

}  // namespace rodpack
