// SPDX-License-Identifier: GPL-2.0-or-later
// Wrong values of every argument of every style and command that has a table of arguments on its
// page, liggghts-src-ext/doc/. What an argument takes comes from the table, so that a new one is
// swept by itself; a new page needs a deck here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "deck.h"
#include "liggghts_run.h"
#include "refusals.h"
#include "programs/run_program.h"

namespace {

using rodpack::test::Deck;
using rodpack::test::fresh_folder;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path pages = fs::path(RODPACK_REPOSITORY) / "liggghts-src-ext/doc";

// A deck in which the command is right. Every argument that is not in the command is added to it.
struct Scene {
  std::string page, before, command, after;

  // Its page and, where that has several of them, the form of the command.
  std::string name() const {
    const auto verb = page.size() + 1;
    const auto length = command.find(' ', verb) - verb;
    return page == "run_folder" ? page + "_" + command.substr(verb, length) : page;
  }
};

void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name(); }

std::string sphere() {
  return Deck().with(
      "create_atoms 1 single 0.05 0.05 0 units box\nset group all diameter 0.003 density 2500\n");
}

const char* const no_relaxation = "fix tau all property/global dashpotRelaxation scalar 0\n";

std::vector<Scene> scenes() {
  const std::string verlet = "fix move all nve/sphere\n";
  const std::string shape = "type 1 aspect_ratio 5 diameter 0.003 surface smooth density 2500";
  const std::string template_of_rods =
      "fix rods all particletemplate/multisphere/spherocylinder 1 " + shape + " planar yes\n";
  const std::string lines =
      "insert/line 1 template rods 1 per_line 4 x 0.01 0.09 y 0.05 total 8 interval 1";
  const std::string rods = Deck().with(template_of_rods);
  const std::string motion = "fix motion all multisphere/ab planar yes\n";
  const std::string models = "gran model spring_dashpot tangential spring_dashpot";
  const std::string law = sphere();
  const auto at = law.find("pair_style");
  const auto next = law.find('\n', at) + 1;
  return {
      {"compute_contact_overlap", sphere() + verlet, "compute c all contact/overlap 1e-4",
       "variable n equal c_c\nthermo_style custom step v_n\nrun 1"},
      {"compute_stress_goldhirsch", sphere() + verlet, "compute c all stress/goldhirsch scale 5e-3",
       "fix mean all ave/time 1 1 1 c_c[1] mode vector file mean\nrun 1"},
      {"fix_check_timestep_multisphere", sphere() + verlet,
       "fix c all check/timestep/multisphere 10", "run 1"},
      {"fix_enforce2d_multisphere", sphere() + verlet, "fix c all enforce2d/multisphere", "run 1"},
      {"fix_halt", sphere() + verlet + "variable one equal 1\n", "fix c all halt 10 v_one < 0",
       "run 1"},
      {"fix_insert_line", rods + motion, "fix c all " + lines, "run 2"},
      {"fix_move_multisphere", rods + motion + "fix in all " + lines + "\nrun 1\n",
       "fix c all move/multisphere velocity 1e-3 0 0 amplitude 1e-6 0 0 period 1", "run 2"},
      {"fix_multisphere_ab", rods, "fix c all multisphere/ab", "fix in all " + lines + "\nrun 2"},
      {"fix_nve_sphere_ab", sphere(), "fix c all nve/sphere/ab", "run 2"},
      {"fix_particletemplate_multisphere_spherocylinder", Deck().with(""),
       "fix rods all particletemplate/multisphere/spherocylinder 1 " + shape,
       motion + "fix in all " + lines + "\nrun 2"},
      {"fix_wall_gran_solid", sphere() + verlet,
       "fix c all wall/gran/solid " + models.substr(5) + " primitive type 1 yplane 0.01 bound lo",
       "run 1"},
      {"gran_model_spring_dashpot", law.substr(0, at) + no_relaxation,
       "pair_style " + models + " multistepOrder 3", law.substr(next) + verlet + "run 1"},
      {"parameter", "print begun\n", "parameter size real 5", "print ended"},
      {"run_folder", "", "run_folder open run dumps", ""},
      {"run_folder", "run_folder open run\n", "run_folder resume run in.deck", ""},
      {"run_folder", "", "run_folder write result.json {}", ""},
      {"stable_timestep", "",
       "stable_timestep step order 2 mass_scaling 3 stiffness 1000 damping_ratio 0.2 aspect_ratio "
       "5 "
       "diameter 3e-3 density 2500",
       ""},
      {"run_style_verlet_planar",
       rods + motion + "fix plane all enforce2d/multisphere\nfix in all " + lines + "\n",
       "run_style verlet/planar", "run 20"},
  };
}

Words words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

Words operator+(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Words part(const Words& words, std::size_t begin, std::size_t end) {
  const auto at = [&](std::size_t k) {
    return words.begin() + static_cast<std::ptrdiff_t>(std::min(k, words.size()));
  };
  return {at(begin), at(end)};
}

// A row of the table.
struct Argument {
  std::string name, takes, meaning;

  // Named by a place of the command rather than by a keyword: N, v_NAME.
  bool positional() const { return std::isupper(name[0]) || name.rfind("v_", 0) == 0; }
  bool once() const {
    return meaning.find("may repeat") == std::string::npos && meaning.rfind("behind ", 0) != 0;
  }
  bool required() const { return meaning.rfind("required:", 0) == 0; }
};

struct Page {
  Words syntax;     // the command as the page shows it, in the form that is swept
  Words elsewhere;  // words of its other forms
  std::vector<Argument> arguments;

  bool is_of_another_form(const Argument& argument) const {
    const auto stands_in = [&](const Words& words) {
      return std::find(words.begin(), words.end(), argument.name) != words.end();
    };
    return argument.positional() && !stands_in(syntax) && stands_in(elsewhere);
  }
  // Whether there may be any number of the last argument.
  bool has_open_end() const {
    return syntax.size() > 1 && syntax.back() == "..." &&
           std::isupper(syntax[syntax.size() - 2][0]);
  }
};

// Whether the page shows this form of the command: "run_folder open FOLDER", not "run_folder
// write".
bool shows(const Words& line, const Words& command) {
  return line.size() > 1 && line[0] == command[0] &&
         (line[1] == command[1] || std::isupper(line[1][0]));
}

// Where the page shows several forms of the command, that of `command` is taken.
Page read_page(const fs::path& file, const Words& command = {}) {
  Page page;
  std::ifstream in(file);
  const std::regex row("\\| `(.+?)` \\| (.+) \\| (.+) \\|");
  std::smatch found;
  bool table = false, fence = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "```")
      fence = !fence;
    else if (fence && !table) {
      const Words form = words_of(std::regex_replace(line, std::regex("[\\[\\]]"), ""));
      if (page.syntax.empty() && !command.empty() && shows(form, command))
        page.syntax = form;
      else
        page.elsewhere = page.elsewhere + form;
    }
    if (line == "| argument | takes | default or meaning |") table = true;
    if (table && line.empty()) return page;
    if (table && std::regex_match(line, found, row))
      page.arguments.push_back({found[1], found[2], found[3]});
  }
  return page;
}

std::string digits(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

// What an argument takes: so many words, of which the last is put wrong.
struct Values {
  std::size_t count = 1;
  std::string valid = "1";
  Words wrong;
  std::string expected;  // part of the message on a wrong one
  bool ordered = false;  // a pair, the lower one first
};

// The numbers outside an interval, and the interval as the page and the message write it.
void leave_interval(const std::string& takes, Values& values) {
  std::smatch found;
  if (!std::regex_search(takes, found, std::regex("([\\[(])([^ ,]+), ([^ \\])]+)([\\])])"))) return;
  values.expected = found[0];
  const double low = std::stod(found[2]), high = std::stod(found[3]);
  const bool with_low = found[1] == "[", with_high = found[4] == "]";
  if (takes.find("whole") != std::string::npos) {
    values.valid = std::to_string(std::llround(low));
    values.wrong.push_back(std::to_string(std::llround(low) - 1));
    values.wrong.push_back(std::to_string(std::llround(high) + 1));
    return;
  }
  values.valid = digits(with_low ? low : std::min(1.0, 0.5 * (low + high)));
  values.wrong.push_back(digits(with_low ? low - 0.01 * std::max(1.0, std::abs(low)) : low));
  values.wrong.push_back(digits(with_high ? high + 0.01 * std::max(1.0, high) : high));
  values.wrong.emplace_back("1e308");
}

Values values_of(const std::string& takes) {
  Values values;
  if (takes[0] == '`') {
    std::smatch first;
    std::regex_search(takes, first, std::regex("`([^`]+)`"));
    values.valid = values.expected = first[1];
    values.wrong = {"MAYBE", values.valid + "x", "0"};
    return values;
  }
  std::smatch found;
  const std::regex kinds("((?:v_)?[A-Z]+(?: [<≤]* ?[A-Z]+)*)(.*)");
  if (!std::regex_match(takes, found, kinds)) {
    ADD_FAILURE() << "'" << takes << "': expected choices or names of values and what they are";
    return values;
  }
  const Words names = words_of(std::regex_replace(found[1].str(), std::regex("<|≤"), ""));
  const std::string what = found[2];
  values.count = names.size();
  values.ordered =
      names.size() == 2 && found[1].str().size() > names[0].size() + names[1].size() + 1;
  if (what.empty()) return values;  // any word
  if (what[0] == ',') {
    values.valid.clear();  // not known
    values.wrong = {"no*such"};
    if (what.find("path") != std::string::npos)
      for (const char* wrong : {"-such", "no;such", "no|such"}) values.wrong.emplace_back(wrong);
    if (what.find("can be read") != std::string::npos) values.wrong.emplace_back("nosuch");
    if (takes.rfind("v_", 0) == 0) values.wrong.emplace_back("v_nosuch");
    return values;
  }
  values.wrong = {"abc", "1abc", "nan", "0x1p3"};
  if (what.rfind(" whole", 0) == 0)
    for (const char* wrong : {"0x10", "1.5", "5.0", "9e18", "99999999999999999999"})
      values.wrong.emplace_back(wrong);
  else
    for (const char* wrong : {"inf", "1e400"}) values.wrong.emplace_back(wrong);
  if (what.rfind(" in the box", 0) == 0)
    for (const char* wrong : {"1e308", "-1e308", "1000000"}) values.wrong.emplace_back(wrong);
  leave_interval(what, values);
  return values;
}

// The words of a command around the value of an argument.
struct Parts {
  Words before, own, after;
  Words keyword;
  bool present = true;  // in the command
};

Parts parts_of(const Words& command, const Page& page, const Argument& argument,
               const Values& values) {
  const Words valid(values.count, values.valid);
  Parts parts;
  std::size_t place = command.size();
  if (argument.positional()) {
    const auto own = std::find(page.syntax.begin(), page.syntax.end(), argument.name);
    if (own == page.syntax.end())
      throw std::runtime_error(argument.name + " stands in the table, expected in the command too");
    // From the word before that stands in the command as it does on the page.
    auto fixed = own;
    while (std::find(command.begin(), command.end(), *fixed) == command.end()) --fixed;
    const auto anchor = std::find(command.begin(), command.end(), *fixed) - command.begin();
    place = static_cast<std::size_t>(anchor + (own - fixed));
  } else {
    parts.keyword = words_of(argument.name);
    const auto found =
        std::search(command.begin(), command.end(), parts.keyword.begin(), parts.keyword.end());
    parts.present = found != command.end();
    if (!parts.present) {
      // "surface overlap" takes the place of the "surface smooth" of the command.
      const auto other = std::find(command.begin(), command.end(), parts.keyword[0]);
      const auto at = static_cast<std::size_t>(other - command.begin());
      parts.before = part(command, 0, at) + part(command, at + 2, command.size()) + parts.keyword;
      parts.own = valid;
      return parts;
    }
    place = static_cast<std::size_t>(found - command.begin()) + parts.keyword.size();
  }
  parts.before = part(command, 0, place);
  parts.own = part(command, place, place + values.count);
  parts.after = part(command, place + values.count, command.size());
  return parts;
}

// A command that is wrong, and what its refusal has to say.
struct Wrong {
  Words command;
  Words says;
};

std::vector<Wrong> wrong_commands(const Words& command, const Page& page,
                                  const Argument& argument) {
  const std::string& name = argument.name;
  const Values values = values_of(argument.takes);
  const Parts parts = parts_of(command, page, argument, values);
  const Words without = part(parts.before, 0, parts.before.size() - parts.keyword.size());
  std::vector<Wrong> all;
  if (argument.positional()) {
    if (argument.once()) all.push_back({parts.before, {name, "expected"}});
  } else {
    all.push_back({without + parts.after + parts.keyword, {name, "missing, expected"}});
  }
  if (!argument.positional() && argument.once() && !parts.own.front().empty())
    all.push_back({parts.before + parts.own + parts.after + parts.keyword + parts.own,
                   {parts.keyword[0], "given twice, expected once"}});
  if (argument.required() && parts.present)
    all.push_back({without + parts.after, {name, "missing, expected"}});
  if (values.ordered)
    all.push_back({parts.before + Words{"2", "1"} + parts.after, {name, "'2 1'", "expected"}});
  for (const std::string& value : values.wrong)
    all.push_back({parts.before + part(parts.own, 0, values.count - 1) + Words{value} + parts.after,
                   {name, "'" + value + "'", "expected", values.expected}});
  return all;
}

// The name of the command or style in messages.
std::string speaker(const Words& command) {
  const std::string id = command.size() > 1 ? command[1] : "";
  if (command[0] == "fix" || command[0] == "compute")
    return (command[0] == "fix" ? "Fix " : "Compute ") + command[3] + " (id " + id + "): ";
  return command[0] == "pair_style"        ? "tangential spring_dashpot: "
         : command[0] == "parameter"       ? "parameter"
         : command[0] == "stable_timestep" ? "stable_timestep: "
                                           : command[0] + " " + id + ": ";
}

struct Answer {
  int exit_code;
  std::string text;
};

Answer run(const Scene& scene, const std::string& command) {
  static const fs::path folder = fresh_folder();
  std::ofstream(folder / "in.deck") << scene.before + command + "\n" + scene.after + "\n";
  const auto said = folder / "said";
  const int exit_code = rodpack::run_program(
      {RODPACK_BIN "/liggghts", "-in", "in.deck", "-log", "none"},
      {"",
       folder.string(),
       said.string(),
       {{"OMPI_MCA_orte_tmpdir_base", folder.string()}, {"OMPI_MCA_ess_singleton_isolated", "1"}}});
  return {exit_code, rodpack::test::text_of(said)};
}

Words errors_of(const std::string& text) {
  Words errors;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.rfind("ERROR", 0) == 0) errors.push_back(line);
  return errors;
}

std::string joined(const Words& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

using rodpack::test::Refusals;

// The lines that begin with ERROR are the refusal.
void judge(const Answer& answer, const Words& says, const std::string& what, Refusals& refusals) {
  const Words errors = errors_of(answer.text);
  refusals.judge(answer.exit_code, errors, says, what,
                 errors.empty() ? answer.text : joined(errors));
}

class KeywordSweep : public testing::TestWithParam<Scene> {
 protected:
  // A value that asks for all memory is to end in a refusal, not in the end of other programs.
  static void SetUpTestSuite() {
    const rlimit memory = {rlim_t(4) << 30, rlim_t(4) << 30};
    ASSERT_EQ(setrlimit(RLIMIT_AS, &memory), 0);
  }
  void TearDown() override { std::cout << GetParam().name() << ": " << count << '\n'; }

  Refusals count;
};

TEST_P(KeywordSweep, EveryWrongValueIsRefusedWithALineThatNamesArgumentValueAndExpectation) {
  const Scene& scene = GetParam();
  const Words command = words_of(scene.command);
  const Page page = read_page(pages / (scene.page + ".md"), command);
  const Answer right = run(scene, scene.command);
  ASSERT_EQ(right.exit_code, 0) << right.text;
  const std::string who = speaker(command);
  for (const Argument& argument : page.arguments) {
    if (scene.before.find("property/global " + argument.name + " ") != std::string::npos) continue;
    if (page.is_of_another_form(argument)) continue;
    for (const Wrong& wrong : wrong_commands(command, page, argument))
      judge(run(scene, joined(wrong.command)), wrong.says + Words{who}, joined(wrong.command),
            count);
  }
  // LIGGGHTS itself reads what its models and walls leave over.
  const bool stock = scene.command.find("model") != std::string::npos;
  const Words says = {who == "tangential spring_dashpot: " ? "" : who, "'nonsense'",
                      stock ? "Unknown argument" : "expected"};
  if (!page.has_open_end()) {
    judge(run(scene, scene.command + " nonsense"), says, "a word too many", count);
    judge(run(scene, scene.command + " nonsense 1"), says, "an unknown keyword", count);
  }
  EXPECT_GT(count.clear, 2);
}

INSTANTIATE_TEST_SUITE_P(Of, KeywordSweep, testing::ValuesIn(scenes()),
                         [](const auto& each) { return each.param.name(); });

// The numbers of the contact law come through LIGGGHTS's property/global; our models see the
// number, not the word, and LIGGGHTS itself refuses what is no finite one.
TEST(KeywordSweepOfTheContactLaw, EveryWrongPropertyIsRefused) {
  const Page page = read_page(pages / "gran_model_spring_dashpot.md");
  const std::string right = sphere() + no_relaxation + "fix move all nve/sphere\n";
  Refusals count;
  for (const Argument& argument : page.arguments) {
    const std::regex line("(fix \\S+ all property/global " + argument.name +
                          " (?:peratomtypepair 1|scalar) )\\S+\n");
    if (!std::regex_search(right, line)) continue;
    if (argument.required())
      judge(run({"", std::regex_replace(right, line, ""), "", ""}, "run 1"), {argument.name},
            "no " + argument.name, count);
    Values values;
    leave_interval(argument.takes, values);
    const auto judge_value = [&](const std::string& value, const std::vector<std::string>& says) {
      const Scene scene{"", std::regex_replace(right, line, "$01" + value + "\n"), "", ""};
      judge(run(scene, "run 1"), says, argument.name + " " + value, count);
    };
    for (const auto& value : values.wrong)
      judge_value(value,
                  {"property/global " + argument.name + " is '" + digits(std::stod(value)) + "'",
                   values.expected});
    judge_value("1e400", {"property/global " + argument.name, "a finite number, got '1e400'"});
  }
  EXPECT_EQ(count.clear, 29);  // six properties, one of which may be left out
}

TEST(KeywordSweepOfPages, EveryPageWithATableIsSwept) {
  Words with_table;
  std::set<std::string> swept;
  for (const auto& file : fs::directory_iterator(pages))
    if (file.path().extension() == ".md" && !read_page(file.path()).arguments.empty())
      with_table.push_back(file.path().stem());
  for (const Scene& scene : scenes()) swept.insert(scene.page);
  EXPECT_THAT(with_table, testing::UnorderedElementsAreArray(swept));
}

}  // namespace
