// SPDX-License-Identifier: GPL-2.0-or-later
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "accuracy_folder.h"
#include "rodpack/data_error.h"
#include "rodpack/text.h"

namespace rodpack {

namespace fs = std::filesystem;

namespace {

const std::string header = "scene,method,order,steps_per_contact,error,force_evaluations,seconds";

std::string text(const AccuracyRow& row) {
  return row.scene + "," + row.method + "," + std::to_string(row.order) + "," +
         number_text(row.steps_per_contact, 12) + "," + number_text(row.error, 12) + "," +
         number_text(row.force_evaluations) + "," + number_text(row.seconds, 6);
}

std::vector<AccuracyRow> read_rows(const std::string& file) {
  std::vector<AccuracyRow> rows;
  for (const auto& f : read_fields(file, header)) {
    try {
      rows.push_back({f[0], f[1], std::stoi(f[2]), std::stod(f[3]), std::stod(f[4]),
                      std::stod(f[5]), std::stod(f[6])});
    } catch (const std::logic_error&) {
      throw DataError(file + ": expected numbers after scene and method " + f[0] + ", " + f[1]);
    }
  }
  return rows;
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

double error_of(const AccuracyScene& scene, const std::string& folder) {
  try {
    return scene.error(last_frame({folder + "/work/end.dump"}));
  } catch (const DataError&) {  // numbers beyond all bounds
    return INFINITY;
  }
}

/// Median time of a step, s, at a step so short that the run takes `timed_steps`.
double seconds_per_step(const AccuracySettings& settings, const std::string& folder,
                        const AccuracyScene& scene, const AccuracyMethod& method) {
  const OneProcessor pinned;
  const long steps = settings.timed_steps;
  const auto variables =
      scene.variables_for(method, scene.duration / static_cast<double>(steps), steps);
  std::vector<double> times;
  for (int k = 0; k < settings.repeats; ++k)
    times.push_back(loop_time(run_accuracy_deck(settings, folder, scene.deck, variables)) /
                    static_cast<double>(steps));
  std::sort(times.begin(), times.end());
  const std::size_t n = times.size();
  return 0.5 * (times[(n - 1) / 2] + times[n / 2]);
}

}  // namespace

std::vector<AccuracyRow> measure_accuracy(const AccuracySettings& settings,
                                          const std::string& folder, std::ostream& progress) {
  claim_folder(folder, settings);
  const std::string file = folder + "/accuracy.csv";
  const auto known = read_rows(file);
  std::vector<AccuracyRow> rows;
  for (const auto& scene_name : settings.scenes) {
    if (scene_name == beds_scene || scene_name == stability_scene) continue;
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
        if (per_step == 0) per_step = seconds_per_step(settings, folder, scene, method);
        run_accuracy_deck(settings, folder, scene.deck, scene.variables_for(method, dt, steps));
        row.error = error_of(scene, folder);
        row.seconds = per_step * static_cast<double>(steps);
        append_line(file, text(row));
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
