// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/planar/scene.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "halo.h"
#include "scene_data.h"

namespace rodpack {

namespace {

// So few that they and their blocks stay in the cache for some steps, so many that parts cost
// little.
const int bodies_in_part = 256;

void require(bool holds, const std::string& name, double value, const char* expected) {
  if (!holds)
    throw std::invalid_argument("planar scene: " + name + " is " + std::to_string(value) +
                                ", expected " + expected);
}

void validate(const PlanarSettings& s, const std::vector<PlanarBody>& bodies) {
  require(s.order >= 1 && s.order <= max_multistep_order, "order", s.order, "1, 2, 3 or 4");
  require(s.remembered >= 1 && s.remembered <= max_multistep_order, "remembered", s.remembered,
          "1, 2, 3 or 4");
  require(s.dt > 0.0, "time step", s.dt, "a step > 0 (s)");
  require(s.types >= 1 && s.laws.size() == static_cast<std::size_t>(s.types) * s.types,
          "number of laws", static_cast<double>(s.laws.size()), "one for every pair of types");
  require(s.min_skin > 0.0 && s.max_skin >= s.min_skin, "min_skin", s.min_skin,
          "0 < min_skin <= max_skin (m)");
  for (const PlanarLaw& law : s.laws) {
    require(law.kn > 0.0, "kn", law.kn, "a stiffness > 0 (N/m)");
    require(law.kt > 0.0, "kt", law.kt, "a stiffness > 0 (N/m)");
    require(law.eta_n >= 0.0 && law.eta_n < 1.0, "eta_n", law.eta_n, "0 <= ratio < 1");
    require(law.eta_t >= 0.0 && law.eta_t < 1.0, "eta_t", law.eta_t, "0 <= ratio < 1");
    require(law.friction >= 0.0, "friction", law.friction, "a coefficient >= 0");
  }
  for (const PlanarWall& wall : s.walls) {
    require(wall.axis == 0 || wall.axis == 1, "axis of a wall", wall.axis, "0 or 1");
    require(wall.type >= 0 && wall.type < s.types, "type of a wall", wall.type, "0 .. types-1");
  }
  for (const PlanarBody& body : bodies) {
    require(body.type >= 0 && body.type < s.types, "type of a body", body.type, "0 .. types-1");
    require(body.mass > 0.0, "mass", body.mass, "a mass > 0 (kg)");
    require(body.moment > 0.0, "moment of inertia", body.moment, "a moment > 0 (kg m^2)");
    require(body.radius > 0.0, "radius", body.radius, "a radius > 0 (m)");
    require(!body.spheres.empty() && body.spheres.size() <= 65535, "number of spheres",
            static_cast<double>(body.spheres.size()), "1 .. 65535");
    require(body.evaluations >= 0, "evaluations", body.evaluations, "0 or more");
  }
}

}  // namespace

PlanarScene::Data::Data(const PlanarSettings& given, const std::vector<PlanarBody>& bodies)
    : settings(given),
      slots(std::max(given.order, given.remembered)),
      parts{static_cast<int>(bodies.size()), bodies_in_part},
      completed_by(parts.count()),
      kernel(planar_kernel(given.instructions)),
      missed(parts.count()),
      newborn(parts.count()),
      pairs(static_cast<int>(bodies.size()), slots, 0),
      at_walls(static_cast<int>(bodies.size()), slots, -1),
      events(parts),
      follows(given.events && given.order > 1) {
  const std::size_t count = bodies.size();
  owned = static_cast<int>(count);
  resize(owned);
  for (auto* vectors : {&inertia, &missed_displacement, &missed_velocity})
    vectors->assign(count, PlanarVector());
  for (int k = 0; k < settings.order - 1; ++k) {
    past_velocity[k].assign(count, PlanarVector());
    past_acceleration[k].assign(count, PlanarVector());
  }
  for (const PlanarWall& wall : settings.walls)
    wall_lines.push_back({wall.axis == 0 ? 1.0 : 0.0, wall.axis == 1 ? 1.0 : 0.0, wall.position,
                          static_cast<double>(wall.free_side)});
  for (const PlanarLaw& law : settings.laws)
    laws.push_back({law.kn, law.kt, 1.0 / law.kt, law.friction * law.kn});
  evaluations.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    const PlanarBody& body = bodies[b];
    PlanarBodyInfo& of = info[b];
    tags[b] = body.tag < 0 ? static_cast<int>(b) : body.tag;
    of.type = body.type;
    of.mass = body.mass;
    of.moment = body.moment;
    of.radius = body.radius;
    of.first = static_cast<int>(spheres.size());
    of.count = static_cast<int>(body.spheres.size());
    spheres.insert(spheres.end(), body.spheres.begin(), body.spheres.end());
    set_reach(static_cast<int>(b));
    longest = std::max(longest, listed[b].reach);
    frames[b] = {body.position[0],
                 body.position[1],
                 body.cosine,
                 body.sine,
                 {body.velocity[0], body.velocity[1], body.velocity[2]},
                 body.radius};
    evaluations[b] = static_cast<std::int8_t>(std::min(body.evaluations, settings.order + 1));
    for (int d = 0; d < 3; ++d) {
      loads[b].d[d] = body.load[d];
      inertia[b].d[d] = 1.0 / (d < 2 ? body.mass : body.moment);
      missed_displacement[b].d[d] = body.missed_displacement[d];
      missed_velocity[b].d[d] = body.missed_velocity[d];
    }
    inertia[b].d[3] = body.mass;
    const int part = parts.of(static_cast<int>(b));
    missed[part].push_back(static_cast<int>(b));
    if (body.evaluations == 0) newborn[part].push_back(static_cast<int>(b));
    for (int k = 0; k < settings.order - 1; ++k) {
      const PlanarRates& past = body.past[k];
      past_velocity[k][b] = {{past.velocity[0], past.velocity[1], past.angular_velocity, 0.0}};
      past_acceleration[k][b] = {
          {past.acceleration[0], past.acceleration[1], past.angular_acceleration, 0.0}};
    }
    if (body.jumped) events.set_jumped(static_cast<int>(b), body.change);
  }
}

PlanarScene::Data::~Data() = default;

/// Room for what forces need of a body; ghosts are not integrated.
void PlanarScene::Data::resize(int bodies) {
  frames.resize(bodies);
  loads.resize(bodies, PlanarVector());
  info.resize(bodies, PlanarBodyInfo());
  listed.resize(bodies, PlanarListed());
  const std::size_t registers = (bodies + body_lanes - 1) / body_lanes;
  PlanarListedLanes nobody = PlanarListedLanes();
  std::fill_n(nobody.skin, body_lanes, std::numeric_limits<double>::infinity());
  listed_lanes.resize(registers, nobody);
  moved.resize(registers * body_lanes);
  tags.resize(bodies, -1);
  pairs.resize(bodies);
  at_walls.resize(bodies);
  events.resize(bodies);
}

void PlanarScene::Data::set_reach(int body) {
  const PlanarBodyInfo& of = info[body];
  double& reach = listed[body].reach;
  reach = 0.0;
  for (int k = of.first; k < of.first + of.count; ++k)
    reach = std::max(reach, std::hypot(spheres[k].x, spheres[k].y) + of.radius);
}

PlanarScene::PlanarScene(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies,
                         PlanarRanks* ranks) {
  validate(settings, bodies);
  data_.reset(new Data(settings, bodies));
  if (!ranks || ranks->count() == 1) return;
  std::vector<int> tags;
  for (const PlanarBody& body : bodies) tags.push_back(body.tag);
  std::sort(tags.begin(), tags.end());
  for (std::size_t k = 0; k < tags.size(); ++k)
    require(tags[k] > (k == 0 ? -1 : tags[k - 1]), "tag of a body", tags[k],
            "tags >= 0, each once");
  data_->halo.reset(new PlanarHalo(*ranks, *data_));
}

PlanarScene::~PlanarScene() = default;

void PlanarScene::evaluate() {
  Data& d = *data_;
  d.make_lists();
  d.begin_forces();
  for (int part = 0; part < d.parts.count(); ++part) d.evaluate_forces(part);
  // No step has gone by that could have missed something.
  for (int part = 0; part < d.parts.count(); ++part) d.events.forget_changes(part);
  for (PlanarBlockPool* pool : {&d.pairs, &d.at_walls}) pool->turn(1);
}

long PlanarScene::run(long steps) {
  Data& d = *data_;
  d.make_lists();
  long step = 0;
  while (step < steps && !(d.halo && d.halo->far_away())) {
    long sweep = steps_in_sweep - d.statistics.steps % steps_in_sweep;
    sweep = std::min(sweep, static_cast<long>(d.longest_sweep));
    if (d.halo) sweep = std::min(sweep, std::max(1L, static_cast<long>(d.halo->quiet_updates())));
    sweep = std::min(sweep, steps - step);
    d.sweep(static_cast<int>(sweep));
    step += sweep;
  }
  if (d.halo) d.halo->check(d);
  return step;
}

void PlanarScene::set_contacts(const std::vector<PlanarContactState>& contacts) {
  Data& d = *data_;
  if (!d.lists_exist) d.list_all();
  for (const PlanarContactState& contact : contacts) {
    Data::Saved saved = Data::Saved();
    const bool swapped = contact.body_j >= 0 && !d.comes_first(contact.body_i, contact.body_j);
    saved.i = swapped ? contact.body_j : contact.body_i;
    saved.j = swapped ? contact.body_i : contact.body_j;
    const int sphere_i = swapped ? contact.sphere_j : contact.sphere_i;
    const int sphere_j = swapped ? contact.sphere_i : contact.sphere_j;
    saved.sliding = contact.count < 0;
    saved.count = static_cast<std::int8_t>(std::min(std::abs(contact.count), d.full_count()));
    saved.mature = saved.count == d.full_count();
    saved.fresh = contact.fresh;
    // Along z x n the components stay as they are when i and j change places.
    saved.spring = contact.spring;
    std::copy(contact.velocity, contact.velocity + max_multistep_order, saved.velocity);
    saved.uncut = contact.uncut;
    saved.touch_rate = contact.touch_rate;
    saved.since = contact.since;
    PlanarBlockPool& pool = saved.j < 0 ? d.at_walls : d.pairs;
    bool found = false;
    for (int place : pool.of_body(saved.i)) {
      const PlanarBlockHead& head = pool.heads[place];
      if (head.i != saved.i || head.j != saved.j) continue;
      const PlanarBlockBirth& birth = pool.births[place];
      for (int lane = 0; lane < planar_lanes; ++lane) {
        if (!(head.used & 1 << lane)) continue;
        if (birth.sphere_i[lane] != sphere_i || birth.sphere_j[lane] != sphere_j) continue;
        restore_lane(pool, place, lane, saved);
        found = true;
      }
    }
    require(found, "contact of bodies", contact.body_i, "spheres that are close");
  }
  d.sort_blocks();
}

std::vector<PlanarContactState> PlanarScene::contacts() const {
  std::size_t count = 0;
  for (const PlanarBlockPool* pool : {&data_->pairs, &data_->at_walls})
    for (const PlanarBlockHead& head : pool->heads) count += std::bitset<8>(head.alive).count();
  std::vector<PlanarContactState> result;
  result.reserve(count);
  for (const PlanarBlockPool* pool : {&data_->pairs, &data_->at_walls})
    for (int place = 0; place < pool->size(); ++place)
      for (int lane = 0; lane < planar_lanes; ++lane) {
        if (!(pool->heads[place].alive & 1 << lane)) continue;
        Data::Saved saved;
        save_lane(*pool, place, lane, saved);
        PlanarContactState state;
        state.body_i = saved.i;
        state.sphere_i = saved.sphere_i;
        state.body_j = saved.j;
        state.sphere_j = saved.sphere_j;
        state.spring = saved.spring;
        std::copy(saved.velocity, saved.velocity + max_multistep_order, state.velocity);
        state.count = saved.sliding ? -saved.count : saved.count;
        state.since = saved.since;
        state.uncut = saved.uncut;
        state.touch_rate = saved.touch_rate;
        state.fresh = saved.fresh;
        PlanarContact contact;
        data_->place_lane(*pool, place, lane, contact);
        state.constants[0] = data_->laws[pool->laws[place]].friction;
        state.constants[1] = contact.kt;
        state.constants[2] = contact.gammat;
        std::copy(contact.en, contact.en + 2, state.normal);
        result.push_back(state);
      }
  return result;
}

int PlanarScene::size() const { return data_->owned; }

int PlanarScene::size_with_ghosts() const { return static_cast<int>(data_->info.size()); }

int PlanarScene::spheres(int body) const { return data_->info[body].count; }

int PlanarScene::sphere_tag(int body, int sphere) const {
  return data_->spheres[data_->info[body].first + sphere].tag;
}

PlanarBody PlanarScene::body(int index) const {
  const Data& d = *data_;
  const PlanarBodyInfo& info = d.info[index];
  const PlanarFrame& frame = d.frames[index];
  PlanarBody body;
  body.tag = d.tags[index];
  body.type = info.type;
  body.mass = info.mass;
  body.moment = info.moment;
  body.radius = info.radius;
  body.spheres.assign(d.spheres.begin() + info.first, d.spheres.begin() + info.first + info.count);
  body.position[0] = frame.x;
  body.position[1] = frame.y;
  body.cosine = frame.cosine;
  body.sine = frame.sine;
  body.evaluations = d.evaluations[index];
  for (int k = 0; k < 3; ++k) {
    body.velocity[k] = frame.velocity[k];
    body.load[k] = d.loads[index].d[k];
    body.missed_displacement[k] = d.missed_displacement[index].d[k];
    body.missed_velocity[k] = d.missed_velocity[index].d[k];
  }
  for (int k = 0; k < d.settings.order - 1; ++k) {
    const double* v = d.past_velocity[d.past(k)][index].d;
    const double* a = d.past_acceleration[d.past(k)][index].d;
    body.past[k] = {{v[0], v[1]}, v[2], {a[0], a[1]}, a[2]};
  }
  body.jumped = d.events.jumped(index);
  if (body.jumped) body.change = d.events.motion(index);
  return body;
}

PlanarScene::Statistics PlanarScene::statistics() const {
  Statistics result = data_->statistics;
  result.blocks = data_->pairs.filled() + data_->at_walls.filled();
  return result;
}

}  // namespace rodpack
