// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "campaigns/accuracy/accuracy.h"
#include "campaigns/accuracy/accuracy_references.h"
#include "reading/angles.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/geometry/mass_properties.h"

namespace rodpack {
namespace {

constexpr double density = 2500;   // kg/m^3, as in the decks
constexpr double diameter = 3e-3;  // m
constexpr double gap = 1e-4;       // m, before the first touch of the first copy
constexpr double lost = std::numeric_limits<double>::infinity();

std::string exact(double value) { return number_text(value, 17); }

void set_law(AccuracyScene& scene, const ReferenceLaw& law) {
  scene.variables["k"] = exact(law.kn);
  scene.variables["kt"] = exact(law.kt);
  scene.variables["eta_n"] = exact(law.eta_n);
  scene.variables["eta_t"] = exact(law.eta_t);
  scene.variables["mu"] = exact(law.mu);
}

double square(double x) { return x * x; }

/// Returns the root mean square of error(copy) over the copies; infinite when bodies were lost.
template <class Error>
double rms(const Frame& end, int copies, int bodies_each, Error error) {
  if (end.rows != static_cast<std::size_t>(copies * bodies_each)) return lost;
  double sum = 0;
  for (int copy = 0; copy < copies; ++copy) sum += square(error(copy));
  return std::sqrt(sum / copies);
}

SpherePair sphere_pair() {
  SpherePair pair;
  pair.radius = 0.5 * diameter;
  pair.mass = density * 4 / 3 * pi * std::pow(pair.radius, 3);
  return pair;
}

AccuracyScene collision(const std::string& name, const SpherePair& pair) {
  AccuracyScene scene;
  scene.name = name;
  scene.deck = "in.collision";
  scene.contact_time = pi * std::sqrt(0.5 * pair.mass / pair.law.kn);
  scene.copies = 12;
  scene.phase_speed = 2 * pair.speed;
  scene.duration = gap / (2 * pair.speed) + (1.0 / 3 + 1.6) * scene.contact_time;
  set_law(scene, pair.law);
  scene.variables["pairs"] = std::to_string(scene.copies);
  scene.variables["speed"] = exact(pair.speed);
  scene.variables["offset"] = exact(pair.offset);
  scene.variables["spin"] = exact(pair.spin);
  scene.variables["distance"] =
      exact(std::sqrt(square(2 * pair.radius) - square(pair.offset)) + gap);
  return scene;
}

AccuracyScene head_on(const std::string& name, double eta_n) {
  SpherePair pair = sphere_pair();
  pair.law.eta_n = eta_n;
  auto scene = collision(name, pair);
  const double expected = 2 * pair.speed * restitution_coefficient(eta_n);
  scene.error_is = "rebound speed, relative; rms over 12 pairs";
  scene.reference = "closed form";
  scene.error = [expected, copies = scene.copies](const Frame& end) {
    const auto& vx = end.column("vx");
    return rms(end, copies, 2, [&](int p) { return (vx[2 * p + 1] - vx[2 * p]) / expected - 1; });
  };
  return scene;
}

double distance(const PairOutcome& a, const PairOutcome& b, const SpherePair& pair) {
  return std::sqrt(square(a.vx - b.vx) + square(a.vy - b.vy) +
                   square(pair.radius * (a.omega - b.omega))) /
         (2 * pair.speed);
}

const char* two_schemes = "events located, Runge-Kutta 4 against Dormand-Prince 5";

AccuracyScene oblique(const std::string& name, const SpherePair& pair) {
  auto scene = collision(name, pair);
  const double h = scene.contact_time / 3000;
  const auto expected = collide(pair, h, Scheme::dormand_prince_5);
  scene.agreement = distance(expected, collide(pair, h, Scheme::runge_kutta_4), pair);
  scene.error_is =
      "velocities after, spins times radius included, over the closing speed; rms over 12 pairs";
  scene.reference = two_schemes;
  scene.error = [expected, pair, copies = scene.copies](const Frame& end) {
    const auto &vx = end.column("vx"), &vy = end.column("vy"), &omega = end.column("omegaz");
    return rms(end, copies, 2, [&](int p) {
      const int i = 2 * p, j = i + 1;
      return distance({vx[i] - vx[j], vy[i] - vy[j], omega[i] + omega[j]}, expected, pair);
    });
  };
  return scene;
}

// Springs only, with k_t / k_n = 2/7: both periods of the contact are then equal, and the
// tangential spring is at rest when the contact ends, so that even the end does not slide.
AccuracyScene oblique_stick() {
  SpherePair pair = sphere_pair();
  pair.law.eta_n = pair.law.eta_t = 0;
  pair.law.kt = pair.law.kn * 2 / 7;
  pair.law.mu = 1e6;  // a last slip would last as long as the cap stays below the spring's force
  pair.offset = 1.5e-3;
  return oblique("oblique_stick", pair);
}

AccuracyScene oblique_slip() {
  SpherePair pair = sphere_pair();
  pair.offset = 1.5e-3;
  return oblique("oblique_slip", pair);
}

RodOnFloor smooth_rod() {
  const ChainShape shape{5, diameter, 0.5, 0, diameter};
  const auto solid = mass_properties(shape, density, MassRule::reference, false);
  RodOnFloor rod;
  rod.mass = solid.mass;
  rod.inertia = solid.inertia[2];
  rod.radius = 0.5 * diameter;
  for (const auto& centre : sphere_centres(shape)) rod.places.push_back(centre[0]);
  return rod;
}

AccuracyScene rods(const std::string& name, const RodOnFloor& rod, double angle) {
  AccuracyScene scene;
  scene.name = name;
  scene.deck = "in.rods";
  const double lever = rod.places.back() * std::cos(angle);
  const double effective = 1 / (1 / rod.mass + lever * lever / rod.inertia);
  scene.contact_time = pi * std::sqrt(effective / rod.law.kn);
  scene.copies = 8;
  scene.gravity = rod.gravity;
  set_law(scene, rod.law);
  scene.variables["rods"] = std::to_string(scene.copies);
  scene.variables["gravity"] = exact(rod.gravity);
  scene.variables["orientation"] =
      exact(std::cos(angle / 2)) + " 0 0 " + exact(std::sin(angle / 2));
  return scene;
}

AccuracyScene rod_drop() {
  const RodOnFloor rod = smooth_rod();
  const double speed = 0.5, angle = pi / 3;
  const PlanarState start = {
      0, rod.radius + rod.places.back() * std::sin(angle) + gap, angle, 0, -speed, 0};
  auto scene = rods("rod_drop", rod, angle);
  scene.phase_speed = speed;
  scene.duration = gap / speed + (1.0 / 3 + 1.6) * scene.contact_time;
  scene.variables["height"] = exact(start.y);
  scene.variables["vy"] = exact(start.vy);
  const double arm = rod.radius + rod.places.back();
  const auto off = [=](double vx, double vy, double omega, const PlanarState& expected) {
    return std::sqrt(square(vx - expected.vx) + square(vy - expected.vy) +
                     square(arm * (omega - expected.omega))) /
           speed;
  };
  const auto expected = move(rod, start, scene.duration, 3e-7, Scheme::dormand_prince_5);
  const auto other = move(rod, start, scene.duration, 3e-7, Scheme::runge_kutta_4);
  scene.agreement = off(other.vx, other.vy, other.omega, expected);
  scene.error_is =
      "velocity after, spin times half the length included, over the impact speed; rms over 8 rods";
  scene.reference = two_schemes;
  scene.error = [=, copies = scene.copies](const Frame& end) {
    const auto &vx = end.column("vx"), &vy = end.column("vy"), &omega = end.column("omegaz");
    return rms(end, copies, 1, [&](int p) { return off(vx[p], vy[p], omega[p], expected); });
  };
  return scene;
}

AccuracyScene rod_rocking(const std::string& name, double mu) {
  RodOnFloor rod = smooth_rod();
  rod.law.mu = mu;
  rod.gravity = 9.81;
  const double speed = 0.05, angle = 5 * pi / 180, shift = 2.237e-6, spacing = 0.03;
  auto scene = rods(name, rod, angle);
  scene.duration = 0.01;
  scene.ends_on_time = true;
  PlanarState start = {0, rod.radius + rod.places.back() * std::sin(angle) + 2e-5, angle, 0, -speed,
                       0};
  scene.variables["height"] = exact(start.y);
  scene.variables["shift"] = exact(shift);
  scene.variables["vy"] = exact(start.vy);
  const double arm = rod.radius + rod.places.back();
  const auto off = [=](double x, double y, double turned, const PlanarState& expected) {
    return std::sqrt(square(x - expected.x) + square(y - expected.y) +
                     square(arm * std::remainder(turned - expected.angle, 2 * pi))) /
           (arm * angle);
  };
  std::vector<PlanarState> expected;
  for (int p = 0; p < scene.copies; ++p) {
    expected.push_back(move(rod, start, scene.duration, 3e-7, Scheme::dormand_prince_5));
    const auto other = move(rod, start, scene.duration, 3e-7, Scheme::runge_kutta_4);
    scene.agreement =
        std::max(scene.agreement, off(other.x, other.y, other.angle, expected.back()));
    start.y += shift;
  }
  scene.error_is =
      "place after 10 ms, angle times half the length included, over the lift of the end at the "
      "start; rms over 8 rods";
  scene.reference = two_schemes;
  scene.error = [=, copies = scene.copies](const Frame& end) {
    const auto &x = end.column("x"), &y = end.column("y"), &turned = end.column("angle");
    return rms(end, copies, 1,
               [&](int p) { return off(x[p] - spacing * p, y[p], turned[p], expected[p]); });
  };
  return scene;
}

AccuracyScene spin(const std::string& name, bool planar) {
  const RodOnFloor rod = smooth_rod();
  auto scene = rods(name, rod, 0);
  scene.contact_time = pi * std::sqrt(0.5 * sphere_pair().mass / rod.law.kn);
  scene.planar = planar;
  scene.copies = 1;
  scene.duration = 0.02;
  scene.asymptotic_from = 0;
  scene.ends_on_time = true;
  const std::array<double, 4> start =
      planar ? std::array<double, 4>{1, 0, 0, 0} : std::array<double, 4>{0.5, 0.5, 0.5, 0.5};
  const std::array<double, 3> omega =
      planar ? std::array<double, 3>{0, 0, 800} : std::array<double, 3>{480, 800, -320};
  scene.variables["rods"] = "1";
  scene.variables["planar"] = planar ? "1" : "0";
  scene.variables["height"] = "0.03";
  scene.variables["vy"] = "0";
  scene.variables["omega"] = exact(omega[0]) + " " + exact(omega[1]) + " " + exact(omega[2]);
  scene.variables["orientation"] =
      exact(start[0]) + " " + exact(start[1]) + " " + exact(start[2]) + " " + exact(start[3]);
  const ChainShape shape{5, diameter, 0.5, 0, diameter};
  const auto moments = mass_properties(shape, density, MassRule::reference, false).inertia;
  const auto expected = symmetric_top(start, omega, moments[0], moments[1], scene.duration);
  scene.error_is = "orientation after 20 ms, rad";
  scene.reference = "closed form";
  scene.error = [expected](const Frame& end) {
    if (end.rows != 1) return lost;
    double minus = 0, plus = 0;  // a quaternion and its negative are the same orientation
    const char* names[] = {"qw", "qx", "qy", "qz"};
    for (int d = 0; d < 4; ++d) {
      const double q = end.column(names[d])[0];
      minus += square(q - expected[d]);
      plus += square(q + expected[d]);
    }
    return 2 * std::sqrt(std::min(minus, plus));
  };
  return scene;
}

struct Named {
  std::string name;
  AccuracyScene (*make)();
};
const std::vector<Named>& scenes() {
  static const std::vector<Named> all = {
      {"collision_0", [] { return head_on("collision_0", 0); }},
      {"collision_0.1", [] { return head_on("collision_0.1", 0.1); }},
      {"collision_0.2", [] { return head_on("collision_0.2", 0.2); }},
      {"collision_0.35", [] { return head_on("collision_0.35", 0.35); }},
      {"collision_0.5", [] { return head_on("collision_0.5", 0.5); }},
      {"oblique_stick", oblique_stick},
      {"oblique_slip", oblique_slip},
      {"rod_drop", rod_drop},
      {"spin_planar", [] { return spin("spin_planar", true); }},
      {"spin_3d", [] { return spin("spin_3d", false); }},
      {"rod_rocking", [] { return rod_rocking("rod_rocking", 0.3); }},
      {"rod_rocking_smooth", [] { return rod_rocking("rod_rocking_smooth", 0); }}};
  return all;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

const std::vector<std::string>& accuracy_scene_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const auto& scene : scenes()) result.push_back(scene.name);
    return result;
  }();
  return names;
}

AccuracyScene accuracy_scene(const std::string& name) {
  for (const auto& scene : scenes())
    if (scene.name == name) return scene.make();
  throw DataError("scene '" + name + "': expected one of " + list(accuracy_scene_names()));
}

const std::vector<std::string>& accuracy_method_names() {
  static const std::vector<std::string> names = {"builtin", "leapfrog", "ab1",  "ab2", "ab3",
                                                 "ab4",     "ab2e",     "ab3e", "ab4e"};
  return names;
}

AccuracyMethod accuracy_method(const std::string& name) {
  const auto& names = accuracy_method_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw DataError("method '" + name + "': expected one of " + list(names));
  if (name == "builtin") return {name, 2, "multisphere"};
  if (name == "leapfrog") return {name, 2, "multisphere/ab order 0"};
  const std::string order = name.substr(2, 1);
  return {name, std::stoi(order),
          "multisphere/ab order " + order + " events " + (name.back() == 'e' ? "yes" : "no")};
}

long AccuracyScene::steps(double steps_per_contact) const {
  const double wanted = duration / contact_time * steps_per_contact;
  return ends_on_time ? std::lround(wanted) : static_cast<long>(std::ceil(wanted));
}

double AccuracyScene::step(double steps_per_contact) const {
  return ends_on_time ? duration / static_cast<double>(steps(steps_per_contact))
                      : contact_time / steps_per_contact;
}

DeckVariables AccuracyScene::variables_for(const AccuracyMethod& method, double dt,
                                           long steps) const {
  DeckVariables all = variables;
  const bool stock = method.name == "builtin";
  all["integrator"] = method.integrator + (stock ? "" : planar ? " planar yes" : " planar no");
  all["dt"] = exact(dt);
  all["steps"] = std::to_string(steps);
  if (phase_speed > 0) all["shift"] = exact(phase_speed * dt / copies);
  // Stock multisphere adds the second half of a kick in the step of birth, without a first.
  if (stock && gravity > 0) all["vy"] = exact(std::stod(all.at("vy")) + 0.5 * gravity * dt);
  return all;
}

}  // namespace rodpack
