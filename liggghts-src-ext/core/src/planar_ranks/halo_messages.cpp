// SPDX-License-Identifier: GPL-2.0-or-later
#include "halo_messages.h"

#include <algorithm>
#include <cstddef>

namespace rodpack {

namespace {

const int kinematic_values = 7, jump_values = 11;
static_assert(sizeof(PlanarKinematics) == (kinematic_values + 1) * sizeof(double),
              "a message has all kinematics but the radius");
static_assert(offsetof(PlanarJump, sine) == (jump_values - 1) * sizeof(double),
              "a message has all that is known of a jump");

}  // namespace

double* pack_kinematics(const PlanarKinematics& kinematics, double* to) {
  const double values[kinematic_values] = {
      kinematics.x,           kinematics.y,           kinematics.cosine,     kinematics.sine,
      kinematics.velocity[0], kinematics.velocity[1], kinematics.velocity[2]};
  return std::copy(values, values + kinematic_values, to);
}

const double* unpack_kinematics(const double* from, PlanarKinematics& kinematics) {
  kinematics = {from[0], from[1], from[2], from[3], {from[4], from[5], from[6]}, kinematics.radius};
  return from + kinematic_values;
}

double* pack_jump(const PlanarJump& jump, double* to) {
  for (const double(*part)[3] : {&jump.acceleration, &jump.velocity, &jump.displacement})
    to = std::copy(*part, *part + 3, to);
  *to++ = jump.cosine;
  *to++ = jump.sine;
  return to;
}

const double* unpack_jump(const double* from, PlanarJump& jump) {
  for (double(*part)[3] : {&jump.acceleration, &jump.velocity, &jump.displacement}) {
    std::copy(from, from + 3, *part);
    from += 3;
  }
  jump.cosine = *from++;
  jump.sine = *from++;
  return from;
}

std::size_t most_step_values(std::size_t bodies) {
  // A kinematics for each, how many had events, and for each of these its place and what the event
  // did.
  return bodies == 0 ? 0 : bodies * (kinematic_values + 1 + jump_values) + 1;
}

void append_body(const PlanarBody& body, std::vector<double>& to) {
  for (const int value : {body.tag, body.type, static_cast<int>(body.spheres.size()),
                          body.prescribed ? 1 : 0, body.jumped ? 1 : 0})
    to.push_back(value);
  for (const double value : {body.mass, body.moment, body.radius, body.position[0],
                             body.position[1], body.cosine, body.sine})
    to.push_back(value);
  to.insert(to.end(), body.velocity, body.velocity + 3);
  if (body.jumped) {
    const std::size_t at = to.size();
    to.resize(at + jump_values);
    pack_jump(body.jump, &to[at]);
  }
  for (const PlanarSphere& sphere : body.spheres)
    for (const double value : {sphere.x, sphere.y, static_cast<double>(sphere.tag)})
      to.push_back(value);
}

const double* unpack_body(const double* from, PlanarBody& body) {
  body.tag = static_cast<int>(*from++);
  body.type = static_cast<int>(*from++);
  body.spheres.resize(static_cast<std::size_t>(*from++));
  body.prescribed = *from++ != 0.0;
  body.jumped = *from++ != 0.0;
  for (double* value : {&body.mass, &body.moment, &body.radius, &body.position[0],
                        &body.position[1], &body.cosine, &body.sine})
    *value = *from++;
  std::copy(from, from + 3, body.velocity);
  from += 3;
  if (body.jumped) from = unpack_jump(from, body.jump);
  for (PlanarSphere& sphere : body.spheres) {
    sphere = {from[0], from[1], static_cast<int>(from[2])};
    from += 3;
  }
  return from;
}

}  // namespace rodpack
