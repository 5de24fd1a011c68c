// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/mixture_outputs.h"

#include "figures/mixture/partial_rdf_figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr std::size_t most_species = 8;  // more are a spread of shapes rather than a mixture

}  // namespace

std::optional<Mixture> kinds_to_measure(const Frame& bodies, std::string& note) {
  if (!bodies.has("type")) return std::nullopt;
  auto mixture = find_mixture(bodies);
  if (mixture.is_one()) return std::nullopt;
  if (mixture.species.size() <= most_species) return mixture;
  note = "mixture: " + std::to_string(mixture.species.size()) +
         " kinds of particles, expected at most " + std::to_string(most_species) +
         ": nothing is measured by kind";
  return std::nullopt;
}

std::string write_partial_rdf(const PartialRdf& rdf, const Mixture& mixture,
                              const std::string& stem, std::string& note) {
  auto table = stem + ".csv";
  write_partial_rdf_table(rdf, mixture, table);
  if (rdf.pairs.size() > most_partial_curves) {
    note = "partial RDF: too many pairs of kinds for a figure; the table has them";
    return table;
  }
  plot_partial_rdf(rdf, mixture, stem);
  return table + " .png .svg";
}

std::string describe(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                     const std::vector<std::vector<double>>& coordination) {
  std::string text;
  for (std::size_t kind = 0; kind < mixture.species.size(); ++kind) {
    const auto& species = mixture.species[kind];
    text += "  " + species.name + ": " + std::to_string(species.number) + " particles";
    if (!measures.empty()) {
      const auto& measure = measures[kind];
      text += ", " + number_text(measure.solid_share, 4) + " of what all cover";
      if (measure.order)
        text +=
            ", S2 = " + number_text(*measure.order, 4) +
            (measure.order_error ? " +- " + number_text(*measure.order_error, 2) : "") +
            (measure.director ? ", director " + number_text(*measure.director, 4) + " deg" : "");
    }
    if (!coordination.empty()) {
      text += ", one touches";
      for (std::size_t other = 0; other < mixture.species.size(); ++other)
        text += (other > 0 ? ", " : " ") + number_text(coordination[kind][other], 4) + " " +
                mixture.species[other].name;
    }
    text += '\n';
  }
  return text;
}

std::string write_by_kind(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                          const std::vector<std::vector<double>>& coordination,
                          const std::string& stem, std::string& written) {
  const auto table = stem + "_mixture.csv";
  write_mixture_table(mixture, measures, coordination, table);
  written += ", " + table;
  return "by kind, last frame:\n" + describe(mixture, measures, coordination);
}

}  // namespace rodpack
