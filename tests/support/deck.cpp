// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck.h"

#include "reading/number_text.h"

namespace rodpack::test {

std::string exact(double value) { return number_text(value, 17); }

std::string one_particle(const std::string& id, const std::array<double, 3>& centre,
                         const std::string& motion, const std::string& of) {
  std::string bounds;
  for (const double low : centre) bounds += " " + exact(low) + " " + exact(low + 1e-15);
  return "region at" + id + " block" + bounds + " units box volume_limit 1e-60\nfix put" + id +
         " all insert/pack seed 32452843 distributiontemplate " + of + " insert_every once " +
         motion + " overlapcheck no all_in no region at" + id + " particles_in_region 1\n";
}

Deck& Deck::box(const std::string& bounds) {
  box_ = bounds;
  return *this;
}

Deck& Deck::boundary(const std::string& flags) {
  boundary_ = flags;
  return *this;
}

Deck& Deck::processors(const std::string& grid) {
  processors_ = grid;
  return *this;
}

Deck& Deck::restart(const std::string& file) {
  restart_ = file;
  return *this;
}

Deck& Deck::atom_types(int number) {
  types_ = number;
  return *this;
}

Deck& Deck::skin(const std::string& length) {
  skin_ = length;
  return *this;
}

Deck& Deck::timestep(const std::string& seconds) {
  timestep_ = seconds;
  return *this;
}

Deck& Deck::stiffness(const std::string& normal, const std::string& tangential) {
  kn_ = normal;
  kt_ = tangential;
  return *this;
}

Deck& Deck::damping(const std::string& ratio) {
  damping_ = ratio;
  return *this;
}

Deck& Deck::friction(const std::string& coefficient) {
  friction_ = coefficient;
  return *this;
}

Deck& Deck::models(const std::string& words) {
  models_ = words;
  return *this;
}

Deck& Deck::hertz() {
  hertz_ = true;
  models_ = "model hertz tangential history";
  return *this;
}

std::string Deck::property(const std::string& id, const std::string& name, const std::string& kind,
                           const std::string& value) const {
  const bool pairs = kind == "peratomtypepair";
  std::string line = "fix " + id + " all property/global " + name + " " + kind;
  if (pairs) line += " " + std::to_string(types_);
  for (int k = 0; k < (pairs ? types_ * types_ : types_); ++k) line += " " + value;
  return line + "\n";
}

std::string Deck::law() const {
  const std::string pairs = "peratomtypepair";
  std::string text;
  if (hertz_) {
    text = property("e", "youngsModulus", "peratomtype", "1e6") +
           property("p", "poissonsRatio", "peratomtype", "0.3") +
           property("r", "coefficientRestitution", pairs, "0.5") +
           property("c", "coefficientFriction", pairs, "0.3");
  } else {
    text = property("kn", "kn", pairs, kn_) + property("kt", "kt", pairs, kt_) +
           property("dn", "dampingRatioNormal", pairs, damping_) +
           property("dt", "dampingRatioTangential", pairs, damping_) +
           property("mu", "coefficientFriction", pairs, friction_);
  }
  return text + "pair_style gran " + models_ + "\npair_coeff * *\n";
}

std::string Deck::with(const std::string& lines) const {
  std::string text = "atom_style granular\natom_modify map array sort 0 0\nboundary " + boundary_ +
                     "\nunits si\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n";
  if (!processors_.empty()) text += "processors " + processors_ + "\n";
  if (restart_.empty())
    text +=
        "region box block " + box_ + " units box\ncreate_box " + std::to_string(types_) + " box\n";
  else
    text += "read_restart " + restart_ + "\n";
  return text + "neighbor " + skin_ + " bin\nneigh_modify delay 0\n" + law() + "timestep " +
         timestep_ + "\n" + lines;
}

}  // namespace rodpack::test
