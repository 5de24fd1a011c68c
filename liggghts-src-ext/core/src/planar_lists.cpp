// SPDX-License-Identifier: GPL-2.0-or-later
// Which sphere pairs may touch: each body is listed when a point of it has moved by its skin. Two
// spheres are listed if they come closer than the skins of both allow, measured where the bodies
// were listed; so that none has to be listed because another one moved.
#include <algorithm>
#include <cmath>
#include <limits>

#include "rodpack/planar_halo.h"
#include "rodpack/planar_scene_data.h"

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

namespace {

int round_up(int blocks) { return (blocks + planar_group - 1) / planar_group * planar_group; }

}  // namespace

void PlanarBlockPool::reorder(const std::vector<int>& order, int touching,
                              const PlanarParts& parts) {
  heads.swap(spare_heads_);
  laws.swap(spare_laws_);
  all_values.swap(spare_values_);
  births.swap(spare_births_);
  for (std::vector<int>& list : of_body_) list.clear();
  early_holes_.clear();
  holes_.clear();
  filled_ = 0;
  const int count = static_cast<int>(order.size());
  ordered_ = round_up(count);
  resize_blocks(count, count);
  for (int k = 0; k < count; ++k) {
    if (order[k] < 0) {
      make_hole(k);
      continue;
    }
    ++filled_;
    heads[k] = spare_heads_[order[k]];
    laws[k] = spare_laws_[order[k]];
    births[k] = spare_births_[order[k]];
    const double* const from = &spare_values_[values_place(order[k])];
    double* const to = values(k);
    for (int row = 0; row < rows(); ++row)
      std::copy_n(from + row * planar_row, planar_lanes, to + row * planar_row);
    of_body_[heads[k].i].push_back(k);
    if (heads[k].j >= 0) of_body_[heads[k].j].push_back(k);
  }

  // Holes name the first body: they are of no part that is too late.
  const auto find_ends = [&](int first, int end, std::vector<int>& ends) {
    ends.clear();
    for (int part = 0; part < parts.last(); ++part) {
      while (first < end && parts.of(heads[first]) <= part) ++first;
      ends.push_back(first - first % planar_group);
    }
    ends.push_back(end);
  };
  find_ends(0, touching, ends_of_touching_);
  find_ends(touching, ordered_, ends_of_others_);
  for (EarlyHole& hole : early_holes_) hole.part = part_of(hole.place);
}

PlanarRange PlanarBlockPool::touching(int part) const {
  if (ends_of_touching_.empty()) return {0, 0};
  return {part == 0 ? 0 : ends_of_touching_[part - 1], ends_of_touching_[part]};
}

PlanarRange PlanarBlockPool::others(int part) const {
  const int last = static_cast<int>(ends_of_others_.size()) - 1;
  if (last < 0) return {0, 0};
  return {part == 0 ? ends_of_touching_[last] : ends_of_others_[part - 1],
          part == last ? size() : ends_of_others_[part]};
}

int PlanarBlockPool::part_of(int place) const {
  const int last = static_cast<int>(ends_of_others_.size()) - 1;
  if (place >= ordered_ || last < 0) return std::max(last, 0);
  const std::vector<int>& ends =
      place < ends_of_touching_[last] ? ends_of_touching_ : ends_of_others_;
  return static_cast<int>(std::upper_bound(ends.begin(), ends.end(), place) - ends.begin());
}

int PlanarBlockPool::take_hole(int part) {
  // What has just been removed comes back in most cases.
  const int count = static_cast<int>(early_holes_.size());
  for (int k = count - 1; k >= 0 && k >= count - 16; --k) {
    if (early_holes_[k].part < part) continue;
    const int place = early_holes_[k].place;
    early_holes_.erase(early_holes_.begin() + k);
    return place;
  }
  if (holes_.empty()) resize_blocks(size(), size() + 1);
  const int place = holes_.back();
  holes_.pop_back();
  return place;
}

void save_lane(const PlanarBlockPool& pool, int place, int lane, PlanarScene::Data::Saved& saved) {
  const PlanarBlockHead& head = pool.heads[place];
  const double* const values = pool.values(place) + lane;
  const PlanarBlockBirth& birth = pool.births[place];
  const int bit = 1 << lane;
  saved.i = head.i;
  saved.j = head.j;
  saved.sphere_i = birth.sphere_i[lane];
  saved.sphere_j = birth.sphere_j[lane];
  saved.sliding = (head.sliding & bit) != 0;
  saved.mature = (head.mature & bit) != 0;
  saved.fresh = birth.fresh[lane];
  saved.count = birth.count[lane];
  saved.spring = values[planar_spring];
  for (int k = 0; k < max_multistep_order; ++k)
    saved.velocity[k] = k < pool.slots ? values[pool.velocity(k)] : 0.0;
  saved.uncut = values[planar_uncut];
  saved.touch_rate = birth.touch_rate[lane];
  saved.since = birth.since[lane];
}

void restore_lane(PlanarBlockPool& pool, int place, int lane, const PlanarScene::Data::Saved& saved,
                  bool turned) {
  PlanarBlockHead& head = pool.heads[place];
  double* const values = pool.values(place) + lane;
  PlanarBlockBirth& birth = pool.births[place];
  const auto set = [&](std::uint8_t& bits, bool on) {
    bits = static_cast<std::uint8_t>((bits & ~(1 << lane)) | (on ? 1 << lane : 0));
  };
  set(head.alive, saved.count != 0);
  set(head.mature, saved.mature);
  set(head.sliding, saved.sliding);
  birth.fresh[lane] = saved.fresh;
  birth.count[lane] = saved.count;
  birth.touch_rate[lane] = saved.touch_rate;
  birth.since[lane] = saved.since;
  values[planar_spring] = saved.spring;
  for (int k = 0; k < pool.slots; ++k) values[pool.velocity(k, turned)] = saved.velocity[k];
  values[planar_uncut] = saved.uncut;
}

void clear_lane(PlanarBlockPool& pool, int place, int lane) {
  restore_lane(pool, place, lane, PlanarScene::Data::Saved());
}

double PlanarScene::Data::wanted_skin(int body) const {
  const double* v = frames[body].velocity;
  const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1]) + listed[body].reach * std::fabs(v[2]);
  return std::min(settings.max_skin,
                  std::max(settings.min_skin, speed * settings.skin_steps * settings.dt));
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
  at = {frame.x, frame.y, frame.cosine, frame.sine, at.reach, wanted_skin(body)};
  PlanarListedLanes& lanes = listed_lanes[body / body_lanes];
  const int lane = body % body_lanes;
  lanes.x[lane] = at.x;
  lanes.y[lane] = at.y;
  lanes.cosine[lane] = at.cosine;
  lanes.sine[lane] = at.sine;
  lanes.reach[lane] = at.reach;
  lanes.skin[lane] = before_its_skin * at.skin;
  moved[body] = 0.0;
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

  std::vector<PlanarScene::Data::Candidate>& candidates = no_candidates();
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
    std::vector<PlanarScene::Data::Candidate>& candidates = no_candidates();
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

/// Touching blocks first, each kind in the order in which their bodies have both moved.
void PlanarScene::Data::sort_blocks() {
  for (int part = 0; part < parts.count(); ++part) complete[part] = part;
  if (halo) halo->each_sent([&](int body) { complete[parts.of(body)] = parts.last(); });
  for (PlanarBlockPool* pool : {&pairs, &at_walls}) {
    const AlignedVector<PlanarBlockHead>& heads = pool->heads;
    near.clear();
    for (int k = 0; k < pool->size(); ++k)
      if (heads[k].used != 0) near.push_back(k);
    const auto touches = [&](int k) { return heads[k].alive != 0; };
    std::sort(near.begin(), near.end(), [&](int a, int b) {
      if (touches(a) != touches(b)) return touches(a);
      const int last_a = std::max(heads[a].i, heads[a].j);
      const int last_b = std::max(heads[b].i, heads[b].j);
      if (last_a != last_b) return last_a < last_b;
      if (heads[a].i != heads[b].i) return heads[a].i < heads[b].i;
      if (heads[a].j != heads[b].j) return heads[a].j < heads[b].j;
      return a < b;
    });
    const auto others = std::partition_point(near.begin(), near.end(), touches);
    const int touching = static_cast<int>(others - near.begin());
    near.insert(others, round_up(touching) - touching, -1);
    pool->reorder(near, round_up(touching), parts);
    for (int part = 0; part < parts.count(); ++part)
      for (const PlanarRange& range : {pool->touching(part), pool->others(part)})
        for (int k = range.first; k < range.end; ++k)
          if (heads[k].used != 0) completes(heads[k], part);
  }
}

/// The forces on the bodies of a block are not complete before this part.
void PlanarScene::Data::completes(const PlanarBlockHead& head, int part) {
  for (const int body : {head.i, head.j})
    if (body >= 0) complete[parts.of(body)] = std::max(complete[parts.of(body)], part);
}

}  // namespace rodpack
