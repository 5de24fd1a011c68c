// SPDX-License-Identifier: GPL-2.0-or-later
#include "stock_heap.h"

#include <gtest/gtest.h>

#include <fstream>

#include "deck.h"
#include "liggghts_run.h"

namespace rodpack::test {
namespace {

// The columns of a compute of the words above.
std::string columns(const std::string& compute) {
  std::string names;
  for (int c = 1; c <= 13; ++c) names += " c_" + compute + "[" + std::to_string(c) + "]";
  return names;
}

}  // namespace

std::filesystem::path stock_heap(const std::string& tangential) {
  auto folder = fresh_folder();
  std::ofstream(folder / "floor.stl")
      << "solid floor\nfacet normal 0 1 0\nouter loop\nvertex 0 0 -0.008\nvertex 0.04 0 0.008\n"
         "vertex 0.04 0 -0.008\nendloop\nendfacet\nfacet normal 0 1 0\nouter loop\nvertex 0 0 "
         "-0.008\nvertex 0 0 0.008\nvertex 0.04 0 0.008\nendloop\nendfacet\nendsolid floor\n";
  const std::string law = "model hertz tangential " + tangential;
  const auto run = run_liggghts_in(folder, Deck()
                                               .hertz()
                                               .models(law)
                                               .box("0 0.04 -0.002 0.05 -0.02 0.02")
                                               .boundary("p f f")
                                               .skin("0.0015")
                                               .timestep("2e-5")
                                               .with(
                                                   R"(
fix rod all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 3 ntry 100000 spheres -0.002 0 0 0.0015 0 0 0 0.0015 0.002 0 0 0.0015 type 1
fix mix all particledistribution/discrete 15485867 1 rod 1.0
fix lines all insert/line 3 template rod 1 per_line 4 x 0 0.04 y 0.02 z 0 total 12 interval 0.04 velocity -0.2 0.2
fix motion all multisphere
fix g all gravity 9.81 vector 0 -1 0
fix stl all mesh/surface file floor.stl type 1
fix floor all wall/gran )" + law + R"( mesh n_meshes 1 meshes stl
compute pairs all pair/gran/local )" + stock_words +
                                                   R"(
compute walls all wall/gran/local )" + stock_words +
                                                   R"(
dump pairs all local 10000 pairs.dump)" + columns("pairs") +
                                                   R"(
dump walls all local 10000 walls.dump)" + columns("walls") +
                                                   R"(
dump spheres all custom 10000 spheres.dump id type x y z radius id_multisphere mass vx vy vz
dump bodies all multisphere/body 10000 bodies.dump
dump contacts all contact/gran 10000 contacts.dump
run 10000
)"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return folder;
}

}  // namespace rodpack::test
