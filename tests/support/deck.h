// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_DECK_H
#define RODPACK_TESTS_DECK_H

#include <array>
#include <string>

namespace rodpack::test {

/// A number in a deck, to its last bit.
std::string exact(double value);

/// Lines that put one particle of the distribution template `of` into the deck in its first step,
/// with the centre of mass at `centre`, m: LIGGGHTS draws it from a region of 1e-15 m. `motion`:
/// "vel constant ...", "omega constant ...", "orientation constant ...", each if it is not 0.
std::string one_particle(const std::string& id, const std::array<double, 3>& centre,
                         const std::string& motion, const std::string& of = "mix");

/// The text of a deck for run_liggghts(): what every deck begins with (SI units, spheres, a box,
/// neighbour lists, the law of the contacts, the time step), then the lines of the test. Each
/// setter returns the deck, so that they can be written one after the other; values are words of
/// the deck, which may contain variables.
class Deck {
 public:
  /// Lower and upper bound of x, y and z, m.
  Deck& box(const std::string& bounds);
  Deck& boundary(const std::string& flags);
  /// Ranks along x, y and z; LIGGGHTS chooses unless told.
  Deck& processors(const std::string& grid);
  /// Goes on from a restart file, in place of a new box.
  Deck& restart(const std::string& file);
  Deck& atom_types(int number);
  /// Of the neighbour lists, m.
  Deck& skin(const std::string& length);
  Deck& timestep(const std::string& seconds);

  // Spring and dashpot, the same for all pairs of atom types; unless told, the values of the paper.
  /// k_n and k_t, N/m.
  Deck& stiffness(const std::string& normal, const std::string& tangential);
  /// Damping ratio of both directions.
  Deck& damping(const std::string& ratio);
  Deck& friction(const std::string& coefficient);
  /// What follows `pair_style gran`.
  Deck& models(const std::string& words);
  /// In place of spring and dashpot: LIGGGHTS's own Hertz law (1 MPa, 0.3; restitution 0.5,
  /// friction 0.3), for tests that are not about contacts.
  Deck& hertz();

  /// The whole deck: its beginning and these lines.
  std::string with(const std::string& lines) const;

 private:
  std::string law() const;
  std::string property(const std::string& id, const std::string& name, const std::string& kind,
                       const std::string& value) const;

  std::string box_ = "0 0.1 0 0.1 -0.005 0.005", boundary_ = "f f f", processors_, restart_;
  std::string skin_ = "0.001", timestep_ = "1e-5";
  int types_ = 1;
  bool hertz_ = false;
  std::string kn_ = "1000", kt_ = "500", damping_ = "0.2", friction_ = "0.3";
  std::string models_ = "model spring_dashpot tangential spring_dashpot";
};

}  // namespace rodpack::test

#endif
