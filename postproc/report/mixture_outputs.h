// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_MIXTURE_OUTPUTS_H
#define RODPACK_REPORT_MIXTURE_OUTPUTS_H

#include <optional>
#include <string>
#include <vector>

#include "analysis/mixture/composition.h"
#include "analysis/mixture/partial_rdf.h"

namespace rodpack {

// What analyse_run() and the subcommands write of a mixture by kind.

/// The kinds of the particles of a frame of bodies; none where all are of one, the dump does not
/// tell types, or there are too many, which `note` says then. @throws DataError as find_mixture().
std::optional<Mixture> kinds_to_measure(const Frame& bodies, std::string& note);

/// Writes `stem`.csv and, where they can be told apart, draws `stem`.png and .svg; `note` says why
/// not. Returns these names for the terminal. @throws DataError when drawing fails.
std::string write_partial_rdf(const PartialRdf& rdf, const Mixture& mixture,
                              const std::string& stem, std::string& note);

/// Lines for the terminal, one per kind: number, shares of the bed and S2 of `measures`, if there
/// are any, and how many of every kind one touches, if there is a `coordination`.
std::string describe(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                     const std::vector<std::vector<double>>& coordination);

/// Writes `stem`_mixture.csv of the last frame, adds its name to those that are `written`, and
/// returns what describe() says of it under a heading.
std::string write_by_kind(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                          const std::vector<std::vector<double>>& coordination,
                          const std::string& stem, std::string& written);

}  // namespace rodpack

#endif
