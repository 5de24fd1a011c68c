// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "campaigns/accuracy/accuracy_folder.h"
#include "campaigns/launch/step_timing.h"
#include "reading/csv_file.h"
#include "reading/data_error.h"
#include "reading/dump.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {

namespace fs = std::filesystem;

namespace {

const std::string header = "scene,method,order,steps_per_contact,error,force_evaluations,seconds";

std::string text(const AccuracyRow& row) {
  return csv_line({row.scene, row.method, std::to_string(row.order),
                   number_text(row.steps_per_contact, 12), number_text(row.error, 12),
                   number_text(row.force_evaluations), number_text(row.seconds, 6)});
}

std::vector<AccuracyRow> read_rows(const std::string& file) {
  const Table table = resume_table(file, header);
  const auto &scene = table.words("scene"), &method = table.words("method");
  const auto order = table.whole_numbers("order");
  const auto& steps_per_contact = table.column("steps_per_contact");
  const auto& error = table.column("error");
  const auto& force_evaluations = table.column("force_evaluations");
  const auto& seconds = table.finite("seconds");
  std::vector<AccuracyRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!(error[i] >= 0)) table.refuse(i, "error", "an error of 0 or more");
    if (!(seconds[i] > 0)) table.refuse(i, "seconds", "a time above 0");
    for (const char* name : {"steps_per_contact", "force_evaluations"})
      if (!(table.finite(name)[i] > 0)) table.refuse(i, name, "a number above 0");
  }
  for (std::size_t i = 0; i < table.rows(); ++i)
    rows.push_back({scene[i], method[i], static_cast<int>(order[i]), steps_per_contact[i], error[i],
                    force_evaluations[i], seconds[i]});
  return rows;
}

double error_of(const AccuracyScene& scene, const std::string& folder) {
  try {
    return scene.error(last_frame({folder + "/work/end.dump"}));
  } catch (const DataError&) {  // numbers beyond all bounds
    return INFINITY;
  }
}

/// Measures the median time of a step, s, at a step so short that the run takes `timed_steps`.
double seconds_per_step(const AccuracySettings& settings, const std::string& folder,
                        const AccuracyScene& scene, const AccuracyMethod& method) {
  const ProcessorPin pinned(1);
  const long steps = settings.timed_steps;
  const auto variables =
      scene.variables_for(method, scene.duration / static_cast<double>(steps), steps);
  std::vector<double> times;
  for (int k = 0; k < settings.repeats; ++k)
    times.push_back(time_per_step(run_accuracy_deck(settings, folder, scene.deck, variables)));
  return median(times);
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
