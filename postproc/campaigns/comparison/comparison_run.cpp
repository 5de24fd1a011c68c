// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/solid_fraction.h"
#include "campaigns/comparison/comparison.h"
#include "reading/dump.h"
#include "reading/number_text.h"
#include "reading/packing.h"
#include "reading/table.h"
#include "rodpack/geometry/chain_geometry.h"

namespace rodpack {
namespace {

ChainShape rod(const RunParameters& parameters) {
  const double diameter = parameters.number("particle_diameter_m");
  return {parameters.number("aspect_ratio"), diameter, 0.5, 0, diameter};
}

/// Returns the value that all bodies have in a column.
double common_value(const Frame& frame, const std::string& column) {
  const auto& values = frame.column(column);
  if (values.empty()) throw DataError(frame.file + ": no bodies in the frame");
  for (const double value : values)
    if (value != values.front())
      throw DataError(frame.file + ": column '" + column + "': expected equal bodies, found " +
                      number_text(values.front()) + " and " + number_text(value));
  return values.front();
}

RunSeries read_series(const std::string& file, const BodyHistory& bodies) {
  const Table table = read_table(file);
  const auto& time = table.column("time_s");
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
  if (!std::equal(time.begin(), time.end(), bodies.time.begin(), bodies.time.end(), same))
    throw DataError(file + ": expected the times of the " + std::to_string(bodies.time.size()) +
                    " frames of bodies.dump, found " + std::to_string(time.size()) + " others");
  return {table.column("kinetic_translational_J"), table.column("kinetic_rotational_J"),
          table.column("elastic_normal_J"), table.column("elastic_tangential_J"),
          table.column("sphere_contacts")};
}

FinalBed read_bed(const std::string& bodies_dump, const std::string& contacts_dump,
                  const ChainShape& shape) {
  Frame frame = last_frame({bodies_dump});
  frame.column("area");  // must be there
  // A stock body carries no covered area, and its dump gives that of the enclosing chain: all runs
  // are of one shape, so all get its exact area.
  const auto area = std::find(frame.names.begin(), frame.names.end(), "area");
  frame.columns[static_cast<std::size_t>(area - frame.names.begin())].assign(frame.rows,
                                                                             covered_area(shape));
  FinalBed bed;
  // How far the bodies of stock LIGGGHTS leave the plane is a result of the comparison.
  PackingOptions options;
  options.out_of_plane_too = true;
  const Packing packing = read_packing(frame, options);
  const SolidFraction phi = solid_fraction(packing);
  bed.height = packing.surface - packing.walls.floor;
  bed.mean_height = std::accumulate(packing.y.begin(), packing.y.end(), 0.0) /
                        static_cast<double>(packing.size()) -
                    packing.walls.floor;
  bed.covered_below_surface = phi.covered_below_surface;
  bed.slice_solid_fraction = phi.up_to_surface;
  try {
    OrientationSample sample;
    sample.add(packing);
    bed.orientation = sample.distribution(36).nematic;
  } catch (const TooFewParticles&) {
  }
  try {
    const Frame contacts = last_frame({contacts_dump});
    bed.coordination = measure_contact_forces(contacts, &frame, {}).coordination;
  } catch (const TooFewParticles&) {
  }
  return bed;
}

}  // namespace

MassProperties exact_mass_properties(const RunParameters& parameters) {
  return mass_properties(rod(parameters), parameters.number("density_kg_m3"), MassRule::own, false);
}

MethodRun read_method_run(const std::string& name, const std::string& folder) {
  const RunParameters parameters = read_parameters(folder + "/parameters.json");
  const std::string bodies = folder + "/bodies.dump";
  MethodRun run;
  run.name = name;
  run.bodies = read_body_history({bodies}, parameters.number("timestep_s"),
                                 parameters.number("gravity_m_s2"));
  run.series = read_series(folder + "/energies.csv", run.bodies);
  run.bed = read_bed(bodies, folder + "/contacts.dump", rod(parameters));
  run.mass = common_value(last_frame({bodies}), "mass");
  const Frame moments = last_frame({folder + "/moments.dump"});
  for (std::size_t axis = 0; axis < 3; ++axis)
    run.inertia[axis] = common_value(moments, "c_moments[" + std::to_string(axis + 1) + "]");
  return run;
}

}  // namespace rodpack
