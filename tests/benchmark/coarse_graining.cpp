// SPDX-License-Identifier: GPL-2.0-or-later
// Accuracy against time of coarse_graining.h on a settled packing:
//   coarse_graining_benchmark BODIES CONTACTS OUT [--tiles N] [--repeats N]
// The packing of the last frames stands N times side by side. Writes OUT.csv and OUT.png, .svg, and
// prints each method's error and median time. Errors are largest deviations over the grid in units
// of the field's largest value, against closed-form lines and a cut-off at 9 w.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "analysis/fields.h"
#include "figures/figure.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace {
using namespace rodpack;

struct Scene {
  std::vector<Particle> particles;
  std::vector<SphereContact> contacts;
  double scale;      // w = 3 l_axial, m
  Vector low, high;  // of the grid, m
};

Scene read_scene(const std::string& bodies, const std::string& contacts, int tiles) {
  const Frame body_frame = last_frame(find_dumps({bodies}));
  const Frame contact_frame = last_frame(find_dumps({contacts}));
  const Packing packing = read_packing(body_frame);
  const auto contact_rows = read_contacts(contact_frame);
  const auto particle_rows =
      read_particles(body_frame, body_frame.column("area"), sum_pairs(contact_rows).pairs);
  Scene scene;
  scene.scale = 3 * packing.axial_length();
  const double width = packing.walls.width();
  for (int tile = 0; tile < tiles; ++tile) {
    const double shift = tile * width;
    for (Particle particle : particle_rows) {
      particle.centre[0] += shift;
      scene.particles.push_back(particle);
    }
    const long ids = static_cast<long>(tile) * 10000000;
    for (SphereContact contact : contact_rows) {
      contact.i += ids;
      contact.j += ids;
      for (Vector* place : {&contact.point, &contact.centre_i, &contact.centre_j})
        (*place)[0] += shift;
      scene.contacts.push_back(contact);
    }
  }
  scene.low = {{packing.walls.left, packing.walls.floor, 0}};
  scene.high = {{packing.walls.left + tiles * width, packing.surface + scene.scale, 0}};
  return scene;
}

struct Method {
  std::string name, line;
  double cutoff, spacing;  // in w
  bool couple = false;     // the couple stress as well
};

std::vector<Field> evaluate(const Scene& scene, const Method& method) {
  const AveragingKernel kernel(KernelShape::gaussian, 2, scene.scale, method.cutoff);
  CoarseGrainingOptions options;
  options.line = LineRule::named(method.line, 1e-6);
  options.couple_stress = method.couple;
  CoarseGraining averages(
      kernel, filling_grid(2, scene.low, scene.high, method.spacing * scene.scale), options);
  const ContactPairs pairs = sum_pairs(scene.contacts);
  for (const Interaction& interaction : pairs.interactions) averages.add(interaction);
  for (const Particle& particle : scene.particles) averages.add(particle);
  return averages.fields();
}

// Largest deviation of any component, in units of the field's largest value.
double deviation(const std::vector<Field>& fields, const std::vector<Field>& reference,
                 const std::string& name) {
  double worst = 0, scale = 0;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].name != name) continue;
    for (std::size_t c = 0; c < fields[f].values.size(); ++c)
      for (std::size_t i = 0; i < fields[f].values[c].size(); ++i) {
        scale = std::max(scale, std::fabs(reference[f].values[c][i]));
        worst = std::max(worst, std::fabs(fields[f].values[c][i] - reference[f].values[c][i]));
      }
  }
  return scale > 0 ? worst / scale : 0;
}

// Largest error of cubic interpolation of the pressure half-way between the grid's
// places, along x: what the grid's spacing costs in accuracy.
double interpolation_error(const Scene& scene, const Method& method) {
  Method finer = method;
  const Grid grid = filling_grid(2, scene.low, scene.high, method.spacing * scene.scale);
  finer.spacing = grid.spacing[0] / scene.scale / 2;
  const auto pressure = [](const std::vector<Field>& fields) {
    std::vector<double> values;
    for (const Field& field : fields)
      if (field.name == "contact_stress")
        for (std::size_t i = 0; i < field.values[0].size(); ++i)
          values.push_back(0.5 * (field.values[0][i] + field.values[3][i]));
    return values;
  };
  const auto fine = pressure(evaluate(scene, finer));
  const Grid fine_grid = filling_grid(2, scene.low, scene.high, finer.spacing * scene.scale);
  const auto nx = static_cast<std::size_t>(fine_grid.count[0]);
  double worst = 0;
  for (std::size_t row = 0; row < fine.size(); row += nx)
    for (std::size_t i = 3; i + 3 < nx; i += 2) {
      const double* p = fine.data() + row + i;
      const double cubic = (9 * (p[-1] + p[1]) - (p[-3] + p[3])) / 16;
      worst = std::max(worst, std::fabs(cubic - *p));
    }
  return worst / *std::max_element(fine.begin(), fine.end());
}

double median_seconds(const Scene& scene, const Method& method, int repeats) {
  std::vector<double> seconds;
  for (int k = 0; k < repeats; ++k) {
    const auto start = std::chrono::steady_clock::now();
    evaluate(scene, method);
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

struct Result {
  Method method;
  double stress_error, density_error, couple_error, interpolation, seconds;
};

// Error of the contact stress against time: lines of methods at all cut-offs.
void draw(const std::vector<Result>& results, const std::string& stem) {
  struct Line {
    std::string rule, title, colour;
  };
  const std::vector<Line> lines{
      {"1", "1 point", "#56B4E9"},         {"2", "2 points", "#009E73"},
      {"3", "3 points", colour::blue},     {"4", "4 points", "#CC79A7"},
      {"exact", "closed form", "#000000"}, {"auto", "auto", colour::vermilion}};
  std::string data, plot = "plot ";
  int number = 0;
  for (const auto& [line, title, colour] : lines) {
    std::vector<double> seconds, error;
    for (const Result& result : results)
      if (result.method.line == line && result.method.spacing == 0.25 && !result.method.couple) {
        seconds.push_back(result.seconds);
        error.push_back(std::max(result.stress_error, 1e-16));
      }
    const std::string block = "m" + std::to_string(++number);
    data += datablock(block, {seconds, error});
    plot += (number > 1 ? ", $" : "$") + block + " using 1:2 with linespoints pointtype " +
            std::to_string(number) + " linewidth 1.4 linecolor '" + colour + "' title '" + title +
            "'";
  }
  draw_figure(stem, 1.4,
              data +
                  "set xlabel 'time for all fields (s)'\n"
                  "set ylabel 'largest error of the contact stress'\n"
                  "set logscale xy\nset format y '10^{%T}'\nset key outside right\n" +
                  plot + ", 1e-6 with lines dashtype 2 linecolor '" + colour::grey +
                  "' title '10^{-6}'\n");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Accuracy against time of the coarse-grained fields of a settled packing.");
  std::string bodies, contacts, out;
  int tiles = 1, repeats = 5;
  app.add_option("bodies", bodies, "bodies dump")->required();
  app.add_option("contacts", contacts, "contacts dump of the same step")->required();
  app.add_option("out", out, "start of the names of the files to write")->required();
  app.add_option("--tiles", tiles, "copies side by side")->check(CLI::Range(1, 1000));
  app.add_option("--repeats", repeats, "timed runs of each method")->check(CLI::Range(5, 1000));
  CLI11_PARSE(app, argc, argv);
  try {
    const Scene scene = read_scene(bodies, contacts, tiles);
    const ContactPairs pairs = sum_pairs(scene.contacts);
    std::printf("%zu particles, %zu contacts, %zu pairs and wall contacts, w = %g m\n",
                scene.particles.size(), scene.contacts.size(), pairs.interactions.size(),
                scene.scale);
    std::vector<Method> methods;
    for (const std::string line : {"1", "2", "3", "4", "auto", "exact"})
      for (const double cutoff : {3.0, 4.0, 5.0, gaussian_cutoff(1e-6, 2), 6.0, 7.0, 8.0})
        methods.push_back({line, line, cutoff, 0.25});
    for (const double spacing : {0.5, 1.0 / 3, 1.0 / 6, 0.125})
      methods.push_back({"auto", "auto", gaussian_cutoff(1e-6, 2), spacing});
    for (const std::string line : {"2", "3", "4", "auto", "exact"})
      methods.push_back({line, line, gaussian_cutoff(1e-6, 2), 0.25, true});

    std::map<std::pair<double, bool>, std::vector<Field>> references;
    std::vector<Result> results;
    for (const Method& method : methods) {
      auto& reference = references[{method.spacing, method.couple}];
      if (reference.empty())
        reference = evaluate(scene, {"reference", "exact", 9, method.spacing, method.couple});
      const auto fields = evaluate(scene, method);
      const bool grids =
          !method.couple && method.line == "auto" && method.cutoff == gaussian_cutoff(1e-6, 2);
      results.push_back({method, deviation(fields, reference, "contact_stress"),
                         deviation(fields, reference, "solid_fraction"),
                         deviation(fields, reference, "couple_stress"),
                         grids ? interpolation_error(scene, method) : 0,
                         median_seconds(scene, method, repeats)});
      const Result& r = results.back();
      std::printf(
          "line %-5s cut-off %.2f w, spacing %.3f w: stress %.1e, solid fraction %.1e, "
          "couple stress %.1e; %.3f s\n",
          method.line.c_str(), method.cutoff, method.spacing, r.stress_error, r.density_error,
          r.couple_error, r.seconds);
      if (grids) std::printf("   cubic interpolation between its places: %.1e\n", r.interpolation);
      std::fflush(stdout);
    }
    std::string csv =
        "line,cutoff_over_w,spacing_over_w,couple,contact_stress_error,solid_fraction_error,"
        "couple_stress_error,cubic_interpolation_error,median_s\n";
    for (const Result& r : results) {
      csv += r.method.line;
      for (const double value :
           {r.method.cutoff, r.method.spacing, r.method.couple ? 1.0 : 0.0, r.stress_error,
            r.density_error, r.couple_error, r.interpolation, r.seconds})
        csv += "," + number_text(value, 4);
      csv += "\n";
    }
    write_text(out + ".csv", csv);
    draw(results, out);
  } catch (const std::exception& error) {
    std::cerr << "coarse_graining_benchmark: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
