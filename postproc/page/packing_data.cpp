// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/packing_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include "analysis/force_chains.h"
#include "figures/drawing.h"
#include "figures/packings/base64.h"
#include "page/html.h"
#include "reading/angles.h"
#include "reading/number_text.h"
#include "reading/packing.h"
#include "reading/run_folder.h"

namespace rodpack {
namespace {
using Json = nlohmann::ordered_json;

constexpr double largest16 = 65535;
constexpr int shades = 64;

// Whole numbers of so many bytes, little endian, in base64.
std::string packed(const std::vector<std::uint32_t>& values, int bytes) {
  std::string raw;
  raw.reserve(values.size() * static_cast<std::size_t>(bytes));
  for (const auto value : values)
    for (int k = 0; k < bytes; ++k) raw += static_cast<char>(value >> (8 * k) & 255U);
  return base64(raw);
}

std::uint32_t quantised(double value, double lowest, double highest) {
  if (!(highest > lowest)) return 0;
  const double part = std::clamp((value - lowest) / (highest - lowest), 0.0, 1.0);
  return static_cast<std::uint32_t>(std::lround(part * largest16));
}

// A column in the order of the particles, 16 bits each; tells its range too.
void put_column(Json& data, const std::string& name, const std::vector<double>& column,
                const std::vector<std::size_t>& order) {
  const auto [lowest, highest] = std::minmax_element(column.begin(), column.end());
  std::vector<std::uint32_t> values;
  for (const auto row : order) values.push_back(quantised(column[row], *lowest, *highest));
  data[name + "_range"] = {*lowest, *highest};
  data[name] = packed(values, 2);
}

// Rows of the spheres' dump by particle, in order of their own ids.
std::map<long, std::vector<std::size_t>> spheres_by_body(const Frame& spheres) {
  const auto& body = spheres.column("body");
  const auto& id = spheres.column("id");
  std::map<long, std::vector<std::size_t>> rows;
  for (std::size_t row = 0; row < spheres.rows; ++row) rows[std::lround(body[row])].push_back(row);
  for (auto& of_body : rows)
    std::sort(of_body.second.begin(), of_body.second.end(),
              [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  return rows;
}

/// Where the spheres of a particle lie in its own frame, in units of 2 (half length − radius), the
/// length of its centreline between the end centres: the same for all particles of a shape.
class BodyFrame {
 public:
  BodyFrame(const Frame& bodies, const Frame& spheres)
      : bodies_(bodies),
        spheres_(spheres),
        period_(spheres.periodic[0] ? spheres.bounds[0][1] - spheres.bounds[0][0] : 0) {}

  double unit(std::size_t body) const {
    return 2 * (bodies_.column("half_length")[body] - bodies_.column("radius")[body]);
  }
  std::array<double, 2> centre(std::size_t body, std::size_t sphere) const {
    double dx = spheres_.column("x")[sphere] - bodies_.column("x")[body];
    const double dy = spheres_.column("y")[sphere] - bodies_.column("y")[body];
    if (period_ > 0) dx -= period_ * std::round(dx / period_);
    const double angle = bodies_.column("angle")[body];
    const double c = std::cos(angle), s = std::sin(angle);
    const double length = unit(body) > 0 ? unit(body) : 1;
    return {(c * dx + s * dy) / length, (c * dy - s * dx) / length};
  }

 private:
  const Frame& bodies_;
  const Frame& spheres_;
  double period_;
};

/// The shapes among the particles: mostly one.
class Shapes {
 public:
  Shapes(const Frame& bodies, const Frame& spheres)
      : bodies_(bodies),
        spheres_(spheres),
        frame_(bodies, spheres),
        rows_(spheres_by_body(spheres)) {}

  /// Rows of the spheres of the particle in this row of the bodies' dump.
  const std::vector<std::size_t>& spheres_of(std::size_t body) const {
    const auto id = std::lround(bodies_.column("id")[body]);
    const auto found = rows_.find(id);
    const auto expected = static_cast<std::size_t>(bodies_.column("nspheres")[body]);
    const auto count = found == rows_.end() ? 0 : found->second.size();
    if (count != expected)
      throw DataError(spheres_.file + ": expected " + std::to_string(expected) +
                      " spheres of particle " + std::to_string(id) + ", found " +
                      std::to_string(count));
    return found->second;
  }

  /// Place of the particle's shape among json(). @throws DataError when its spheres lie elsewhere.
  std::uint32_t shape_of(std::size_t body) {
    const auto& mine = spheres_of(body);
    const bool sphere = mine.size() == 1;  // half its length is its radius, which differs
    const double half_length = sphere ? 0 : bodies_.column("half_length")[body];
    const double curvature = sphere ? 0 : bodies_.column("curvature")[body];
    const auto [found, is_new] =
        places_.try_emplace({mine.size(), half_length, curvature}, centres_.size());
    if (is_new) add(body, mine, half_length, curvature > 0);
    check(body, mine, centres_[found->second]);
    return static_cast<std::uint32_t>(found->second);
  }
  const Json& json() const { return json_; }

 private:
  void add(std::size_t body, const std::vector<std::size_t>& mine, double half_length,
           bool curved) {
    if (centres_.size() > 255)
      throw DataError(bodies_.file + ": more than 256 shapes of particles");
    std::vector<std::array<double, 2>> centres;
    for (const auto sphere : mine) centres.push_back(frame_.centre(body, sphere));
    centres_.push_back(centres);
    Json shape;
    shape["half_length_m"] = half_length;
    shape["gamma_range_deg"] = mine.size() == 1 ? 0 : curved ? 360 : 180;
    for (const auto& [x, y] : centres)
      shape["centres"].push_back({std::round(x * 1e5) / 1e5, std::round(y * 1e5) / 1e5});
    json_.push_back(shape);
  }

  void check(std::size_t body, const std::vector<std::size_t>& mine,
             const std::vector<std::array<double, 2>>& centres) const {
    const double radius = bodies_.column("radius")[body];
    for (std::size_t k = 0; k < mine.size(); ++k) {
      const auto at = frame_.centre(body, mine[k]);
      const double length = mine.size() > 1 ? frame_.unit(body) : 1;
      const double off = std::hypot(at[0] - centres[k][0], at[1] - centres[k][1]) * length;
      if (off > 0.05 * radius)
        throw DataError(spheres_.file + ": sphere " + number_text(spheres_.column("id")[mine[k]]) +
                        " is " + number_text(off, 3) + " m off its place in its particle");
    }
  }

  const Frame& bodies_;
  const Frame& spheres_;
  BodyFrame frame_;
  std::map<long, std::vector<std::size_t>> rows_;
  std::map<std::tuple<std::size_t, double, double>, std::size_t> places_;
  std::vector<std::vector<std::array<double, 2>>> centres_;
  Json json_ = Json::array();
};

// As render_spheres() shades, but for plain spheres, on which the forces balance the weight: there
// it is the sum of their magnitudes that tells them apart.
ColourScale scale_of(const Frame& bodies, const Frame& spheres) {
  if (spheres.has("fsum") && spheres.rows == bodies.rows)
    return force_scale(spheres.column("fsum"), std::nullopt, "sum of contact forces");
  const auto force = vector_columns(spheres, {"fx", "fy", "fz"});
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < spheres.rows; ++i)
    magnitudes.push_back(std::hypot((*force[0])[i], (*force[1])[i], (*force[2])[i]));
  return force_scale(magnitudes, std::nullopt, "contact force on sphere");
}

Json scale_json(const ColourScale& scale) {
  Json json{{"label", scale.label},
            {"highest", scale.highest},
            {"tick", scale.tick},
            {"open_top", scale.open_top}};
  for (int k = 0; k < shades; ++k)
    json["colours"].push_back(
        palette_colour(*scale.palette, static_cast<double>(k) / (shades - 1)));
  return json;
}

std::string wall_name(const ForceLine& line) {
  if (line.wall_normal[1] > 0.9) return "floor";
  if (line.wall_normal[0] > 0.9) return "left wall";
  if (line.wall_normal[0] < -0.9) return "right wall";
  return "wall";
}

Json contacts_json(const std::vector<ForceLine>& lines, const std::map<long, std::uint32_t>& places,
                   int index_bytes) {
  double lowest = 0, highest = 0;
  for (const auto& line : lines)
    if (line.force > 0) {
      lowest = lowest > 0 ? std::min(lowest, line.force) : line.force;
      highest = std::max(highest, line.force);
    }
  std::vector<std::string> walls;
  std::vector<std::uint32_t> i, j, force;
  const auto place = [&](long id) {
    const auto found = places.find(id);
    if (found == places.end())
      throw DataError("contacts: particle " + std::to_string(id) + " is not among the bodies");
    return found->second;
  };
  for (const auto& line : lines) {
    i.push_back(place(line.particle));
    if (line.other != 0) {
      j.push_back(place(line.other));
    } else {
      const auto name = wall_name(line);
      const auto found = std::find(walls.begin(), walls.end(), name);
      j.push_back(static_cast<std::uint32_t>(places.size()) +
                  static_cast<std::uint32_t>(found - walls.begin()));
      if (found == walls.end()) walls.push_back(name);
    }
    // On a logarithmic scale, so that weak contacts keep their digits.
    const double part = highest > lowest && line.force > 0
                            ? std::log(line.force / lowest) / std::log(highest / lowest)
                            : 0;
    force.push_back(
        line.force > 0 ? 1 + static_cast<std::uint32_t>(std::lround(part * (largest16 - 1))) : 0);
  }
  return {{"walls", walls},
          {"i", packed(i, index_bytes)},
          {"j", packed(j, index_bytes)},
          {"force", packed(force, 2)},
          {"lowest_N", lowest},
          {"highest_N", highest}};
}

Json bed_json(const Frame& spheres) {
  const auto walls = find_walls(spheres, {}, find_parameters(spheres.file, ""));
  double top = walls.floor;
  for (std::size_t i = 0; i < spheres.rows; ++i)
    top = std::max(top, spheres.column("y")[i] + spheres.column("radius")[i]);
  return {{"left", walls.left},
          {"right", walls.right},
          {"floor", walls.floor},
          {"top", top},
          {"sides", walls.sides},
          {"bottom", walls.bottom},
          {"diameter_m", sphere_diameter(spheres, {})}};
}

// Lines of the contacts at the bodies' timestep, or `why` there are none.
std::optional<std::vector<ForceLine>> contacts_at(const std::string& run, long timestep,
                                                  std::string& why) {
  try {
    const auto frame = frame_at(dumps_of_run(run, "contacts"), timestep);
    return frame.rows > 0 ? force_lines(frame) : std::vector<ForceLine>();
  } catch (const DataError& reason) {
    why = reason.what();
    return {};
  }
}

}  // namespace

Json packing_data(const std::string& run_folder) {
  const Frame bodies = last_frame(dumps_of_run(run_folder, "bodies"));
  const Frame spheres = frame_at(dumps_of_run(run_folder, "spheres"), bodies.timestep);
  if (bodies.rows == 0) throw DataError(bodies.file + ": the last frame holds no particles");

  const auto& id = bodies.column("id");
  std::vector<std::size_t> order(bodies.rows);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });

  const auto scale = scale_of(bodies, spheres);
  Shapes shapes(bodies, spheres);
  std::map<long, std::uint32_t> places;
  std::vector<std::uint32_t> ids, angle, shape, shade;
  for (const auto row : order) {
    ids.push_back(static_cast<std::uint32_t>(std::lround(id[row])));
    places.emplace(std::lround(id[row]), static_cast<std::uint32_t>(places.size()));
    const double turns = bodies.column("angle")[row] / (2 * pi);
    angle.push_back(static_cast<std::uint32_t>(std::lround((turns - std::floor(turns)) * 65536)) %
                    65536);
    shape.push_back(shapes.shape_of(row));
    for (const auto sphere : shapes.spheres_of(row)) {
      const double part = std::clamp(scale.values[sphere] / scale.highest, 0.0, 1.0);
      shade.push_back(static_cast<std::uint32_t>(std::lround(part * (shades - 1))));
    }
  }

  const int index_bytes = bodies.rows < 65000 ? 2 : 4;
  Json data;
  data["timestep"] = bodies.timestep;
  data["bed"] = bed_json(spheres);
  data["particles"] = bodies.rows;
  if (ids.back() - ids.front() + 1 == ids.size())
    data["first_id"] = ids.front();
  else
    data["ids"] = packed(ids, 4);
  put_column(data, "x", bodies.column("x"), order);
  put_column(data, "y", bodies.column("y"), order);
  put_column(data, "radius", bodies.column("radius"), order);
  data["angle"] = packed(angle, 2);
  data["shapes"] = shapes.json();
  data["shape"] = packed(shape, 1);
  data["scale"] = scale_json(scale);
  data["shade"] = packed(shade, 1);
  data["index_bits"] = 8 * index_bytes;
  std::string why;
  const auto lines = contacts_at(run_folder, bodies.timestep, why);
  data["contacts"] = lines ? contacts_json(*lines, places, index_bytes) : Json();
  if (!lines) data["contacts_missing"] = why;
  return data;
}

}  // namespace rodpack
