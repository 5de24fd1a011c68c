// SPDX-License-Identifier: GPL-2.0-or-later
// What parameters.json, result.json and tables may hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/energies.h"
#include "liggghts_run.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/parameters.h"
#include "reading/run_folder.h"
#include "reading/table.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;

template <class Read>
std::string error_of(const std::string& file, Read read) {
  try {
    read();
  } catch (const DataError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    const auto at = text.find(file);
    EXPECT_NE(at, std::string::npos) << text;
    return text.substr(at + file.size());
  }
  return "no error";
}

std::string json_error(const std::string& text) {
  const auto file = put(fresh_folder() / "a.json", text);
  return error_of(file, [&] { read_json_object(file); });
}

std::string parameter_error(const std::string& key, const std::string& value) {
  const auto file = put(fresh_folder() / "parameters.json", "{\"" + key + "\": " + value + "}");
  return error_of(file, [&] { read_parameters(file).number(key); });
}

TEST(JsonFile, DepthIsLimited) {
  const auto nested = [](std::size_t depth) {
    return "{\"a\": " + std::string(depth, '[') + std::string(depth, ']') + "}";
  };
  EXPECT_EQ(json_error(nested(31)), "no error");
  const std::string expected =
      ": expected JSON at most 32 objects and lists deep, found a deeper one";
  EXPECT_EQ(json_error(nested(33)), expected);
  EXPECT_EQ(json_error("{\"a\":" + std::string(1000000, '[')), expected);
  std::string objects;
  for (int k = 0; k < 100000; ++k) objects += "{\"a\":";
  EXPECT_EQ(json_error(objects), expected);
}

TEST(JsonFile, ErrorsNameFileAndLine) {
  EXPECT_EQ(json_error("{\n\"a\": 1,\n\"b\" 2\n}"),
            ":3: expected a JSON object, found an error in it here");
  EXPECT_EQ(json_error(""), ":1: expected a JSON object, found an error in it here");
  EXPECT_EQ(json_error("[1]"), ": expected a JSON object { \"key\": value, ... }");
  EXPECT_THAT(json_error("{\"a\": 1e999}"), HasSubstr(": expected a JSON object, found "));
  EXPECT_EQ(json_error("{\"seed\": 1, \"b\": {\"seed\": 3}, \"seed\": 2}"),
            ": expected each key once in an object, found 'seed' twice");
  EXPECT_EQ(json_error("{\"a\": [{\"b\": 1}, {\"b\": 2}], \"c\": {\"b\": 3}}"), "no error");
}

TEST(Parameters, EveryNumberHasARange) {
  EXPECT_EQ(parameter_error("aspect_ratio", "5"), "no error");
  for (const std::string key :
       {"aspect_ratio", "particle_diameter_m", "container_width_m", "timestep_s", "density_kg_m3"})
    for (const std::string value : {"-1", "0", "1e308", "\"5\"", "null", "[5]"})
      EXPECT_THAT(parameter_error(key, value), HasSubstr(": key '" + key + "': expected a number"))
          << key << ' ' << value;
  EXPECT_THAT(parameter_error("friction", "-0.1"), HasSubstr("a number of 0 to 1000, found -0.1"));
}

TEST(Parameters, UnitsOtherThanSiAreRefused) {
  const auto file = put(fresh_folder() / "parameters.json", "{\"units\": \"cgs\"}");
  EXPECT_EQ(error_of(file, [&] { read_parameters(file); }),
            ": key 'units': expected \"si\", in whose units all is labelled, found \"cgs\"");
  put(file, "{\"units\": \"si\"}");
  EXPECT_EQ(error_of(file, [&] { read_parameters(file); }), "no error");
}

TEST(Result, TheStepIsAWholeNumber) {
  const auto folder = fresh_folder();
  const auto dump = folder / "dumps" / "bodies.5.dump";
  put(dump, rodpack::test::frame_head(5, 0, 0.3, 2, "id x"));
  const auto file = folder / "result.json";
  for (const std::string step : {"-1", "1e300", "1.5", "\"5\"", "null"}) {
    put(file, "{\"step\": " + step + "}");
    EXPECT_THAT(error_of(file.string(), [&] { dumps_of_run(folder.string(), "bodies"); }),
                HasSubstr(": key 'step': expected a whole number of 0 to 9007199254740992"))
        << step;
  }
}

TEST(TableFile, HoldsTextAndFiniteNumbers) {
  const auto file = (fresh_folder() / "energies.csv").string();
  const auto error = [&](const std::string& rows) {
    put(file,
        "time_s,kinetic_translational_J,kinetic_rotational_J,elastic_normal_J,elastic_tangential_"
        "J\n" +
            rows);
    return error_of(file, [&] { read_energies(file); });
  };
  EXPECT_EQ(error("+1,+2e-3,0,0,0\n"), "no error");
  for (const std::string value : {"nan", "inf", "-inf"})
    EXPECT_EQ(
        error("1,0,0,0,0\n2,0," + value + ",0,0\n"),
        ":3: expected a finite number, found '" + value + "' (column 'kinetic_rotational_J')");
  EXPECT_EQ(error(std::string("1,0,0,\0", 7) + ",0\n"), ":2: expected text, found a NUL character");
  EXPECT_THAT(error(std::string(2000000, '1') + "\n"), HasSubstr(":2: expected a line of at most"));
  put(file, "a,b,a\n1,2,3\n");
  EXPECT_EQ(error_of(file, [&] { read_table(file); }),
            ":1: expected each column once, found 'a' twice");
}

}  // namespace
