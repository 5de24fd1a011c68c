// SPDX-License-Identifier: GPL-2.0-or-later
// A slide in space whose direction turns, until it stops: a sphere on a floor that is tilted across
// its way.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "deck.h"
#include "liggghts_run.h"
#include "table.h"

using namespace rodpack::test;

namespace {

/// A sphere lies on the floor y = 0, pressed in by m g_n / k_n, and slides along x while the
/// gravity g_t pulls along z. Its surface's velocity u at the contact, at the angle psi to g_t, has
/// under a force against it, that of a stiff spring,
///   du/dt = -A + g_t cos(psi), u dpsi/dt = -g_t sin(psi), A = mu m g_n (1/m + l^2 / I),
/// so that u sin(psi) / tan(psi/2)^(A/g_t) keeps its value, whatever the time step.
struct TurningSlide {
  double g_n = 9.81, g_t = 5, mu = 0.3, speed = 0.3, eta = 0.01;
  double radius = 1.5e-3, k = 1000, kt = 500, duration = 0.016;
  std::string events = "yes";

  double mass() const { return 2500 * 4.0 / 3 * M_PI * std::pow(radius, 3); }
  double overlap() const { return mass() * g_n / k; }
  double lever() const { return radius - 0.5 * overlap(); }
  double invariant(const Table& body) const {
    const auto at = [&](const char* name) { return body.column(name).front(); };
    // v + omega x (-l y)
    const double across = at("vx") + lever() * at("omegaz");
    const double along = at("vz") - lever() * at("omegax");
    const double inertia = 0.4 * radius * radius;  // per mass
    const double power = mu * g_n * (1 + lever() * lever() / inertia) / g_t;
    return across / std::pow(std::tan(0.5 * std::atan2(across, along)), power);
  }

  /// Body and time step after a quarter of the run, and at its end.
  std::pair<Table, Table> run(int steps) const {
    const double height = radius - overlap();
    const auto run = run_liggghts(
        Deck()
            .box("-0.02 0.02 -0.02 0.02 -0.02 0.02")
            .stiffness(exact(k), exact(kt))
            .damping(exact(eta))
            .friction(exact(mu))
            .timestep(exact(duration / steps))
            .with(
                "fix gravity all gravity " + exact(std::hypot(g_n, g_t)) + " vector 0 " +
                exact(-g_n) + " " + exact(g_t) +
                "\nfix floor all wall/gran model spring_dashpot tangential spring_dashpot "
                "primitive type 1 yplane 0\n"
                "fix ball all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 1 "
                "aspect_ratio 1 diameter " +
                exact(2 * radius) +
                " surface smooth density constant 2500 planar no\n"
                "fix mix all particledistribution/discrete 15485867 1 ball 1.0\n" +
                one_particle("floor", {0, height, 0}, "vel constant " + exact(speed) + " 0 0.01") +
                "fix motion all multisphere/ab order 3 planar no events " + events +
                "\nrun 1\nrun " + std::to_string(steps / 4) +
                "\nwrite_dump all multisphere/body begin.dump modify format %.17g\nrun " +
                std::to_string(3 * steps / 4) +
                "\nwrite_dump all multisphere/body end.dump modify format %.17g\n"));
    if (run.exit_code != 0) throw std::runtime_error(run.output);
    return {read_dump(run.folder / "begin.dump"), read_dump(run.folder / "end.dump")};
  }

  /// Relative change of the invariant over the last three quarters of the run.
  double drift(int steps) const {
    const auto [begin, end] = run(steps);
    return std::fabs(invariant(end) / invariant(begin) - 1);
  }

  /// Where the run ends, along and across, m.
  std::array<double, 2> end(int steps) const {
    const Table body = run(steps).second;
    return {body.column("x").front(), body.column("z").front()};
  }
};

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

}  // namespace

// A slip of micrometres turns a spring of femtometres against the velocity at once: that of a slide
// whose spring carries the cap of 0.1 mN at 5e8 N/m.
TEST(SlidingInSpace, UnderAStiffSpringItTurnsWithTheVelocity) {
  for (const double eta : {1e-5, 1e-4}) {
    TurningSlide slide;
    slide.kt = 5e8;
    slide.eta = eta;
    EXPECT_LT(slide.drift(800), 1e-9);
  }
}

// The slide turns towards g_t and stops within the run, from where on the sphere rolls: its place
// is off by what the spring that is left at the stop is, of 0.21 um.
TEST(SlidingInSpace, ASlideThatTurnsAndThenSticksIsOfThirdOrderWithEvents) {
  for (const double g_t : {1.0, 2.0, 5.0}) {
    TurningSlide slide;
    slide.eta = 0.2;
    slide.g_t = g_t;
    slide.duration = 0.06;
    const auto reference = slide.end(25600);
    const double coarse = distance(slide.end(800), reference);
    const double fine = distance(slide.end(3200), reference);
    EXPECT_GT(observed_order(coarse, fine, 4), 2.6) << g_t;
    EXPECT_LT(coarse, 0.04 * 0.21e-6);
    // Without events it comes to the same end.
    slide.events = "no";
    EXPECT_LT(distance(slide.end(3200), reference), 5e-3 * 0.21e-6);
  }
}
