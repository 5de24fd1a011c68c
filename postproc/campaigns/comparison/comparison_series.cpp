// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/comparison/comparison.h"
#include "reading/angles.h"
#include "reading/csv_file.h"

namespace rodpack {
namespace {
using Columns = std::vector<std::pair<std::string, std::vector<double>>>;
}  // namespace

void write_trajectories(const Comparison& comparison, const std::string& file) {
  const auto& first = comparison.builtin.bodies;
  const auto& parted = comparison.builtin_rodpack.parted;
  const std::size_t frames = parted ? *parted + 1 : first.time.size();
  Columns columns = {{"time_s", {}}, {"body", {}}};
  for (std::size_t frame = 0; frame < frames; ++frame)
    for (const double body : first.body) {
      columns[0].second.push_back(first.time[frame]);
      columns[1].second.push_back(body);
    }
  for (const auto* run : {&comparison.builtin, &comparison.rodpack}) {
    const auto add = [&](const std::string& name, const std::vector<std::vector<double>>& values,
                         double factor) {
      std::vector<double> column;
      for (std::size_t frame = 0; frame < frames; ++frame)
        for (const double value : values[frame]) column.push_back(factor * value);
      columns.emplace_back(name, std::move(column));
    };
    add(run->name + "_x_m", run->bodies.x, 1);
    add(run->name + "_y_m", run->bodies.y, 1);
    add(run->name + "_angle_deg", run->bodies.angle, degrees_in_radian);
  }
  write_csv(file, columns);
}

void write_separation(const Comparison& comparison, const std::string& file) {
  const auto& builtin = comparison.builtin_rodpack;
  const auto& sampled = comparison.sampled_rodpack;
  write_csv(file, {{"time_s", builtin.time},
                   {"builtin_largest_m", builtin.largest},
                   {"builtin_rms_m", builtin.rms},
                   {"builtin_sampled_largest_m", sampled.largest},
                   {"builtin_sampled_rms_m", sampled.rms}});
}

void write_energies(const Comparison& comparison, const std::string& file) {
  Columns columns = {{"time_s", comparison.builtin.bodies.time}};
  for (const auto* run : {&comparison.builtin, &comparison.rodpack, &comparison.sampled}) {
    columns.emplace_back(run->name + "_kinetic_translational_J", run->series.kinetic_translational);
    columns.emplace_back(run->name + "_kinetic_rotational_J", run->series.kinetic_rotational);
    columns.emplace_back(run->name + "_elastic_normal_J", run->series.elastic_normal);
    columns.emplace_back(run->name + "_elastic_tangential_J", run->series.elastic_tangential);
    columns.emplace_back(run->name + "_gravitational_J", run->bodies.potential);
    columns.emplace_back(run->name + "_sphere_contacts", run->series.sphere_contacts);
  }
  write_csv(file, columns);
}

void write_step_times(const Comparison& comparison, const std::string& file) {
  Columns columns = {{"round", {}}};
  for (const auto& times : comparison.step_times) {
    columns.front().second.clear();
    for (std::size_t round = 1; round <= times.builtin.size(); ++round)
      columns.front().second.push_back(static_cast<double>(round));
    columns.emplace_back(times.state + "_builtin_s", times.builtin);
    columns.emplace_back(times.state + "_rodpack_s", times.rodpack);
  }
  write_csv(file, columns);
}

}  // namespace rodpack
