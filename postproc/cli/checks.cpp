// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/checks.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "reading/checks/number_range.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "reading/parsing.h"
#include "reading/wildcard.h"

namespace rodpack::cli {
namespace {
namespace fs = std::filesystem;

template <class Sound>
CLI::Validator word_check(const std::string& expected, const std::string& shown, Sound sound) {
  return {[expected, sound](std::string& word) {
            return sound(word) ? std::string()
                               : "expected " + expected + ", found '" + shortened(word) + "'";
          },
          shown};
}

CLI::Validator in_range(const NumberRange& range) {
  const std::string low =
      range.above_low ? "above " + number_text(range.low) + " up" : number_text(range.low, 16);
  return word_check(range.text(),
                    (range.whole ? "whole, " : "") + low + " to " + number_text(range.high, 16),
                    [range](const std::string& word) {
                      // Digits alone make a whole number: the conversion takes no 1e3.
                      long whole = 0;
                      double value = 0;
                      if (range.whole && !parse_number(word, whole)) return false;
                      return parse_number(word, value) && range.contains(value);
                    });
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_program(const fs::path& path) {
  return !is_folder(path) && ::access(path.c_str(), X_OK) == 0;
}

bool in_search_path(const std::string& word) {
  if (word.empty() || word.find('/') != std::string::npos) return false;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_program(fs::path(folder) / word)) return true;
  return false;
}

}  // namespace

CLI::Validator number(double low, double high) { return in_range({low, high}); }
CLI::Validator positive_number(double high) { return in_range({0, high, false, true}); }
CLI::Validator whole_number(double low, double high) { return in_range({low, high, true}); }
CLI::Validator length() { return in_range({1e-12, 1e6}); }
CLI::Validator place() { return in_range({-1e6, 1e6}); }

CLI::Validator one_of(const std::vector<std::string>& words) {
  std::string listed;
  for (const auto& word : words) listed += (listed.empty() ? "" : ", ") + word;
  return word_check("one of " + listed, "{" + listed + "}", [words](const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  });
}

void require_window(const std::vector<double>& w) {
  if (w.at(1) > w.at(0) && w.at(3) > w.at(2)) return;
  std::string found;
  for (const double each : w) found += " " + number_text(each);
  throw CLI::ValidationError("--window", "expected XLO < XHI and YLO < YHI, found" + found);
}

CLI::Validator some_name() {
  return word_check("a name", "", [](const std::string& word) { return !word.empty(); });
}

CLI::Validator existing_files() {
  return word_check("a file that exists, or a pattern that some match", "",
                    [](const std::string& word) { return !files_matching(word).empty(); });
}

CLI::Validator stem_of_files() {
  return word_check("the start of names of files in a folder that exists", "",
                    [](const std::string& word) {
                      const fs::path path(word);
                      return shortened(word).substr(0, word.size()) == word.substr(0, 60) &&
                             path.has_filename() && !is_folder(path) &&
                             (!path.has_parent_path() || is_folder(path.parent_path()));
                    });
}

CLI::Validator name_of_folder() {
  return word_check("the name of a folder", "", [](const std::string& word) {
    std::error_code ignored;
    return !word.empty() && (!fs::exists(word, ignored) || is_folder(word));
  });
}

CLI::Validator existing_file() {
  return word_check("a file that exists", "", [](const std::string& word) {
    std::error_code ignored;
    return fs::is_regular_file(word, ignored);
  });
}

CLI::Validator existing_folder() {
  return word_check("a folder that exists", "",
                    [](const std::string& word) { return is_folder(word); });
}

CLI::Validator existing_program() {
  return word_check("a program that exists", "", [](const std::string& word) {
    return is_program(word) || in_search_path(word);
  });
}

void require_other_folder(const std::string& folder, const std::string& earlier) {
  if (fs::equivalent(folder, earlier)) refuse_run_again(folder, earlier);
}

void refuse_run_again(const std::string& folder, const std::string& earlier) {
  throw DataError(folder + ": expected each run once, found that of " + earlier + " again");
}

}  // namespace rodpack::cli
