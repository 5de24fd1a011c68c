// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/mixture_measures.h"

#include "analysis/mixture/composition.h"
#include "analysis/mixture/partial_rdf.h"
#include "analysis/rdf.h"
#include "analysis/space/spatial_rdf.h"
#include "reading/angles.h"
#include "report/mixture_outputs.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

void put_mixture(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                 const std::vector<std::vector<double>>& coordination, const fs::path& out,
                 Json& summary) {
  write_mixture_table(mixture, measures, coordination, (out / "mixture.csv").string());
  Json list = Json::array();
  for (std::size_t kind = 0; kind < mixture.species.size(); ++kind) {
    const auto& species = mixture.species[kind];
    const auto& measure = measures[kind];
    Json entry{{"species", species.name},
               {"type", species.type},
               {"particles", species.number},
               {"diameter_m", species.diameter},
               {"aspect_ratio", species.aspect_ratio},
               {"curvature_deg", species.curvature / degree},
               {"number_share", measure.number_share},
               {"solid_share", measure.solid_share},
               {"nematic_order_S2", json_of(measure.order)},
               {"nematic_order_S2_standard_error", json_of(measure.order_error)},
               {"director_deg", json_of(measure.director)}};
    if (!coordination.empty())
      for (std::size_t other = 0; other < mixture.species.size(); ++other)
        entry["touching"][mixture.species[other].name] = coordination[kind][other];
    list.push_back(entry);
  }
  summary["mixture"] = list;
}

template <class AnyPacking>
void put_partial_rdf(const AnyPacking& packing, const Mixture& mixture, const fs::path& out,
                     Json& summary) {
  std::optional<PartialRdf> rdf;
  try {
    rdf = partial_rdf(packing, mixture, up_to({}, half_period(packing)));
  } catch (const DataError& reason) {
    summary["notes"].push_back(std::string("partial RDF: ") + reason.what());
    return;
  }
  std::string note;
  write_partial_rdf(*rdf, mixture, (out / "rdf_partial").string(), note);
  if (!note.empty()) summary["notes"].push_back(note);
}

template <class AnyPacking, class Measure>
void report_kinds(const AnyPacking& packing, const Frame& bodies, const MeasuredContacts& contacts,
                  const fs::path& out, Json& summary, const Measure& measure) {
  std::string note;
  const auto mixture = kinds_to_measure(bodies, note);
  if (!note.empty()) summary["notes"].push_back(note);
  if (!mixture) return;
  std::vector<std::vector<double>> coordination;
  if (contacts.frame.rows > 0 && contacts.frame.timestep == bodies.timestep)
    coordination = coordination_by_species(contacts.frame, bodies, *mixture);
  put_mixture(*mixture, measure(*mixture), coordination, out, summary);
  put_partial_rdf(packing, *mixture, out, summary);
}

}  // namespace

void report_mixture(const Packing& packing, const Frame& bodies, const MeasuredContacts& contacts,
                    const fs::path& out, Json& summary) {
  report_kinds(packing, bodies, contacts, out, summary,
               [&](const Mixture& mixture) { return measure_species(packing, mixture); });
}

void report_mixture(const SpatialPacking& packing, const Frame& bodies,
                    const MeasuredContacts& contacts, const fs::path& out, Json& summary) {
  report_kinds(packing, bodies, contacts, out, summary,
               [&](const Mixture& mixture) { return measure_species(packing, bodies, mixture); });
}

}  // namespace rodpack
