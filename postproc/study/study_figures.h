// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_STUDY_FIGURES_H
#define RODPACK_STUDY_STUDY_FIGURES_H

#include <string>
#include <vector>

#include "ensemble/ensemble.h"
#include "study/published.h"

namespace rodpack {

/// A figure or table of the paper, drawn from an ensemble.
struct StudyFigure {
  std::string name;       // of its files, without suffix: fig3_orientation
  std::string paper;      // what it is in the paper: "Fig. 3"
  std::string caption;    // what it shows, in a sentence or two
  std::string not_drawn;  // why; empty: it was drawn
};

/// Draws the paper's figures, those that the ensemble has cases for, into `out`: NAME.png and
/// NAME.svg each. `study`: folder that the runs' folders are relative to. `published`: the file of
/// published values; empty: see find_published().
/// @return every figure in the paper's order, with the reason where one was not drawn.
/// @throws DataError when a file cannot be read or written.
std::vector<StudyFigure> draw_study_figures(const Ensemble& ensemble, const std::string& study,
                                            const std::string& out,
                                            const std::string& published = "");

/// Writes `folder`/figures.json, what was drawn and what it shows, for the study's page.
/// @throws DataError when it cannot be written.
void write_figure_list(const std::vector<StudyFigure>& figures, const std::string& folder);

// Each alone.

/// Fig. 3: distribution of gamma, straight particles, a panel per aspect ratio.
StudyFigure draw_orientation(const Ensemble& ensemble, const std::string& out);
/// Fig. 7: distribution of gamma over [0, 360) degrees, curved particles.
StudyFigure draw_curved_orientation(const Ensemble& ensemble, const std::string& out);
/// Fig. 4: G(r), straight particles, peaks named by their position; their table beside it.
StudyFigure draw_rdf(const Ensemble& ensemble, const std::string& out);
/// Fig. 9: the same, curved particles.
StudyFigure draw_curved_rdf(const Ensemble& ensemble, const std::string& out);
/// Fig. 5: P_0(h) of spheres, with Janssen's law, and of straight particles.
StudyFigure draw_pressure(const Ensemble& ensemble, const std::string& out);
/// Fig. 10: P_0(h), curved particles.
StudyFigure draw_curved_pressure(const Ensemble& ensemble, const std::string& out);
/// For what the paper says of stress and curvature: P_0 in the lower part of the bed over theta.
StudyFigure draw_pressure_over_theta(const Ensemble& ensemble, const std::string& out);
/// Fig. 6a: solid fraction over theta.
StudyFigure draw_solid_fraction_over_theta(const Ensemble& ensemble, const std::string& out);
/// The solid fraction over AR, beside published values.
StudyFigure draw_solid_fraction_over_aspect_ratio(const Ensemble& ensemble,
                                                  const std::vector<PublishedValue>& published,
                                                  const std::string& out);
/// Fig. 2: maps of the mean solid fraction of straight particles, a panel per case, from the tables
/// CASE_fields.csv that `rodpack ensemble` has left in `out`.
StudyFigure draw_solid_fraction_maps(const Ensemble& ensemble, const std::string& out);
/// Fig. 2: the solid fraction over the height in the central slice, straight particles.
StudyFigure draw_slice(const Ensemble& ensemble, const std::string& out);
/// The same, curved particles.
StudyFigure draw_curved_slice(const Ensemble& ensemble, const std::string& out);
/// Fig. 1: packings coloured by contact force, the first run of each case.
StudyFigure draw_packings(const Ensemble& ensemble, const std::string& study,
                          const std::string& out);
/// Fig. 6b: the longest and most curved case, its first run, with the voids marked.
StudyFigure draw_packing_with_voids(const Ensemble& ensemble, const std::string& study,
                                    const std::string& out);

}  // namespace rodpack

#endif
