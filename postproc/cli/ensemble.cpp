// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/ensemble.h"

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "cli/checks.h"
#include "cli/commands.h"
#include "ensemble/analyse_runs.h"
#include "ensemble/case_mean.h"
#include "ensemble/cases.h"
#include "ensemble/ensemble_field.h"
#include "ensemble/run_analysis.h"
#include "reading/number_text.h"
#include "study/claims/claims.h"
#include "study/study_figures.h"

namespace rodpack::cli {
namespace {
namespace fs = std::filesystem;

struct EnsembleOptions {
  std::vector<std::string> folders;
  std::string out;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool allow_missing = false;
  bool analyse_again = false;
  std::string published;
};

std::string output_folder(const EnsembleOptions& options) {
  const fs::path first(options.folders.front());
  if (options.out.empty())
    return fs::exists(first / "cases.json") ? (first / "ensemble").string() : "ensemble";
  // The folder above it is where names of runs start: without a slash at the end.
  const fs::path out = fs::path(options.out).lexically_normal();
  return (out.has_filename() ? out : out.parent_path()).string();
}

void bring_up_to_date(const FoundCases& found, const EnsembleOptions& options) {
  std::vector<std::string> folders;
  for (const auto& one : found.cases)
    for (const auto& run : one.runs)
      if (options.analyse_again || !why_not_current(run).empty()) folders.push_back(run.folder);
  if (folders.empty()) return;
  // One line that is written over again on a terminal, a line a run in a file.
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  analyse_runs(folders, options.jobs, fs::canonical("/proc/self/exe").string(),
               [&](std::size_t done, std::size_t of, const std::string& folder) {
                 std::cerr << (terminal ? "\r\033[K" : "") << done << " of " << of
                           << " runs analysed: " << folder << (terminal && done < of ? "" : "\n")
                           << std::flush;
               });
}

std::string text(const EnsembleMean& mean) {
  return number_text(mean.mean, 5) + (mean.sem ? " +- " + number_text(*mean.sem, 2) : "");
}

void report(const Ensemble& ensemble) {
  for (const auto& one : ensemble.cases) {
    std::cout << one.name << ": " << one.runs.size() << (one.runs.size() == 1 ? " run" : " runs");
    for (const auto* name : {"solid_fraction", "nematic_order_S2_pooled"}) {
      const auto found = one.numbers.find(name);
      if (found != one.numbers.end()) std::cout << ", " << name << ' ' << text(found->second);
    }
    std::cout << '\n';
  }
  for (const auto& note : ensemble.notes) std::cout << "note: " << note << '\n';
}

void make_ensemble(const EnsembleOptions& options) {
  const std::string out = output_folder(options);
  const auto found =
      find_cases(options.folders, fs::absolute(out).lexically_normal().parent_path().string(),
                 options.allow_missing);
  bring_up_to_date(found, options);
  Ensemble ensemble;
  ensemble.notes = found.notes;
  for (const auto& one : found.cases) ensemble.cases.push_back(mean_over_case(one));
  write_ensemble(ensemble, out);
  for (const auto& one : found.cases)
    if (const auto field = mean_field(one))
      write_ensemble_field(*field, (fs::path(out) / (one.name + "_fields.csv")).string());
  report(ensemble);
  const auto figures =
      draw_study_figures(ensemble, fs::path(out).parent_path().string(), out, options.published);
  write_figure_list(figures, out);
  write_claims(test_claims(ensemble), out);
  for (const auto& figure : figures)
    if (!figure.not_drawn.empty())
      std::cout << "not drawn: " << figure.paper << ": " << figure.not_drawn << '\n';
  std::cout << "written: " << out
            << "/ensemble.json, a table for each case and measure, table2, claims, figures\n";
}

}  // namespace

void add_ensemble(CLI::App& app) {
  auto options = std::make_shared<EnsembleOptions>();
  auto* command = app.add_subcommand(
      "ensemble",
      "Means over repetitions, with standard errors, of every number and curve that `rodpack "
      "analyse` gives, case by case. Runs are sorted by their parameters, or as a study's "
      "cases.json says; those without a current analysis are analysed first.");
  command->footer(
      "Example:\n"
      "  rodpack ensemble results/study\n"
      "writes results/study/ensemble/ensemble.json and CSV tables beside it, such as "
      "smooth-AR5_rdf.csv.\n"
      "  rodpack ensemble results/a results/b -o results/both\n"
      "takes run folders, or folders that hold some.");
  command
      ->add_option("folders", options->folders,
                   "a study's folder, or run folders, or folders with run folders below them")
      ->required()
      ->check(some_name())
      ->type_name("FOLDER");
  command
      ->add_option("-o,--output", options->out,
                   "folder for the results [default: STUDY/ensemble, else ensemble]")
      ->check(name_of_folder())
      ->type_name("FOLDER");
  command->add_option("-j,--jobs", options->jobs, "runs that are analysed at the same time")
      ->check(whole_number(1, 1024))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--allow-missing", options->allow_missing,
                    "leave out runs that are missing or have not finished, with a note");
  command
      ->add_option("--published", options->published,
                   "values to compare with [default: published.csv of the study's folder, else of "
                   "inputs/study/]")
      ->check(existing_file())
      ->type_name("FILE");
  command->add_flag("--again", options->analyse_again, "analyse all runs again");
  command->callback([options] { make_ensemble(*options); });
}

}  // namespace rodpack::cli
