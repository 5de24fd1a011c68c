// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "analysis/space/body_volumes.h"
#include "analysis/stock/stock_dumps.h"
#include "reading/angles.h"
#include "reading/checks/body_axes.h"
#include "reading/checks/contacts_of_bodies.h"
#include "reading/checks/planar.h"
#include "reading/number_text.h"
#include "reading/text_file.h"
#include "rodpack/averaging/kernel_share.h"
#include "rodpack/vtk/field_image.h"

namespace rodpack {
namespace {

std::string where(const Frame& frame) {
  return frame.file + ":" + std::to_string(frame.header_line);
}

Vector vector_at(const Frame& frame, const std::array<const char*, 3>& columns, std::size_t row) {
  return {{frame.column(columns[0])[row], frame.column(columns[1])[row],
           frame.column(columns[2])[row]}};
}

}  // namespace

Grid checked_grid(const Grid& grid) {
  constexpr double most = 1e6;  // some 500 MB of fields
  const double places = double{1} * grid.count[0] * grid.count[1] * grid.count[2];
  if (!(places <= most))
    throw DataError("grid: expected at most " + number_text(most) + " places, found " +
                    number_text(places) + " (spacing " + number_text(grid.spacing[1], 4) + " m)");
  return grid;
}

namespace {

Grid field_grid(const Packing& packing, const FieldOptions& options) {
  const double scale = averaging_scale(packing, options);
  const auto& walls = packing.walls;
  // Above the surface there is nothing where the kernel counts what is below it alone.
  const bool closed = options.normalisation == Normalisation::walls_and_surface || !walls.bottom;
  const double above = closed ? 0 : scale;
  const auto window = options.window.value_or(
      std::array<double, 4>{walls.left, walls.right, walls.floor, packing.surface + above});
  if (window[0] > walls.right || window[1] < walls.left || window[3] < walls.floor)
    throw DataError("window: x " + number_text(window[0]) + " ... " + number_text(window[1]) +
                    " m, y " + number_text(window[2]) + " ... " + number_text(window[3]) +
                    " m is outside the container (" + walls.source + ")");
  try {
    return checked_grid(filling_grid(2, {{window[0], window[2], 0}}, {{window[1], window[3], 0}},
                                     options.spacing.value_or(scale / 4)));
  } catch (const std::invalid_argument& reason) {
    throw DataError(reason.what());
  }
}

}  // namespace

Rectangle counted_space(const Packing& packing, Normalisation normalisation) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  Rectangle space{-endless, endless, -endless, endless};
  if (normalisation == Normalisation::none) return space;
  const auto& walls = packing.walls;
  if (walls.sides) {
    space.left = walls.left;
    space.right = walls.right;
  }
  if (walls.bottom) {
    space.bottom = walls.floor;
    if (normalisation == Normalisation::walls_and_surface) space.top = packing.surface;
  }
  return space;
}

double averaging_scale(const Packing& packing, const FieldOptions& options) {
  const double diameters = options.scale_in_diameters.value_or(3 * packing.aspect_ratio);
  const double scale = options.scale.value_or(diameters * packing.particle_diameter);
  if (!(scale > 0)) throw DataError("scale: expected a length > 0, found " + number_text(scale));
  return scale;
}

std::vector<SphereContact> read_contacts(const Frame& frame) {
  const auto& i = frame.column("body_i");
  const auto& j = frame.column("body_j");
  const auto& wall = frame.column("wall");
  std::vector<SphereContact> contacts;
  for (std::size_t row = 0; row < frame.rows; ++row)
    contacts.push_back({static_cast<long>(i[row]), static_cast<long>(j[row]), wall[row] != 0,
                        vector_at(frame, {"x", "y", "z"}, row),
                        vector_at(frame, {"fx", "fy", "fz"}, row),
                        vector_at(frame, {"bix", "biy", "biz"}, row),
                        vector_at(frame, {"bjx", "bjy", "bjz"}, row)});
  return contacts;
}

AveragingKernel averaging_kernel(const Packing& packing, const FieldOptions& options) {
  return {kernel_shape(options.kernel), 2, averaging_scale(packing, options),
          gaussian_cutoff(options.tolerance, 2)};
}

CoarseGrainingOptions averaging_options(const Packing& packing, const FieldOptions& options) {
  CoarseGrainingOptions averaging;
  averaging.line = LineRule::named(options.line, options.tolerance);
  averaging.couple_stress = options.couple_stress;
  if (!packing.walls.sides) averaging.period[0] = packing.walls.width();
  if (!packing.walls.bottom) averaging.period[1] = packing.walls.ceiling - packing.walls.floor;
  return averaging;
}

std::vector<Particle> read_particles(const Frame& bodies, const std::vector<double>& extent,
                                     const std::vector<TouchingPair>& pairs) {
  std::unordered_map<long, Touching> touching;
  for (const auto& pair : pairs)
    for (const long body : {pair.i, pair.j}) {
      ++touching[body].particles;
      touching[body].contacts += pair.contacts;
    }
  const auto& id = bodies.column("id");
  const auto& mass = bodies.column("mass");
  std::vector<Particle> particles;
  for (std::size_t row = 0; row < bodies.rows; ++row)
    particles.push_back({vector_at(bodies, {"x", "y", "z"}, row),
                         vector_at(bodies, {"vx", "vy", "vz"}, row), mass[row], extent[row],
                         touching[static_cast<long>(id[row])]});
  return particles;
}

namespace {

// A contact far from the particles that it is of belongs to a damaged file, and would make branch
// vectors of any length.
void require_near(const Frame& contacts, const std::vector<SphereContact>& read,
                  const Frame& bodies) {
  if (!bodies.has("half_length")) return;
  const auto& id = bodies.column("id");
  const auto& half_length = bodies.column("half_length");
  std::unordered_map<long, double> longest;
  for (std::size_t row = 0; row < bodies.rows; ++row)
    longest[static_cast<long>(id[row])] = 2 * half_length[row];
  const auto check = [&](std::size_t row, long body, const Vector& centre, const Vector& point) {
    const double distance =
        std::hypot(point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]);
    if (!(distance <= longest.at(body)))
      throw DataError(at_row(contacts, row) + "expected the contact within " +
                      number_text(longest.at(body), 4) + " m of the centre of particle " +
                      std::to_string(body) + " (twice its half length), found " +
                      number_text(distance, 4) + " m");
  };
  for (std::size_t row = 0; row < read.size(); ++row) {
    const auto& contact = read[row];
    check(row, contact.i, contact.centre_i, contact.point);
    if (!contact.wall) check(row, contact.j, contact.centre_j, contact.point);
  }
}

}  // namespace

void AveragedFrame::add_to(CoarseGraining& averages) const {
  for (const auto& interaction : interactions) averages.add(interaction);
  for (const auto& particle : particles) averages.add(particle);
}

AveragedFrame averaged_frame(const Frame& bodies, const Frame* contacts, int dimension) {
  ContactPairs pairs;
  if (contacts) {
    if (contacts->timestep != bodies.timestep)
      throw DataError(where(*contacts) + ": contacts of timestep " +
                      std::to_string(contacts->timestep) + ", expected " +
                      std::to_string(bodies.timestep) + " as in " + bodies.file);
    if (dimension == 2) require_planar_contacts(*contacts);
    const auto read = read_contacts(*contacts);
    std::unordered_set<long> known;
    for (const double id : bodies.column("id")) known.insert(static_cast<long>(id));
    for (const auto& contact : read)
      for (const long body : {contact.i, contact.wall ? contact.i : contact.j})
        if (!known.count(body))
          throw DataError(where(*contacts) + ": particle " + std::to_string(body) +
                          " of a contact is not in " + bodies.file);
    require_near(*contacts, read, bodies);
    require_contacts_of_bodies(*contacts, bodies);
    pairs = sum_pairs(read);
  }
  require_motion(bodies);
  const auto extent = dimension == 2 ? bodies.column("area") : body_volumes(bodies);
  return {read_particles(bodies, extent, pairs.pairs), pairs.interactions};
}

void add_frame(CoarseGraining& averages, const Frame& bodies, const Frame* contacts) {
  averaged_frame(bodies, contacts, averages.kernel().dimension()).add_to(averages);
}

void FieldSample::add(const Packing& packing, const Frame& bodies, const Frame* contacts) {
  if (!averages_) {
    averages_ = std::make_unique<CoarseGraining>(averaging_kernel(packing, options_),
                                                 field_grid(packing, options_),
                                                 averaging_options(packing, options_));
    space_ = counted_space(packing, options_.normalisation);
  }
  add_frame(*averages_, bodies, contacts);
  ++frames_;
}

const CoarseGraining& FieldSample::averages() const {
  if (!averages_) throw TooFewParticles("no frame to average");
  return *averages_;
}

std::vector<Field> FieldSample::fields() const {
  auto fields = averages().fields(frames_);
  if (options_.normalisation != Normalisation::none) normalise_by_share(averages(), space_, fields);
  return fields;
}

const Field& field_named(const std::vector<Field>& fields, const std::string& name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const Field& field) { return field.name == name; });
  if (found == fields.end()) throw std::out_of_range("no field " + name);
  return *found;
}

PrincipalStress principal_stress(double xx, double xy, double yx, double yy) {
  const double mean = 0.5 * (xx + yy);
  const double shear = 0.5 * (xy + yx);
  const double radius = std::hypot(0.5 * (xx - yy), shear);
  double direction = 0.5 * std::atan2(2 * shear, xx - yy) * 180 / pi;
  if (direction < 0) direction += 180;
  return {mean + radius, mean - radius, direction};
}

double anisotropy(const PrincipalStress& stress) {
  const double sum = stress.larger + stress.smaller;
  return sum > 0 ? (stress.larger - stress.smaller) / sum : 0;
}

void write_fields(const CoarseGraining& averages, const std::vector<Field>& fields, double time_s,
                  const std::string& stem) {
  write_text(stem + ".csv", csv_text(averages, fields));
  if (!write_field_image(*averages.grid(), fields, time_s, stem + ".vti"))
    throw DataError(stem + ".vti: cannot be written");
}

}  // namespace rodpack
