// SPDX-License-Identifier: GPL-2.0-or-later
#include "stock_models.h"

#include <fstream>

#include "deck.h"

namespace rodpack::test {
namespace {

/// What the models need beside Deck::hertz().
const char* const properties = R"(
fix q1 all property/global characteristicVelocity scalar 0.5
fix q2 all property/global cohesionEnergyDensity peratomtypepair 1 200
fix q3 all property/global coefficientRollingFriction peratomtypepair 1 0.1
fix q4 all property/global coefficientRollingViscousDamping peratomtypepair 1 0.1
fix q5 all property/global coefficientMaxElasticStiffness peratomtypepair 1 3
fix q6 all property/global coefficientAdhesionStiffness peratomtypepair 1 0.5
fix q7 all property/global coefficientPlasticityDepth peratomtypepair 1 0.1
fix q8 all property/global kn peratomtypepair 1 1000
fix q9 all property/global kt peratomtypepair 1 500
fix q10 all property/global gamman peratomtypepair 1 500
fix q11 all property/global gammat peratomtypepair 1 500
fix q12 all property/global surfaceLiquidContentInitial scalar 1
fix q13 all property/global surfaceTension scalar 0.07
fix q14 all property/global fluidViscosity scalar 1e-3
fix q15 all property/global contactAngle peratomtype 10
fix q16 all property/global minSeparationDistanceRatio scalar 1.01
fix q18 all property/global dampingRatioNormal peratomtypepair 1 0.2
fix q19 all property/global dampingRatioTangential peratomtypepair 1 0.2
fix q17 all property/global maxSeparationDistanceRatio scalar 1.1
)";

std::string number(double value) { return std::to_string(value); }

Deck hertz_deck(const std::string& models) {
  return Deck().hertz().models(models).timestep("1e-5");
}

std::string floor_of(const std::string& models, const std::filesystem::path* mesh = nullptr,
                     const std::string& settings = "") {
  std::string wall = "primitive type 1 yplane 0", lines;
  if (mesh) {
    std::ofstream stl(*mesh / "floor.stl");
    stl << "solid floor\n";
    for (const char* corners : {"0.002 0 -0.008\nvertex 0.018 0 0.008\nvertex 0.018 0 -0.008",
                                "0.002 0 -0.008\nvertex 0.002 0 0.008\nvertex 0.018 0 0.008"})
      stl << "facet normal 0 1 0\nouter loop\nvertex " << corners << "\nendloop\nendfacet\n";
    stl << "endsolid floor\n";
    lines = "fix stl all mesh/surface file " + (*mesh / "floor.stl").string() + " type 1\n";
    wall = "mesh n_meshes 1 meshes stl";
  }
  return lines + "fix floor all wall/gran " + models + " " + wall + " " + settings + "\n";
}

}  // namespace

std::vector<std::string> stock_models() {
  return {"model hertz tangential history cohesion sjkr rolling_friction epsd",
          "model hooke tangential history rolling_friction cdt",
          "model hooke/stiffness tangential no_history",
          "model hertz/stiffness tangential history cohesion sjkr2 rolling_friction epsd2",
          "model hooke/hysteresis tangential history",
          bridging_model};
}

std::string pressed_spheres(const std::string& models, const std::filesystem::path* mesh,
                            const std::string& settings) {
  return hertz_deck(models + " " + settings)
      .box("0 0.02 -0.001 0.02 -0.01 0.01")
      .with(properties +
            std::string("create_atoms 1 single 0.011 0.00447 0 units box\n"
                        "create_atoms 1 single 0.011 0.00148 0 units box\n"
                        "set group all diameter 0.003 density 2500\n"
                        "fix integrate all nve/sphere\n") +
            floor_of(models, mesh, settings));
}

std::string column_of(const std::string& models, const std::string& spheres,
                      const std::filesystem::path* mesh) {
  return hertz_deck(models)
      .box("0 0.02 -0.001 0.04 -0.01 0.01")
      .with(properties + spheres +
            "set group all diameter 0.003 density 2500\nfix integrate all nve/sphere\n"
            "fix g all gravity 9.81 vector 0 -1 0\n" +
            floor_of(models, mesh));
}

std::string shaken_spheres(const std::string& models, const std::string& lines,
                           const std::string& from, const std::string& end) {
  Deck deck = hertz_deck(models);
  deck.boundary("p f f").box("0 0.012 -0.001 0.05 -0.02 0.02").skin("0.0015");
  std::string text = properties;
  if (from.empty()) {
    for (int k = 0; k < 36; ++k) {
      const int column = k % 3, layer = k / 6, row = k / 3 % 2;
      const double shift = 0.0007 * (layer % 3);
      text += "create_atoms 1 single " + number(0.002 + 0.004 * column + shift) + " " +
              number(0.0018 + 0.003 * layer) + " " + number(-0.0018 + 0.0035 * row - shift) +
              " units box\n";
    }
    text +=
        "set group all diameter 0.003 density 2500\n"
        "velocity all set 0 -0.4 0 units box\n"
        "velocity all ramp vx 0.3 -0.3 y 0 0.02 units box\n"
        "velocity all ramp vz -0.2 0.3 x 0 0.012 units box\n";
  } else {
    deck.restart(from);
  }
  return deck.with(text + "fix integrate all nve/sphere\nfix g all gravity 9.81 vector 0 -1 0\n" +
                   floor_of(models) + lines + "run 2000\nwrite_dump all custom " + end +
                   ".dump id x y z vx vy vz omegax omegay omegaz modify format "
                   "\"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n");
}

std::string falling_rods(const std::string& models, const std::string& lines) {
  Deck deck = hertz_deck(models);
  return deck.boundary("p f f")
      .box("0 0.04 -0.001 0.05 -0.02 0.02")
      .skin("0.0015")
      .timestep("2e-5")
      .with(properties + std::string(R"(
fix rod all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 3 ntry 100000 spheres -0.002 0 0 0.0015 0 0 0 0.0015 0.002 0 0 0.0015 type 1
fix mix all particledistribution/discrete 15485867 1 rod 1.0
fix lines all insert/line 3 template rod 1 per_line 4 x 0 0.04 y 0.02 z 0 total 12 interval 0.04 velocity -0.2 0.2
fix motion all multisphere
fix g all gravity 9.81 vector 0 -1 0
)") + floor_of(models) +
            lines + "run 10000\n");
}

std::string listed_every(int steps) {
  const std::string every = std::to_string(steps);
  return "dump a all custom " + every +
         " atoms.dump id fx fy fz\ndump_modify a sort id format \"%d %.16g %.16g %.16g\"\n"
         "dump s all multisphere/sphere " +
         every + " spheres.dump\ndump c all contact/gran " + every + " contacts.dump\n";
}

}  // namespace rodpack::test
