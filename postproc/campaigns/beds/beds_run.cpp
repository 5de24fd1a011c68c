// SPDX-License-Identifier: GPL-2.0-or-later
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>

#include "campaigns/accuracy/accuracy_folder.h"
#include "campaigns/beds/beds.h"
#include "reading/data_error.h"
#include "reading/dump.h"
#include "reading/number_text.h"
#include "reading/table.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

constexpr double gravity = 9.81;  // m/s^2

/// Returns the processor time of all programs that this one has waited for, s.
double processor_time_of_runs() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void measure_bodies(const Frame& bodies, double width, BedRow& row) {
  const double n = static_cast<double>(bodies.rows);
  const auto &y = bodies.column("y"), &angle = bodies.column("angle"),
             &area = bodies.column("area");
  double covered = 0, height = 0;
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    height += y[i] / n;
    row.order += std::cos(2 * angle[i]) / n;
    covered += area[i];
  }
  // The mean height of an even bed is half of its own.
  row.solid_fraction = covered / (2 * height * width);
  row.height = height / rod_diameter;
}

void measure_contacts(const Frame& contacts, const Frame& bodies, BedRow& row) {
  const auto &wall = contacts.column("wall"), &fx = contacts.column("fx"),
             &fy = contacts.column("fy"), &i = contacts.column("body_i"),
             &j = contacts.column("body_j"), &overlap = contacts.column("overlap_n");
  std::map<std::pair<double, double>, std::pair<double, double>> pairs;
  double carried = 0, between_rods = 0;
  for (std::size_t c = 0; c < contacts.rows; ++c) {
    if (wall[c] != 0) {
      carried += fy[c];
      continue;
    }
    between_rods += 1;
    row.overlap += overlap[c] / rod_diameter;
    const double sign = i[c] < j[c] ? 1 : -1;
    auto& force = pairs[std::minmax(i[c], j[c])];
    force.first += sign * fx[c];
    force.second += sign * fy[c];
  }
  double weight = 0;
  for (const double mass : bodies.column("mass")) weight += gravity * mass;
  row.carried_weight = carried / weight;
  if (pairs.empty()) return;
  row.overlap /= between_rods;
  for (const auto& [pair, force] : pairs) {
    const double size = std::hypot(force.first, force.second);
    row.mean_force += size / static_cast<double>(pairs.size());
    row.largest_force = std::max(row.largest_force, size);
  }
  row.neighbours = 2.0 * static_cast<double>(pairs.size()) / static_cast<double>(bodies.rows);
  row.contacts = 2.0 * between_rods / static_cast<double>(bodies.rows);
}

/// Fills in what the run left behind.
void measure(const std::string& work, double width, BedRow& row) {
  const Table energies = read_table(work + "/energies.txt");
  if (energies.rows() == 0)
    throw DataError(work + "/energies.txt: expected two energies and a fraction, found no row");
  const BedRow before = row;
  try {
    row.kinetic = energies.column("kinetic_J").front();
    row.elastic = energies.column("elastic_J").front();
    row.step_over_limit = energies.column("step_over_limit").front();
    const Frame bodies = last_frame({work + "/end.dump"});
    row.rods = static_cast<int>(bodies.rows);
    if (row.rods == 0) return;
    measure_bodies(bodies, width, row);
    measure_contacts(last_frame({work + "/contacts.dump"}), bodies, row);
    if (!std::isfinite(row.kinetic + row.elastic + row.solid_fraction)) row = before;
  } catch (const std::exception&) {  // numbers beyond all bounds
    if (!std::filesystem::exists(work + "/end.dump")) throw;
    row = before;
  }
}

}  // namespace

BedRow run_bed(const AccuracySettings& settings, const std::string& folder, const BedModel& model,
               int seed) {
  const BedScene& scene = settings.bed_scene;
  BedRow row;
  row.model = model;
  row.seed = seed;
  row.steps = std::lround(scene.duration() / model.step);
  const std::string integrator = accuracy_method(model.method).integrator;
  const std::string scaling =
      model.mass_scaling > 0 ? " mass_scaling " + number_text(model.mass_scaling, 17) : "";
  const double before = processor_time_of_runs();
  run_accuracy_deck(settings, folder, "in.bed",
                    {{"integrator", integrator + scaling +
                                        (model.method == "builtin" ? ""
                                         : model.planar            ? " planar yes"
                                                                   : " planar no")},
                     {"dt", number_text(model.step, 17)},
                     {"steps", std::to_string(row.steps)},
                     {"aspect_ratio", number_text(scene.aspect_ratio, 17)},
                     {"width", number_text(scene.width(), 17)},
                     {"lines", std::to_string(scene.lines)},
                     {"per_line", std::to_string(scene.per_line)},
                     {"style", model.engine ? "verlet/planar" : "verlet"},
                     {"overlap", number_text(model.overlap, 17)},
                     {"relaxation", number_text(model.relaxation_steps * model.step, 17)},
                     {"stiffness", number_text(model.stiffness, 17)},
                     {"seed", std::to_string(seed)}});
  row.seconds_per_step = (processor_time_of_runs() - before) / static_cast<double>(row.steps);
  measure(folder + "/work", scene.width(), row);
  return row;
}

std::vector<BedRow> measure_beds(const AccuracySettings& settings, const std::string& folder,
                                 std::ostream& progress) {
  claim_folder(folder, settings);
  const std::string file = folder + "/beds.csv";
  const auto known = read_bed_rows(file);
  std::vector<BedModel> models;
  for (const auto& comparison :
       bed_comparisons(settings.bed_methods, settings.bed_comparisons, settings.bed_scene))
    for (const auto& model : comparison.models)
      if (std::find(models.begin(), models.end(), model) == models.end()) models.push_back(model);
  std::vector<BedRow> rows;
  for (int seed = 1; seed <= settings.seeds; ++seed) {
    int runs = 0;
    for (const auto& model : models) {
      const auto found = std::find_if(known.begin(), known.end(), [&](const BedRow& row) {
        return row.seed == seed && row.model == model;
      });
      if (found == known.end()) {
        rows.push_back(run_bed(settings, folder, model, seed));
        append_line(file, bed_row_text(rows.back()));
        ++runs;
      } else {
        rows.push_back(*found);
      }
    }
    progress << beds_scene << ": seed " << seed << " of " << settings.seeds << ", " << models.size()
             << " models, " << (runs == 0 ? "all known" : std::to_string(runs) + " run")
             << std::endl;
  }
  std::filesystem::remove_all(folder + "/work");
  return rows;
}

}  // namespace rodpack
