// SPDX-License-Identifier: GPL-2.0-or-later
#include "parameter.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "comm.h"
#include "input.h"
#include "json_text.h"
#include "rodpack/version.h"
#include "run_files.h"
#include "run_parameters.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "variable.h"

using namespace LAMMPS_NS;

std::vector<Parameter::Declaration> Parameter::declared_;

namespace {

/// Command-line words of this process; empty where the system does not tell (no /proc).
std::vector<std::string> command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

/// Folder of the deck that the command line names, with a slash at its end, or empty for the one
/// that the program was started in; no value where the command line names none.
bool folder_of_deck(std::string& folder) {
  const std::vector<std::string> words = command_line();
  for (std::size_t k = 1; k + 1 < words.size(); ++k) {
    if (words[k] != "-in" && words[k] != "-i") continue;
    const std::size_t slash = words[k + 1].rfind('/');
    folder = slash == std::string::npos ? "" : words[k + 1].substr(0, slash + 1);
    return true;
  }
  return false;
}

/// Version and commit of this rodpack, as a JSON object.
std::string json_of_rodpack() {
  return "{\"version\": " + json_string(rodpack::version()) +
         ", \"commit\": " + json_string(rodpack::commit()) + "}";
}

}  // namespace

void Parameter::command(int narg, char** arg) {
  const std::vector<std::string> words(arg, arg + narg);
  if (narg == 1 && words[0] == "check")
    check_command_line();
  else if (narg == 2 && words[0] == "write")
    write(words[1]);
  else if (narg >= 2 && words[0] == "compare" && (narg == 2 || words[2] == "except"))
    compare(words[1], {words.begin() + std::min(narg, 3), words.end()});
  else if (narg == 1 && words[0] == "clear")
    clear();
  else if (narg == 1 && words[0] == "version")
    set_variable("rodpack", "string", json_of_rodpack());
  else if (narg == 1 && words[0] == "folder")
    set_folder();
  else if (narg == 2 && words[0] == "include")
    include(words[1]);
  else
    declare(narg, arg);
}

/// The folder of the deck, for names of files beside it.
void Parameter::set_folder() const {
  std::string folder;
  if (!folder_of_deck(folder))
    stop_run(lmp, "parameter folder: expected the deck on the command line, as -in FILE");
  if (folder.empty()) folder = "./";
  if (!is_plain_path(folder))
    stop_run(lmp, "parameter folder: the deck is in '" + folder + "', expected " + a_plain_path);
  set_variable("deck_folder", "string", folder);
}

/// Reads a file beside the deck, wherever the program was started: 'include' looks from there.
void Parameter::include(const std::string& file) const {
  std::string name;
  if (!folder_of_deck(name))
    stop_run(lmp,
             "parameter include " + file + ": expected the deck on the command line, as -in FILE");
  name += file;
  const bool missing = comm->me == 0 && !std::ifstream(name);
  stop_run_by_rank_0(lmp,
                     missing ? "parameter include " + file + ": cannot read '" + name + "'" : "");
  // Quotes keep the blanks of a path together.
  input->one(("include \"" + name + "\"").c_str());
}

void Parameter::declare(int narg, char** arg) {
  StyleArguments command(lmp, "parameter", narg, arg, 0);
  const char* const a_name = "letters, digits and _";
  Declaration it{command.word("NAME", a_name), "", "", ""};
  if (!std::all_of(it.name.begin(), it.name.end(),
                   [](unsigned char c) { return std::isalnum(c) || c == '_'; }))
    command.reject("NAME", a_name, it.name);
  StyleArguments arguments(lmp, "parameter '" + it.name + "'", narg, arg, 1);
  it.type = arguments.peek();
  arguments.choice("TYPE", {"real", "integer", "choice", "text"});
  if (!arguments.more()) arguments.word("DEFAULT", "a value");
  it.value = take_value(it.name, arguments.peek());
  if (it.type == "real" && it.value == "auto") it.value = automatic_value(it, arguments);
  if (it.type == "choice") {
    declare_choice(it, arguments);
  } else if (it.type == "text") {
    const std::string fallback = arguments.word("DEFAULT", "a text");
    set_variable(it.name + "_given", "string", it.value == fallback ? "0" : "1");
    if (arguments.more() && arguments.new_keyword() != "path")
      arguments.reject_keyword(arg[3], "path");
    arguments.require_end();
    if (arguments.given("path") && !is_plain_path(it.value))
      arguments.fail(std::string("expected ") + a_plain_path + ", got '" + it.value + "'");
  } else {
    declare_number(it, arguments);
  }
  declared_.erase(std::remove_if(declared_.begin(), declared_.end(),
                                 [&](const Declaration& d) { return d.name == it.name; }),
                  declared_.end());
  declared_.push_back(it);
  std::string text;
  for (const auto& d : declared_) text += json_entry(d) + "\n";
  run_parameters() = text;
}

/// The value of the variable that the deck names behind `auto`, which the parameter takes then.
std::string Parameter::automatic_value(const Declaration& it,
                                       const StyleArguments& arguments) const {
  int at = 1;
  while (at < arguments.left() && arguments.peek(at) != "auto") ++at;
  if (at >= arguments.left()) return it.value;  // which is no number, as declare_number() will say
  std::string variable = arguments.peek(at + 1);
  char* const value = variable.empty() || input->variable->find(&variable[0]) < 0
                          ? nullptr
                          : input->variable->retrieve(&variable[0]);
  if (!value)
    arguments.fail("value 'auto' is that of the variable '" + variable +
                   "', which is not set here: expected a number");
  const std::string number = value;
  double ignored = 0;
  // A deck that has no value to offer says there why.
  if (!read_number(number, ignored)) arguments.fail("value 'auto' " + number);
  std::string words[] = {it.name, "delete"};
  char* remove[] = {&words[0][0], &words[1][0]};
  input->variable->set(2, remove);  // the word on the command line would stay otherwise
  set_variable(it.name, "string", number);
  return number;
}

void Parameter::clear() {
  declared_.clear();
  run_parameters().clear();
}

void Parameter::declare_choice(const Declaration& it, StyleArguments& arguments) {
  std::string list;
  std::set<std::string> choices;
  while (arguments.more()) {
    const std::string choice = arguments.word("choice", "a word");
    choices.insert(choice);
    list += " " + choice;
  }
  if (!choices.count(it.value)) arguments.fail("value '" + it.value + "' is none of:" + list);
  // The input language compares numbers only, so a deck tests ${NAME_is_CHOICE} == 1.
  for (const auto& choice : choices)
    set_variable(it.name + "_is_" + choice, "string", choice == it.value ? "1" : "0");
}

void Parameter::declare_number(Declaration& it, StyleArguments& arguments) {
  double number = 0;
  long long whole = 0;
  const bool integer = it.type == "integer";
  const std::string expected = integer ? "an integer" : "a number";
  // The default, which the value of the command line may have replaced.
  if (integer)
    arguments.step("DEFAULT", expected);
  else
    arguments.number("DEFAULT", expected);
  if (!(integer ? read_integer(it.value, whole) : read_number(it.value, number)))
    arguments.fail("expected " + expected + ", got '" + it.value + "'");
  if (integer) number = static_cast<double>(whole);
  std::string broken;  // the first bound that the value does not keep
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword(), text = arguments.peek();
    if (keyword == "auto") {
      arguments.word(keyword, "the name of a variable");
      continue;
    }
    if (keyword == "unit") {
      it.unit = arguments.word(keyword, "the name of a unit");
      continue;
    }
    if (keyword != "minimum" && keyword != "above" && keyword != "maximum" && keyword != "below")
      arguments.reject_keyword(keyword, "unit, auto, minimum, above, maximum or below");
    const double bound = arguments.number(keyword, "a number");
    const bool kept = keyword == "minimum"   ? number >= bound
                      : keyword == "above"   ? number > bound
                      : keyword == "maximum" ? number <= bound
                                             : number < bound;
    if (!kept && broken.empty()) broken = keyword + " " + text;
  }
  if (!broken.empty()) arguments.fail("expected " + broken + ", got " + it.value);
}

void Parameter::check_command_line() const {
  const std::vector<std::string> words = command_line();
  std::map<std::string, std::string> given;
  for (std::size_t k = 0; k + 2 < words.size(); ++k) {
    if (words[k] != "-var" && words[k] != "-v") continue;
    const std::string &name = words[k + 1], &value = words[k + 2];
    if (std::none_of(declared_.begin(), declared_.end(),
                     [&](const Declaration& d) { return d.name == name; })) {
      std::string list;
      for (const auto& d : declared_) list += " " + d.name;
      stop_run(lmp, "unknown deck parameter '" + name +
                        "' on the command line; this deck takes:" + list);
    }
    // LIGGGHTS takes the first of several, as it does of several values.
    if (!given.emplace(name, value).second)
      stop_run(lmp, "deck parameter '" + name + "' is given twice on the command line, as '" +
                        given[name] + "' and '" + value + "'");
    k += 2;
    if (k + 1 < words.size() && words[k + 1].compare(0, 1, "-") != 0)
      stop_run(lmp, "deck parameter '" + name + "': '" + words[k + 1] + "' follows its value '" +
                        value + "' on the command line, expected one value");
  }
}

std::string Parameter::json_entry(const Declaration& d) {
  const bool number = d.type == "real" || d.type == "integer";
  const std::string value =
      number ? json_number(std::strtod(d.value.c_str(), nullptr)) : json_string(d.value);
  return json_string(d.unit.empty() ? d.name : d.name + "_" + d.unit) + ": " + value;
}

void Parameter::write(const std::string& file) const {
  std::string fault;
  if (comm->me == 0 && std::ifstream(file)) {
    fault = "'" + file +
            "' exists already: a run is never overwritten, choose another folder or resume it";
  } else if (comm->me == 0) {
    std::string text = "{\n  \"format\": \"rodpack-run 1\"";
    text += ",\n  \"rodpack\": " + json_of_rodpack();
    for (const auto& d : declared_) text += ",\n  " + json_entry(d);
    fault = write_whole(file, text + "\n}\n");
  }
  if (!fault.empty()) fault = "parameter write " + file + ": " + fault;
  stop_run_by_rank_0(lmp, fault);
}

void Parameter::compare(const std::string& file, const std::set<std::string>& except) const {
  for (const auto& name : except)
    if (std::none_of(declared_.begin(), declared_.end(),
                     [&](const Declaration& d) { return d.name == name; }))
      stop_run(lmp, "parameter compare: '" + name + "' after 'except' is no parameter");
  std::string difference;
  if (comm->me == 0) {
    const bool of_restart = file == "restart";
    std::ifstream from_file(of_restart ? "" : file);
    std::istringstream from_restart(parameters_of_restart());
    std::istream& in = of_restart ? static_cast<std::istream&>(from_restart) : from_file;
    if (of_restart ? parameters_of_restart().empty() : !in)
      difference = of_restart ? "the restart file does not tell the parameters of its run"
                              : "cannot read '" + file +
                                    "': expected the parameters of the run to go on with";
    std::vector<std::string> lines;  // as write() made them: one entry a line
    for (std::string line; std::getline(in, line);) {
      line.erase(0, line.find_first_not_of(' '));
      if (!line.empty() && line.back() == ',') line.pop_back();
      lines.push_back(line);
    }
    for (const auto& d : declared_) {
      if (!difference.empty()) break;
      const std::string entry = json_entry(d);
      if (except.count(d.name) || std::count(lines.begin(), lines.end(), entry)) continue;
      const std::string key = entry.substr(0, entry.find(": ") + 2);
      const auto before = std::find_if(lines.begin(), lines.end(), [&](const std::string& line) {
        return line.compare(0, key.size(), key) == 0;
      });
      difference = "parameter '" + d.name + "': expected as in " +
                   (of_restart ? "the restart file" : "'" + file + "'") + ", " +
                   (before == lines.end() ? "where it is missing" : before->substr(key.size())) +
                   ", got " + d.value;
    }
  }
  stop_run_by_rank_0(lmp, difference);
}

std::string Parameter::take_value(const std::string& name, const std::string& fallback) const {
  // An "index" leaves a variable alone that the command line has set already.
  set_variable(name, "index", fallback);
  return input->variable->retrieve(const_cast<char*>(name.c_str()));
}

void Parameter::set_variable(const std::string& name, const std::string& style,
                             const std::string& value) const {
  std::string words[] = {name, style, value};
  char* arg[] = {&words[0][0], &words[1][0], &words[2][0]};
  input->variable->set(3, arg);
}
