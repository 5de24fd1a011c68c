// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <functional>

#include "campaigns/comparison/comparison.h"
#include "campaigns/launch/step_timing.h"
#include "reading/angles.h"
#include "reading/csv_file.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {
using Value = std::optional<double>;

/// Collects rows; a quantity of all three runs is a function of the run.
class RowCollector {
 public:
  explicit RowCollector(const Comparison& comparison) : comparison_(comparison) {}
  void add(const std::string& quantity, const std::string& unit,
           const std::function<Value(const MethodRun&)>& of, Value exact = {}) {
    rows_.push_back({quantity, unit, of(comparison_.builtin), of(comparison_.rodpack),
                     of(comparison_.sampled), exact});
  }
  void add(const ComparisonRow& row) { rows_.push_back(row); }
  std::vector<ComparisonRow> take() { return std::move(rows_); }

 private:
  const Comparison& comparison_;
  std::vector<ComparisonRow> rows_;
};

double kinetic(const MethodRun& run, std::size_t frame) {
  return run.series.kinetic_translational[frame] + run.series.kinetic_rotational[frame];
}
double elastic(const MethodRun& run, std::size_t frame) {
  return run.series.elastic_normal[frame] + run.series.elastic_tangential[frame];
}

void add_parting(RowCollector& rows, const Comparison& c) {
  rows.add({"parting_time_from_rodpack",
            "s",
            c.builtin_rodpack.parting_time(),
            {},
            c.sampled_rodpack.parting_time(),
            {}});
  rows.add({"largest_distance_from_rodpack_at_the_end",
            "m",
            c.builtin_rodpack.largest.back(),
            {},
            c.sampled_rodpack.largest.back(),
            {}});
}

void add_mass(RowCollector& rows, const MassProperties& exact) {
  rows.add(
      "mass", "kg", [](const MethodRun& run) { return run.mass; }, exact.mass);
  const char* names[] = {"inertia_along_the_rod", "inertia_across_1", "inertia_across_2"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    rows.add(
        names[axis], "kg m2", [=](const MethodRun& run) { return run.inertia[axis]; },
        exact.inertia[axis]);
}

void add_leak(RowCollector& rows) {
  const auto leak = [&rows](const std::string& name, const std::string& unit, double Leak::*member,
                            double factor = 1) {
    rows.add(name, unit, [=](const MethodRun& run) { return factor * (run.bodies.leak.*member); });
  };
  leak("largest_z_from_start", "m", &Leak::z);
  leak("largest_v_z", "m/s", &Leak::vz);
  leak("largest_omega_x", "rad/s", &Leak::omega_x);
  leak("largest_omega_y", "rad/s", &Leak::omega_y);
  leak("largest_tilt_out_of_the_plane", "deg", &Leak::tilt, degrees_in_radian);
  leak("largest_omega_z_for_scale", "rad/s", &Leak::omega_z);
}

void add_energies(RowCollector& rows, const std::string& when, bool at_the_end) {
  const auto frame = [at_the_end](const MethodRun& run) {
    return at_the_end ? run.bodies.time.size() - 1 : 0;
  };
  rows.add("kinetic_energy_" + when, "J",
           [=](const MethodRun& run) { return kinetic(run, frame(run)); });
  rows.add("elastic_energy_" + when, "J",
           [=](const MethodRun& run) { return elastic(run, frame(run)); });
  rows.add("gravitational_energy_" + when, "J",
           [=](const MethodRun& run) { return run.bodies.potential[frame(run)]; });
  rows.add("total_energy_" + when, "J", [=](const MethodRun& run) {
    const auto at = frame(run);
    return kinetic(run, at) + elastic(run, at) + run.bodies.potential[at];
  });
}

void add_bed(RowCollector& rows) {
  const auto coordination = [&rows](const std::string& name, double Coordination::*member) {
    rows.add(name, "1", [=](const MethodRun& run) -> Value {
      if (!run.bed.coordination) return {};
      return (*run.bed.coordination).*member;
    });
  };
  rows.add("sphere_contacts", "1",
           [](const MethodRun& run) { return run.series.sphere_contacts.back(); });
  coordination("touching_particles_per_particle", &Coordination::touching_particles);
  coordination("contacts_per_particle", &Coordination::contacts);
  rows.add("solid_fraction_below_surface", "1",
           [](const MethodRun& run) { return run.bed.covered_below_surface; });
  rows.add("solid_fraction_central_slice", "1",
           [](const MethodRun& run) { return run.bed.slice_solid_fraction; });
  rows.add("bed_height", "m", [](const MethodRun& run) { return run.bed.height; });
  rows.add("mean_height_of_centres", "m", [](const MethodRun& run) { return run.bed.mean_height; });
  const auto nematic = [&rows](const std::string& name, const std::string& unit,
                               double NematicOrder::*member) {
    rows.add(name, unit, [=](const MethodRun& run) -> Value {
      if (!run.bed.orientation) return {};
      return (*run.bed.orientation).*member;
    });
  };
  nematic("nematic_order", "1", &NematicOrder::order);
  nematic("director", "deg", &NematicOrder::director);
}

void add_times(RowCollector& rows, const StepTimes& times) {
  const double builtin = median(times.builtin);
  const double rodpack = median(times.rodpack);
  rows.add({"time_per_step_" + times.state, "s", builtin, rodpack, {}, {}});
  rows.add({"time_per_step_over_builtin_" + times.state, "1", 1.0, rodpack / builtin, {}, {}});
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

}  // namespace

std::vector<ComparisonRow> comparison_rows(const Comparison& comparison) {
  RowCollector rows(comparison);
  add_parting(rows, comparison);
  add_mass(rows, comparison.exact);
  add_leak(rows);
  add_energies(rows, "at_the_start", false);
  add_energies(rows, "at_the_end", true);
  add_bed(rows);
  for (const auto& times : comparison.step_times) add_times(rows, times);
  return rows.take();
}

void write_comparison(const std::vector<ComparisonRow>& rows, const std::string& file) {
  std::string text = "quantity,unit,builtin,rodpack,builtin_sampled,exact\n";
  for (const auto& row : rows)
    text += row.quantity + "," + row.unit + "," + csv_number(row.builtin, 10) + "," +
            csv_number(row.rodpack, 10) + "," + csv_number(row.sampled, 10) + "," +
            csv_number(row.exact, 10) + "\n";
  write_text(file, text);
}

std::string comparison_text(const std::vector<ComparisonRow>& rows) {
  const auto line = [](const std::string& quantity, const std::string& unit,
                       const std::vector<std::string>& values) {
    std::string text = padded(quantity, 42) + padded(unit, 7);
    for (const auto& value : values) text += padded(value.empty() ? "-" : value, 17);
    return text.erase(text.find_last_not_of(' ') + 1) + "\n";
  };
  std::string text = line("quantity", "unit", {"builtin", "rodpack", "builtin_sampled", "exact"});
  for (const auto& row : rows)
    text += line(row.quantity, row.unit,
                 {csv_number(row.builtin, 6), csv_number(row.rodpack, 6),
                  csv_number(row.sampled, 6), csv_number(row.exact, 6)});
  return text;
}

}  // namespace rodpack
