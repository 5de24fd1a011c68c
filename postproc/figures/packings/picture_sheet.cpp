// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/packings/picture_sheet.h"

#include <algorithm>
#include <regex>

#include "figures/drawing.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

struct Picture {
  double width = 0, height = 0;
  std::string elements;  // between <svg ...> and </svg>
};

// Names that elements refer to each other by are made different for every picture of the sheet.
std::string with_own_names(std::string text, std::size_t place) {
  const std::string mark = "_" + std::to_string(place);
  text = std::regex_replace(text, std::regex("id=\"(window|scale)\""), "id=\"$1" + mark + "\"");
  return std::regex_replace(text, std::regex("url\\(#(window|scale)\\)"), "url(#$1" + mark + ")");
}

Picture read_picture(const std::string& stem, std::size_t place) {
  const std::string text = read_text(stem + ".svg");
  static const std::regex size("<svg [^>]*width=\"([0-9.]+)\" height=\"([0-9.]+)\"[^>]*>");
  std::smatch found;
  const auto head = text.substr(0, 1000);
  const auto end = text.rfind("</svg>");
  if (!std::regex_search(head, found, size) || end == std::string::npos)
    throw DataError(stem + ".svg: not a picture of rodpack");
  const auto begin = static_cast<std::size_t>(found.position(0) + found.length(0));
  return {std::stod(found[1]), std::stod(found[2]),
          with_own_names(text.substr(begin, end - begin), place)};
}

}  // namespace

void draw_picture_sheet(const std::vector<SheetPicture>& pictures, int columns,
                        const std::string& stem) {
  std::vector<Picture> parts;
  double width = 0, height = 0;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    parts.push_back(read_picture(pictures[k].stem, k));
    width = std::max(width, parts.back().width);
    height = std::max(height, parts.back().height);
  }
  const double title = width / 26, gap = width / 40;
  const auto rows = (static_cast<int>(parts.size()) + columns - 1) / columns;
  const double whole_width = columns * width + (columns - 1) * gap;
  const double whole_height = rows * (height + 1.6 * title) + (rows - 1) * gap;
  Drawing sheet;
  sheet.raw("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1280\" height=\"" +
            Drawing::at(std::ceil(1280 * whole_height / whole_width)) + "\" viewBox=\"0 0 " +
            Drawing::at(whole_width) + " " + Drawing::at(whole_height) +
            "\" font-family=\"DejaVu Sans, sans-serif\" fill=\"#202020\">");
  sheet.rectangle(0, 0, whole_width, whole_height, "fill=\"#ffffff\"");
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double x = static_cast<int>(k) % columns * (width + gap);
    const double y = static_cast<int>(k) / columns * (height + 1.6 * title + gap);
    sheet.label(x + 0.3 * title, y + 1.15 * title, title, "start", pictures[k].title);
    sheet.raw("<svg x=\"" + Drawing::at(x) + "\" y=\"" + Drawing::at(y + 1.6 * title) +
              "\" width=\"" + Drawing::at(parts[k].width) + "\" height=\"" +
              Drawing::at(parts[k].height) + "\">" + parts[k].elements + "</svg>");
  }
  sheet.raw("</svg>");
  write_text(stem + ".svg", sheet.text());
  rasterise(stem + ".svg", stem + ".png");
}

}  // namespace rodpack
