// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/spatial_measures.h"

#include "analysis/space/axial_rdf.h"
#include "analysis/space/fabric.h"
#include "analysis/space/spatial_orientation.h"
#include "analysis/space/spatial_rdf.h"
#include "analysis/space/vertical_profile.h"
#include "report/outputs.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// The result of a measure, or none and a note that says why, after the name of the measure where
// the reason does not begin with it; drawing it is none of its business, so
// that a missing program is no reason to leave a measure out.
template <class Measure>
auto measured(const std::string& what, Json& summary, const Measure& measure)
    -> std::optional<decltype(measure())> {
  try {
    return measure();
  } catch (const DataError& reason) {
    const std::string why = reason.what();
    const bool named = why.rfind(what + ":", 0) == 0;
    summary["notes"].push_back(named ? why : what + ": " + why);
    return std::nullopt;
  }
}

void put_order(const std::string& name, const OrderTensor& order, const OrderAbout& vertical,
               Json& summary) {
  const auto chance = isotropic_order(order.number);
  summary[name + "_S2"] = order.value[0];
  summary[name + "_S2_standard_error"] = order.standard_error[0];
  summary[name + "_S2_without_bias"] = order.order_without_bias;
  summary[name + "_S2_of_as_many_isotropic_mean"] = chance.mean;
  summary[name + "_S2_of_as_many_isotropic_standard_deviation"] = chance.deviation;
  summary[name + "_second_value"] = order.value[1];
  summary[name + "_second_value_standard_error"] = order.standard_error[1];
  summary[name + "_third_value"] = order.value[2];
  summary[name + "_third_value_standard_error"] = order.standard_error[2];
  const std::string about =
      name == "order_tensor" ? "order_about_vertical" : name + "_about_vertical";
  summary[about] = vertical.value;
  summary[about + "_standard_error"] = vertical.standard_error;
}

void put_orientation(const SpatialOrientation& result, const fs::path& out, Json& summary) {
  write_orientation(result, (out / "orientation").string());
  summary["orientation_particles"] = result.order.number;
  summary["orientation_left_out_closer_than_AR_dp_to_walls"] = result.near_walls;
  put_order("order_tensor", result.order, result.about_vertical, summary);
  const auto director = direction_angles(result.order.direction[0], result.vertical);
  summary["director_from_vertical_deg"] = director.polar;
  summary["director_azimuth_deg"] = director.azimuth;
  summary["director_standard_error_deg"] = result.order.director_standard_error;
}

void put_axial_rdf(const AxialRdf& rdf, const fs::path& out, Json& summary) {
  write_axial_rdf(rdf, (out / "rdf_axial").string());
  summary["rdf_axial_centres"] = rdf.centres;
  summary["rdf_axial_margin_over_dp"] = rdf.margin;
}

void put_layers(const VerticalProfile& profile, const fs::path& out, Json& summary) {
  write_layers(profile, (out / "solid_fraction").string());
  const std::string key =
      "solid_fraction_of_cross_section_from_3_omega_above_floor_to_3_omega_below_surface";
  summary["omega_m"] = profile.scale;
  summary["container_cross_section_m2"] = profile.cross_section;
  if (const auto mean = mean_solid_fraction(profile)) {
    summary[key] = *mean;
  } else {
    summary[key] = nullptr;
    summary["notes"].push_back("solid fraction: the bed is lower than the 6 omega that its mean " +
                               std::string("needs; --scale of rodpack solid-fraction makes omega "
                                           "smaller"));
  }
}

void put_stresses(const VerticalProfile& profile, const fs::path& out, Json& summary) {
  const auto fit = measured("Janssen fit", summary, [&] { return fit_janssen(profile); });
  write_profile(profile, fit ? &*fit : nullptr, (out / "profile").string());
  put_janssen_fit(fit, profile.particle_diameter, "N_m2", summary);
}

void put_fabric(const Fabric& fabric, const fs::path& out, Json& summary) {
  write_fabric(fabric, (out / "forces_fabric").string());
  put_order("contact_normals", fabric.order, fabric.about_vertical, summary);
}

std::optional<VerticalProfile> profile_of(const std::string& what, const SpatialPacking& packing,
                                          const Frame& bodies, const Frame* contacts,
                                          Json& summary) {
  return measured(what, summary, [&] {
    VerticalProfileSample sample({});
    sample.add(packing, bodies, contacts);
    return sample.result();
  });
}

// What a sample of G(r) or of directions says of the one packing.
template <class Sample>
auto sampled(const std::string& what, Sample sample, const SpatialPacking& packing, Json& summary) {
  return measured(what, summary, [&] {
    sample.add(packing);
    return sample.result();
  });
}

// How the particles lie and fill space, as the bodies alone tell.
int report_bodies(const SpatialPacking& packing, const Frame& bodies, const fs::path& out,
                  Json& summary) {
  int made = 0;
  if (const auto result = sampled("orientation", SpatialOrientationSample(), packing, summary)) {
    put_orientation(*result, out, summary);
    ++made;
  }
  if (const auto rdf = sampled("RDF", SpatialRdfSample(rdf_options(half_period(packing), summary)),
                               packing, summary)) {
    put_rdf(*rdf, out, summary);
    ++made;
  }
  if (const auto rdf = sampled("pair correlation along and across",
                               AxialRdfSample(AxialRdfOptions()), packing, summary)) {
    put_axial_rdf(*rdf, out, summary);
    ++made;
  }
  if (const auto layers = profile_of("solid fraction", packing, bodies, nullptr, summary)) {
    put_layers(*layers, out, summary);
    ++made;
  }
  return made;
}

int report_fields_in_space(const SpatialPacking& packing, const Frame& bodies,
                           const Frame* contacts, double time, const fs::path& out, Json& summary) {
  const auto sample = measured("fields", summary, [&] {
    SpatialFieldSample fields({});
    fields.add(packing, bodies, contacts);
    return fields;
  });
  if (!sample) return 0;
  write_fields(*sample, {}, time, (out / "fields").string());
  draw_solid_fraction_maps(*sample, (out / "solid_fraction_map").string());
  if (contacts) draw_pressure_maps(*sample, (out / "pressure_map").string());
  const std::string key = "solid_fraction_3_omega_from_walls_floor_and_surface";
  if (const auto interior = interior_solid_fraction(*sample)) {
    summary[key] = interior->mean;
    summary[key + "_standard_deviation_over_places"] = interior->deviation;
  } else {
    summary[key] = nullptr;
    summary["notes"].push_back(
        "solid fraction: no place is further than 3 omega from walls, floor and surface; --scale "
        "of rodpack solid-fraction makes omega smaller");
  }
  return contacts ? 1 : 0;  // densities alone there are of any particle
}

}  // namespace

int report_in_space(const SpatialPacking& packing, const Frame& bodies,
                    const MeasuredContacts& contacts, double time, const fs::path& out,
                    Json& summary) {
  int made = report_bodies(packing, bodies, out, summary);
  report_contacts(contacts, out, summary);
  if (contacts.forces) {
    ++made;
    if (const auto fabric = measured("fabric", summary, [&] {
          return measure_fabric(contacts.normals, contacts.normal_forces, packing.walls.vertical);
        }))
      put_fabric(*fabric, out, summary);
    if (const auto profile = profile_of("profile", packing, bodies, &contacts.frame, summary))
      put_stresses(*profile, out, summary);
  }
  const bool stressed = contacts.frame.rows > 0 && contacts.frame.timestep == bodies.timestep;
  made += report_fields_in_space(packing, bodies, stressed ? &contacts.frame : nullptr, time, out,
                                 summary);
  summary["notes"].push_back("force chains, sixfold orders: of scenes in a plane alone");
  return made;
}

}  // namespace rodpack
