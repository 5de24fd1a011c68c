// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CLI_CHECKS_H
#define RODPACK_CLI_CHECKS_H

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rodpack::cli {

// Checks of the words of the command line. Every option with a value has one, which the help shows;
// the library's own take "nan" for a number of any range. What they refuse reads "--bin: expected a
// number of 0.001 to 10, found 'abc'".

/// A number of `low` to `high`, both finite.
CLI::Validator number(double low, double high);
/// A number above 0 and at most `high`.
CLI::Validator positive_number(double high);
/// A whole number of `low` to `high`.
CLI::Validator whole_number(double low, double high);
/// A length, a place, a force, m or N: limits far beyond every packing of grains.
CLI::Validator length();
CLI::Validator place();
/// For --window. @throws CLI::ValidationError unless XLO < XHI and YLO < YHI.
void require_window(const std::vector<double>& corners);
/// One of the words, in just these letters.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Any word that is not empty, for what is looked at later: the name of a file, a pattern, of a
/// folder.
CLI::Validator some_name();
/// The same where there are such files.
CLI::Validator existing_files();
/// The start of names of files in a folder that exists, such as results/rdf.
CLI::Validator stem_of_files();
/// The name of a folder that is there or can be made.
CLI::Validator name_of_folder();
/// A file, a folder that is there; a program that is, or is found in PATH.
CLI::Validator existing_file();
CLI::Validator existing_folder();
CLI::Validator existing_program();

// Several runs count once each. Both throw a DataError that names both folders.

/// Refuses a folder that is `earlier`, by whatever name.
void require_other_folder(const std::string& folder, const std::string& earlier);
/// Refuses a run that is the one in `earlier`.
[[noreturn]] void refuse_run_again(const std::string& folder, const std::string& earlier);

}  // namespace rodpack::cli

#endif
