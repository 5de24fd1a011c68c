// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/stock/stock_dumps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "analysis/pairs/pair_configuration.h"
#include "reading/angles.h"
#include "reading/checks/body_axes.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

using Rows = std::vector<std::size_t>;

std::string header_of(const Frame& frame) {
  return frame.file + ":" + std::to_string(frame.header_line) + ": ";
}

std::string body_column(const Frame& frame) {
  for (const char* name : {"id_multisphere", "mol"})
    if (frame.has(name)) return name;
  return "";
}

// Columns that a dump custom may have, or not; all of a line, or none counts.
const std::vector<std::string> motion[] = {
    {"mass"}, {"vx", "vy", "vz"}, {"omegax", "omegay", "omegaz"}};

bool has_all(const Frame& frame, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return frame.has(name); });
}

// A straight chain of equal spheres.
struct StraightChain {
  Vector3 centre{}, axis{1, 0, 0};
  double length = 0;  // between the end centres, m
};

class StockBodies {
 public:
  explicit StockBodies(const Frame& spheres)
      : spheres_(spheres),
        place_(vector_columns(spheres, {"x", "y", "z"})),
        radius_(spheres.column("radius")) {
    for (const char* name : {"id", "type", "nspheres", "x", "y", "z", "angle", "qw", "qx", "qy",
                             "qz", "half_length", "radius", "curvature", "area"})
      bodies_.names.emplace_back(name);
    for (const auto& quantity : motion)
      if (has_all(spheres, quantity))
        bodies_.names.insert(bodies_.names.end(), quantity.begin(), quantity.end());
    bodies_.columns.resize(bodies_.names.size());
    bodies_.bad_fields.resize(bodies_.names.size());
    bodies_.file = spheres.file;
    bodies_.header_line = spheres.header_line;
    bodies_.timestep = spheres.timestep;
    bodies_.bounds = spheres.bounds;
    bodies_.periodic = spheres.periodic;
  }

  Frame result() {
    const auto body = bodies_of_spheres(spheres_);
    std::map<double, Rows> rows_of;
    for (std::size_t row = 0; row < spheres_.rows; ++row) rows_of[body[row]].push_back(row);
    for (const auto& [key, rows] : rows_of) add(key, rows);
    return bodies_;
  }

 private:
  [[noreturn]] void refuse(double id, const std::string& found) const {
    throw DataError(header_of(spheres_) + "body " + number_text(id) +
                    ": expected the equal spheres of a straight chain, found " + found +
                    "; 'dump bodies all multisphere/body 10000 bodies.*.dump' in the deck tells " +
                    "any body");
  }

  // Of a sphere, in the image nearest to the place of another one.
  Vector3 near(std::size_t row, const Vector3& other) const {
    Vector3 at{};
    for (std::size_t c = 0; c < 3; ++c) {
      at[c] = (*place_[c])[row];
      const double period = spheres_.bounds[c][1] - spheres_.bounds[c][0];
      if (spheres_.periodic[c]) at[c] -= period * std::round((at[c] - other[c]) / period);
    }
    return at;
  }

  StraightChain chain_of(double id, const Rows& rows) const {
    StraightChain chain;
    const double r = radius_[rows[0]];
    std::vector<Vector3> places{
        near(rows[0], {(*place_[0])[rows[0]], (*place_[1])[rows[0]], (*place_[2])[rows[0]]})};
    for (std::size_t k = 1; k < rows.size(); ++k) {
      if (std::abs(radius_[rows[k]] - r) > 1e-4 * r) refuse(id, "spheres of different radii");
      places.push_back(near(rows[k], places[0]));
    }
    // Longer than a reach from one sphere to all others: the farthest one is an end, and the one
    // farthest from that is the other.
    const auto farthest = [&](const Vector3& from) {
      return *std::max_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
        return distance(a, from) < distance(b, from);
      });
    };
    const Vector3 end = farthest(places[0]), begin = farthest(end);
    chain.length = distance(begin, end);
    for (std::size_t c = 0; c < 3; ++c) chain.centre[c] = 0.5 * (begin[c] + end[c]);
    if (rows.size() < 2) return chain;
    if (!(chain.length > 0)) refuse(id, "spheres at one place");
    for (std::size_t c = 0; c < 3; ++c) chain.axis[c] = (end[c] - begin[c]) / chain.length;
    require_even(id, places, begin, chain, r);
    return chain;
  }

  // Spheres on the line, at even distances: a dump of a part of them would be a shorter rod.
  void require_even(double id, const std::vector<Vector3>& places, const Vector3& begin,
                    const StraightChain& chain, double radius) const {
    constexpr double slack = 2e-3;  // of the radius; a dump may print six digits
    std::vector<double> along;
    for (const auto& place : places) {
      double reach = 0, square = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        reach += (place[c] - begin[c]) * chain.axis[c];
        square += (place[c] - begin[c]) * (place[c] - begin[c]);
      }
      if (std::sqrt(std::max(0.0, square - reach * reach)) > 0.05 * radius)
        refuse(id, "spheres beside a line");
      along.push_back(reach);
    }
    std::sort(along.begin(), along.end());
    const double step = chain.length / static_cast<double>(places.size() - 1);
    for (std::size_t k = 1; k < along.size(); ++k)
      if (std::abs(along[k] - along[k - 1] - step) > slack * radius + 1e-5 * chain.length)
        refuse(id, "uneven distances between them (a group that leaves some out?)");
    if (step > 2 * radius * (1 + slack)) refuse(id, "spheres that do not touch");
  }

  static double distance(const Vector3& a, const Vector3& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  void add(double id, const Rows& rows) {
    const auto chain = chain_of(id, rows);
    const double r = radius_[rows[0]], half_length = chain.length / 2 + r;
    auto axis = chain.axis;  // no head: the half of space on +x, where the turn below is shortest
    if (axis[0] < 0)
      for (auto& each : axis) each = -each;
    const double turn = std::sqrt(2 * (1 + axis[0]));
    double angle = std::atan2(axis[1], axis[0]);
    if (angle < 0) angle += 2 * pi;
    const auto count = static_cast<double>(rows.size());
    double area = pi * r * r;
    if (rows.size() > 1)
      area = covered_area(
          shape_of_body(static_cast<int>(rows.size()), half_length / r, 2 * r, 2 * r, 0));
    const double values[] = {id,
                             spheres_.column("type")[rows[0]],
                             count,
                             inside(chain.centre, 0),
                             inside(chain.centre, 1),
                             inside(chain.centre, 2),
                             angle,
                             turn / 2,
                             0,
                             -axis[2] / turn,
                             axis[1] / turn,
                             half_length,
                             r,
                             0,
                             area};
    constexpr std::size_t always = std::size(values);
    for (std::size_t c = 0; c < always; ++c) bodies_.columns[c].push_back(values[c]);
    for (std::size_t c = always; c < bodies_.names.size(); ++c)
      bodies_.columns[c].push_back(mean_of(id, bodies_.names[c], rows));
    ++bodies_.rows;
  }

  // The chain is symmetric, so that its centre has the mean velocity; of what all spheres of a body
  // have in common it is that.
  double mean_of(double id, const std::string& name, const Rows& rows) const {
    const auto& values = spheres_.column(name);
    double sum = 0;
    for (const auto row : rows) {
      if (name == "mass" && std::abs(values[row] - values[rows[0]]) > 1e-4 * values[rows[0]])
        refuse(id, "spheres of different mass, each of which has the body's in a body");
      sum += values[row];
    }
    return sum / static_cast<double>(rows.size());
  }

  // Back into the period, as the dump of bodies has its centres.
  double inside(const Vector3& place, std::size_t axis) const {
    if (!spheres_.periodic[axis]) return place[axis];
    const double low = spheres_.bounds[axis][0], period = spheres_.bounds[axis][1] - low;
    return place[axis] - period * std::floor((place[axis] - low) / period);
  }

  const Frame& spheres_;
  VectorColumns place_;
  const std::vector<double>& radius_;
  Frame bodies_;
};

}  // namespace

bool is_stock_dump(const Frame& frame) {
  return !frame.has("nspheres") && !frame.has("half_length") && !frame.has("body") &&
         !body_column(frame).empty() && has_all(frame, {"id", "type", "x", "radius"});
}

std::string why_no_motion(const Frame& bodies) {
  if (has_all(bodies, {"mass", "vx", "vy", "vz"})) return "";
  return header_of(bodies) +
         "expected particles with mass and velocity, which fields need, found some without; "
         "'mass vx vy vz' among the columns of the dump custom tell them";
}

void require_motion(const Frame& bodies) {
  const auto why = why_no_motion(bodies);
  if (!why.empty()) throw DataError(why);
}

std::vector<double> bodies_of_spheres(const Frame& spheres) {
  auto body = spheres.column(body_column(spheres));
  const auto& id = spheres.column("id");
  double largest = 0;
  for (const double each : body) largest = std::max(largest, each);
  for (std::size_t row = 0; row < spheres.rows; ++row)
    if (!(body[row] > 0)) body[row] = largest + id[row];
  return body;
}

Frame as_bodies(const Frame& frame) {
  if (frame.has("nspheres") || frame.has("half_length")) return frame;
  if (frame.has("body_i") || frame.has("body") || !frame.has("x"))
    throw DataError(header_of(frame) + "expected a dump of bodies, found one of " +
                    (frame.has("body_i") ? "contacts"
                     : frame.has("body") ? "spheres"
                                         : "something else") +
                    "; 'dump bodies all multisphere/body 10000 bodies.*.dump' in the deck writes " +
                    "bodies");
  for (const char* name : {"id", "type", "radius"})
    if (!frame.has(name) || body_column(frame).empty())
      throw DataError(
          header_of(frame) +
          "expected a dump of bodies, found one of spheres without all of the columns "
          "id type x y z radius id_multisphere; 'dump bodies all multisphere/body 10000 "
          "bodies.*.dump' in the deck writes bodies");
  return StockBodies(frame).result();
}

std::string why_no_contact_dump(const Frame& frame) {
  if (frame.has("body_i")) return "";
  return header_of(frame) + "expected a dump of contacts, found one without 'body_i'; " +
         "'dump contacts all contact/gran 10000 contacts.*.dump' in the deck writes them; " +
         "those of LIGGGHTS's own 'compute pair/gran/local' are read with --local";
}

void require_contact_dump(const Frame& frame) {
  const auto why = why_no_contact_dump(frame);
  if (!why.empty()) throw DataError(why);
}

}  // namespace rodpack
