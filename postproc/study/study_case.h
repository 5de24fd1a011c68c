// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_STUDY_CASE_H
#define RODPACK_STUDY_STUDY_CASE_H

#include <optional>
#include <string>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

enum class Surface { sphere, coarse, smooth };

/// The surface of straight particles.
inline Surface surface_of(bool coarse) { return coarse ? Surface::coarse : Surface::smooth; }

/// What the name of one of the paper's cases says: "spheres", "coarse-AR2", "curved-AR5-theta60"
/// (curved particles are smooth), and a case of the sensitivity to a parameter, "smooth-AR5-mu0.1".
struct StudyCase {
  Surface surface = Surface::sphere;
  double aspect_ratio = 1;
  double theta = 0;       // opening angle of the arc, degrees; 0 straight
  std::string variation;  // what a sensitivity case changes, "mu0.1"; empty: nothing
};

/// Reads the name of a case; none when it has another form.
std::optional<StudyCase> study_case(const std::string& name);

/// Aspect ratios of the straight (`curved`: of the curved) cases of the ensemble, ascending.
std::vector<double> aspect_ratios(const Ensemble& ensemble, bool curved);

/// Opening angles of the curved cases of that aspect ratio, degrees, ascending.
std::vector<double> opening_angles(const Ensemble& ensemble, double aspect_ratio);

/// The same after 0, which stands for the straight smooth case.
std::vector<double> angles_from_straight(const Ensemble& ensemble, double aspect_ratio);

/// Finds the case of spheres, or of straight particles of that surface; null when there is none.
const EnsembleCase* straight_case(const Ensemble& ensemble, Surface surface, double aspect_ratio);

/// Finds the case of curved particles; the straight smooth one for `theta` = 0. Null when there is
/// none.
const EnsembleCase* curved_case(const Ensemble& ensemble, double aspect_ratio, double theta);

/// Finds a number of a case that has a finite mean; null when there is none, or no case.
const EnsembleMean* number_of(const EnsembleCase* each, const std::string& name);

/// Finds a curve of a case that is not empty; null when there is none, or no case.
const EnsembleCurve* curve_of(const EnsembleCase* each, const std::string& name);

}  // namespace rodpack

#endif
