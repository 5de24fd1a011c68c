// SPDX-License-Identifier: GPL-2.0-or-later
// The arguments of two styles with many keywords, a template of spherocylinders ('t') and a compute
// of averages ('a'), words between blanks: what is taken makes particles and places that mean
// something.
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "averaging_options.h"
#include "input_file.h"
#include "lammps.h"
#include "spherocylinder_options.h"
#include "stop_run.h"

namespace LAMMPS_NS {

// The refusal of an input.
void stop_run(LAMMPS*, const std::string& message) {
  if (message.empty()) std::abort();
  throw std::domain_error(message);
}

}  // namespace LAMMPS_NS

namespace {

using namespace LAMMPS_NS;

void require(bool holds) {
  if (!holds) std::abort();
}

bool is_size(double value) { return value > 0 && std::isfinite(value); }

void read_template(LAMMPS& lmp, std::vector<char*>& words) {
  const auto options =
      read_spherocylinder_options(&lmp, static_cast<int>(words.size()), words.data());
  require(options.seed > 0 && options.atom_type > 0 && options.body_type > 0);
  require(is_size(options.density) && is_size(options.shape.nominal_diameter));
  require(options.shape.overlap >= 0 && options.shape.overlap < 1);
  if (options.shape.aspect_ratio > 20) return;  // thousands of spheres: slow, and all alike
  const auto particle = options.particle(options.diameter(0.5));
  require(is_size(particle.volume) && is_size(particle.area) && is_size(particle.mass.mass));
  for (const double moment : particle.mass.inertia) require(is_size(moment));
}

void read_averages(LAMMPS& lmp, std::vector<char*>& words) {
  const auto options =
      read_averaging_options(&lmp, static_cast<int>(words.size()), words.data(), 3);
  require(options.kernel != nullptr);
  if (!options.points.empty()) return;
  double places = 1;
  for (const int count : options.grid.count) {
    require(count > 0);
    places *= count;
  }
  require(places <= 1e8);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  Atom atom;
  Domain domain;
  Force force;
  LAMMPS lmp{};
  lmp.atom = &atom;
  lmp.domain = &domain;
  lmp.force = &force;
  std::istringstream in(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  std::vector<std::string> texts{"id", "all", "style"};
  for (std::string word; in >> word;) {
    word = word.c_str();                                             // a deck has no NUL
    if (word.find('/') == std::string::npos) texts.push_back(word);  // no file of this machine
  }
  std::vector<char*> words;
  for (auto& text : texts) words.push_back(&text[0]);
  try {
    data[0] == 'a' ? read_averages(lmp, words) : read_template(lmp, words);
  } catch (const std::domain_error&) {
  }
  return 0;
}
