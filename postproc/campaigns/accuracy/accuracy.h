// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_ACCURACY_ACCURACY_H
#define RODPACK_CAMPAIGNS_ACCURACY_ACCURACY_H

#include <algorithm>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "campaigns/launch/deck_run.h"
#include "reading/dump.h"

namespace rodpack {

/// A way to move the bodies, as the decks of inputs/accuracy take it.
struct AccuracyMethod {
  std::string name;        // builtin, leapfrog, ab1 ... ab4, with events ab2e ... ab4e
  int order;               // of the formula, for smooth forces
  std::string integrator;  // style and arguments of the fix, without `planar`
};
/// Returns the method of that name. @throws DataError naming those there are.
AccuracyMethod accuracy_method(const std::string& name);
/// Lists the names of all methods.
const std::vector<std::string>& accuracy_method_names();
/// The colour of a method in figures, the same in all of them.
const std::string& accuracy_colour(const std::string& method);

constexpr double paper_step = 1.1e-5;  // s, Lu et al. (2016)

/// A motion with a known end.
struct AccuracyScene {
  std::string name;
  std::string error_is;     // what the error is of and relative to
  std::string reference;    // how the expected end was found
  double agreement = 0;     // of the reference's two ways, in the unit of the error; 0: exact
  std::string deck;         // file name in the folder of decks
  DeckVariables variables;  // the same for all methods and steps
  bool planar = true;
  double contact_time = 0;      // s, what steps_per_contact refers to
  double duration = 0;          // simulated time, s
  bool ends_on_time = false;    // the step has to divide the duration
  double phase_speed = 0;       // m/s: `shift` spreads the first touches over a step at this speed;
                                // 0: the deck's own `shift`
  int copies = 1;               // over which the touches spread
  double gravity = 0;           // m/s^2
  double asymptotic_from = 25;  // steps per contact from which on errors show the order
  std::function<double(const Frame&)> error;  // of the end.dump

  /// Returns the number of time steps of a run with about so many steps per contact.
  long steps(double steps_per_contact) const;
  /// Returns the length of each of these time steps, s.
  double step(double steps_per_contact) const;
  /// Returns every -var of a run of so many steps of `dt`, s.
  DeckVariables variables_for(const AccuracyMethod& method, double dt, long steps) const;
};
/// Name of the scene whose trajectories are chaotic, so that only means can be compared: beds of
/// rods (campaigns/beds/beds.h).
constexpr const char* beds_scene = "beds";
/// Name under which the limits of stability (campaigns/stability/stability.h) are asked for.
constexpr const char* stability_scene = "stability";

/// Returns the scene of that name with its reference, which takes up to a second. @throws DataError
/// naming those there are.
AccuracyScene accuracy_scene(const std::string& name);
/// Lists the names of all scenes with a known end, that is without `beds_scene`.
const std::vector<std::string>& accuracy_scene_names();

struct AccuracyRow {
  std::string scene, method;
  int order = 0;
  double steps_per_contact = 0;
  double error = 0;  // inf: the bodies were lost
  double force_evaluations = 0;
  double seconds = 0;  // of the run's loop
};

constexpr double rod_diameter = 3e-3;  ///< of the rods of a bed, m, as in the deck

/// Where the rods of a bed fall (inputs/accuracy/in.bed), line above line.
struct BedScene {
  int lines = 12, per_line = 5;
  double aspect_ratio = 5;
  std::string surface = "smooth";  // or coarse: primary spheres that do not overlap
  int rods() const { return lines * per_line; }
  double overlap() const { return surface == "coarse" ? 0.0 : 0.5; }          // in diameters
  double length() const { return aspect_ratio * rod_diameter; }               // of a rod, m
  double width() const { return (length() + 1e-3) * per_line; }               // m
  double duration() const { return 0.55 + 0.55 * std::max(lines, 12) / 12; }  // s
};

struct AccuracySettings {
  Liggghts liggghts;
  std::string inputs;  // folder with accuracy/; empty: find_deck looks for it
  std::vector<std::string> scenes = accuracy_scene_names();
  std::vector<std::string> methods = accuracy_method_names();
  std::vector<double> steps;  // per contact
  int repeats = 5;            // of timed runs
  long timed_steps = 20000;
  int seeds = 8;                                                      // of the beds
  std::vector<std::string> bed_methods = {"builtin", "ab3", "ab3e"};  // whose step varies
  std::vector<std::string> bed_comparisons;                           // empty: all
  BedScene bed_scene;
};

/// Runs what is missing in `folder`/accuracy.csv, appends it there row by row, and returns all rows
/// of the scenes and methods asked for. Lines of progress go to `progress`. @throws DataError when
/// the folder holds rows of other settings, or a run fails.
std::vector<AccuracyRow> measure_accuracy(const AccuracySettings& settings,
                                          const std::string& folder, std::ostream& progress);

/// What the rows of one scene and method tell.
struct AccuracySummary {
  std::string scene, method;
  std::optional<double> order;        // observed; none: fewer than three errors in range
  std::optional<double> paper_error;  // at the paper's step, between rows
  std::optional<double> evaluations;  // to reach `target`, between rows
  std::optional<double> seconds;
  bool at_once = false;                               // the coarsest step reaches it already
  double finest_evaluations = 0, finest_seconds = 0;  // of the finest step
};
/// Summarises the rows of one scene and method. `steps_of_paper`: the paper's step in steps per
/// contact; errors below `floor` are rounding.
AccuracySummary summarise(const std::vector<AccuracyRow>& rows, double steps_of_paper,
                          double asymptotic_from = 25, double floor = 1e-9, double target = 1e-3);

/// Returns the observed order: slope of -log error over log steps by least squares, of the errors
/// between `floor` and 0.05 from `asymptotic_from` steps per contact on. None with fewer than
/// three.
std::optional<double> observed_order(const std::vector<double>& steps,
                                     const std::vector<double>& errors, double asymptotic_from = 25,
                                     double floor = 1e-9);

/// Writes accuracy.md, which ends with the section `beds`, and the figures `scene`_evaluations and
/// `scene`_seconds (.png, .svg) in `folder`.
void report_accuracy(const std::vector<AccuracyRow>& rows, const std::string& beds,
                     const AccuracySettings& settings, const std::string& folder);

}  // namespace rodpack

#endif
