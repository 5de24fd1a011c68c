// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PACKINGS_PICTURE_SHEET_H
#define RODPACK_FIGURES_PACKINGS_PICTURE_SHEET_H

#include <string>
#include <vector>

namespace rodpack {

/// A picture of ours for a sheet: PATH.svg, and what stands above it.
struct SheetPicture {
  std::string stem, title;
};

/// Sets pictures of one size side by side, `columns` in a row: `stem`.svg and `stem`.png, 1280
/// pixels wide. @throws DataError when a picture is not an SVG of ours or a file cannot be written.
void draw_picture_sheet(const std::vector<SheetPicture>& pictures, int columns,
                        const std::string& stem);

}  // namespace rodpack

#endif
