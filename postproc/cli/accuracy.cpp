// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/accuracy/accuracy.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

#include "campaigns/beds/beds.h"
#include "campaigns/launch/deck_folder.h"
#include "campaigns/stability/stability.h"
#include "cli/checks.h"
#include "cli/commands.h"
#include "reading/data_error.h"

namespace rodpack::cli {
namespace {

// The fraction is the same everywhere, and not 0: without damping, what the two ends of a contact
// leave in the velocity cancels the more the closer its time is to a whole number of steps.
const std::vector<double> all_steps = {10.37, 14.37,  20.37,  28.37,  40.37,  57.37,
                                       81.37, 114.37, 162.37, 229.37, 324.37, 500.37};
const std::vector<double> quick_steps = {28.37, 57.37, 114.37};
const std::vector<std::string> quick_scenes = {"collision_0.2", "oblique_slip", "rod_drop",
                                               "spin_3d", "rod_rocking"};

struct AccuracyArguments {
  AccuracySettings settings;
  bool quick = false;
  std::string out;
};

void measure_stability_into(const AccuracySettings& settings, const std::string& folder) {
  StabilityOptions options;
  options.liggghts = settings.liggghts;
  const std::filesystem::path deck = find_deck("accuracy/in.stability", settings.inputs);
  options.decks = deck.parent_path().parent_path().string();
  options.folder = folder;
  const auto progress = [](const std::string& what) { std::cout << what << std::endl; };
  write_stability(measure_stability(options, progress), folder);
  write_stability_scenes(measure_stability_scenes(options, progress), folder);
  std::cout << "written: " << folder << "/stability.csv, .png, .svg, stability_scenes.csv\n";
}

/// Returns the section of accuracy.md.
std::string measure_beds_into(const AccuracySettings& settings, const std::string& folder) {
  const auto rows = measure_beds(settings, folder, std::cout);
  draw_beds(rows, settings, folder);
  std::cout << "written: " << folder << "/beds.csv, beds_*.png .svg\n";
  return beds_section(rows, settings);
}

bool wanted(const AccuracySettings& settings, const char* scene) {
  return std::find(settings.scenes.begin(), settings.scenes.end(), scene) != settings.scenes.end();
}

/// @throws CLI::ValidationError for a word that stands twice: its runs would count twice.
template <class Word>
void require_each_once(const char* option, const std::vector<Word>& words) {
  for (auto word = words.begin(); word != words.end(); ++word)
    if (std::find(words.begin(), word, *word) != word) {
      std::ostringstream text;
      text << "expected each once, found '" << *word << "' twice";
      throw CLI::ValidationError(option, text.str());
    }
}

/// Options of a kind of scenes, which are no use without one of these.
void require_scenes_of(const std::vector<CLI::Option*>& options, bool there,
                       const std::string& scenes) {
  for (const auto* option : options)
    if (option->count() > 0 && !there)
      throw CLI::ValidationError(option->get_name(),
                                 "expected with " + scenes + ", found none in the list of scenes");
}

/// What compares surfaces, and the report on all comparisons together, know the paper's rods alone.
void require_paper_rods(const AccuracySettings& settings) {
  const BedScene paper;
  const auto& names = settings.bed_comparisons;
  const bool none = names.empty();
  if (!none && std::find(names.begin(), names.end(), "surface") == names.end()) return;
  for (const auto& [option, given] :
       {std::pair("--aspect-ratio", settings.bed_scene.aspect_ratio != paper.aspect_ratio),
        std::pair("--surface", settings.bed_scene.surface != paper.surface)})
    if (given)
      throw CLI::ValidationError(
          option, std::string("expected with --comparisons other than surface, found ") +
                      (none ? "no --comparisons" : "surface"));
}

/// Checks the settings before anything runs. @throws CLI::ValidationError naming what cannot be
/// run.
void check(const AccuracySettings& settings) {
  require_each_once("--scenes", settings.scenes);
  require_each_once("--methods", settings.methods);
  require_each_once("--steps", settings.steps);
  require_each_once("--comparisons", settings.bed_comparisons);
  require_paper_rods(settings);
  try {
    bed_comparisons(settings.bed_methods, settings.bed_comparisons, settings.bed_scene);
  } catch (const DataError& error) {
    throw CLI::ValidationError(error.what());
  }
}

void measure(const AccuracySettings& settings, const std::string& out) {
  const auto rows = measure_accuracy(settings, out, std::cout);
  std::string beds;
  if (wanted(settings, beds_scene)) beds = measure_beds_into(settings, out);
  report_accuracy(rows, beds, settings, out);
  std::cout << "written: " << out << "/accuracy.csv, accuracy.md, *_evaluations and "
            << "*_seconds .png .svg\n";
  if (wanted(settings, stability_scene)) measure_stability_into(settings, out);
}

std::vector<CLI::Option*> add_bed_options(CLI::App& command, AccuracySettings& settings) {
  auto* seeds = command.add_option("--seeds", settings.seeds, "beds per model")
                    ->check(whole_number(1, 1000))
                    ->capture_default_str()
                    ->type_name("N");
  auto* comparisons =
      command
          .add_option(
              "--comparisons", settings.bed_comparisons,
              "what beds compare: surface,planar,engine,stiffness,step_METHOD,frontier,economy,"
              "presets [default: all]")
          ->delimiter(',')
          ->type_name("LIST");
  auto* lines = command.add_option("--lines", settings.bed_scene.lines, "lines of rods in a bed")
                    ->check(whole_number(1, 10000))
                    ->capture_default_str()
                    ->type_name("N");
  auto* per_line =
      command.add_option("--per-line", settings.bed_scene.per_line, "rods per line of a bed")
          ->check(whole_number(1, 10000))
          ->capture_default_str()
          ->type_name("N");
  auto* aspect_ratio = command
                           .add_option("--aspect-ratio", settings.bed_scene.aspect_ratio,
                                       "of the rods of a bed, with --comparisons")
                           ->check(number(1.5, 100))
                           ->capture_default_str()
                           ->type_name("AR");
  auto* surface = command
                      .add_option("--surface", settings.bed_scene.surface,
                                  "of these rods, with --comparisons other than surface")
                      ->check(one_of(std::vector<std::string>{"smooth", "coarse"}))
                      ->capture_default_str();
  return {seeds, comparisons, lines, per_line, aspect_ratio, surface};
}

void add_places(CLI::App& command, AccuracyArguments& arguments) {
  command.add_option("OUT", arguments.out, "folder of the results")
      ->required()
      ->check(name_of_folder());
  command
      .add_option("--liggghts", arguments.settings.liggghts.program,
                  "program to run [default: liggghts beside this program]")
      ->check(existing_program())
      ->type_name("PROGRAM");
  command
      .add_option("--inputs", arguments.settings.inputs,
                  "the folder inputs/; default: that of the repository")
      ->check(existing_folder())
      ->type_name("FOLDER");
}

/// Joins names with commas, as the options take them.
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

}  // namespace

void add_accuracy(CLI::App& app) {
  auto options = std::make_shared<AccuracyArguments>();
  auto& settings = options->settings;
  settings.scenes.push_back(beds_scene);
  settings.scenes.push_back(stability_scene);
  auto* command = app.add_subcommand(
      "accuracy",
      "Error against cost of the integrators: runs small scenes with a known end at many time "
      "steps. Rows that OUT/accuracy.csv holds already are not run again.");
  command->footer(
      "Example:\n"
      "  rodpack accuracy results/accuracy --methods builtin,ab3\n"
      "writes accuracy.csv, accuracy.md and two figures per scene, .png/.svg; beds (which model a "
      "settled bed needs): beds.csv and four figures.");
  add_places(*command, *options);
  auto* scenes = command
                     ->add_option("--scenes", settings.scenes,
                                  "scenes [default: " + listed(settings.scenes) + "]")
                     ->delimiter(',')
                     ->check(one_of(settings.scenes))
                     ->type_name("LIST");
  auto* methods =
      command
          ->add_option(
              "--methods", settings.methods,
              "builtin: fix multisphere; abN: fix multisphere/ab order N events no; abNe: with "
              "events yes [default: " +
                  listed(accuracy_method_names()) + "; beds: " + listed(settings.bed_methods) + "]")
          ->delimiter(',')
          ->check(one_of(accuracy_method_names()))
          ->type_name("LIST");
  auto* steps = command
                    ->add_option("--steps", settings.steps,
                                 "time steps per contact [default: 12 from 10.37 to 500.37]")
                    ->delimiter(',')
                    ->check(number(3, 1e5))
                    ->type_name("LIST");
  auto* repeats = command
                      ->add_option("--repeats", settings.repeats,
                                   "timed runs per scene and method [default: 5]")
                      ->check(whole_number(1, 1000))
                      ->type_name("N");
  const auto of_beds = add_bed_options(*command, settings);
  command->add_flag("--quick", options->quick,
                    "five scenes, three steps, one timed run: below a minute");

  command->callback([options, scenes, methods, steps, repeats, of_beds] {
    auto& given = options->settings;
    if (options->quick) {
      if (scenes->count() == 0) given.scenes = quick_scenes;
      if (repeats->count() == 0) given.repeats = 1;
      given.timed_steps = 4000;
    }
    if (methods->count() > 0) given.bed_methods = given.methods;
    if (steps->count() == 0) given.steps = options->quick ? quick_steps : all_steps;
    require_scenes_of(of_beds, wanted(given, beds_scene), "the scene beds");
    const bool others = std::any_of(given.scenes.begin(), given.scenes.end(), [](const auto& each) {
      return each != beds_scene && each != stability_scene;
    });
    require_scenes_of({steps, repeats}, others, "a scene other than beds and stability");
    check(given);
    if (given.liggghts.program.empty()) given.liggghts.program = liggghts_beside_this_program();
    measure(given, options->out);
  });
}

}  // namespace rodpack::cli
