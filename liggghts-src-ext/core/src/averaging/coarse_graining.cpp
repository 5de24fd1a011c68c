// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/coarse_graining.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rodpack {

namespace {

// First of each kind among the sums that the particles make; D momenta and D (D + 1) / 2 products
// of velocities follow.
enum ParticleSum : std::size_t { number, mass, extent, partners, contacts, momentum };

}  // namespace

CoarseGraining::CoarseGraining(const AveragingKernel& kernel, const Grid& grid,
                               const CoarseGrainingOptions& options)
    : kernel_(kernel), dimension_(kernel.dimension()), gridded_(true), grid_(grid) {
  for (std::size_t d = 0; d < 3; ++d) {
    const std::string axis = std::string("grid along ") + "xyz"[d];
    if (grid.count[d] < 1) throw std::invalid_argument(axis + " has no places");
    if (!(grid.spacing[d] > 0)) throw std::invalid_argument(axis + ": spacing must be > 0");
  }
  if (dimension_ == 2 && grid.count[2] != 1)
    throw std::invalid_argument("a grid with z belongs to three dimensions");
  columns_ = grid.count[0];
  places_ = grid.size();
  for (int k = 0; k < grid.count[2]; ++k)
    for (int j = 0; j < grid.count[1]; ++j)
      rows_.push_back({grid.origin[0], grid.origin[1] + j * grid.spacing[1],
                       grid.origin[2] + k * grid.spacing[2]});
  low_ = grid.origin;
  high_ = grid.place(places_ - 1);
  prepare(options);
}

CoarseGraining::CoarseGraining(const AveragingKernel& kernel, std::vector<Vector> places,
                               const CoarseGrainingOptions& options)
    : kernel_(kernel),
      dimension_(kernel.dimension()),
      gridded_(false),
      scattered_(std::move(places)),
      columns_(1),
      places_(scattered_.size()) {
  if (scattered_.empty()) throw std::invalid_argument("there are no places to average at");
  order_.resize(places_);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return scattered_[a][1] < scattered_[b][1];
  });
  low_ = high_ = scattered_.front();
  for (const std::size_t index : order_) {
    const Vector& place = scattered_[index];
    rows_.push_back({place[0], place[1], place[2]});
    for (std::size_t d = 0; d < 3; ++d) {
      low_[d] = std::min(low_[d], place[d]);
      high_[d] = std::max(high_[d], place[d]);
    }
  }
  prepare(options);
}

void CoarseGraining::prepare(const CoarseGrainingOptions& options) {
  options_ = options;
  const auto D = static_cast<std::size_t>(dimension_);
  particle_sums_ = momentum + D + D * (D + 1) / 2;
  line_sums_ = D * D + (options.couple_stress ? (D == 2 ? 2 : 9) : 0);
  sums_.assign((particle_sums_ + line_sums_ + D) * places_, 0.0);
  weights_.resize(static_cast<std::size_t>(columns_));
  factors_.resize(static_cast<std::size_t>(columns_));
}

// Visits the shift by whole periods of every image of the box low ... high that may reach a place.
template <class Visit>
void CoarseGraining::for_images(const Vector& low, const Vector& high, Visit visit) const {
  std::array<int, 3> first{{0, 0, 0}}, last{{0, 0, 0}};
  const double reach = kernel_.cutoff();
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension_); ++d) {
    const double period = options_.period[d];
    if (period > 0) {
      first[d] = static_cast<int>(std::ceil((low_[d] - reach - high[d]) / period));
      last[d] = static_cast<int>(std::floor((high_[d] + reach - low[d]) / period));
    } else if (low[d] > high_[d] + reach || high[d] < low_[d] - reach) {
      return;
    }
  }
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i)
        visit(Vector{{i * options_.period[0], j * options_.period[1], k * options_.period[2]}});
}

// Visits the indices of the rows within the cut-off of the box low ... high, by y (and z).
template <class Visit>
void CoarseGraining::for_rows(const Vector& low, const Vector& high, Visit visit) const {
  const double reach = kernel_.cutoff();
  if (!gridded_) {
    const auto below = [](const GridRow& row, double y) { return row.y < y; };
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), low[1] - reach, below);
    for (auto row = begin; row != rows_.end() && row->y <= high[1] + reach; ++row)
      visit(static_cast<std::size_t>(row - rows_.begin()));
    return;
  }
  const auto range = [&](std::size_t d) {
    const double from = std::ceil((low[d] - reach - grid_.origin[d]) / grid_.spacing[d]);
    const double to = std::floor((high[d] + reach - grid_.origin[d]) / grid_.spacing[d]);
    return Range{static_cast<int>(std::max(from, 0.0)),
                 static_cast<int>(std::min(to, grid_.count[d] - 1.0)) + 1};
  };
  const Range y = range(1);
  const Range z = dimension_ == 3 ? range(2) : Range{0, 1};
  for (int k = z.begin; k < z.end; ++k)
    for (int j = y.begin; j < y.end; ++j) visit(static_cast<std::size_t>(k * grid_.count[1] + j));
}

// The places of a row with low <= x <= high.
CoarseGraining::Range CoarseGraining::columns_within(const GridRow& row, double low,
                                                     double high) const {
  if (!gridded_) return {0, row.x >= low && row.x <= high ? 1 : 0};
  const double from = std::ceil((low - row.x) / grid_.spacing[0]);
  const double to = std::floor((high - row.x) / grid_.spacing[0]);
  return {static_cast<int>(std::max(from, 0.0)),
          static_cast<int>(std::min(to, columns_ - 1.0)) + 1};
}

// Adds values[k] weights_[column] to the sums first + k along a row.
void CoarseGraining::add_weighted(std::size_t row, Range columns, std::size_t first,
                                  std::size_t count, const double* values) {
  const std::size_t start = gridded_ ? row * static_cast<std::size_t>(columns_) : order_[row];
  const double* const weight = weights_.data();
  for (std::size_t k = 0; k < count; ++k) {
    double* const sum = sums_.data() + (first + k) * places_ + start;
    const double value = values[k];
    for (int i = columns.begin; i < columns.end; ++i) sum[i] += value * weight[i];
  }
}

// Adds values[k] phi(place - centre) to the sums first + k.
void CoarseGraining::spread(const Vector& centre, std::size_t first, std::size_t count,
                            const double* values) {
  const double reach = kernel_.cutoff();
  const bool product = gridded_ && kernel_.shape() == KernelShape::gaussian;
  if (product) {  // the factors of x are the same in all rows
    const Range all = columns_within(rows_.front(), centre[0] - reach, centre[0] + reach);
    for (int i = all.begin; i < all.end; ++i)
      factors_[static_cast<std::size_t>(i)] =
          kernel_.axis_factor(grid_.origin[0] + i * grid_.spacing[0] - centre[0]);
  }
  for_rows(centre, centre, [&](std::size_t index) {
    const GridRow& row = rows_[index];
    const double y = row.y - centre[1];
    const double z = dimension_ == 3 ? row.z - centre[2] : 0.0;
    const double across = y * y + z * z;
    const double half_squared = reach * reach - across;
    if (half_squared < 0) return;
    const double half = std::sqrt(half_squared);
    const Range columns = columns_within(row, centre[0] - half, centre[0] + half);
    if (columns.end <= columns.begin) return;
    if (product) {
      const double factor = kernel_.norm() * kernel_.axis_factor(std::sqrt(across));
      for (int i = columns.begin; i < columns.end; ++i)
        weights_[static_cast<std::size_t>(i)] = factor * factors_[static_cast<std::size_t>(i)];
    } else {
      for (int i = columns.begin; i < columns.end; ++i) {
        const double x = row.x + i * grid_.spacing[0] - centre[0];
        weights_[static_cast<std::size_t>(i)] = kernel_(x * x + across);
      }
    }
    add_weighted(index, columns, first, count, values);
  });
}

void CoarseGraining::add(const Particle& particle) {
  double values[14] = {1.0, particle.mass, particle.extent,
                       static_cast<double>(particle.touching.particles),
                       static_cast<double>(particle.touching.contacts)};
  double* next = values + momentum;
  for (int a = 0; a < dimension_; ++a)
    *next++ = particle.mass * particle.velocity[static_cast<std::size_t>(a)];
  for (int a = 0; a < dimension_; ++a)
    for (int b = a; b < dimension_; ++b)
      *next++ = particle.mass * particle.velocity[static_cast<std::size_t>(a)] *
                particle.velocity[static_cast<std::size_t>(b)];
  for_images(particle.centre, particle.centre, [&](const Vector& shift) {
    Vector centre = particle.centre;
    for (std::size_t d = 0; d < 3; ++d) centre[d] += shift[d];
    spread(centre, 0, particle_sums_, values);
  });
}

void CoarseGraining::add(const Interaction& interaction) {
  Vector low, high;
  for (std::size_t d = 0; d < 3; ++d) {
    const double end = interaction.from[d] + interaction.branch[d];
    low[d] = std::min(interaction.from[d], end);
    high[d] = std::max(interaction.from[d], end);
  }
  for_images(low, high, [&](const Vector& shift) {
    Vector from = interaction.from;
    for (std::size_t d = 0; d < 3; ++d) from[d] += shift[d];
    spread_line(interaction, from);
    if (!interaction.wall) return;
    Vector end = from;
    for (std::size_t d = 0; d < 3; ++d) end[d] += interaction.branch[d];
    spread(end, particle_sums_ + line_sums_, static_cast<std::size_t>(dimension_),
           interaction.force.data());
  });
}

// Contact stress and couple stress of one interaction whose particle i is at `from`.
void CoarseGraining::spread_line(const Interaction& interaction, const Vector& from) {
  const auto D = static_cast<std::size_t>(dimension_);
  const Vector& f = interaction.force;
  const Vector& r = interaction.branch;
  const Vector& moment = interaction.moment;
  // The moment of the force about x(s) is `moment` - s `lever`.
  const Vector lever{
      {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]}};

  double values[18], slopes[18];  // what a kernel of weight 1, and of weight s, adds to the sums
  std::size_t n = 0;
  for (std::size_t a = 0; a < D; ++a)
    for (std::size_t b = 0; b < D; ++b) {
      values[n] = -f[a] * r[b];
      slopes[n++] = 0.0;
    }
  if (options_.couple_stress)
    for (std::size_t a = D == 2 ? 2 : 0; a < 3; ++a)
      for (std::size_t b = 0; b < D; ++b) {
        values[n] = -moment[a] * r[b];
        slopes[n++] = lever[a] * r[b];
      }

  double length_squared = 0;
  for (std::size_t d = 0; d < D; ++d) length_squared += r[d] * r[d];
  const auto nodes =
      line_nodes(options_.line, kernel_.shape(), std::sqrt(length_squared) / kernel_.scale(),
                 options_.couple_stress ? 1 : 0);
  double weighted[18];
  for (const LineNode& node : nodes) {
    Vector centre = from;
    for (std::size_t d = 0; d < 3; ++d) centre[d] += node.s * r[d];
    for (std::size_t k = 0; k < n; ++k)
      weighted[k] = node.weight * (values[k] + node.s * slopes[k]);
    spread(centre, particle_sums_, n, weighted);
  }
  if (!nodes.empty()) return;

  Vector low = from, high = from;
  for (std::size_t d = 0; d < D; ++d) (r[d] < 0 ? low : high)[d] += r[d];
  const double reach = kernel_.cutoff();
  const std::size_t stresses = D * D;
  for_rows(low, high, [&](std::size_t index) {
    const GridRow& row = rows_[index];
    const Range columns = columns_within(row, low[0] - reach, high[0] + reach);
    for (int i = columns.begin; i < columns.end; ++i) {
      const double x = row.x + i * grid_.spacing[0];
      const double offset[3] = {x - from[0], row.y - from[1], row.z - from[2]};
      const LineIntegral integral = kernel_.along(offset, r.data());
      if (integral.mean == 0) continue;
      for (std::size_t k = 0; k < n; ++k)
        weighted[k] = values[k] * integral.mean + (k < stresses ? 0 : slopes[k] * integral.moment);
      weights_[static_cast<std::size_t>(i)] = 1.0;
      add_weighted(index, {i, i + 1}, particle_sums_, n, weighted);
    }
  });
}

}  // namespace rodpack
