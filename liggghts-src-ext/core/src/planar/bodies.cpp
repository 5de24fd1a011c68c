// SPDX-License-Identifier: GPL-2.0-or-later
// What is known of the bodies, as it is given and asked for.
#include "bodies.h"

#include <algorithm>
#include <cmath>

namespace rodpack {

namespace {

double reach_of(const PlanarSphere* spheres, int count, double radius) {
  double reach = 0.0;
  for (int k = 0; k < count; ++k)
    reach = std::max(reach, std::hypot(spheres[k].x, spheres[k].y) + radius);
  return reach;
}

PlanarKinematics kinematics_of(const PlanarBody& body) {
  return {body.position[0],
          body.position[1],
          body.cosine,
          body.sine,
          {body.velocity[0], body.velocity[1], body.velocity[2]},
          body.radius};
}

}  // namespace

PlanarBodyStates::PlanarBodyStates(const PlanarSettings& given, const PlanarParts& division,
                                   const std::vector<PlanarBody>& bodies)
    : settings_(given), parts_(division), missed_(division.count()), newborn_(division.count()) {
  const std::size_t count = bodies.size();
  resize(static_cast<int>(count));
  evaluations_.resize(count);
  for (auto* vectors : {&inertia_, &missed_displacement_, &missed_velocity_})
    vectors->assign(count, PlanarVector());
  for (int k = 0; k < settings_.order - 1; ++k) {
    past_velocity_[k].assign(count, PlanarVector());
    past_acceleration_[k].assign(count, PlanarVector());
  }
  for (std::size_t b = 0; b < count; ++b) add(static_cast<int>(b), bodies[b]);
}

void PlanarBodyStates::add(int body, const PlanarBody& from) {
  set_info(body, from);
  if (from.tag < 0) tags_[body] = body;
  kinematics_[body] = kinematics_of(from);
  evaluations_[body] =
      static_cast<std::int8_t>(std::min(from.evaluations, std::max(1, settings_.order) + 1));
  for (int d = 0; d < 3; ++d) {
    loads_[body].d[d] = from.load[d];
    inertia_[body].d[d] = from.prescribed ? 0.0 : 1.0 / (d < 2 ? from.mass : from.moment);
    missed_displacement_[body].d[d] = from.missed_displacement[d];
    missed_velocity_[body].d[d] = from.missed_velocity[d];
  }
  inertia_[body].d[3] = from.mass;
  if (settings_.mass_scaling > 0.0) loads_[body].d[3] = from.contact_weight;
  const int part = parts_.of(body);
  missed_[part].push_back(body);
  if (from.evaluations == 0) newborn_[part].push_back(body);
  for (int k = 0; k < settings_.order - 1; ++k) {
    const PlanarRates& rates = from.past[k];
    past_velocity_[k][body] = {{rates.velocity[0], rates.velocity[1], rates.angular_velocity, 0.0}};
    past_acceleration_[k][body] = {
        {rates.acceleration[0], rates.acceleration[1], rates.angular_acceleration, 0.0}};
  }
}

/// Appends the spheres of the body to those of the others.
void PlanarBodyStates::set_info(int body, const PlanarBody& from) {
  const int count = static_cast<int>(from.spheres.size());
  info_[body] = {from.type,
                 from.prescribed,
                 from.mass,
                 from.moment,
                 from.radius,
                 reach_of(from.spheres.data(), count, from.radius),
                 box_of(from.spheres.data(), count),
                 static_cast<int>(spheres_.size()),
                 count};
  tags_[body] = from.tag;
  if (settings_.mass_scaling > 0.0)
    weights_[body] = planar_contact_weight(from.mass, from.moment, from.radius);
  spheres_.insert(spheres_.end(), from.spheres.begin(), from.spheres.end());
}

double PlanarBodyStates::longest_reach() const {
  double longest = 0.0;
  for (const PlanarBodyInfo& of : info_) longest = std::max(longest, of.reach);
  return longest;
}

double PlanarBodyStates::step_displacement(int body, double x, double y) const {
  const double* const v = kinematics_[body].velocity;
  const double dx = settings_.dt * v[0] - x, dy = settings_.dt * v[1] - y;
  return std::sqrt(dx * dx + dy * dy) + info_[body].reach * settings_.dt * std::fabs(v[2]);
}

PlanarBody PlanarBodyStates::present(int index) const {
  const PlanarBodyInfo& of = info_[index];
  const PlanarKinematics& now = kinematics_[index];
  PlanarBody body;
  body.tag = tags_[index];
  body.type = of.type;
  body.prescribed = of.prescribed;
  body.mass = of.mass;
  body.moment = of.moment;
  body.radius = of.radius;
  body.spheres.assign(spheres(index), spheres(index) + of.count);
  body.position[0] = now.x;
  body.position[1] = now.y;
  body.cosine = now.cosine;
  body.sine = now.sine;
  std::copy_n(now.velocity, 3, body.velocity);
  return body;
}

PlanarBody PlanarBodyStates::state(int index, long step) const {
  PlanarBody body = present(index);
  body.evaluations = evaluations_[index];
  std::copy_n(loads_[index].d, 3, body.load);
  if (settings_.mass_scaling > 0.0) body.contact_weight = loads_[index].d[3];
  std::copy_n(missed_displacement_[index].d, 3, body.missed_displacement);
  std::copy_n(missed_velocity_[index].d, 3, body.missed_velocity);
  for (int k = 0; k < settings_.order - 1; ++k) {
    const double* v = past_velocity_[past(k, step)][index].d;
    const double* a = past_acceleration_[past(k, step)][index].d;
    body.past[k] = {{v[0], v[1]}, v[2], {a[0], a[1]}, a[2]};
  }
  return body;
}

void PlanarBodyStates::resize(int bodies) {
  kinematics_.resize(bodies);
  loads_.resize(bodies, PlanarVector());
  info_.resize(bodies, PlanarBodyInfo());
  tags_.resize(bodies, -1);
  if (settings_.mass_scaling > 0.0) weights_.resize(bodies, ContactWeight());
}

void PlanarBodyStates::forget_ghost_spheres() {
  int own = 0;
  for (int b = 0; b < owned(); ++b) own += info_[b].count;
  spheres_.resize(own);
}

void PlanarBodyStates::set_ghost(int ghost, const PlanarBody& body) {
  set_info(ghost, body);
  move_ghost(ghost, kinematics_of(body));
  kinematics_[ghost].radius = body.radius;
}

void PlanarBodyStates::move_ghost(int ghost, const PlanarKinematics& moved) {
  const double radius = kinematics_[ghost].radius;
  kinematics_[ghost] = moved;
  kinematics_[ghost].radius = radius;
  loads_[ghost] = PlanarVector();  // the forces on a ghost are summed by its own rank
}

}  // namespace rodpack
