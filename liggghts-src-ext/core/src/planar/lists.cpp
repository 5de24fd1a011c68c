// SPDX-License-Identifier: GPL-2.0-or-later
// Which sphere pairs may touch: each body is listed when a point of it has moved by its skin. Two
// spheres are listed if they come closer than the skins of both allow, measured where the bodies
// were listed; so that none has to be listed because another one moved.
#include <algorithm>
#include <cmath>
#include <limits>

#include "scene_data.h"

namespace rodpack {

void PlanarGrid::build(const AlignedVector<PlanarListed>& bodies, double cell) {
  const int count = static_cast<int>(bodies.size());
  double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0};
  for (int k = 0; k < count; ++k) {
    const double place[2] = {bodies[k].x, bodies[k].y};
    for (int d = 0; d < 2; ++d) {
      low[d] = k == 0 ? place[d] : std::min(low[d], place[d]);
      high[d] = k == 0 ? place[d] : std::max(high[d], place[d]);
    }
  }
  // Not more cells than a few per body, however far one has flown.
  const double most = 4.0 * count + 16.0;
  while ((std::floor((high[0] - low[0]) / cell) + 1.0) *
             (std::floor((high[1] - low[1]) / cell) + 1.0) >
         most)
    cell *= 1.5;
  x0_ = low[0];
  y0_ = low[1];
  inverse_ = 1.0 / cell;
  nx_ = static_cast<int>((high[0] - low[0]) * inverse_) + 1;
  ny_ = static_cast<int>((high[1] - low[1]) * inverse_) + 1;
  head_.assign(static_cast<std::size_t>(nx_) * ny_, -1);
  next_.assign(count, -1);
  previous_.assign(count, -1);
  cell_.assign(count, -1);
  for (int k = 0; k < count; ++k) link(k, row(bodies[k].y) * nx_ + column(bodies[k].x));
}

void PlanarGrid::link(int body, int cell) {
  cell_[body] = cell;
  previous_[body] = -1;
  next_[body] = head_[cell];
  if (head_[cell] >= 0) previous_[head_[cell]] = body;
  head_[cell] = body;
}

void PlanarGrid::move(int body, double x, double y) {
  const int cell = row(y) * nx_ + column(x);
  if (cell == cell_[body]) return;
  unlink(body);
  link(body, cell);
}

void PlanarGrid::add(int body, double x, double y) {
  if (body >= static_cast<int>(cell_.size()))
    for (auto* of_bodies : {&next_, &previous_, &cell_}) of_bodies->resize(body + 1, -1);
  link(body, row(y) * nx_ + column(x));
}

void PlanarGrid::remove(int body) { unlink(body); }

void PlanarGrid::unlink(int body) {
  if (previous_[body] >= 0)
    next_[previous_[body]] = next_[body];
  else
    head_[cell_[body]] = next_[body];
  if (next_[body] >= 0) previous_[next_[body]] = previous_[body];
}

/// Of the point of the body that goes farthest, at its present speed, m.
double PlanarScene::Data::way_in_step(int body) const {
  const double* v = frames[body].velocity;
  const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1]) + listed[body].reach * std::fabs(v[2]);
  return speed * settings.dt;
}

/// Of body i with body j, or wall -1 - j.
PlanarScene::Data::Coefficients PlanarScene::Data::coefficients(int i, int j) const {
  const bool wall = j < 0;
  const int type_j = wall ? settings.walls[-1 - j].type : info[j].type;
  const double m = info[i].mass, mass = wall ? m : m * info[j].mass / (m + info[j].mass);
  const int place = info[i].type * settings.types + type_j;
  const PlanarLaw& law = settings.laws[place];
  return {
      place,
      {damping_coefficient(law.eta_n, mass, law.kn), damping_coefficient(law.eta_t, mass, law.kt)}};
}

/// A body is about to be listed where it is.
void PlanarScene::Data::mark_listed(int body) {
  PlanarListed& at = listed[body];
  const PlanarFrame& frame = frames[body];
  const double way = way_in_step(body);
  const double skin =
      std::min(settings.max_skin, std::max(settings.min_skin, settings.skin_steps * way));
  at = {frame.x, frame.y, frame.cosine, frame.sine, at.reach, skin};
  PlanarListedLanes& lanes = listed_lanes[body / body_lanes];
  const int lane = body % body_lanes;
  lanes.x[lane] = at.x;
  lanes.y[lane] = at.y;
  lanes.cosine[lane] = at.cosine;
  lanes.sine[lane] = at.sine;
  lanes.reach[lane] = at.reach;
  lanes.skin[lane] = before_its_skin * skin;
  moved[body] = 0.0;
  // `moved` may be the square root of 2 times too large.
  const double covered = before_its_skin * skin / (std::sqrt(2.0) * way);
  if (covered < next_longest_sweep) {
    next_longest_sweep = std::max(1, static_cast<int>(covered));
    longest_sweep = std::min(longest_sweep, next_longest_sweep);
  }
}

void PlanarScene::Data::make_lists() {
  if (lists_exist) return;
  list_all();
  sort_blocks();
}

void PlanarScene::Data::list_all() {
  const int count = static_cast<int>(info.size());
  for (int k = 0; k < count; ++k) mark_listed(k);
  grid.build(listed, 2.0 * (longest + settings.max_skin));
  lists_exist = true;
  for (int k = 0; k < count; ++k) list_near(k, k);
}

void PlanarScene::Data::renew_lists() {
  for (int body : to_list) {
    mark_listed(body);
    grid.move(body, listed[body].x, listed[body].y);
    list(body);
  }
  to_list.clear();
}

/// Makes the blocks of a body with those before `end`, and with walls.
void PlanarScene::Data::list_near(int body, int end) {
  const PlanarListed& at = listed[body];
  near.clear();
  grid.around(at.x, at.y, [&](int other) {
    if (other == body || other >= end) return;
    if (other >= owned && body >= owned) return;  // other ranks' own affair
    const PlanarListed& there = listed[other];
    const double dx = at.x - there.x, dy = at.y - there.y;
    const double far = at.reach + there.reach + at.skin + there.skin;
    if (dx * dx + dy * dy < far * far) near.push_back(other);
  });
  for (int other : near) {
    const bool first = comes_first(body, other);
    list_pair(first ? body : other, first ? other : body);
  }
  if (body < owned) list_walls(body);
}

/// Makes the blocks of a body anew; contacts keep their history.
void PlanarScene::Data::list(int body) {
  ++statistics.listings;
  saved.clear();
  for (PlanarBlockPool* pool : {&pairs, &at_walls}) {
    for (const int place : pool->of_body(body))
      for (int lane = 0; lane < planar_lanes; ++lane)
        if (pool->heads[place].alive & 1 << lane) {
          saved.push_back(Saved());
          save_lane(*pool, place, lane, saved.back());
        }
    pool->remove_all_of(body);
  }
  list_near(body, static_cast<int>(info.size()));
  for (const Saved& contact : saved) {
    PlanarBlockPool& pool = contact.j < 0 ? at_walls : pairs;
    for (int place : pool.of_body(body)) {
      const PlanarBlockHead& head = pool.heads[place];
      if (head.i != contact.i || head.j != contact.j) continue;
      const PlanarBlockBirth& birth = pool.births[place];
      for (int lane = 0; lane < planar_lanes; ++lane)
        if ((head.used & 1 << lane) && birth.sphere_i[lane] == contact.sphere_i &&
            birth.sphere_j[lane] == contact.sphere_j)
          restore_lane(pool, place, lane, contact);
    }
  }
}

namespace {

std::vector<PlanarScene::Data::Candidate>& no_candidates() {
  static thread_local std::vector<PlanarScene::Data::Candidate> candidates;
  candidates.clear();
  return candidates;
}

}  // namespace

/// Puts candidates of i and j into blocks, the closest first: so those that touch share blocks.
void PlanarScene::Data::add_blocks(PlanarBlockPool& pool, int i, int j,
                                   std::vector<Candidate>& candidates) {
  if (candidates.empty()) return;
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.gap != b.gap             ? a.gap < b.gap
           : a.sphere_i != b.sphere_i ? a.sphere_i < b.sphere_i
                                      : a.sphere_j < b.sphere_j;
  });
  const PlanarSphere none = PlanarSphere();
  const PlanarSphere* const of_i = &spheres[info[i].first];
  const PlanarSphere* const of_j = j < 0 ? &none : &spheres[info[j].first];
  const Coefficients of_both = coefficients(i, j);
  const int count = static_cast<int>(candidates.size());
  for (int first = 0; first < count; first += planar_lanes) {
    PlanarBlockBirth birth = PlanarBlockBirth();
    const int used = std::min(planar_lanes, count - first);
    PlanarBlockHead head = PlanarBlockHead();
    head.i = i;
    head.j = j;
    head.used = static_cast<std::uint8_t>((1 << used) - 1);
    head.gap = std::nextafter(static_cast<float>(candidates[first].gap),
                              -std::numeric_limits<float>::infinity());
    for (int lane = 0; lane < planar_lanes; ++lane) {
      const Candidate& pair = candidates[first + (lane < used ? lane : 0)];
      birth.sphere_i[lane] = static_cast<std::uint16_t>(pair.sphere_i);
      birth.sphere_j[lane] = static_cast<std::uint16_t>(pair.sphere_j);
    }
    const int place = pool.add(parts.of(head), head, of_both.law, birth);
    completes(head, pool.part_of(place));
    double* const values = pool.values(place);
    std::copy_n(of_both.gamma, 2, values + planar_gammas);
    for (int lane = 0; lane < planar_lanes; ++lane) {
      const PlanarSphere &i = of_i[birth.sphere_i[lane]], &j = of_j[birth.sphere_j[lane]];
      values[planar_xi + lane] = i.x;
      values[planar_yi + lane] = i.y;
      values[planar_xj + lane] = j.x;
      values[planar_yj + lane] = j.y;
    }
  }
}

void PlanarScene::Data::list_pair(int i, int j) {
  const PlanarListed &a = listed[i], &b = listed[j];
  // j's frame seen from i's: spheres of i in j's frame, at the positions where both were listed
  const double c = b.cosine * a.cosine + b.sine * a.sine;
  const double s = b.cosine * a.sine - b.sine * a.cosine;
  const double dx = a.x - b.x, dy = a.y - b.y;
  const double x0 = b.cosine * dx + b.sine * dy, y0 = b.cosine * dy - b.sine * dx;
  const double touch = info[i].radius + info[j].radius, near_by = touch + a.skin + b.skin;
  const double around_j = b.reach - info[j].radius + near_by;

  std::vector<Candidate>& candidates = no_candidates();
  const PlanarSphere* const of_i = &spheres[info[i].first];
  const PlanarSphere* const of_j = &spheres[info[j].first];
  for (int k = 0; k < info[i].count; ++k) {
    const double x = x0 + c * of_i[k].x - s * of_i[k].y, y = y0 + s * of_i[k].x + c * of_i[k].y;
    if (x * x + y * y > around_j * around_j) continue;
    for (int l = 0; l < info[j].count; ++l) {
      const double rx = x - of_j[l].x, ry = y - of_j[l].y, square = rx * rx + ry * ry;
      if (square < near_by * near_by) candidates.push_back({std::sqrt(square) - touch, k, l});
    }
  }
  add_blocks(pairs, i, j, candidates);
}

void PlanarScene::Data::list_walls(int i) {
  const PlanarListed& a = listed[i];
  const double radius = info[i].radius;
  const PlanarSphere* const of_i = &spheres[info[i].first];
  for (std::size_t w = 0; w < settings.walls.size(); ++w) {
    const PlanarWall& wall = settings.walls[w];
    const double centre = (wall.axis == 0 ? a.x : a.y) - wall.position;
    if (wall.side_of(centre) * centre > a.reach + a.skin) continue;
    std::vector<Candidate>& candidates = no_candidates();
    const double along_x = wall.axis == 0 ? a.cosine : a.sine;
    const double along_y = wall.axis == 0 ? -a.sine : a.cosine;
    for (int k = 0; k < info[i].count; ++k) {
      const double distance = centre + along_x * of_i[k].x + along_y * of_i[k].y;
      const double gap = wall.side_of(distance) * distance - radius;
      if (gap < a.skin) candidates.push_back({gap, k, 0});
    }
    add_blocks(at_walls, i, -1 - static_cast<int>(w), candidates);
  }
}

}  // namespace rodpack
