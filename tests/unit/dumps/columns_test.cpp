// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/dumps/columns.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using rodpack::DumpColumn;

namespace {

using Names = std::vector<std::string>;

template <std::size_t number>
Names names_of(const DumpColumn (&columns)[number]) {
  Names names;
  for (const DumpColumn& column : columns) names.push_back(column.name);
  return names;
}

/// The columns that a style's page lists: the words between backquotes in the first field of each
/// line of its table.
Names documented(const std::string& page) {
  std::ifstream in(RODPACK_REPOSITORY "/liggghts-src-ext/doc/" + page);
  if (!in) throw std::runtime_error("no page " + page);
  Names names;
  const std::regex quoted("`([^`]*)`"), word("[^ ]+");
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, 3, "| `") != 0) continue;
    const std::string field = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator part(field.begin(), field.end(), quoted), end; part != end; ++part) {
      const std::string words = (*part)[1];
      for (std::sregex_iterator name(words.begin(), words.end(), word); name != end; ++name)
        names.push_back(name->str());
    }
  }
  return names;
}

}  // namespace

TEST(DumpColumns, PagesListThemInTheOrderOfTheFile) {
  EXPECT_EQ(documented("dump_multisphere_body.md"), names_of(rodpack::body_dump::columns));
  EXPECT_EQ(documented("dump_multisphere_sphere.md"), names_of(rodpack::sphere_dump::columns));
  EXPECT_EQ(documented("dump_contact_gran.md"), names_of(rodpack::contact_dump::columns));
}

TEST(DumpColumns, EachNameOccursOnceInADump) {
  for (const Names& names :
       {names_of(rodpack::body_dump::columns), names_of(rodpack::sphere_dump::columns),
        names_of(rodpack::contact_dump::columns)})
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

// A reader may look up a column's unit by its name, whichever dump it comes from.
TEST(DumpColumns, OneNameHasOneUnitInAllDumps) {
  std::vector<DumpColumn> all;
  for (const DumpColumn& column : rodpack::body_dump::columns) all.push_back(column);
  for (const DumpColumn& column : rodpack::sphere_dump::columns) all.push_back(column);
  for (const DumpColumn& column : rodpack::contact_dump::columns) all.push_back(column);
  for (const DumpColumn& a : all)
    for (const DumpColumn& b : all) {
      if (std::string(a.name) != b.name) continue;
      EXPECT_EQ(std::string(a.unit), b.unit) << a.name;
      EXPECT_EQ(a.is_integer, b.is_integer) << a.name;
    }
}
