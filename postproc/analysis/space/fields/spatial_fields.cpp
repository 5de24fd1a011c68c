// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/fields/spatial_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/edges/undisturbed.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr double no_wall = std::numeric_limits<double>::infinity();

// What the averages cover: between the walls, a little above the surface.
struct OppositeCorners {
  Vector low, high;
};

OppositeCorners corners_of(const SpatialPacking& packing, double above) {
  const auto& walls = packing.walls;
  OppositeCorners corners{walls.low, walls.high};
  if (walls.round)
    for (const std::size_t which : {0U, 1U}) {
      corners.low[walls.horizontal(which)] = walls.middle[which] - walls.radius;
      corners.high[walls.horizontal(which)] = walls.middle[which] + walls.radius;
    }
  if (!walls.periodic[walls.vertical]) corners.high[walls.vertical] = packing.surface + above;
  return corners;
}

UprightContainer counted_container(const SpatialPacking& packing, Normalisation normalisation) {
  const auto& walls = packing.walls;
  UprightContainer container = walls;
  container.high[walls.vertical] =
      normalisation == Normalisation::walls_and_surface ? packing.surface : no_wall;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (walls.periodic[axis]) {
      container.low[axis] = -no_wall;
      container.high[axis] = no_wall;
    }
  return container;
}

Grid grid_between(const OppositeCorners& corners, double spacing) {
  try {
    return checked_grid(filling_grid(3, corners.low, corners.high, spacing));
  } catch (const std::invalid_argument& reason) {
    throw DataError(reason.what());
  }
}

// One plane of such a grid.
Grid grid_of(const Slice& slice, OppositeCorners corners, double spacing) {
  if (slice.at < corners.low[slice.axis] || slice.at > corners.high[slice.axis])
    throw DataError(std::string("slice: expected ") + "xyz"[slice.axis] + " of " +
                    number_text(corners.low[slice.axis]) + " to " +
                    number_text(corners.high[slice.axis]) + " m, found " + number_text(slice.at));
  corners.low[slice.axis] = slice.at;
  corners.high[slice.axis] = slice.at + spacing;
  auto grid = grid_between(corners, spacing);
  grid.count[slice.axis] = 1;
  return grid;
}

}  // namespace

double averaging_scale(const SpatialPacking& packing, const FieldOptions& options) {
  const double diameters = options.scale_in_diameters.value_or(packing.aspect_ratio / 2);
  return options.scale.value_or(diameters * packing.particle_diameter);
}

std::vector<Slice> middle_slices(const SpatialPacking& packing) {
  const auto& walls = packing.walls;
  const auto corners = corners_of(packing, 0);
  const auto middle = [&](std::size_t axis) {
    return Slice{axis, 0.5 * (corners.low[axis] + corners.high[axis])};
  };
  return {middle(walls.horizontal(1)), middle(walls.vertical)};
}

double distance_to_edges(const SpatialPacking& packing, const Vector3& place,
                         Normalisation normalisation) {
  const auto& walls = packing.walls;
  double distance = no_wall;
  if (normalisation == Normalisation::none)
    distance = std::min(walls.distance_to_sides(place), walls.height(place));
  if (normalisation != Normalisation::walls_and_surface && !walls.periodic[walls.vertical])
    distance = std::min(distance, packing.surface - place[walls.vertical]);
  return distance;
}

SpatialFieldSample::SpatialFieldSample(FieldOptions options, std::vector<Slice> slices)
    : options_(std::move(options)), slices_(std::move(slices)), slices_given_(!slices_.empty()) {
  if (options_.normalisation != Normalisation::none && options_.kernel != "gaussian")
    throw DataError("--normalise: expected the kernel gaussian in space, found " + options_.kernel);
}

void SpatialFieldSample::start(const SpatialPacking& packing) {
  const auto& walls = packing.walls;
  if (!(packing.surface > walls.low[walls.vertical]))
    throw TooFewParticles("fields: there is no bed above the floor");
  const double scale = averaging_scale(packing, options_);
  const AveragingKernel kernel(kernel_shape(options_.kernel), 3, scale,
                               gaussian_cutoff(options_.tolerance, 3));
  CoarseGrainingOptions averaging;
  averaging.line = LineRule::named(options_.line, options_.tolerance);
  averaging.couple_stress = options_.couple_stress;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (walls.periodic[axis]) averaging.period[axis] = walls.high[axis] - walls.low[axis];
  const double above = options_.normalisation == Normalisation::walls_and_surface ? 0 : scale;
  const auto corners = corners_of(packing, above);
  const double spacing = options_.spacing.value_or(scale / 2);
  grid_ = std::make_unique<CoarseGraining>(kernel, grid_between(corners, spacing), averaging);
  if (!slices_given_) slices_ = middle_slices(packing);
  for (const auto& slice : slices_)
    on_slices_.emplace_back(kernel, grid_of(slice, corners, options_.spacing.value_or(scale / 4)),
                            averaging);
  if (walls.round) {
    rings_.emplace(walls, corners.high[walls.vertical], spacing, scale / 2);
    on_rings_ = std::make_unique<CoarseGraining>(kernel, rings_->places(), averaging);
  }
  container_ = counted_container(packing, options_.normalisation);
  packing_ = packing;
}

void SpatialFieldSample::add(const SpatialPacking& packing, const Frame& bodies,
                             const Frame* contacts) {
  const auto frame = averaged_frame(bodies, contacts, 3);
  if (!packing_) start(packing);
  frame.add_to(*grid_);
  for (auto& slice : on_slices_) frame.add_to(slice);
  if (on_rings_) frame.add_to(*on_rings_);
  ++frames_;
}

const SpatialPacking& SpatialFieldSample::packing() const {
  if (!packing_) throw TooFewParticles("no frame to average");
  return *packing_;
}

const CoarseGraining& SpatialFieldSample::averages() const {
  packing();
  return *grid_;
}

std::vector<Field> SpatialFieldSample::fields_of(const CoarseGraining& averages) const {
  auto fields = averages.fields(frames_);
  if (options_.normalisation != Normalisation::none)
    normalise_by_share(averages, container_, fields);
  return fields;
}

std::vector<Field> SpatialFieldSample::fields() const { return fields_of(averages()); }

std::vector<Section> SpatialFieldSample::sections() const {
  std::vector<Section> sections;
  for (std::size_t k = 0; k < on_slices_.size(); ++k)
    sections.push_back(
        slice_section(slices_[k], packing().walls, on_slices_[k], fields_of(on_slices_[k])));
  return sections;
}

std::optional<Section> SpatialFieldSample::rings() const {
  packing();
  if (!rings_) return std::nullopt;
  return rings_->means(fields_of(*on_rings_));
}

std::optional<InteriorMean> interior_solid_fraction(const SpatialFieldSample& sample) {
  const auto fields = sample.fields();
  const auto& values = field_named(fields, "solid_fraction").values[0];
  const double reach = kernel_reach(sample.averages().kernel()) * (1 - 1e-5);
  double sum = 0, squares = 0;
  std::size_t places = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto place = sample.averages().place(i);
    const bool inside = distance_to_edges(sample.packing(), place, Normalisation::none) >= 0;
    if (!inside || distance_to_edges(sample.packing(), place, sample.normalisation()) < reach)
      continue;
    sum += values[i];
    squares += values[i] * values[i];
    ++places;
  }
  if (places == 0) return std::nullopt;
  const double count = static_cast<double>(places), mean = sum / count;
  return InteriorMean{mean, std::sqrt(std::max(0.0, squares / count - mean * mean)), places};
}

}  // namespace rodpack
