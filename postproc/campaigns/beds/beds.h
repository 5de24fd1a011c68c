// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_BEDS_BEDS_H
#define RODPACK_CAMPAIGNS_BEDS_BEDS_H

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "campaigns/accuracy/accuracy.h"

namespace rodpack {

/// How a bed is modelled. The defaults are the paper's, with events.
struct BedModel {
  std::string method = "ab3e";  // as accuracy_method() takes it
  double step = paper_step;     // s
  double overlap = 0.5;         // of neighbouring primary spheres, in diameters
  double stiffness = 2000;      // N/m, normal, of one particle; tangential: half of it
  bool planar = true;           // motion in the plane only; builtin: false, it has no such thing
  bool engine = false;          // by run_style verlet/planar
  double mass_scaling = 0;      // S of rodpack/motion/mass_scaling.h; 0: none
  double relaxation_steps = 0;  // dashpots relax in, rodpack/contact/dashpot_relaxation.h; 0: none

  bool operator==(const BedModel& other) const;
};
/// The paper's model of the rods of a scene, by the engine or not; costs are relative to its.
BedModel paper_model(bool engine, const BedScene& scene = {});

/// A bed at the end of its run. Means are over what is in the container.
struct BedRow {
  BedModel model;
  int seed = 0;
  int rods = 0;               // still in the container; 0: the numbers have left all bounds
  double kinetic = 0;         // J
  double elastic = 0;         // J
  double carried_weight = 0;  // vertical force of floor and walls over the weight
  double height = 0;          // mean of the centres, d_p
  double solid_fraction = 0;  // covered area over that of an even bed of this mean height, 2 height
  double order = 0;           // <cos 2 gamma>: S2 about the horizontal; 1: all rods lie flat
  double neighbours = 0;      // other rods that a rod touches
  double contacts = 0;        // contacts of primary spheres per rod, between rods
  double overlap = 0;         // mean of these, d_p
  double mean_force = 0;      // N, of pairs of rods, the sum over their contacts
  double largest_force = 0;   // N
  double step_over_limit = 0;   // fix check/timestep/multisphere at the end
  long steps = 0;               // force evaluations
  double seconds_per_step = 0;  // processor time, s

  /// All `rods` are there, E_k <= 1e-5 E_p (the paper's criterion), and floor and walls carry the
  /// weight to 1 %.
  bool at_rest(int expected_rods) const;
};

/// Models that differ in one respect, coarsest first; the last is what the others are held against.
struct BedComparison {
  std::string name;      // of the figure and the heading
  std::string question;  // what the table answers
  std::vector<BedModel> models;
  bool by_engine() const;  // all of them
};
/// Lists the comparisons surface, planar, engine, stiffness, a `step_METHOD` for each of `methods`,
/// frontier, economy and presets, for the rods of a scene; those of `only`, if it names any.
/// @throws DataError for a name that is none.
std::vector<BedComparison> bed_comparisons(const std::vector<std::string>& methods,
                                           const std::vector<std::string>& only = {},
                                           const BedScene& scene = {});

/// Runs one bed in `folder`/work. @throws DataError when the run fails.
BedRow run_bed(const AccuracySettings& settings, const std::string& folder, const BedModel& model,
               int seed);

/// Does as measure_accuracy, in `folder`/beds.csv: runs every model of the comparisons of
/// settings.bed_methods with every seed, once each.
std::vector<BedRow> measure_beds(const AccuracySettings& settings, const std::string& folder,
                                 std::ostream& progress);

/// Reads the rows of a beds.csv; a missing file is made, with the header alone. @throws DataError
/// naming file and line for malformed ones.
std::vector<BedRow> read_bed_rows(const std::string& file);
/// Writes a line of that file, without line end.
std::string bed_row_text(const BedRow& row);

/// Mean over seeds with its standard error (0 for fewer than two).
struct SeedMean {
  int seeds = 0;
  double value = 0, error = 0;
};
/// Computes it from one value per seed, in their unit.
SeedMean seed_mean(const std::vector<double>& values);
/// Returns a mean difference in its standard errors; 0 if it is 0, infinite if only its error is.
double in_standard_errors(const SeedMean& difference);

/// Returns the mean of `value` over the runs of `model` that have come to rest with all `rods`.
SeedMean resting_mean(const std::vector<BedRow>& rows, const BedModel& model, int rods,
                      const std::function<double(const BedRow&)>& value);

/// Returns the mean difference of `value` between `model` and `reference`, over the seeds with
/// which both have come to rest. In pairs, since a seed's bed is much the same with either: the way
/// the rods start makes two thirds of the scatter of phi.
SeedMean paired_difference(const std::vector<BedRow>& rows, const BedModel& model,
                           const BedModel& reference, int rods,
                           const std::function<double(const BedRow&)>& value);

/// Returns the median processor time per simulated second, s; 0 without rows.
double bed_cost(const std::vector<BedRow>& rows, const BedModel& model);

/// A quantity that is compared.
struct BedQuantity {
  std::string name, unit;
  std::function<double(const BedRow&)> value;
};
/// Lists them: solid fraction, S2, elastic energy (µJ), neighbours.
const std::vector<BedQuantity>& bed_quantities();

/// One model of a comparison, over its seeds.
struct BedSummary {
  BedModel model;
  int runs = 0, at_rest = 0;
  std::vector<SeedMean> means;        // of bed_quantities(), over the runs at rest
  std::vector<SeedMean> differences;  // of the same from the reference, in pairs
  double worst = 0;      // largest of these, in standard errors; 0: fewer than two pairs
  std::string worst_of;  // its quantity
  bool all_at_rest() const { return runs > 0 && at_rest == runs; }
};
/// Returns one entry per model that has rows, in the comparison's order, held against the last of
/// them.
std::vector<BedSummary> summarise_beds(const std::vector<BedRow>& rows,
                                       const BedComparison& comparison, int rods);

/// Returns the largest time step, s, up to which, from the finest on, all runs come to rest with no
/// mean `bound` or more standard errors of the difference away from that of the finest step. None
/// when the finest does not come to rest, or its means have no error.
std::optional<double> largest_step_within(const std::vector<BedSummary>& steps, double bound);

/// Writes the section for accuracy.md: the comparisons, the closed forms of the surface, and the
/// guide.
std::string beds_section(const std::vector<BedRow>& rows, const AccuracySettings& settings);
/// Writes the guide alone, a table: scene, model, integrator, step, expected error, relative cost.
std::string bed_guide(const std::vector<BedRow>& rows, const std::vector<std::string>& methods,
                      int rods);

/// Draws the figures of the settings' comparisons: beds_step, beds_surface, beds_stiffness and
/// beds_frontier, .png and .svg, in `folder`.
void draw_beds(const std::vector<BedRow>& rows, const AccuracySettings& settings,
               const std::string& folder);

}  // namespace rodpack

#endif
