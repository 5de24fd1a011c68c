// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_COMPARISON_COMPARISON_H
#define RODPACK_CAMPAIGNS_COMPARISON_COMPARISON_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/contact_forces.h"
#include "analysis/orientation.h"
#include "rodpack/geometry/mass_properties.h"

namespace rodpack {

/// Largest magnitudes over all bodies and frames of what a planar motion does not have.
struct Leak {
  double z = 0;                     // of a centre, from where it started, m
  double vz = 0;                    // m/s
  double omega_x = 0, omega_y = 0;  // rad/s
  double tilt = 0;                  // of a body's x axis out of the plane, against its start, rad
  double omega_z = 0;               // rad/s: in the plane, for the scale
};

/// The bodies of one run, frame by frame.
struct BodyHistory {
  std::vector<double> body;                // ids, in the order of the first frame
  std::vector<double> time;                // s, one per frame
  std::vector<std::vector<double>> x, y;   // centres of mass, m, [frame][body]
  std::vector<std::vector<double>> angle;  // of the x axis of the body, rad, [frame][body]
  std::vector<double> potential;           // sum of m g y, J, one per frame
  Leak leak;
};

/// Reads the bodies' dumps `files` (columns `id x y z angle vx vy vz omegax omegay omegaz qw qx qy
/// qz mass`), in order; `timestep` in s, `gravity` along -y in m/s^2.
/// @throws DataError when a frame does not hold the bodies of the first one, in the same order.
BodyHistory read_body_history(const std::vector<std::string>& files, double timestep,
                              double gravity);

/// How far the bodies of two runs are from each other.
struct Separation {
  std::vector<double> time;           // s, one per frame
  std::vector<double> largest;        // distance between the centres of one body, m
  std::vector<double> rms;            // root of the mean square over the bodies, m
  std::optional<std::size_t> parted;  // first frame whose largest distance exceeds the limit
  std::optional<double> parting_time() const;  // time of that frame, s
};
/// Measures it frame by frame. `limit` in m. @throws DataError when the histories are of other
/// bodies or other times.
Separation separate(const BodyHistory& a, const BodyHistory& b, double limit);

/// Energies and contacts of one run, one per frame.
struct RunSeries {
  std::vector<double> kinetic_translational, kinetic_rotational;  // J
  std::vector<double> elastic_normal, elastic_tangential;         // J
  std::vector<double> sphere_contacts;
};

/// The bed of the last frame.
struct FinalBed {
  double height = 0;                           // of the surface, m
  double mean_height = 0;                      // of the centres above the floor, m
  double covered_below_surface = 0;            // solid fraction phi: covered over bed area
  std::optional<double> slice_solid_fraction;  // coarse-grained; none in a bed lower than 3 omega
  std::optional<NematicOrder> orientation;     // none when all particles are close to a wall
  std::optional<Coordination> coordination;    // none without contacts
};

/// One run of the deck comparison/in.comparison, read from the folder where it ran.
struct MethodRun {
  std::string name;
  BodyHistory bodies;
  RunSeries series;
  FinalBed bed;
  double mass = 0;                  // of every body, kg
  std::array<double, 3> inertia{};  // principal moments of every body, kg m^2, as LIGGGHTS has them
};
/// Reads the run of the method `name`. @throws DataError when a file is missing, does not fit the
/// others or is of unequal bodies.
MethodRun read_method_run(const std::string& name, const std::string& folder);

/// Computes mass (kg) and moments (kg m^2) of the deck's rod in closed form, for its
/// parameters.json.
MassProperties exact_mass_properties(const RunParameters& parameters);

/// Wall-clock times per step of the built-in fix and of ours, one per round, s.
struct StepTimes {
  std::string state;  // of the bed: "falling", "at_the_end"
  std::vector<double> builtin, rodpack;
};

/// What `rodpack compare` found. `builtin`: fix multisphere with the exact bodies of `rodpack`;
/// `sampled`: fix multisphere with the stock template's.
struct Comparison {
  MethodRun builtin, rodpack, sampled;
  MassProperties exact{};
  double particle_diameter = 0;                 // m
  double limit = 0;                             // distance from which runs have parted, m
  Separation builtin_rodpack, sampled_rodpack;  // as separate() finds them
  std::vector<StepTimes> step_times;
};

/// One line of compare.csv; what does not exist is left empty.
struct ComparisonRow {
  std::string quantity, unit;
  std::optional<double> builtin, rodpack, sampled, exact;
};
/// Lists all that is compared, in the order of compare.csv.
std::vector<ComparisonRow> comparison_rows(const Comparison& comparison);

/// Writes a CSV table with the columns quantity, unit, builtin, rodpack, builtin_sampled, exact.
/// @throws DataError when it cannot be written.
void write_comparison(const std::vector<ComparisonRow>& rows, const std::string& file);
/// Returns the same for a terminal, aligned.
std::string comparison_text(const std::vector<ComparisonRow>& rows);

/// Writes a CSV table with the columns time_s, body, then x_m, y_m, angle_deg of builtin and
/// rodpack: up to and with the frame where they have parted, all frames if they never do.
void write_trajectories(const Comparison& comparison, const std::string& file);
/// Writes a CSV table with the columns time_s, largest and rms distance (m) of builtin and of
/// builtin_sampled from rodpack.
void write_separation(const Comparison& comparison, const std::string& file);
/// Writes a CSV table with the columns time_s, then for each run the energies (J) and the number of
/// sphere contacts.
void write_energies(const Comparison& comparison, const std::string& file);
/// Writes a CSV table with the columns round, then state and method: seconds per step.
void write_step_times(const Comparison& comparison, const std::string& file);

/// Draws the largest distance over time, in d_p: `stem`.png and `stem`.svg.
void plot_separation(const Comparison& comparison, const std::string& stem);
/// Draws kinetic and elastic energy over time: `stem`.png and `stem`.svg.
void plot_energy_comparison(const Comparison& comparison, const std::string& stem);

}  // namespace rodpack

#endif
