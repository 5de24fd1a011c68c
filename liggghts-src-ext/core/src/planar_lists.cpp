// SPDX-License-Identifier: GPL-2.0-or-later
// Which sphere pairs may touch: each body is listed when a point of it has moved by its skin. Two
// spheres are listed if they come closer than the skins of both allow, measured where the bodies
// were listed; so that none has to be listed because another one moved.
#include <algorithm>
#include <cmath>

#include "rodpack/planar_scene_data.h"

namespace rodpack {

void PlanarGrid::build(const std::vector<PlanarBodyInfo>& bodies, double cell) {
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

void PlanarBlockPool::reorder(const std::vector<int>& order) {
  const AlignedVector<PlanarBlock> old_blocks(blocks);
  const AlignedVector<PlanarBlockHistory> old_histories(histories);
  const std::vector<PlanarBlockBirth> old_births(births);
  for (std::vector<int>& list : of_body_) list.clear();
  for (int k = 0; k < size(); ++k) {
    blocks[k] = old_blocks[order[k]];
    histories[k] = old_histories[order[k]];
    births[k] = old_births[order[k]];
    of_body_[blocks[k].i].push_back(k);
    if (blocks[k].j >= 0) of_body_[blocks[k].j].push_back(k);
  }
}

void save_lane(const PlanarBlockPool& pool, int place, int lane, PlanarScene::Data::Saved& saved) {
  const PlanarBlock& block = pool.blocks[place];
  const PlanarBlockHistory& history = pool.histories[place];
  const PlanarBlockBirth& birth = pool.births[place];
  const int bit = 1 << lane;
  saved.i = block.i;
  saved.j = block.j;
  saved.sphere_i = block.sphere_i[lane];
  saved.sphere_j = block.sphere_j[lane];
  saved.sliding = (block.sliding & bit) != 0;
  saved.mature = (block.mature & bit) != 0;
  saved.fresh = birth.fresh[lane];
  saved.count = birth.count[lane];
  saved.spring = history.spring[lane];
  for (int k = 0; k < max_multistep_order; ++k) saved.velocity[k] = history.velocity[k][lane];
  saved.uncut = history.uncut[lane];
  saved.touch_rate = birth.touch_rate[lane];
  saved.since = birth.since[lane];
}

void restore_lane(PlanarBlockPool& pool, int place, int lane,
                  const PlanarScene::Data::Saved& saved) {
  PlanarBlock& block = pool.blocks[place];
  PlanarBlockHistory& history = pool.histories[place];
  PlanarBlockBirth& birth = pool.births[place];
  const auto set = [&](std::uint8_t& bits, bool on) {
    bits = static_cast<std::uint8_t>((bits & ~(1 << lane)) | (on ? 1 << lane : 0));
  };
  set(block.alive, saved.count != 0);
  set(block.mature, saved.mature);
  set(block.sliding, saved.sliding);
  birth.fresh[lane] = saved.fresh;
  birth.count[lane] = saved.count;
  birth.touch_rate[lane] = saved.touch_rate;
  birth.since[lane] = saved.since;
  history.spring[lane] = saved.spring;
  for (int k = 0; k < max_multistep_order; ++k) history.velocity[k][lane] = saved.velocity[k];
  history.uncut[lane] = saved.uncut;
}

void clear_lane(PlanarBlockPool& pool, int place, int lane) {
  restore_lane(pool, place, lane, PlanarScene::Data::Saved());
}

double PlanarScene::Data::wanted_skin(int body) const {
  const double* v = frames[body].velocity;
  const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1]) + info[body].reach * std::fabs(v[2]);
  return std::min(settings.max_skin,
                  std::max(settings.min_skin, speed * settings.skin_steps * settings.dt));
}

void PlanarScene::Data::set_coefficients(PlanarBlock& block) const {
  const PlanarBodyInfo& i = info[block.i];
  const bool wall = block.j < 0;
  const int type_j = wall ? settings.walls[-1 - block.j].type : info[block.j].type;
  const double mass = wall ? i.mass : i.mass * info[block.j].mass / (i.mass + info[block.j].mass);
  const PlanarLaw& law = settings.laws[i.type * settings.types + type_j];
  block.radius_i = i.radius;
  block.radius_j = wall ? 0.0 : info[block.j].radius;
  block.kn = law.kn;
  block.kt = law.kt;
  block.inverse_kt = 1.0 / law.kt;
  block.gamma_n = damping_coefficient(law.eta_n, mass, law.kn);
  block.gamma_t = damping_coefficient(law.eta_t, mass, law.kt);
  block.friction = law.friction * law.kn;
}

void PlanarScene::Data::list_all() {
  const int count = static_cast<int>(info.size());
  double reach = 0.0;
  for (int k = 0; k < count; ++k) {
    info[k].x = frames[k].x;
    info[k].y = frames[k].y;
    info[k].cosine = frames[k].cosine;
    info[k].sine = frames[k].sine;
    info[k].skin = wanted_skin(k);
    reach = std::max(reach, info[k].reach);
  }
  grid.build(info, 2.0 * (reach + settings.max_skin));
  lists_exist = true;
  for (int k = 0; k < count; ++k) list(k);
  sort_blocks();
}

void PlanarScene::Data::renew_lists() {
  for (int body : to_list) {
    PlanarBodyInfo& at = info[body];
    at.x = frames[body].x;
    at.y = frames[body].y;
    at.cosine = frames[body].cosine;
    at.sine = frames[body].sine;
    at.skin = wanted_skin(body);
    grid.move(body, at.x, at.y);
    list(body);
  }
  to_list.clear();
}

/// Makes the blocks of a body anew; contacts keep their history.
void PlanarScene::Data::list(int body) {
  ++statistics.listings;
  saved.clear();
  for (PlanarBlockPool* pool : {&pairs, &at_walls}) {
    while (!pool->of_body(body).empty()) {
      const int place = pool->of_body(body).back();
      for (int lane = 0; lane < planar_lanes; ++lane)
        if (pool->blocks[place].alive & 1 << lane) {
          saved.push_back(Saved());
          save_lane(*pool, place, lane, saved.back());
        }
      pool->remove(place);
    }
  }
  const PlanarBodyInfo& at = info[body];
  near.clear();
  grid.around(at.x, at.y, [&](int other) {
    if (other == body || (other >= owned && body >= owned)) return;  // other ranks' own affair
    const PlanarBodyInfo& there = info[other];
    const double dx = at.x - there.x, dy = at.y - there.y;
    const double far = at.reach + there.reach + at.skin + there.skin;
    if (dx * dx + dy * dy < far * far) near.push_back(other);
  });
  for (int other : near) {
    const bool first = comes_first(body, other);
    list_pair(first ? body : other, first ? other : body);
  }
  if (body < owned) list_walls(body);
  for (const Saved& contact : saved) {
    PlanarBlockPool& pool = contact.j < 0 ? at_walls : pairs;
    for (int place : pool.of_body(body)) {
      const PlanarBlock& block = pool.blocks[place];
      if (block.i != contact.i || block.j != contact.j) continue;
      for (int lane = 0; lane < block.used; ++lane)
        if (block.sphere_i[lane] == contact.sphere_i && block.sphere_j[lane] == contact.sphere_j)
          restore_lane(pool, place, lane, contact);
    }
  }
}

namespace {

/// Fills blocks one lane after the other.
class BlockWriter {
 public:
  BlockWriter(PlanarBlockPool& pool, const PlanarBlock& empty) : pool_(pool), block_(empty) {}
  ~BlockWriter() {
    if (block_.used > 0) pool_.add(block_);
  }
  void add(int sphere_i, const PlanarSphere& i, int sphere_j, const PlanarSphere& j, double reach) {
    if (block_.used == planar_lanes) {
      pool_.add(block_);
      block_.used = 0;
      for (double& r : block_.reach) r = 0.0;
    }
    const int lane = block_.used++;
    block_.xi[lane] = i.x;
    block_.yi[lane] = i.y;
    block_.xj[lane] = j.x;
    block_.yj[lane] = j.y;
    block_.reach[lane] = reach;
    block_.sphere_i[lane] = static_cast<std::uint16_t>(sphere_i);
    block_.sphere_j[lane] = static_cast<std::uint16_t>(sphere_j);
  }

 private:
  PlanarBlockPool& pool_;
  PlanarBlock block_;
};

}  // namespace

void PlanarScene::Data::list_pair(int i, int j) {
  const PlanarBodyInfo &a = info[i], &b = info[j];
  // j's frame seen from i's: spheres of i in j's frame, at the positions where both were listed
  const double c = b.cosine * a.cosine + b.sine * a.sine;
  const double s = b.cosine * a.sine - b.sine * a.cosine;
  const double dx = a.x - b.x, dy = a.y - b.y;
  const double x0 = b.cosine * dx + b.sine * dy, y0 = b.cosine * dy - b.sine * dx;
  const double touch = a.radius + b.radius, near_by = touch + a.skin + b.skin;
  const double around_j = b.reach - b.radius + near_by;

  PlanarBlock empty = PlanarBlock();
  empty.i = i;
  empty.j = j;
  set_coefficients(empty);
  BlockWriter writer(pairs, empty);
  const PlanarSphere* const of_i = &spheres[a.first];
  const PlanarSphere* const of_j = &spheres[b.first];
  for (int k = 0; k < a.count; ++k) {
    const double x = x0 + c * of_i[k].x - s * of_i[k].y, y = y0 + s * of_i[k].x + c * of_i[k].y;
    if (x * x + y * y > around_j * around_j) continue;
    for (int l = 0; l < b.count; ++l) {
      const double rx = x - of_j[l].x, ry = y - of_j[l].y;
      if (rx * rx + ry * ry < near_by * near_by) writer.add(k, of_i[k], l, of_j[l], touch);
    }
  }
}

void PlanarScene::Data::list_walls(int i) {
  const PlanarBodyInfo& a = info[i];
  for (std::size_t w = 0; w < settings.walls.size(); ++w) {
    const PlanarWall& wall = settings.walls[w];
    const double centre = (wall.axis == 0 ? a.x : a.y) - wall.position;
    if (wall.side_of(centre) * centre > a.reach + a.skin) continue;
    PlanarBlock empty = PlanarBlock();
    empty.i = i;
    empty.j = -1 - static_cast<int>(w);
    set_coefficients(empty);
    BlockWriter writer(at_walls, empty);
    const double along_x = wall.axis == 0 ? a.cosine : a.sine;
    const double along_y = wall.axis == 0 ? -a.sine : a.cosine;
    for (int k = 0; k < a.count; ++k) {
      const PlanarSphere& sphere = spheres[a.first + k];
      const double distance = centre + along_x * sphere.x + along_y * sphere.y;
      if (wall.side_of(distance) * distance < a.radius + a.skin)
        writer.add(k, sphere, 0, PlanarSphere(), a.radius);
    }
  }
}

/// Touching blocks first, each kind in the order of the bodies: they run through memory.
void PlanarScene::Data::sort_blocks() {
  for (PlanarBlockPool* pool : {&pairs, &at_walls}) {
    near.resize(pool->size());
    for (int k = 0; k < pool->size(); ++k) near[k] = k;
    const AlignedVector<PlanarBlock>& blocks = pool->blocks;
    std::sort(near.begin(), near.end(), [&](int a, int b) {
      const bool touches_a = blocks[a].alive != 0, touches_b = blocks[b].alive != 0;
      if (touches_a != touches_b) return touches_a;
      if (blocks[a].i != blocks[b].i) return blocks[a].i < blocks[b].i;
      if (blocks[a].j != blocks[b].j) return blocks[a].j < blocks[b].j;
      return a < b;
    });
    pool->reorder(near);
  }
}

}  // namespace rodpack
