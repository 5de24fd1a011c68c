// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include "campaigns/accuracy/accuracy.h"
#include "cli/checks.h"
#include "cli/commands.h"
#include "figures/figure.h"
#include "reading/number_text.h"
#include "reading/text_file.h"
#include "timestep/advice.h"
#include "timestep/run_network.h"

namespace rodpack::cli {
namespace {

struct TimestepArguments {
  std::string run, stem;
  Collision collision;
  double error = 1e-3, speed = 0;
  int contacts = 1;
};

std::string short_number(double value) { return number_text(value, 4); }

void print_table(const std::vector<TimestepAdvice>& all, const TimestepAdvice* best, double error) {
  std::cout << "method   stable below  time step   steps per  error      steps per     held by\n"
               "         s             s           collision             simulated s\n";
  for (const TimestepAdvice& each : all) {
    char line[200];
    if (each.timestep > 0)
      std::snprintf(line, sizeof line, "%-8s %-13s %-11s %-10s %-10s %-13s %s%s\n",
                    each.integrator.name.c_str(), short_number(each.limit).c_str(),
                    short_number(each.timestep).c_str(),
                    short_number(each.steps_per_collision).c_str(),
                    short_number(each.error).c_str(), short_number(1 / each.timestep).c_str(),
                    each.held_by_stability ? "stability" : "error",
                    &each == best ? "   <- fewest steps" : "");
    else
      std::snprintf(line, sizeof line, "%-8s %-13s %s\n", each.integrator.name.c_str(),
                    short_number(each.limit).c_str(),
                    each.fewest_steps ? "unstable at any step"
                                      : ("error above " + short_number(error) + " with " +
                                         short_number(most_steps) + " steps per collision, too")
                                            .c_str());
    std::cout << line;
  }
}

void write_chart(const std::vector<TimestepAdvice>& all, const std::string& stem) {
  std::ostringstream table, plot;
  table << "method,steps_per_collision,error\n";
  std::string data;
  int plots = 0;
  for (const TimestepAdvice& each : all) {
    const std::string& name = each.integrator.name;
    std::vector<std::vector<double>> columns(2);
    for (const ErrorAtStep& at : each.chart) {
      if (!(at.error < 1)) continue;  // beyond the limit of stability
      table << name << ',' << number_text(at.steps_per_collision) << ',' << number_text(at.error, 4)
            << '\n';
      columns[0].push_back(at.steps_per_collision);
      columns[1].push_back(at.error);
    }
    data += datablock(name, columns);
    // In the colour of the same scheme without.
    const bool relaxes = each.integrator.relaxation_steps > 0;
    plot << (plots++ == 0 ? "plot $" : ", $") << name << " with lines linewidth 2 linecolor rgb '"
         << accuracy_colour(relaxes ? "leapfrog" : name) << "'"
         << (name == "builtin" ? " dashtype 2"
             : relaxes         ? " dashtype 3"
                               : "")
         << " title '" << name << "'";
  }
  write_text(stem + ".csv", table.str());
  draw_figure(stem, 1.4,
              data +
                  "set logscale xy\nset format y '10^{%T}'\nset grid\nset key bottom left\n"
                  "set xlabel 'steps per collision'\n"
                  "set ylabel 'error of the rebound speed'\n" +
                  plot.str() + "\n");
}

/// What the limit of stability depends on: the order, and what dashpots count.
typedef std::pair<int, double> Method;
Method method_of(const Integrator& integrator) {
  return {integrator.order, integrator.dashpot_share()};
}

/// The limits of all contacts of a bed for each of integrators().
std::map<Method, NetworkLimit> limits_of_bed(const RunNetwork& network) {
  std::map<Method, NetworkLimit> limits;
  for (const Integrator& integrator : integrators()) {
    const Method method = method_of(integrator);
    if (limits.count(method) > 0) continue;
    std::vector<NetworkContact> contacts = network.contacts;
    for (NetworkContact& contact : contacts) {
      contact.damping_n *= method.second;
      contact.damping_t *= method.second;
    }
    limits[method] = network_limit(method.first, network.bodies, contacts);
  }
  return limits;
}

void advise_on(const TimestepArguments& arguments) {
  Collision collision = arguments.collision;
  int on_one_line = arguments.contacts;
  std::map<Method, NetworkLimit> of_bed;
  if (!arguments.run.empty()) {
    const RunNetwork network = read_network(arguments.run);
    collision = {network.stiffness, network.damping_ratio, network.lightest};
    on_one_line = 1;
    of_bed = limits_of_bed(network);
    std::cout << arguments.run << ": " << network.bodies.size() << " particles, "
              << network.contacts.size() << " contacts, " << of_bed.begin()->second.contacts
              << " of the stiffest particle; time step " << short_number(network.timestep)
              << " s\n";
    if (network.mass_scaling > 0)
      std::cout << "its mass scaling of " << short_number(network.mass_scaling)
                << " is left out: limits are those of the particles' own inertia\n";
  }
  const auto limit_of = [&](const Integrator& integrator) {
    const double of_line =
        limit_of_contacts(integrator.order, collision, on_one_line, integrator.dashpot_share());
    const auto of_run = of_bed.find(method_of(integrator));
    return of_run == of_bed.end() ? of_line : std::min(of_line, of_run->second.timestep);
  };
  std::cout << "k_n = " << short_number(collision.stiffness)
            << " N/m, eta = " << short_number(collision.damping_ratio)
            << ", m = " << short_number(collision.mass) << " kg: a collision lasts "
            << short_number(collision.duration()) << " s";
  if (arguments.speed > 0)
    std::cout << ", overlaps by up to " << short_number(collision.largest_overlap(arguments.speed))
              << " m";
  std::cout << '\n';
  const auto all = advise(collision, arguments.error, limit_of);
  const TimestepAdvice* const best = cheapest(all);
  print_table(all, best, arguments.error);
  if (best) {
    const std::string step = short_number(best->timestep);
    std::cout << "in a deck: timestep " << step << "\n           fix ID all "
              << best->integrator.fix << '\n';
    if (best->integrator.relaxation_steps > 0)
      std::cout << "           fix ID all property/global dashpotRelaxation scalar "
                << short_number(best->integrator.relaxation_steps * best->timestep) << '\n';
  }
  if (!arguments.stem.empty()) {
    write_chart(all, arguments.stem);
    std::cout << "written: " << arguments.stem << ".csv .png .svg\n";
  }
}

}  // namespace

void add_timestep(CLI::App& app) {
  auto arguments = std::make_shared<TimestepArguments>();
  auto* command = app.add_subcommand(
      "timestep",
      "Which time step, with which integrator: stability limits, and the error of a head-on "
      "collision against its steps, for the linear contact law; of a finished run, or of numbers.");
  command->footer(
      "Examples:\n"
      "  rodpack timestep results/quick\n"
      "  rodpack timestep --kn 2000 --eta 0.2 --mass 8.8e-5 --contacts 30 --error 1e-4");
  auto* run =
      command->add_option("run", arguments->run, "run folder: its last frame has the contacts")
          ->check(existing_folder());
  const auto add = [&](const char* name, double& value, const char* help, double low, double high) {
    return command->add_option(name, value, help)->check(number(low, high))->excludes(run);
  };
  auto* kn = add("--kn", arguments->collision.stiffness,
                 "stiffness k_n of a particle, N/m; two in contact have half of it", 1e-9, 1e15);
  auto* mass =
      add("--mass", arguments->collision.mass, "mass of the lightest particle, kg", 1e-30, 1e12);
  auto* eta = command
                  ->add_option("--eta", arguments->collision.damping_ratio,
                               "damping ratio along the normal")
                  ->check(number(0, 1))
                  ->excludes(run);
  command
      ->add_option(
          "--contacts", arguments->contacts,
          "contacts that hold the stiffest particle, on one line (default 1; a settled bed "
          "of smooth rods of AR 5 has some 30)")
      ->check(whole_number(1, 100000))
      ->excludes(run);
  command
      ->add_option("--speed", arguments->speed,
                   "closing speed, m/s: says how far two particles overlap")
      ->check(positive_number(1e9));
  command
      ->add_option("--error", arguments->error,
                   "largest relative error of the rebound speed (default 0.001)")
      ->check(number(1e-12, 0.5));
  command
      ->add_option("-o,--output", arguments->stem,
                   "writes the chart of error against steps as <output>.csv .png .svg")
      ->check(stem_of_files())
      ->type_name("STEM");
  command->callback([=] {
    if (arguments->run.empty() && !(*kn && *mass && *eta))
      throw CLI::ValidationError("timestep",
                                 "expected a run folder, or all of --kn, --mass and --eta");
    advise_on(*arguments);
  });
}

}  // namespace rodpack::cli
