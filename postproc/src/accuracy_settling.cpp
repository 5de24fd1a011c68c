// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>

#include "accuracy_folder.h"
#include "rodpack/data_error.h"
#include "rodpack/text.h"

namespace rodpack {
namespace {

constexpr double diameter = 3e-3, width = 0.08;  // m, as in the deck
constexpr double duration = 0.5;                 // s
constexpr double contact_time = 4.176e-4;        // s, of two of the paper's spheres
constexpr int rods = 50;
const double steps_per_contact[] = {10.37, 20.37, 37.96, 81.37};

const std::string header =
    "method,steps_per_contact,seed,rods,kinetic_J,elastic_J,mean_height_over_dp,solid_fraction";

std::string text(const SettlingRow& row) {
  return row.method + "," + number_text(row.steps_per_contact) + "," + std::to_string(row.seed) +
         "," + std::to_string(row.rods) + "," + number_text(row.kinetic) + "," +
         number_text(row.elastic) + "," + number_text(row.height) + "," +
         number_text(row.solid_fraction);
}

std::vector<SettlingRow> read_rows(const std::string& file) {
  std::vector<SettlingRow> rows;
  for (const auto& f : read_fields(file, header)) {
    try {
      rows.push_back({f[0], std::stod(f[1]), std::stoi(f[2]), std::stoi(f[3]), std::stod(f[4]),
                      std::stod(f[5]), std::stod(f[6]), std::stod(f[7])});
    } catch (const std::logic_error&) {
      throw DataError(file + ": expected numbers after the method " + f[0]);
    }
  }
  return rows;
}

/// Fills in what the run left behind.
void measure(const std::string& work, SettlingRow& row) {
  std::ifstream energies(work + "/energies.txt");
  std::string comment;
  std::getline(energies, comment);
  if (!(energies >> row.kinetic >> row.elastic))
    throw DataError(work + "/energies.txt: expected two energies");
  const Frame end = last_frame({work + "/end.dump"});
  row.rods = static_cast<int>(end.rows);
  if (row.rods == 0) return;
  const auto &y = end.column("y"), &area = end.column("area");
  for (const double height : y) row.height += height / row.rods;
  double below = 0;
  for (std::size_t i = 0; i < end.rows; ++i) below += y[i] < row.height ? area[i] : 0;
  row.solid_fraction = below / (width * row.height);
  row.height /= diameter;
}

struct Mean {
  double n = 0, sum = 0, squares = 0;
  void add(double x) {
    n += 1;
    sum += x;
    squares += x * x;
  }
  double value() const { return sum / n; }
  double error() const {
    return n < 2 ? 0 : std::sqrt(std::max(0.0, squares / n - value() * value()) / (n - 1));
  }
  std::string text(int digits) const {
    return number_text(value(), digits) + (n < 2 ? "" : " ± " + number_text(error(), 1));
  }
};

}  // namespace

std::vector<SettlingRow> measure_settling(const AccuracySettings& settings,
                                          const std::string& folder, std::ostream& progress) {
  claim_folder(folder, settings);
  const std::string file = folder + "/settling.csv";
  const auto known = read_rows(file);
  std::vector<SettlingRow> rows;
  for (int seed = 1; seed <= settings.seeds; ++seed) {
    for (const auto& name : settings.methods) {
      const auto method = accuracy_method(name);
      for (const double per_contact : steps_per_contact) {
        const auto same = [&](const SettlingRow& row) {
          return row.method == name && row.seed == seed && row.steps_per_contact == per_contact;
        };
        const auto found = std::find_if(known.begin(), known.end(), same);
        if (found != known.end()) {
          rows.push_back(*found);
          continue;
        }
        const double dt = contact_time / per_contact;
        SettlingRow row{name, per_contact, seed, 0, 0, 0, 0, 0};
        run_accuracy_deck(
            settings, folder, "in.settling",
            {{"integrator", method.integrator + (name == "builtin" ? "" : " planar yes")},
             {"dt", number_text(dt, 17)},
             {"steps", std::to_string(std::lround(duration / dt))},
             {"width", number_text(width)},
             {"seed", std::to_string(seed)}});
        measure(folder + "/work", row);
        append_line(file, text(row));
        rows.push_back(row);
      }
      progress << settling_scene << ' ' << name << ": seed " << seed << " of " << settings.seeds
               << std::endl;
    }
  }
  std::filesystem::remove_all(folder + "/work");
  return rows;
}

std::string settling_table(const std::vector<SettlingRow>& rows) {
  struct Means {
    Mean kinetic, elastic, height, solid_fraction;
    long lost = 0;
  };
  std::map<std::pair<double, std::string>, Means> groups;
  for (const auto& row : rows) {
    auto& group = groups[{row.steps_per_contact, row.method}];
    group.lost += rods - row.rods;
    if (row.rods < rods || !(row.kinetic > 0)) continue;
    group.kinetic.add(std::log10(row.kinetic));
    group.elastic.add(row.elastic * 1e6);
    group.height.add(row.height);
    group.solid_fraction.add(row.solid_fraction);
  }
  std::string table =
      "| steps per contact | method | seeds | rods lost | log10 of the kinetic energy in J | "
      "elastic "
      "energy, µJ | mean height / d_p | solid fraction |\n|---|---|---|---|---|---|---|---|\n";
  for (const auto& [key, group] : groups) {
    table += "| " + number_text(key.first, 4) + " | " + key.second + " | " +
             number_text(group.height.n) + " | " + std::to_string(group.lost) + " | ";
    table += group.height.n == 0
                 ? "– | – | – | – |\n"
                 : group.kinetic.text(3) + " | " + group.elastic.text(4) + " | " +
                       group.height.text(4) + " | " + group.solid_fraction.text(3) + " |\n";
  }
  return table;
}

}  // namespace rodpack
