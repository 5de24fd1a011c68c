// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_TABLES_H
#define RODPACK_PAGE_TABLES_H

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "reading/number_text.h"

namespace rodpack {

/// A table of HTML cells, the first of each row its heading.
struct HtmlTable {
  std::string caption;                         // HTML; none if empty
  std::vector<std::string> header;             // HTML, one per column
  std::vector<bool> numeric;                   // per column: set flush right
  std::vector<std::vector<std::string>> rows;  // HTML
};
/// A name in a cell, which is not broken into lines where it is one word.
std::string name_html(const std::string& name);

/// Writes it; one wider than the page is scrolled by itself.
std::string table_html(const HtmlTable& table);

/// Writes a table of keys and values, such as a parameters.json, in words and with units. Numbers
/// whose key says "standard_error" are put beside the value they belong to; null is "not measured";
/// objects and arrays are left to the caller.
std::string values_table(const nlohmann::ordered_json& values, const std::string& caption);

/// Writes a CSV file as a table, its headers in words. A column "sem", "combined_error" or
/// NAME_error behind a column (NAME) holds its standard errors and is put into it. `left_out`:
/// columns not to show.
/// @throws DataError when the file cannot be read.
std::string csv_table(const std::string& file, const std::string& caption,
                      const std::set<std::string>& left_out = {});

/// The unit in which values of about this size are read best: lengths, forces and energies of
/// grains get a prefix, other units stay.
ScaledUnit readable_unit(double value, const std::string& unit);

}  // namespace rodpack

#endif
