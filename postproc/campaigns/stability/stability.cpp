// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "reading/csv_file.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "reading/table.h"
#include "reading/text_file.h"
#include "rodpack/geometry/mass_properties.h"
#include "rodpack/motion/stability_limit.h"

namespace rodpack {
namespace {

namespace fs = std::filesystem;

const double stiffness = 1000;      // of a contact in the decks, N/m
const double smallest_step = 0.05;  // omega dt
const double scene_damping = 0.2;   // of the bed's deck
const char* const table_name = "stability.csv";
const char* const scenes_name = "stability_scenes.csv";
const char* const table_header = "method,order,damping_ratio,limit_measured,limit_theory";
const char* const scenes_header =
    "scene,order,damping_ratio,limit_measured_s,limit_check_s,limit_single_contact_s,factor";

/// Returns the mass of a smooth rod of `spheres` spheres (1: a sphere) of the decks, kg.
double rod_mass(int spheres) {
  const double diameter = 3e-3;
  const ChainShape shape{0.5 * (spheres + 1), diameter, 0.5, 0, diameter};
  return mass_properties(shape, 2500, MassRule::reference, false).mass;
}

std::string method_name(int order) { return order == 0 ? "velocity_verlet" : "adams_bashforth"; }

std::string table_text(const std::vector<StabilityLimit>& rows) {
  std::string text = std::string(table_header) + "\n";
  for (const auto& row : rows)
    text +=
        csv_line({method_name(row.order), std::to_string(row.order), number_text(row.damping_ratio),
                  number_text(row.limit_measured), number_text(row.limit_theory)}) +
        "\n";
  return text;
}

std::string scenes_text(const std::vector<SceneLimit>& rows) {
  std::string text = std::string(scenes_header) + "\n";
  for (const auto& row : rows)
    text += csv_line({row.scene, std::to_string(row.order), number_text(row.damping_ratio),
                      number_text(row.limit_measured), number_text(row.limit_check),
                      number_text(row.limit_single_contact), number_text(row.factor())}) +
            "\n";
  return text;
}

/// Reads the rows of a table that an earlier measurement left; none when there is no such file.
std::optional<Table> known_rows(const fs::path& file, const char* header) {
  if (!fs::exists(file)) return std::nullopt;
  return read_table(file.string(), header);
}

std::vector<StabilityLimit> read_limits(const fs::path& file) {
  std::vector<StabilityLimit> rows;
  const auto table = known_rows(file, table_header);
  if (!table) return rows;
  const auto order = table->whole_numbers("order");
  const auto &damping = table->column("damping_ratio"), &measured = table->column("limit_measured"),
             &theory = table->column("limit_theory");
  for (std::size_t i = 0; i < table->rows(); ++i)
    rows.push_back({static_cast<int>(order[i]), damping[i], measured[i], theory[i]});
  return rows;
}

std::vector<SceneLimit> read_scene_limits(const fs::path& file) {
  std::vector<SceneLimit> rows;
  const auto table = known_rows(file, scenes_header);
  if (!table) return rows;
  const auto& scene = table->words("scene");
  const auto order = table->whole_numbers("order");
  const auto &damping = table->column("damping_ratio"),
             &measured = table->column("limit_measured_s"), &check = table->column("limit_check_s"),
             &single = table->column("limit_single_contact_s");
  for (std::size_t i = 0; i < table->rows(); ++i)
    rows.push_back(
        {scene[i], static_cast<int>(order[i]), damping[i], measured[i], check[i], single[i]});
  return rows;
}

/// Returns the largest excursion in a file that the deck's `fix print` wrote, in units of the depth
/// at rest.
double largest_excursion(const fs::path& file) {
  const Table table = read_table(file.string());
  if (table.rows() == 0) throw DataError(file.string() + ": expected excursions, found no row");
  double result = 0;
  for (const double value : table.column("out")) result = std::max(result, std::fabs(value));
  return result;
}

/// Returns what fix check/timestep/multisphere took for the limit, s.
double limit_of_check(const fs::path& folder) {
  const fs::path file = folder / "check.txt";
  const Table table = read_table(file.string());
  if (table.rows() == 0) throw DataError(file.string() + ": expected a limit, found no row");
  return table.column("limit").front();
}

/// Runs of accuracy/in.stability, each in the same folder.
class Oscillator {
 public:
  Oscillator(const StabilityOptions& options, int order, double damping_ratio, int spheres)
      : options_(options),
        folder_(fs::path(options.folder) / "runs" / "oscillator"),
        variables_({{"order", std::to_string(order)},
                    {"eta", number_text(damping_ratio)},
                    {"spheres", std::to_string(spheres)}}) {}

  bool grows(double timestep) {
    for (const char* name : {"early.txt", "late.txt", "grown.txt"}) fs::remove(folder_ / name);
    variables_["timestep"] = number_text(timestep, 15);
    run_deck(options_.liggghts, options_.decks + "/accuracy/in.stability", variables_,
             folder_.string());
    if (fs::exists(folder_ / "grown.txt")) return true;
    const double early = largest_excursion(folder_ / "early.txt"),
                 late = largest_excursion(folder_ / "late.txt");
    // It starts at 1e-3; what has died out to rounding errors does not count.
    return late > 1e-9 && late > 1.002 * early;
  }

  double check_limit() const { return limit_of_check(folder_); }

 private:
  const StabilityOptions& options_;
  fs::path folder_;
  DeckVariables variables_;
};

void measure_oscillator(const StabilityOptions& options, int spheres, SceneLimit& row) {
  Oscillator oscillator(options, row.order, row.damping_ratio, spheres);
  const double single = std::sqrt(rod_mass(spheres) / stiffness);
  row.limit_single_contact = stability_limit(row.order, row.damping_ratio) * single;
  row.limit_measured = bisect_growth([&](double dt) { return oscillator.grows(dt); },
                                     0.02 * row.limit_single_contact, 2 * row.limit_single_contact,
                                     options.tolerance);
  row.limit_check = oscillator.check_limit();
}

void measure_bed(const StabilityOptions& options, int aspect_ratio, SceneLimit& row) {
  const fs::path runs = fs::absolute(fs::path(options.folder) / "runs");
  const fs::path bed = runs / (row.scene + "_order" + std::to_string(row.order));
  const std::string ratio = std::to_string(aspect_ratio);
  const fs::path restart = bed / "restart" / "deposition.end.restart";
  if (!fs::exists(bed / "result.json")) {
    fs::remove_all(bed);
    run_deck(options.liggghts, options.decks + "/deposition/in.deposition",
             {{"particles", "60"},
              {"aspect_ratio", ratio},
              {"width_in_lengths", "3"},
              {"container_height", number_text(0.03 * aspect_ratio)},
              {"particles_per_line", "2"},
              {"relaxation_ratio", "1e-12"},
              {"output_interval", "10"},
              {"restart_interval", "10"},
              {"integrator", row.order == 0 ? "builtin" : "ab" + std::to_string(row.order)},
              {"out", bed.string()}},
             (runs / "deposition").string());
  }
  const fs::path folder = runs / "bed";
  const auto grows = [&](double timestep) {
    fs::remove(folder / "awake.txt");
    run_deck(options.liggghts, options.decks + "/accuracy/in.stability_bed",
             {{"restart", restart.string()},
              {"order", std::to_string(row.order)},
              {"ratio", ratio},
              {"width", number_text(3 * aspect_ratio * 3e-3)},
              {"timestep", number_text(timestep, 15)}},
             folder.string());
    return fs::exists(folder / "awake.txt");
  };
  row.limit_single_contact = stability_limit(row.order, row.damping_ratio) *
                             std::sqrt(0.5 * rod_mass(2 * aspect_ratio - 1) / stiffness);
  row.limit_measured = bisect_growth(grows, 0.02 * row.limit_single_contact,
                                     2 * row.limit_single_contact, 5 * options.tolerance);
  row.limit_check = limit_of_check(folder);
}

}  // namespace

double bisect_growth(const std::function<bool(double)>& grows, double low, double high,
                     double tolerance) {
  if (grows(low)) return 0.0;
  if (!grows(high)) return std::numeric_limits<double>::infinity();
  while (high - low > tolerance * low) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<StabilityLimit> measure_stability(const StabilityOptions& options,
                                              const Progress& progress) {
  const fs::path file = fs::path(options.folder) / table_name;
  fs::create_directories(options.folder);
  std::vector<StabilityLimit> known = read_limits(file);

  std::vector<StabilityLimit> result;
  for (const int order : options.orders) {
    for (const double eta : options.damping_ratios) {
      const auto found = std::find_if(known.begin(), known.end(), [&](const StabilityLimit& row) {
        return row.order == order && std::fabs(row.damping_ratio - eta) < 1e-9;
      });
      if (found != known.end()) {
        result.push_back(*found);
        continue;
      }
      if (progress)
        progress("stability limit: " + method_name(order) + " order " + std::to_string(order) +
                 ", damping ratio " + number_text(eta));
      Oscillator oscillator(options, order, eta, 1);
      const double omega = std::sqrt(stiffness / rod_mass(1));
      const double measured = bisect_growth([&](double y) { return oscillator.grows(y / omega); },
                                            smallest_step, 2.5, options.tolerance);
      known.push_back({order, eta, measured, stability_limit(order, eta)});
      result.push_back(known.back());
      write_text(file.string(), table_text(known));
    }
  }
  return result;
}

std::vector<SceneLimit> measure_stability_scenes(const StabilityOptions& options,
                                                 const Progress& progress) {
  const fs::path file = fs::path(options.folder) / scenes_name;
  fs::create_directories(options.folder);
  std::vector<SceneLimit> known = read_scene_limits(file);

  std::vector<SceneLimit> result;
  for (const std::string scene : {"sphere", "rod_flat", "bed_ar5", "bed_ar7"}) {
    for (const int order : {3, 0}) {
      const auto found = std::find_if(known.begin(), known.end(), [&](const SceneLimit& row) {
        return row.scene == scene && row.order == order;
      });
      if (found != known.end()) {
        result.push_back(*found);
        continue;
      }
      if (progress)
        progress("stability limit: scene " + scene + ", " + method_name(order) + " order " +
                 std::to_string(order));
      SceneLimit row = {scene, order, scene_damping, 0, 0, 0};
      if (scene == "bed_ar5" || scene == "bed_ar7")
        measure_bed(options, scene == "bed_ar5" ? 5 : 7, row);
      else
        measure_oscillator(options, scene == "sphere" ? 1 : 9, row);
      known.push_back(row);
      result.push_back(row);
      write_text(file.string(), scenes_text(known));
    }
  }
  return result;
}

void write_stability(const std::vector<StabilityLimit>& rows, const std::string& folder) {
  fs::create_directories(folder);
  write_text((fs::path(folder) / table_name).string(), table_text(rows));
  plot_stability(rows, (fs::path(folder) / "stability").string());
}

void write_stability_scenes(const std::vector<SceneLimit>& rows, const std::string& folder) {
  fs::create_directories(folder);
  write_text((fs::path(folder) / scenes_name).string(), scenes_text(rows));
}

}  // namespace rodpack
