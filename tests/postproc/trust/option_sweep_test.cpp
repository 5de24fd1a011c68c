// SPDX-License-Identifier: GPL-2.0-or-later
// Wrong values of every option of every subcommand. What there is to sweep comes from the program's
// own --help, where each option shows what it takes, so that a new one is swept by itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "liggghts_run.h"
#include "refusals.h"
#include "cli/command_line.h"
#include "programs/run_program.h"
#include "../synthetic_packing.h"

namespace {
using rodpack::test::fresh_folder;
using rodpack::test::put;
namespace fs = std::filesystem;

constexpr const char* subcommands[] = {"analyse",  "report",   "orientation", "rdf",
                                       "forces",   "render",   "stress",      "solid-fraction",
                                       "profile",  "export",   "ensemble",    "compare",
                                       "accuracy", "timestep", "discharge",   "incline"};

struct Answer {
  int exit_code;
  std::string text;
};

// The words arrive as they are: no shell.
Answer started(std::vector<std::string> words, const fs::path& folder) {
  words.insert(words.begin(), RODPACK_BIN "/rodpack");
  const auto output = folder / "said.txt";
  const int exit_code = rodpack::run_program(words, {"", folder.string(), output.string(), {}});
  std::ifstream in(output);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  fs::remove(output);
  return {exit_code, text};
}

// What std::cout and std::cerr are given in its life, in place of what they were for.
class Said {
 public:
  Said() : out_(std::cout.rdbuf(text_.rdbuf())), error_(std::cerr.rdbuf(text_.rdbuf())) {}
  ~Said() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(error_);
  }
  Said(const Said&) = delete;
  Said& operator=(const Said&) = delete;
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf *out_, *error_;
};

// The same without a start of the program, of which there would be more than two thousand.
Answer rodpack(const std::vector<std::string>& words, const fs::path& folder) {
  fs::current_path(folder);
  std::vector<const char*> given{"rodpack"};
  for (const auto& word : words) given.push_back(word.c_str());
  const Said said;
  const int exit_code =
      rodpack::cli::run_command_line(static_cast<int>(given.size()), given.data());
  return {exit_code, said.text()};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// An option as the help shows it: "-o,--output STEM [rdf]      start of the names ...".
struct Option {
  std::string name;      // "--output"
  std::string takes;     // "STEM [rdf]"; empty: a flag
  bool several = false;  // takes more than one word
};

std::vector<Option> options_of(const std::string& subcommand, const fs::path& folder) {
  const auto help = rodpack({subcommand, "--help"}, folder);
  EXPECT_EQ(help.exit_code, 0);
  std::vector<Option> options;
  const std::regex line("  (-[^ ]+)(?: ([^ ].*?))?(?:  .*)?");
  std::smatch found;
  for (const auto& each : lines_of(help.text)) {
    if (!std::regex_match(each, found, line)) continue;
    const std::string names = found[1];
    const auto first = names.find("--");
    if (first == std::string::npos) continue;
    Option option{names.substr(first, names.find(',', first) - first), found[2]};
    option.several = std::regex_search(option.takes, std::regex(" x [0-9]|\\.\\.\\.|LIST"));
    if (option.name != "--help") options.push_back(option);
  }
  return options;
}

// Values that the option must not take, by what the help says it takes.
std::vector<std::string> wrong_values(const Option& option) {
  static const std::regex range(":(whole, )?(above )?(\\S+) (?:up )?to (\\S+)");
  std::smatch found;
  if (std::regex_search(option.takes, found, range)) {
    std::vector<std::string> values{"",       "abc",   "nan", "-nan", "inf", "-inf",  "1e400",
                                    "-1e400", "0x1p3", "5e",  "--5",  "5 m", "1e308", "-1e308"};
    if (option.takes.find("LIST") == std::string::npos) values.push_back("5,6");
    const double low = std::stod(found[3]), high = std::stod(found[4]);
    std::ostringstream below, above;
    below << std::setprecision(17) << (found[2].matched ? low : low - 0.1 * std::max(1.0, low));
    above << std::setprecision(17) << high * 1.01;
    values.push_back(below.str());
    values.push_back(above.str());
    if (found[1].matched)
      for (const std::string value : {"5.5", "5.0", "1e1", "9e18", "9000000000000000000"})
        values.push_back(value);
    return values;
  }
  const std::regex choices(":\\{([^,}]*)[^}]*\\}");
  if (std::regex_search(option.takes, found, choices)) {
    const std::string first = found[1];
    std::string upper = first;
    for (char& each : upper) each = static_cast<char>(std::toupper(each));
    std::vector<std::string> values{"", "nonsense", "0", first + "x", first + " "};
    if (upper != first) values.push_back(upper);
    return values;
  }
  const std::string kind = option.takes.substr(0, option.takes.find_first_of(" :=["));
  if (kind == "STEM") return {"", ".", "no/such/folder/x", "folder/", "folder", "a\nb"};
  if (kind == "FOLDER") return {"", "file"};
  if (kind == "FILE" || kind == "PROGRAM") return {"", "nowhere", "no/where"};
  if (kind == "AXIS")
    return {"",      "nonsense", "0.1",   "x",       "x=",    "=0.1",
            "w=0.1", "x=abc",    "x=nan", "x=1e400", "x=0.1,"};
  if (kind == "LIST") return {"", "nonsense", "surface,nonsense"};
  ADD_FAILURE() << option.name << " takes '" << option.takes
                << "': expected a range, a choice, or STEM, FOLDER, FILE, PROGRAM, AXIS or LIST";
  return {};
}

std::string for_message(std::string value) {
  for (char& each : value)
    if (each == '\n') each = '?';
  return value;
}

using rodpack::test::Refusals;

// The refusal is all that the program says, and begins with its name.
void judge(const Answer& answer, const std::vector<std::string>& has, const std::string& what,
           Refusals& refusals) {
  auto lines = lines_of(answer.text);
  if (answer.text.rfind("rodpack: ", 0) != 0) lines.clear();
  refusals.judge(answer.exit_code, lines, has, what, answer.text);
}

// Its relative names stand in a folder of its own.
class OptionSweep : public testing::TestWithParam<const char*> {
 protected:
  void TearDown() override { fs::current_path(before_); }

 private:
  const fs::path before_ = fs::current_path();
};

TEST_P(OptionSweep, EveryWrongValueIsRefusedWithALineThatNamesOptionValueAndExpectation) {
  const auto folder = fresh_folder();
  const std::string subcommand = GetParam();
  put(folder / "file", "no dump\n");
  fs::create_directory(folder / "folder");
  // What the subcommand is about; wrong options have to show before any of it is read.
  const bool dumps =
      rodpack({subcommand, "--help"}, folder).text.find("dumps FILE") != std::string::npos;
  const std::string object = dumps ? "file" : "folder";
  Refusals count;
  const auto options = options_of(subcommand, folder);
  for (const auto& option : options) {
    if (option.takes.empty()) {
      judge(rodpack({subcommand, option.name + "=maybe", object}, folder), {option.name, "maybe"},
            option.name + "=maybe", count);
      continue;
    }
    judge(rodpack({subcommand, object, option.name}, folder), {option.name},
          option.name + " without a value", count);
    for (const auto& value : wrong_values(option)) {
      std::vector<std::string> words{subcommand, object, option.name + "=" + value};
      if (value.empty()) words = {subcommand, object, option.name, value};  // "--bin=" has none
      const auto number = std::regex_replace(option.takes, std::regex(".* x ([0-9])"), "$1");
      if (number != option.takes)
        for (int k = 1; k < std::stoi(number); ++k) words.emplace_back("1");
      const bool list = option.takes.find("LIST") != std::string::npos;
      const auto last = value.substr(value.rfind(',') + 1);
      std::vector<std::string> has{option.name, "expected"};
      has.push_back(value.empty() ? option.name : "'" + for_message(list ? last : value) + "'");
      judge(rodpack(words, folder), has, option.name + "='" + value + "'", count);
    }
    if (!option.several)
      judge(rodpack({subcommand, object, option.name + "=1", option.name + "=2"}, folder),
            {option.name}, option.name + " twice", count);
  }
  const std::vector<std::string> nonsense{subcommand, object, "--nonsense"};
  judge(rodpack(nonsense, folder), {"--nonsense"}, "--nonsense", count);
  judge(started(nonsense, folder), {"--nonsense"}, "--nonsense of the program", count);
  judge(rodpack({subcommand, ""}, folder), {"expected"}, "an empty name", count);
  judge(rodpack({subcommand}, folder), {}, "no name", count);
  if (dumps) judge(rodpack({subcommand, "nowhere"}, folder), {"nowhere"}, "nowhere", count);
  std::cout << subcommand << ": " << options.size() << " options; " << count << '\n';
  EXPECT_GT(count.clear, 2);
  // Nothing was written beside what was there.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
  EXPECT_TRUE(fs::is_empty(folder / "folder"));
}

INSTANTIATE_TEST_SUITE_P(Of, OptionSweep, testing::ValuesIn(subcommands), [](const auto& each) {
  std::string name = each.param;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
});

TEST(OptionSweep, EverySubcommandIsSwept) {
  const auto help = started({"--help"}, fresh_folder());
  std::vector<std::string> found;
  const std::regex line("  ([a-z-]+)  .*|  ([a-z-]+)");
  bool at = false;
  std::smatch match;
  for (const auto& each : lines_of(help.text)) {
    if (at && std::regex_match(each, match, line))
      found.push_back(match[1].matched ? match[1] : match[2]);
    at = each == "Subcommands:" || (at && !each.empty());
  }
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(subcommands));
}

}  // namespace
