// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_MEASURES_H
#define RODPACK_REPORT_MEASURES_H

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/contact_forces.h"
#include "analysis/janssen_fit.h"
#include "analysis/pairs/rdf_sums.h"
#include "analysis/stock/local_contacts.h"
#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

// The parts of analyse_run() for scenes in a plane; spatial_measures.cpp shares what holds in space
// too. Each writes the table and the
// figures of one measure into the folder `out` and its numbers into `summary`, under keys that name
// their units; what could not be measured goes into the summary's "notes".

/// @throws TooFewParticles when no particle is left to measure, DataError when drawing fails, like
/// all of these.
void report_orientation(const Packing& packing, const std::filesystem::path& out,
                        nlohmann::ordered_json& summary);
/// Of the points of the particles of `bodies`, the frame that `packing` was read from.
void report_bond_order(const Frame& bodies, const Packing& packing,
                       nlohmann::ordered_json& summary);
void report_rdf(const Packing& packing, const std::filesystem::path& out,
                nlohmann::ordered_json& summary);
void report_solid_fraction(const Packing& packing, const std::filesystem::path& out,
                           nlohmann::ordered_json& summary);

/// The options of G(r), up to half of the shortest period (d_p) where that is less than usual,
/// which the notes say.
RdfOptions rdf_options(double half_period, nlohmann::ordered_json& summary);
/// The tables, figures and numbers of G(r), in a plane and in space.
void put_rdf(const Rdf& rdf, const std::filesystem::path& out, nlohmann::ordered_json& summary);
/// The numbers of a fit of Janssen's law, null where there is none or it does not saturate, which
/// the notes say. `pressure_unit`: as keys end, "N_m".
void put_janssen_fit(const std::optional<JanssenFit>& fit, double particle_diameter,
                     const std::string& pressure_unit, nlohmann::ordered_json& summary);

/// The contacts of one timestep of a run and what they say, or why they say nothing.
struct MeasuredContacts {
  std::vector<std::string> files;  // all contacts' dumps of the run
  Frame frame;                     // that of the timestep; without rows where there is none
  std::optional<ContactForces> forces;
  std::vector<Vector3> normals;       // of the contacts that are measured
  std::vector<double> normal_forces;  // of the same, N
  std::string note;                   // why there are no forces
};
/// Reads the contacts of the timestep of `bodies` and measures their forces. `contacts_of`: what
/// makes them of LIGGGHTS's own dumps, if these are some. `parameters`: the run's parameters.json;
/// `friction`: in place of what the scene or that says. @throws DataError when a column is missing
/// or malformed.
MeasuredContacts measure_contacts(const std::string& run, const Frame& bodies,
                                  const std::function<Frame(const Frame&)>& contacts_of,
                                  const std::string& parameters, std::optional<double> friction);

/// Distributions and numbers of the forces, in a plane and in space.
void report_contacts(const MeasuredContacts& contacts, const std::filesystem::path& out,
                     nlohmann::ordered_json& summary);

/// Maps of the fields and the profile of the pressure; without contacts (null) the densities alone.
/// `time`: s, or the timestep where that is not known.
void report_fields(const Packing& packing, const Frame& bodies, const Frame* contacts, double time,
                   const std::filesystem::path& out, nlohmann::ordered_json& summary);

/// From `run`/energies.csv, if there is one.
void report_energies(const std::filesystem::path& run, const std::filesystem::path& out,
                     nlohmann::ordered_json& summary);

}  // namespace rodpack

#endif
