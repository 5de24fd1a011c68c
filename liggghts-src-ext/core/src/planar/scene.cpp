// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/planar/scene.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "blocks.h"
#include "bodies.h"
#include "events.h"
#include "force_evaluator.h"
#include "../planar_ranks/ghosts.h"
#include "../planar_ranks/halo.h"
#include "../planar_lists/neighbours.h"
#include "pipeline.h"

namespace rodpack {

namespace {

// So few that they and their blocks stay in the cache for some steps, so many that parts cost
// little.
const int bodies_in_part = 256;

// A multiple of most_steps_in_pass: no pass goes on over the step in which blocks are sorted.
const int steps_between_sorts = 256;

void require(bool holds, const std::string& name, double value, const char* expected) {
  if (!holds)
    throw std::invalid_argument("planar scene: " + name + " is " + std::to_string(value) +
                                ", expected " + expected);
}

void validate(const PlanarSettings& s, const std::vector<PlanarBody>& bodies) {
  require(s.order >= 0 && s.order <= max_multistep_order, "order", s.order, "0, 1, 2, 3 or 4");
  require(s.slots >= 1 && s.slots <= max_multistep_order, "slots", s.slots, "1, 2, 3 or 4");
  require(s.mass_scaling == 0.0 || s.mass_scaling >= 1.0, "mass_scaling", s.mass_scaling,
          "0 or a number >= 1");
  require(s.dashpot_relaxation == 0.0 || (s.dashpot_relaxation > 0.0 && s.order == 0),
          "dashpot_relaxation", s.dashpot_relaxation, "0, or a time > 0 (s) with order 0");
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

/// On several ranks bodies are known by their tags.
void validate_tags(const std::vector<PlanarBody>& bodies) {
  std::vector<int> tags;
  for (const PlanarBody& body : bodies) tags.push_back(body.tag);
  std::sort(tags.begin(), tags.end());
  for (std::size_t k = 0; k < tags.size(); ++k)
    require(tags[k] > (k == 0 ? -1 : tags[k - 1]), "tag of a body", tags[k],
            "tags >= 0, each once");
}

bool has_sphere(const PlanarBodyStates& bodies, int body, int sphere) {
  return body >= 0 && body < bodies.size() && sphere >= 0 && sphere < bodies.info(body).count;
}

void validate(const PlanarContactState& contact, const PlanarBodyStates& bodies,
              std::size_t walls) {
  require(has_sphere(bodies, contact.body_i, contact.sphere_i), "sphere of a contact",
          contact.sphere_i, "one of a body of the scene");
  if (contact.body_j >= 0)
    require(has_sphere(bodies, contact.body_j, contact.sphere_j), "sphere of a contact",
            contact.sphere_j, "one of a body of the scene");
  else
    require(static_cast<std::size_t>(-1 - contact.body_j) < walls, "wall of a contact",
            -1 - contact.body_j, "0 .. number of walls-1");
}

/// Tangential velocities that contacts remember: of leapfrog none but what the dashpot felt.
int slots_of(const PlanarSettings& settings) {
  return settings.order == 0 ? 1 : std::max(settings.order, settings.slots);
}

/// The state of a lane in which i and j change places if `swapped`; components along z x n stay.
/// `relaxes`: whether dashpots have a relaxation time. A history without what they felt, or with it
/// where they feel no past, is none for the SIMD loops.
PlanarLaneState lane_state_of(const PlanarContactState& contact, bool swapped, int full_count,
                              bool relaxes) {
  PlanarLaneState state = PlanarLaneState();
  state.i = swapped ? contact.body_j : contact.body_i;
  state.j = swapped ? contact.body_i : contact.body_j;
  state.sphere_i = static_cast<std::uint16_t>(swapped ? contact.sphere_j : contact.sphere_i);
  state.sphere_j = static_cast<std::uint16_t>(swapped ? contact.sphere_i : contact.sphere_j);
  state.history = contact.history;
  state.history.known = std::min(contact.history.known, full_count);
  state.full_history = state.history.known == full_count && state.history.relaxes == relaxes;
  return state;
}

}  // namespace

/// The parts of the engine, and what they do one after the other in a step.
struct PlanarScene::Data : private PlanarPartStep {
  Data(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies, PlanarRanks* ranks);

  /// Makes the first lists, if there are none yet.
  void make_lists();
  void evaluate_all();
  /// Makes up to `most` steps in one pass over the bodies; returns how many.
  int pass(long most);
  void sort_blocks();
  Statistics statistics() const;

  const PlanarSettings settings;
  const PlanarParts parts;
  const PlanarKernel kernel;
  PlanarBodyStates bodies;
  PlanarBlocks blocks;
  PlanarEvents events;
  PlanarDependencies dependencies;
  PlanarNeighbours neighbours;
  PlanarForceEvaluator forces;
  PlanarGhosts ghosts;
  std::unique_ptr<PlanarHalo> halo;
  long steps = 0;  // made so far, but for those of a pass that is under way

 private:
  bool move(int step, int part) override;
  void evaluate(int step, int part) override;
  void correct_for_events(int step, int part);

  PlanarPipeline pipeline_;
  int steps_of_pass_ = 1;
  std::vector<int> to_list_[most_steps_in_pass];  // bodies to be listed anew, by step of the pass
};

PlanarScene::Data::Data(const PlanarSettings& given, const std::vector<PlanarBody>& all,
                        PlanarRanks* ranks)
    : settings(given),
      parts{static_cast<int>(all.size()), bodies_in_part},
      kernel(planar_kernel(given.instructions, given.total_force_cap)),
      bodies(settings, parts, all),
      blocks(bodies.size(), slots_of(given),
             {given.total_force_cap, given.dashpot_relaxation > 0.0, given.mass_scaling > 0.0}),
      events(parts),
      dependencies(parts),
      neighbours(settings, bodies, parts, blocks, dependencies),
      forces(settings, kernel, bodies, neighbours, blocks, events),
      ghosts(bodies, neighbours, events),
      pipeline_(parts, dependencies) {
  events.resize(bodies.size());
  for (std::size_t b = 0; b < all.size(); ++b)
    if (all[b].jumped) events.set_jumped(static_cast<int>(b), all[b].jump);
  double longest_reach = bodies.longest_reach();
  if (ranks) ranks->largest(&longest_reach, 1);
  neighbours.set_longest_reach(longest_reach);
  if (!ranks) return;
  halo.reset(new PlanarHalo(*ranks, settings, longest_reach, bodies, events, ghosts));
  halo->renew(to_list_[0]);
  halo->hold_back_sent(dependencies);
}

void PlanarScene::Data::make_lists() {
  if (neighbours.exist()) return;
  neighbours.list_all();
  sort_blocks();
}

void PlanarScene::Data::sort_blocks() {
  neighbours.renew_steps_within_skins();
  dependencies.clear();
  if (halo) halo->hold_back_sent(dependencies);
  blocks.sort(parts, dependencies);
}

void PlanarScene::Data::evaluate_all() {
  make_lists();
  bodies.begin_loads();
  for (int part = 0; part < parts.count(); ++part) forces.evaluate(part, steps);
  // No step has gone by that could have missed something.
  for (int part = 0; part < parts.count(); ++part) events.forget_changes(part);
  blocks.settle();
  blocks.age(1);
}

int PlanarScene::Data::pass(long most) {
  // Passes end at multiples of their largest length, so that blocks are sorted at the same steps,
  // however many are asked for at a time.
  long steps_of_pass = most_steps_in_pass - steps % most_steps_in_pass;
  steps_of_pass = std::min(steps_of_pass, static_cast<long>(neighbours.steps_within_skins()));
  if (halo)
    steps_of_pass = std::min(steps_of_pass, std::max(1L, static_cast<long>(halo->quiet_updates())));
  if (steps % steps_between_sorts == steps_between_sorts / 2) sort_blocks();
  steps_of_pass_ = neighbours.begin_pass(static_cast<int>(std::min(steps_of_pass, most)));
  pipeline_.run(steps_of_pass_, *this);
  neighbours.look_at(steps_of_pass_);
  blocks.settle();
  blocks.age(steps_of_pass_);
  for (int part = 0; part < parts.count(); ++part) correct_for_events(steps_of_pass_, part);
  steps += steps_of_pass_;
  return steps_of_pass_;
}

// A part of the bodies goes through a step of a pass as follows: it is corrected for the events of
// the last step, its bodies move, those that have left their skins are listed anew, and the contact
// forces are evaluated.

bool PlanarScene::Data::move(int step, int part) {
  if (step > 0) correct_for_events(step, part);
  neighbours.look_at(step + 1);
  std::vector<int>& to_list = to_list_[step];
  if (part == parts.last()) {
    if (halo && halo->update(to_list)) halo->hold_back_sent(dependencies);
    return false;
  }
  bodies.prepare(part, steps + step, neighbours);
  bodies.advance(part, steps + step, kernel, neighbours, steps_of_pass_ - step, to_list);
  return !to_list.empty();
}

void PlanarScene::Data::evaluate(int step, int part) {
  blocks.look_ahead(step);
  neighbours.look_at(step + 1);
  neighbours.list_anew(to_list_[step]);
  to_list_[step].clear();
  forces.evaluate(part, steps + step + 1);
}

void PlanarScene::Data::correct_for_events(int step, int part) {
  if (forces.follows_events()) bodies.apply_events(part, steps + step, events);
}

PlanarScene::Statistics PlanarScene::Data::statistics() const {
  return {steps,
          neighbours.listings(),
          forces.general_contacts(),
          halo ? halo->ghosts_brought() : 0,
          halo ? halo->bytes_sent() : 0,
          blocks.filled()};
}

PlanarScene::PlanarScene(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies,
                         PlanarRanks* ranks) {
  validate(settings, bodies);
  const bool several = ranks && ranks->count() > 1;
  if (several) validate_tags(bodies);
  data_.reset(new Data(settings, bodies, several ? ranks : nullptr));
}

PlanarScene::~PlanarScene() = default;

void PlanarScene::evaluate() { data_->evaluate_all(); }

long PlanarScene::run(long steps) {
  Data& d = *data_;
  d.make_lists();
  long step = 0;
  while (step < steps && !(d.halo && d.halo->far_away())) step += d.pass(steps - step);
  if (d.halo) d.halo->check();
  return step;
}

void PlanarScene::set_contacts(const std::vector<PlanarContactState>& contacts) {
  Data& d = *data_;
  if (!d.neighbours.exist()) d.neighbours.list_all();
  for (const PlanarContactState& contact : contacts) {
    validate(contact, d.bodies, d.settings.walls.size());
    const bool swapped =
        contact.body_j >= 0 && !d.bodies.comes_first(contact.body_i, contact.body_j);
    const PlanarLaneState state =
        lane_state_of(contact, swapped, d.forces.full_count(), d.settings.dashpot_relaxation > 0.0);
    require(d.blocks.restore(state), "contact of bodies", contact.body_i, "spheres that are close");
  }
  d.sort_blocks();
}

std::vector<PlanarContactState> PlanarScene::contacts() const { return data_->forces.contacts(); }

int PlanarScene::size() const { return data_->bodies.owned(); }

int PlanarScene::size_with_ghosts() const { return data_->bodies.size(); }

int PlanarScene::spheres(int body) const { return data_->bodies.info(body).count; }

int PlanarScene::sphere_tag(int body, int sphere) const {
  return data_->bodies.spheres(body)[sphere].tag;
}

PlanarBody PlanarScene::body(int index) const {
  PlanarBody body = data_->bodies.state(index, data_->steps);
  body.jumped = data_->events.jumped(index);
  if (body.jumped) body.jump = data_->events.jump(index);
  return body;
}

PlanarScene::Statistics PlanarScene::statistics() const { return data_->statistics(); }

}  // namespace rodpack
