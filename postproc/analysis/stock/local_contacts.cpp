// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/stock/local_contacts.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "analysis/stock/stock_dumps.h"
#include "reading/checks/body_axes.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr std::size_t any_number = 0;  // the history's, which depends on the contact model
// Words and widths in the order of LIGGGHTS's columns (compute_pair_gran_local.cpp).
const std::pair<const char*, std::size_t> layout[] = {{"pos", 6},
                                                      {"vel", 6},
                                                      {"id", 3},
                                                      {"force", 3},
                                                      {"force_normal", 3},
                                                      {"force_tangential", 3},
                                                      {"torque", 3},
                                                      {"torque_normal", 3},
                                                      {"torque_tangential", 3},
                                                      {"history", any_number},
                                                      {"contactArea", 1},
                                                      {"delta", 1},
                                                      {"heatFlux", 1},
                                                      {"contactPoint", 3},
                                                      {"ms_id", 2}};

std::string place_of(const Frame& frame) {
  return frame.file + ":" + std::to_string(frame.header_line) + ": ";
}

// The columns of such a dump by their words.
class LocalColumns {
 public:
  LocalColumns(const Frame& frame, const std::vector<std::string>& words) : frame_(frame) {
    std::set<std::string> asked(words.begin(), words.end());
    std::size_t next = 0;
    bool open = false;
    std::string known;
    for (const auto& [word, width] : layout) {
      known += (known.empty() ? "" : " ") + std::string(word);
      if (asked.erase(word) == 0) continue;
      begin_[word] = next;
      next += width;
      open = open || width == any_number;
    }
    if (!asked.empty())
      throw DataError("words of the compute: expected some of " + known + ", found '" +
                      *asked.begin() + "'");
    for (const char* word : {"id", "force"}) require(word);
    const auto found = frame.names.size();
    if (open ? found < next : found != next)
      throw DataError(place_of(frame) + "expected " + std::to_string(next) +
                      (open ? " columns and those of the history" : " columns") +
                      " of the words of the compute, found " + std::to_string(found));
  }

  void require(const std::string& word) const {
    if (!begin_.count(word))
      throw DataError("words of the compute: expected '" + word + "' among them, without which " +
                      "contacts cannot be told");
  }
  bool has(const std::string& word) const { return begin_.count(word) > 0; }
  double value(const std::string& word, std::size_t component, std::size_t row) const {
    return frame_.column(frame_.names[begin_.at(word) + component])[row];
  }
  Vector3 vector(const std::string& word, std::size_t first, std::size_t row) const {
    return {value(word, first, row), value(word, first + 1, row), value(word, first + 2, row)};
  }

 private:
  const Frame& frame_;
  std::map<std::string, std::size_t> begin_;
};

Vector3 sum(const Vector3& a, const Vector3& b, double factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

double length_of(const Vector3& a) { return std::hypot(a[0], a[1], a[2]); }

// One sphere, and its body.
struct StockSphere {
  double id = 0, type = 0, radius = 0, body = 0;
  Vector3 place{}, centre{};  // of the sphere; of its body, in the image next to it
};

class SphereDump {
 public:
  explicit SphereDump(const Frame& frame) : frame_(frame) {
    if (!frame.has("radius") || frame.has("nspheres"))
      throw DataError(place_of(frame) +
                      "expected a dump of spheres that tells their bodies, beside one of contacts "
                      "of LIGGGHTS's own; 'dump bodies all custom 10000 bodies.*.dump id type x y "
                      "z radius id_multisphere mass vx vy vz' in the deck writes it");
    const auto bodies = as_bodies(frame);
    const auto& body_id = bodies.column("id");
    const auto centre = vector_columns(bodies, {"x", "y", "z"});
    std::map<double, Vector3> centres;
    for (std::size_t row = 0; row < bodies.rows; ++row)
      centres[body_id[row]] = {(*centre[0])[row], (*centre[1])[row], (*centre[2])[row]};
    const auto body = bodies_of_spheres(frame);
    const auto place = vector_columns(frame, {"x", "y", "z"});
    const auto &id = frame.column("id"), &type = frame.column("type"),
               &radius = frame.column("radius");
    for (std::size_t row = 0; row < frame.rows; ++row) {
      StockSphere sphere{id[row],
                         type[row],
                         radius[row],
                         body[row],
                         {(*place[0])[row], (*place[1])[row], (*place[2])[row]},
                         {}};
      sphere.centre = sum(sphere.place, nearest(centres.at(body[row]), sphere.place));
      spheres_[sphere.id] = sphere;
    }
  }

  // The vector from `b` to the image of `a` that is next to it.
  Vector3 nearest(const Vector3& a, const Vector3& b) const {
    auto way = sum(a, b, -1);
    for (std::size_t c = 0; c < 3; ++c) {
      const double period = frame_.bounds[c][1] - frame_.bounds[c][0];
      if (frame_.periodic[c]) way[c] -= period * std::round(way[c] / period);
    }
    return way;
  }

  const StockSphere& of(const Frame& local, double id) const {
    const auto found = spheres_.find(id);
    if (found == spheres_.end())
      throw DataError(frame_.file + ": no sphere " + number_text(id) + ", which has a contact in " +
                      local.file);
    return found->second;
  }

  void require_timestep_of(const Frame& local) const {
    if (frame_.timestep != local.timestep)
      throw DataError(frame_.file + ": expected spheres of timestep " +
                      std::to_string(local.timestep) + " as the contacts of " + local.file +
                      ", found timestep " + std::to_string(frame_.timestep));
  }

  // Where the dump of contacts says its sphere to be; it may be printed with six digits.
  void require_place(const Frame& local, const StockSphere& sphere, const Vector3& said) const {
    const double off = length_of(nearest(said, sphere.place));
    if (off > 0.01 * sphere.radius + 1e-5 * length_of(sphere.place))
      throw DataError(place_of(local) + "sphere " + number_text(sphere.id) + ": expected at " +
                      number_text(sphere.place[0], 6) + ' ' + number_text(sphere.place[1], 6) +
                      ' ' + number_text(sphere.place[2], 6) + " m as in " + frame_.file +
                      ", found at " + number_text(said[0], 6) + ' ' + number_text(said[1], 6) +
                      ' ' + number_text(said[2], 6) + ": were these the words of the compute?");
  }

 private:
  const Frame& frame_;
  std::map<double, StockSphere> spheres_;
};

struct ContactRow {
  double body_i, body_j, sphere_i, sphere_j, wall;
  Vector3 point, force, centre_i, centre_j;
  double overlap;
  Vector3 normal;
  double type_i, type_j;  // the latter 0 of a wall, which LIGGGHTS's dumps do not tell
};

const std::vector<std::string> contact_columns{
    "body_i", "body_j",    "sphere_i", "sphere_j", "wall", "x",      "y",     "z",
    "fx",     "fy",        "fz",       "bix",      "biy",  "biz",    "bjx",   "bjy",
    "bjz",    "overlap_n", "nx",       "ny",       "nz",   "type_i", "type_j"};

void append(const ContactRow& row, Frame& contacts) {
  std::vector<double> values{row.body_i, row.body_j, row.sphere_i, row.sphere_j, row.wall};
  const auto put = [&](const Vector3& v) { values.insert(values.end(), v.begin(), v.end()); };
  for (const auto* each : {&row.point, &row.force, &row.centre_i, &row.centre_j}) put(*each);
  values.push_back(row.overlap);
  put(row.normal);
  values.push_back(row.type_i);
  values.push_back(row.type_j);
  for (std::size_t c = 0; c < values.size(); ++c) contacts.columns[c].push_back(values[c]);
  ++contacts.rows;
}

}  // namespace

Frame read_local_contacts(const Frame& pairs, const LocalContactOptions& options,
                          const Frame& spheres) {
  auto contacts = contacts_of_local_dump(pairs, options.words, spheres);
  if (!options.wall_files.empty())
    add_contacts_of_wall_dump(frame_beside(pairs, find_dumps(options.wall_files)), options.words,
                              spheres, contacts);
  return contacts;
}

std::string note_on_local_contacts(const LocalContactOptions& options) {
  return "LIGGGHTS's own compute evaluates forces anew after the step: tangential ones of contacts "
         "that slide are not those that acted, nor are their mobilised friction and their part of "
         "the stress" +
         std::string(options.wall_files.empty()
                         ? "; contacts with walls are not among them: no --local-walls"
                         : "; contacts with walls that are no meshes are not among them");
}

std::vector<std::string> local_contact_words() {
  std::vector<std::string> words;
  for (const auto& each : layout) words.emplace_back(each.first);
  return words;
}

Frame contacts_of_local_dump(const Frame& pairs, const std::vector<std::string>& words,
                             const Frame& spheres) {
  const LocalColumns columns(pairs, words);
  const SphereDump all(spheres);
  all.require_timestep_of(pairs);
  Frame contacts;
  contacts.file = pairs.file;
  contacts.header_line = pairs.header_line;
  contacts.timestep = pairs.timestep;
  contacts.bounds = pairs.bounds;
  contacts.periodic = pairs.periodic;
  contacts.names = contact_columns;
  contacts.columns.resize(contact_columns.size());
  contacts.bad_fields.resize(contact_columns.size());
  for (std::size_t row = 0; row < pairs.rows; ++row) {
    const auto& i = all.of(pairs, columns.value("id", 0, row));
    const auto& j = all.of(pairs, columns.value("id", 1, row));
    if (columns.has("pos")) {
      all.require_place(pairs, i, columns.vector("pos", 0, row));
      all.require_place(pairs, j, columns.vector("pos", 3, row));
    }
    if (i.body == j.body) continue;
    const auto from_j = all.nearest(i.place, j.place);
    const double distance = length_of(from_j);
    if (!(distance > 0))
      throw DataError(place_of(pairs) + "spheres " + number_text(i.id) + " and " +
                      number_text(j.id) + ": expected two places, found one");
    const Vector3 normal = sum({}, from_j, 1 / distance);
    const double overlap = i.radius + j.radius - distance;
    const Vector3 place_j = sum(i.place, from_j, -1);
    append({i.body, j.body, i.id, j.id, 0, sum(place_j, normal, j.radius - overlap / 2),
            columns.vector("force", 0, row), i.centre, sum(place_j, sum(j.centre, j.place, -1)),
            overlap, normal, i.type, j.type},
           contacts);
  }
  return contacts;
}

void add_contacts_of_wall_dump(const Frame& walls, const std::vector<std::string>& words,
                               const Frame& spheres, Frame& contacts) {
  const LocalColumns columns(walls, words);
  columns.require("pos");
  const SphereDump all(spheres);
  all.require_timestep_of(walls);
  for (std::size_t row = 0; row < walls.rows; ++row) {
    const auto& i = all.of(walls, columns.value("id", 2, row));
    all.require_place(walls, i, columns.vector("pos", 3, row));
    const auto from_wall = all.nearest(i.place, columns.vector("pos", 0, row));
    const double distance = length_of(from_wall);
    if (!(distance > 0))
      throw DataError(place_of(walls) + "sphere " + number_text(i.id) +
                      ": expected a contact point beside its centre, found it there");
    const Vector3 normal = sum({}, from_wall, 1 / distance);
    const double overlap = i.radius - distance;
    const Vector3 point = sum(i.place, normal, overlap / 2 - i.radius);
    append({i.body, 0, i.id, 0, 1, point, columns.vector("force", 0, row), i.centre, point, overlap,
            normal, i.type, 0},
           contacts);
  }
}

}  // namespace rodpack
