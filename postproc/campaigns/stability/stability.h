// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_STABILITY_STABILITY_H
#define RODPACK_CAMPAIGNS_STABILITY_STABILITY_H

#include <functional>
#include <string>
#include <vector>

#include "campaigns/launch/deck_run.h"

namespace rodpack {

/// Largest omega dt at which a sphere on the floor, omega = sqrt(k/m), does not shake itself up.
struct StabilityLimit {
  int order;              // of Adams-Bashforth; 0: velocity Verlet of the built-in multisphere
  double damping_ratio;   // of the contact
  double limit_measured;  // by runs of LIGGGHTS; 0: grows even at the smallest step tried, 0.05
  double limit_theory;    // stability_limit(), 0: at any step
};

/// The limit of a scene against that of one of its contacts alone.
struct SceneLimit {
  std::string scene;
  int order;
  double damping_ratio;
  double limit_measured;        // time step, s, by runs of LIGGGHTS
  double limit_check;           // what fix check/timestep/multisphere finds for the scene, s
  double limit_single_contact;  // stability_limit() for one contact, s
  double factor() const { return limit_single_contact / limit_measured; }
};

struct StabilityOptions {
  Liggghts liggghts;
  std::string decks;   // the folder inputs/
  std::string folder;  // for the tables, the figure and the runs
  std::vector<int> orders = {0, 1, 2, 3, 4};
  std::vector<double> damping_ratios = {0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 0.9};
  double tolerance = 2e-3;  // relative width at which a bisection ends
};

/// Says what is being done; called before each bisection.
using Progress = std::function<void(const std::string&)>;

/// Measures the limit by bisection for each order and damping ratio, with `accuracy/in.stability`:
/// a step is beyond the limit when the sphere's excursion grows from the middle of 20000 steps to
/// the end. Rows that `folder`/stability.csv holds already are taken from there; each new one is
/// added at once, so an interrupted measurement goes on where it stopped.
/// @throws DataError when a run fails or the table is malformed.
std::vector<StabilityLimit> measure_stability(const StabilityOptions& options,
                                              const Progress& progress = {});

/// The same for scenes of more than one contact, orders 3 and 0, damping ratio 0.2, with
/// `folder`/stability_scenes.csv:
/// - `sphere`: a sphere on the floor;
/// - `rod_flat`: a smooth rod of AR 5 that lies on the floor with 9 spheres. The single contact is
///   that of the rod and the floor;
/// - `bed_ar5`, `bed_ar7`: 60 smooth rods at rest, made by `deposition/in.deposition`, which go on
///   with another step in `accuracy/in.stability_bed`. The single contact is that of two rods, of
///   half the mass.
std::vector<SceneLimit> measure_stability_scenes(const StabilityOptions& options,
                                                 const Progress& progress = {});

/// Writes `folder`/stability.csv and the figure stability.png, stability.svg: measured points on
/// the curves of theory. @throws DataError when a file cannot be written.
void write_stability(const std::vector<StabilityLimit>& rows, const std::string& folder);

/// Draws that figure into `stem`.png and `stem`.svg.
void plot_stability(const std::vector<StabilityLimit>& rows, const std::string& stem);

/// Writes `folder`/stability_scenes.csv.
void write_stability_scenes(const std::vector<SceneLimit>& rows, const std::string& folder);

/// Largest value between `low` and `high` at which `grows` is false, to a relative width of
/// `tolerance`; 0 if it grows at `low` already, infinity if it does not at `high`.
double bisect_growth(const std::function<bool(double)>& grows, double low, double high,
                     double tolerance);

}  // namespace rodpack

#endif
