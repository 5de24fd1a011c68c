// SPDX-License-Identifier: GPL-2.0-or-later
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "rodpack/accuracy.h"
#include "rodpack/data_error.h"
#include "rodpack/text.h"

namespace rodpack {

namespace fs = std::filesystem;

namespace {

const std::string header = "scene,method,order,steps_per_contact,error,force_evaluations,seconds\n";

std::string text(const AccuracyRow& row) {
  return row.scene + "," + row.method + "," + std::to_string(row.order) + "," +
         number_text(row.steps_per_contact, 12) + "," + number_text(row.error, 12) + "," +
         number_text(row.force_evaluations) + "," + number_text(row.seconds, 6) + "\n";
}

AccuracyRow parse(const std::string& line, const std::string& where) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  try {
    if (fields.size() != 7) throw std::invalid_argument("fields");
    return {fields[0],
            fields[1],
            std::stoi(fields[2]),
            std::stod(fields[3]),
            std::stod(fields[4]),
            std::stod(fields[5]),
            std::stod(fields[6])};
  } catch (const std::logic_error&) {
    throw DataError(where + ": expected " + header.substr(0, header.size() - 1) + ", found '" +
                    line + "'");
  }
}

/// Rows of the file; a last line that was cut short is removed from it.
std::vector<AccuracyRow> read_rows(const std::string& file) {
  std::vector<AccuracyRow> rows;
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    write_text(file, header);
    return rows;
  }
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  in.close();
  const std::size_t whole = all.rfind('\n') == std::string::npos ? 0 : all.rfind('\n') + 1;
  if (all.compare(0, header.size(), header) != 0 && whole > 0)
    throw DataError(file + ":1: expected " + header.substr(0, header.size() - 1));
  if (whole == 0) {
    write_text(file, header);
    return rows;
  }
  if (whole < all.size()) write_text(file, all.substr(0, whole));
  std::istringstream lines(all.substr(header.size(), whole - header.size()));
  long number = 1;
  for (std::string line; std::getline(lines, line);)
    rows.push_back(parse(line, file + ":" + std::to_string(++number)));
  return rows;
}

/// What has to be the same for all rows of a folder.
nlohmann::json common(const AccuracySettings& settings) {
  return {{"liggghts", fs::absolute(settings.liggghts.program).lexically_normal().string()},
          {"inputs", fs::absolute(settings.inputs).lexically_normal().string()},
          {"steps", settings.steps},
          {"repeats", settings.repeats},
          {"timed_steps", settings.timed_steps}};
}

void claim(const std::string& folder, const AccuracySettings& settings) {
  const std::string file = folder + "/settings.json";
  const auto wanted = common(settings);
  std::ifstream in(file);
  if (!in) {
    if (fs::exists(folder + "/accuracy.csv"))
      throw DataError(folder + ": holds accuracy.csv but no settings.json; expected a new folder");
    fs::create_directories(folder);
    write_text(file, wanted.dump(2) + "\n");
    return;
  }
  const auto found = nlohmann::json::parse(in, nullptr, false);
  if (!found.is_object()) throw DataError(file + ": expected a JSON object");
  for (const auto& [key, value] : wanted.items())
    if (!found.contains(key) || found.at(key) != value)
      throw DataError(file + ": " + key + " is " +
                      (found.contains(key) ? found.at(key).dump() : std::string("missing")) +
                      ", expected " + value.dump() + ": other settings need another folder");
}

/// Keeps this process and those it starts on one processor, while it lives.
class OneProcessor {
 public:
  OneProcessor() {
    if (sched_getaffinity(0, sizeof before_, &before_) != 0) return;
    int last = -1;
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
      if (CPU_ISSET(cpu, &before_)) last = cpu;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(last, &one);
    pinned_ = last >= 0 && sched_setaffinity(0, sizeof one, &one) == 0;
  }
  ~OneProcessor() {
    if (pinned_) sched_setaffinity(0, sizeof before_, &before_);
  }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_;
  bool pinned_ = false;
};

/// Loop time of the last `run`, s.
double loop_time(const std::string& output) {
  const std::string label = "Loop time of ";
  const auto at = output.rfind(label);
  if (at == std::string::npos) throw DataError("LIGGGHTS printed no '" + label + "'");
  return std::stod(output.substr(at + label.size()));
}

class Measurement {
 public:
  Measurement(const AccuracySettings& settings, const std::string& folder)
      : settings_(settings), liggghts_(settings.liggghts), work_(folder + "/work") {
    // runs have another working folder
    if (fs::exists(liggghts_.program)) liggghts_.program = fs::absolute(liggghts_.program).string();
  }

  double error(const AccuracyScene& scene, const AccuracyMethod& method, double dt, long steps) {
    fs::remove(work_ + "/end.dump");
    run(scene, method, dt, steps);
    try {
      return scene.error(last_frame({work_ + "/end.dump"}));
    } catch (const DataError&) {  // numbers beyond all bounds
      return INFINITY;
    }
  }

  /// Median time of a step, s, at a step so short that the run takes `timed_steps`.
  double seconds_per_step(const AccuracyScene& scene, const AccuracyMethod& method) {
    const OneProcessor pinned;
    const long steps = settings_.timed_steps;
    std::vector<double> times;
    for (int k = 0; k < settings_.repeats; ++k)
      times.push_back(loop_time(run(scene, method, scene.duration / steps, steps)) / steps);
    std::sort(times.begin(), times.end());
    const std::size_t n = times.size();
    return 0.5 * (times[(n - 1) / 2] + times[n / 2]);
  }

 private:
  std::string run(const AccuracyScene& scene, const AccuracyMethod& method, double dt, long steps) {
    return run_deck(liggghts_, settings_.inputs + "/accuracy/" + scene.deck,
                    scene.variables_for(method, dt, steps), work_);
  }

  const AccuracySettings& settings_;
  Liggghts liggghts_;
  std::string work_;
};

}  // namespace

std::vector<AccuracyRow> measure_accuracy(const AccuracySettings& settings,
                                          const std::string& folder, std::ostream& progress) {
  claim(folder, settings);
  const std::string file = folder + "/accuracy.csv";
  const auto known = read_rows(file);
  Measurement measurement(settings, folder);
  std::vector<AccuracyRow> rows;
  for (const auto& scene_name : settings.scenes) {
    const auto scene = accuracy_scene(scene_name);
    for (const auto& method_name : settings.methods) {
      const auto method = accuracy_method(method_name);
      double per_step = 0;
      for (const auto& row : known)
        if (row.scene == scene.name && row.method == method.name)
          per_step = row.seconds / row.force_evaluations;
      long runs = 0;
      for (const double wanted : settings.steps) {
        const long steps = scene.steps(wanted);
        const double dt = scene.step(wanted);
        AccuracyRow row{scene.name,
                        method.name,
                        method.order,
                        scene.contact_time / dt,
                        0,
                        static_cast<double>(steps),
                        0};
        const auto same = [&](const AccuracyRow& other) {
          return other.scene == row.scene && other.method == row.method &&
                 std::fabs(other.steps_per_contact / row.steps_per_contact - 1) < 1e-9;
        };
        const auto found = std::find_if(known.begin(), known.end(), same);
        if (found != known.end()) {
          rows.push_back(*found);
          continue;
        }
        if (per_step == 0) per_step = measurement.seconds_per_step(scene, method);
        row.error = measurement.error(scene, method, dt, steps);
        row.seconds = per_step * static_cast<double>(steps);
        std::ofstream out(file, std::ios::app | std::ios::binary);
        out << text(row) << std::flush;
        if (!out) throw DataError(file + ": cannot be written");
        rows.push_back(row);
        ++runs;
      }
      progress << scene.name << ' ' << method.name << ": " << settings.steps.size() << " steps, "
               << (runs == 0 ? "all known" : std::to_string(runs) + " run") << std::endl;
    }
  }
  fs::remove_all(folder + "/work");
  return rows;
}

}  // namespace rodpack
