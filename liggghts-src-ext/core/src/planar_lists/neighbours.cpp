// SPDX-License-Identifier: GPL-2.0-or-later
#include "neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../planar/blocks.h"
#include "../planar/bodies.h"
#include "rodpack/contact/contact_law.h"

namespace rodpack {

namespace {

// What is found next to a body when it is listed may be some steps of the pass ahead of it, and
// must not touch it before. So a body is listed when it is about to leave its skin in what is left
// of the pass or in the step after it, and this much before, for what the forces of these steps may
// add.
constexpr double before_its_skin = 0.98;

constexpr double none = std::numeric_limits<double>::infinity();  // the gap of no candidates

double lane_abs(double x) { return std::fabs(x); }

#include "../planar_simd/motion_bound.h"

/// By how much the bound on the motion of a body, which may be too large, grows in a step in which
/// the body goes `displacement` in its frame, m.
double growth_of_bound(double displacement, const PlanarFrameStep& frame) {
  return octagon_excess * displacement + frame.strain;
}

}  // namespace

PlanarNeighbours::PlanarNeighbours(const PlanarSettings& settings, const PlanarBodyStates& bodies,
                                   const PlanarParts& parts, PlanarBlocks& blocks,
                                   PlanarDependencies& dependencies)
    : settings_(settings),
      bodies_(bodies),
      parts_(parts),
      blocks_(blocks),
      dependencies_(dependencies),
      frames_(settings) {
  resize(bodies.size());
}

void PlanarNeighbours::resize(int bodies) {
  references_.resize(bodies, MovingReference());
  const std::size_t registers = (bodies + body_lanes - 1) / body_lanes;
  PlanarReferenceLanes no_bodies = PlanarReferenceLanes();
  std::fill_n(no_bodies.skin, body_lanes, none);
  reference_lanes_.resize(registers, no_bodies);
  moved_.resize(registers * body_lanes);
  travelled_.resize(registers * body_lanes);
  work_.newest.resize(settings_.walls.size() + bodies, -1);
  blocks_.resize(bodies);
}

/// Makes the present position of the body, which is in its cell, its reference position, and sets
/// its skin.
void PlanarNeighbours::set_reference(int body) {
  const PlanarKinematics& kinematics = bodies_.kinematics(body);
  const PlanarFrameStep frame = exist_ ? frames_.step(grid_.cell(body)) : PlanarFrameStep();
  const double displacement = bodies_.step_displacement(body, frame.x, frame.y);
  const double skin =
      std::min(settings_.max_skin,
               std::max(settings_.min_skin, settings_.skin_steps * (displacement + frame.strain)));
  references_[body] = {{kinematics.x - step_ * frame.x, kinematics.y - step_ * frame.y,
                        kinematics.cosine, kinematics.sine, bodies_.info(body).reach, skin},
                       frame.x,
                       frame.y};
  set_lanes(body, -step_ * frame.strain, frame.strain);
  moved_[body] = travelled_[body] = 0.0;
  const double covered = before_its_skin * skin / growth_of_bound(displacement, frame);
  if (covered < steps_of_listed_) {
    steps_of_listed_ = std::max(1, static_cast<int>(covered));
    steps_within_skins_ = std::min(steps_within_skins_, steps_of_listed_);
  }
}

void PlanarNeighbours::set_lanes(int body, double strain, double strain_step) {
  const PlanarReference& at = references_[body].at;
  PlanarReferenceLanes& lanes = reference_lanes_[body / body_lanes];
  const int lane = body % body_lanes;
  lanes.x[lane] = at.x;
  lanes.y[lane] = at.y;
  lanes.cosine[lane] = at.cosine;
  lanes.sine[lane] = at.sine;
  lanes.reach[lane] = at.reach;
  lanes.skin[lane] = before_its_skin * at.skin;
  lanes.step_x[lane] = references_[body].step_x;
  lanes.step_y[lane] = references_[body].step_y;
  lanes.strain[lane] = strain;
  lanes.strain_step[lane] = strain_step;
}

/// The reference position at the time that is looked at.
PlanarReference PlanarNeighbours::reference(int body) const {
  const MovingReference& of = references_[body];
  PlanarReference at = of.at;
  at.x += step_ * of.step_x;
  at.y += step_ * of.step_y;
  return at;
}

int PlanarNeighbours::begin_pass(int most) {
  begun_ = step_;
  if (begun_ == 0 || begun_ + most > frames_.steps_within_way()) renew_frames();
  return std::min(most, frames_.steps_within_way() - begun_);
}

void PlanarNeighbours::renew_frames() {
  const bool moved = frames_.any_moves();
  if (moved) move_references();
  begun_ = step_ = 0;
  frames_.renew(grid_, bodies_);
  if (!moved && !frames_.any_moves()) return;
  std::vector<int>& leaving = work_.leaving;
  leaving.clear();
  for (int body = 0; body < bodies_.size(); ++body) {
    if (bodies_.info(body).count == 0) continue;  // a ghost that is out of use
    const PlanarFrameStep frame = frames_.step(grid_.cell(body));
    MovingReference& reference = references_[body];
    PlanarReferenceLanes& lanes = reference_lanes_[body / body_lanes];
    const int lane = body % body_lanes;
    lanes.step_x[lane] = reference.step_x = frame.x;
    lanes.step_y[lane] = reference.step_y = frame.y;
    lanes.strain_step[lane] = frame.strain;
    // Seen from another frame it may leave its skin in the first step.
    const double* const v = bodies_.kinematics(body).velocity;
    const double bound = motion_bound(settings_.dt * v[0] - frame.x, settings_.dt * v[1] - frame.y,
                                      lanes.reach[lane], settings_.dt * v[2], 0.0);
    if (moved_[body] + bound + frame.strain > lanes.skin[lane]) leaving.push_back(body);
  }
  list_anew(leaving);
}

/// Moves the reference positions to the time that is looked at, and into their cells.
void PlanarNeighbours::move_references() {
  for (int body = 0; body < bodies_.size(); ++body) {
    if (bodies_.info(body).count == 0) continue;  // a ghost that is out of use
    PlanarReferenceLanes& lanes = reference_lanes_[body / body_lanes];
    const int lane = body % body_lanes;
    lanes.strain[lane] += step_ * lanes.strain_step[lane];
    PlanarReference& at = references_[body].at;
    lanes.x[lane] = at.x += step_ * lanes.step_x[lane];
    lanes.y[lane] = at.y += step_ * lanes.step_y[lane];
    grid_.move(body, at.x, at.y);
  }
}

void PlanarNeighbours::renew_steps_within_skins() {
  steps_within_skins_ = steps_of_listed_;
  steps_of_listed_ = most_steps_in_pass;
}

void PlanarNeighbours::set_arguments(int steps_ahead, PlanarAdvanceArguments& arguments) {
  arguments.steps_since = step_;
  arguments.steps_ahead = steps_ahead;
  arguments.references = reference_lanes_.data();
  arguments.moved = moved_.data();
  arguments.travelled = travelled_.data();
}

void PlanarNeighbours::list_all() {
  const int count = bodies_.size();
  std::vector<double> x(count), y(count);
  double fastest = 0.0;  // m in a step
  for (int k = 0; k < count; ++k) {
    set_reference(k);
    fastest = std::max(fastest, bodies_.step_displacement(k));
    x[k] = references_[k].at.x;
    y[k] = references_[k].at.y;
  }
  // Frames may go as far in a pass as the fastest body, and somewhat more; but no cell grows by
  // more than four times what skins make of it.
  const double way = 1.25 * most_steps_in_pass * fastest;
  frames_.set_way(std::min(4.0 * settings_.max_skin, std::max(0.25 * settings_.max_skin, way)));
  // Those that may touch are in the same cell or in cells next to each other, though reference
  // positions may be on their way to other cells.
  grid_.build(x, y, 2.0 * (longest_reach_ + settings_.max_skin + frames_.way()));
  exist_ = true;
  for (int k = 0; k < count; ++k) list_near(k, k);
}

void PlanarNeighbours::list_anew(const std::vector<int>& bodies) {
  for (int body : bodies) {
    grid_.move(body, bodies_.kinematics(body).x, bodies_.kinematics(body).y);
    set_reference(body);
    list(body);
  }
}

void PlanarNeighbours::add_ghost(int ghost) {
  if (exist_) grid_.add(ghost, bodies_.kinematics(ghost).x, bodies_.kinematics(ghost).y);
  set_reference(ghost);
}

void PlanarNeighbours::remove_ghost(int ghost) {
  blocks_.remove_all_of(ghost);
  if (exist_) grid_.remove(ghost);
}

void PlanarNeighbours::add_path(int body, const double* displacement) {
  travelled_[body] += motion_bound(displacement[0], displacement[1], references_[body].at.reach,
                                   displacement[2], 0.0);
}

/// Bounds the motion as the SIMD loop does that advances the bodies of this rank.
bool PlanarNeighbours::follow_ghost(int ghost, const PlanarKinematics& before) {
  const PlanarKinematics& kinematics = bodies_.kinematics(ghost);
  const PlanarReference at = reference(ghost);
  const PlanarReferenceLanes& lanes = reference_lanes_[ghost / body_lanes];
  const int lane = ghost % body_lanes;
  const auto bound = [&](double x, double y, double cosine, double sine) {
    return motion_bound(kinematics.x - x, kinematics.y - y, at.reach, kinematics.cosine - cosine,
                        kinematics.sine - sine);
  };
  double& moved = moved_[ghost];
  moved =
      bound(at.x, at.y, at.cosine, at.sine) + lanes.strain[lane] + step_ * lanes.strain_step[lane];
  const MovingReference& frame = references_[ghost];
  travelled_[ghost] +=
      bound(before.x + frame.step_x, before.y + frame.step_y, before.cosine, before.sine) +
      lanes.strain_step[lane];
  return exist_ && moved > before_its_skin * at.skin;
}

/// Finds the bodies before `end` that are near a body.
void PlanarNeighbours::find_near(int body, int end) {
  const PlanarChain here = chain(body);
  const PlanarReference& at = here.at;
  const int owned = bodies_.owned();
  std::vector<int>& near = work_.near;
  near.clear();
  const double farthest = at.reach + at.skin + longest_reach_ + settings_.max_skin + frames_.way();
  grid_.around(at.x, at.y, farthest, [&](int other) {
    if (other == body || other >= end) return;
    if (other >= owned && body >= owned) return;  // contacts of two ghosts are their ranks' affair
    const MovingReference& there = references_[other];
    const double dx = at.x - there.at.x - step_ * there.step_x,
                 dy = at.y - there.at.y - step_ * there.step_y;
    const double far = at.reach + there.at.reach + at.skin + there.at.skin;
    if (dx * dx + dy * dy < far * far && are_close(here, chain(other))) near.push_back(other);
  });
}

/// Lists a body with the bodies near it that come before `end`, and with walls. What stands in
/// work_.blocks is looked at again; contacts keep their history.
void PlanarNeighbours::list_near(int body, int end) {
  find_near(body, end);
  for (const int other : work_.near) bodies_.prefetch_spheres(other);
  for (const int other : work_.near) {
    const bool first = bodies_.comes_first(body, other);
    list_pair(first ? body : other, first ? other : body, other);
  }
  if (body < bodies_.owned()) list_walls(body);
}

/// Brings the blocks of a body to its present reference position.
void PlanarNeighbours::list(int body) {
  ++listings_;
  std::vector<ListedBlock>& listed = work_.blocks;
  listed.clear();
  for (const PlanarBlockPool* pool : {&blocks_.pairs(), &blocks_.at_walls()})
    for (const int place : pool->of_body(body)) {
      pool->prefetch(place);
      const PlanarBlockHead head = pool->head(place);
      const int other = head.i == body ? head.j : head.i;
      int& newest = newest_listed(other);
      listed.push_back({other, place, newest});
      newest = static_cast<int>(listed.size()) - 1;
    }
  list_near(body, bodies_.size());
  for (const ListedBlock& block : listed) {
    int& newest = newest_listed(block.other);
    for (; newest >= 0; newest = listed[newest].earlier)  // out of reach
      blocks_.of(block.other).remove(listed[newest].place);
  }
  listed.clear();
}

PlanarChain PlanarNeighbours::chain(int body) const {
  const PlanarBodyInfo& info = bodies_.info(body);
  return {bodies_.spheres(body), info.count, info.radius, info.box, reference(body)};
}

void PlanarNeighbours::list_pair(int i, int j, int other) {
  work_.candidates.clear();
  find_candidates(chain(i), chain(j), work_.candidates);
  set_blocks(i, j, other);
}

void PlanarNeighbours::list_walls(int i) {
  for (std::size_t w = 0; w < settings_.walls.size(); ++w) {
    work_.candidates.clear();
    find_candidates(chain(i), settings_.walls[w], work_.candidates);
    const int wall = -1 - static_cast<int>(w);
    set_blocks(i, wall, wall);
  }
}

/// Sees to it that all candidates of i and j, one of which is `other`, stand in blocks.
void PlanarNeighbours::set_blocks(int i, int j, int other) {
  std::vector<int>& of_pair = work_.of_pair;
  of_pair.clear();
  int& newest = newest_listed(other);
  for (; newest >= 0; newest = work_.blocks[newest].earlier)
    of_pair.push_back(work_.blocks[newest].place);
  if (!of_pair.empty() && renew_gaps(j)) return;
  work_.contacts.clear();
  for (const int place : of_pair) blocks_.take_out(j, place, work_.contacts);
  add_blocks(i, j);
  for (const PlanarLaneState& contact : work_.contacts) blocks_.restore(contact);
}

/// Sets the gaps of the blocks of a pair of bodies, the second one j, if they hold all candidates.
/// Spheres that are none are farther apart than any of these.
bool PlanarNeighbours::renew_gaps(int j) {
  if (work_.candidates.empty()) return false;
  PlanarBlockPool& pool = blocks_.of(j);
  const std::size_t columns = j < 0 ? 1 : bodies_.info(j).count;
  const auto gap_of = [&](int sphere_i, int sphere_j) -> double& {
    return work_.gap_of[sphere_i * columns + sphere_j];
  };
  const std::size_t last = work_.candidates.back().sphere_i;
  if (work_.gap_of.size() < (last + 1) * columns) work_.gap_of.resize((last + 1) * columns, none);
  for (const PlanarCandidate& pair : work_.candidates)
    gap_of(pair.sphere_i, pair.sphere_j) = pair.gap;
  std::vector<double>& gaps = work_.gaps;
  gaps.clear();
  std::size_t found = 0;
  for (const int place : work_.of_pair) {
    const PlanarBlockHead head = pool.head(place);
    const PlanarBlockColdData& cold = pool.cold(place);
    double smallest = none;
    for (int lane = 0; lane < planar_lanes; ++lane) {
      if (!(head.used & 1 << lane) || cold.sphere_i[lane] > last) continue;
      const double gap = gap_of(cold.sphere_i[lane], cold.sphere_j[lane]);
      if (gap < none) ++found;
      smallest = std::min(smallest, gap);
    }
    gaps.push_back(smallest);
  }
  for (const PlanarCandidate& pair : work_.candidates) gap_of(pair.sphere_i, pair.sphere_j) = none;
  if (found < work_.candidates.size()) return false;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (gaps[k] < none)
      pool.set_gap(work_.of_pair[k], gaps[k]);
    else
      pool.remove(work_.of_pair[k]);
  }
  return true;
}

/// The coefficients of contacts of body i with body j, or with wall -1 - j.
PlanarNeighbours::Coefficients PlanarNeighbours::coefficients(int i, int j) const {
  const PlanarBodyInfo& of_i = bodies_.info(i);
  const double m = of_i.mass;
  double mass = m;
  int type_j;
  if (j < 0) {
    type_j = settings_.walls[-1 - j].type;
  } else {
    const PlanarBodyInfo& of_j = bodies_.info(j);
    type_j = of_j.type;
    mass = effective_mass(m, of_j.mass);
    // A prescribed motion is that of an infinite mass.
    if (of_i.prescribed) mass = of_j.mass;
    if (of_j.prescribed) mass = m;
  }
  const int law_index = of_i.type * settings_.types + type_j;
  const PlanarLaw& law = settings_.laws[law_index];
  return {
      law_index,
      {damping_coefficient(law.eta_n, mass, law.kn), damping_coefficient(law.eta_t, mass, law.kt)}};
}

/// Puts the candidates of i and j into blocks, the closest first.
void PlanarNeighbours::add_blocks(int i, int j) {
  std::vector<PlanarCandidate>& candidates = work_.candidates;
  if (candidates.empty()) return;
  sort_candidates(candidates);
  const Coefficients of_both = coefficients(i, j);
  const PlanarSphere on_wall = PlanarSphere();
  PlanarBlockPool& pool = blocks_.of(j);
  const int count = static_cast<int>(candidates.size());
  for (int first = 0; first < count; first += planar_lanes) {
    PlanarBlockColdData cold = PlanarBlockColdData();
    const int used = std::min(planar_lanes, count - first);
    PlanarBlockHead head = PlanarBlockHead();
    head.i = i;
    head.j = j;
    head.used = static_cast<std::uint8_t>((1 << used) - 1);
    head.gap = PlanarBlockPool::rounded_down(candidates[first].gap);
    for (int lane = 0; lane < planar_lanes; ++lane) {
      const PlanarCandidate& pair = candidates[first + (lane < used ? lane : 0)];
      cold.sphere_i[lane] = static_cast<std::uint16_t>(pair.sphere_i);
      cold.sphere_j[lane] = static_cast<std::uint16_t>(pair.sphere_j);
    }
    const int place = pool.add(parts_.of_pair(i, j), head, of_both.law, cold);
    dependencies_.add_contact(i, j, pool.part_of(place));
    pool.set_spheres(place, bodies_.spheres(i), j < 0 ? &on_wall : bodies_.spheres(j),
                     of_both.gamma);
    if (settings_.mass_scaling > 0.0)
      pool.set_weights(place, bodies_.weight(i), j < 0 ? ContactWeight() : bodies_.weight(j));
  }
}

}  // namespace rodpack
