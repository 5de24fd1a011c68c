// SPDX-License-Identifier: GPL-2.0-or-later
#include "halo.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "../planar/bodies.h"
#include "../planar/events.h"
#include "ghosts.h"
#include "halo_messages.h"
#include "../planar/pipeline.h"

namespace rodpack {

namespace {

// The fastest point of all bodies may become so many times faster before ghosts are asked for
// again.
const double speed_margin = 2.0;
// They are asked for after at most so many steps, since what rests may be hit; and chosen anew if
// they would have to be asked for sooner than after the least.
const int most_patience = 32, least_patience = 4;

/// The number of steps in which a body goes `distance`, m.
int patience_of(double distance, double in_a_step) {
  if (distance <= 0.0) return 0;
  return distance < most_patience * in_a_step ? static_cast<int>(distance / in_a_step)
                                              : most_patience;
}

/// The box around the centres of a rank's own bodies.
struct Box {
  double low[2], high[2];
  double reach;  // of the longest body, m; negative: there are no bodies

  bool is_near(const PlanarKinematics& kinematics, double distance) const {
    return reach >= 0.0 && kinematics.x > low[0] - distance && kinematics.x < high[0] + distance &&
           kinematics.y > low[1] - distance && kinematics.y < high[1] + distance;
  }
};

Box box_around(const PlanarBodyStates& bodies) {
  Box box = {{1e300, 1e300}, {-1e300, -1e300}, -1.0};
  for (int b = 0; b < bodies.owned(); ++b) {
    const double position[2] = {bodies.kinematics(b).x, bodies.kinematics(b).y};
    for (int d = 0; d < 2; ++d) {
      box.low[d] = std::min(box.low[d], position[d]);
      box.high[d] = std::max(box.high[d], position[d]);
    }
    box.reach = std::max(box.reach, bodies.info(b).reach);
  }
  return box;
}

}  // namespace

PlanarHalo::PlanarHalo(PlanarRanks& ranks, const PlanarSettings& settings, double longest_reach,
                       const PlanarBodyStates& bodies, PlanarEvents& events, PlanarGhosts& ghosts)
    : ranks_(ranks),
      settings_(settings),
      bodies_(bodies),
      events_(events),
      ghosts_(ghosts),
      // Ghosts in reserve cost some 80 ns each in every step, those of a bed in a slab a tenth of
      // it.
      reserve_(0.25 * longest_reach + 2.0 * settings.max_skin),
      is_limited_(std::min(settings.farthest[0], settings.farthest[1]) < 1e300),
      begun_(own_poses()) {}

bool PlanarHalo::update(std::vector<int>& to_list) {
  if (--patience_ <= 0 && ask()) {
    renew(to_list);
    return true;
  }
  for (std::size_t k = 0; k < links_.size(); ++k) pack(partners_[k], links_[k]);
  ranks_.swap(links_);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    unpack(partners_[k], links_[k], to_list);
    ghosts_brought_ += static_cast<long>(partners_[k].received.size());
    bytes_sent_ += static_cast<long>(links_[k].out_count * sizeof(double));
  }
  return false;
}

std::vector<PlanarHalo::Pose> PlanarHalo::own_poses() const {
  std::vector<Pose> poses;
  for (int b = 0; b < bodies_.owned(); ++b) {
    const PlanarKinematics& kinematics = bodies_.kinematics(b);
    poses.push_back({kinematics.x, kinematics.y, kinematics.cosine, kinematics.sine});
  }
  return poses;
}

/// How far the body has gone that has gone farthest since ghosts were chosen, m.
double PlanarHalo::checked_distance() const {
  double most = 0.0;
  int farthest = -1;
  for (int b = 0; b < bodies_.owned(); ++b) {
    const double x = bodies_.kinematics(b).x - chosen_at_[b].x,
                 y = bodies_.kinematics(b).y - chosen_at_[b].y;
    if (x * x + y * y <= most) continue;
    most = x * x + y * y;
    farthest = b;
  }
  const double distance = std::sqrt(most);
  if (distance > reserve_)
    throw std::runtime_error("planar scene: body " + std::to_string(bodies_.tag(farthest)) +
                             " went " + std::to_string(distance) +
                             " m, faster than its contacts with other ranks could be followed, "
                             "expected at most " +
                             std::to_string(reserve_) + " m");
  return distance;
}

/// Whether ghosts have to be chosen anew; sets when to ask again. Collective.
bool PlanarHalo::ask() {
  double values[3] = {checked_distance(), 0.0, -1e300};  // the last one: -distance_left()
  for (int b = 0; b < bodies_.owned(); ++b) {
    values[1] = std::max(values[1], bodies_.step_displacement(b));
    if (is_limited_) values[2] = std::max(values[2], -distance_left(b));
  }
  ranks_.largest(values, 3);
  const double gone = values[0], in_a_step = speed_margin * values[1];
  const int until_far_away = patience_of(-values[2], in_a_step);
  far_away_ = until_far_away < least_patience;
  patience_ = std::min(until_far_away, patience_of(reserve_ - gone, in_a_step));
  if (patience_ >= least_patience || gone == 0.0 || far_away_) return false;
  patience_ = std::min(until_far_away, patience_of(reserve_, in_a_step));
  return true;
}

/// How much farther any point of the body may go along x and y, m.
double PlanarHalo::distance_left(int body) const {
  const PlanarKinematics& kinematics = bodies_.kinematics(body);
  const Pose& begun = begun_[body];
  const double c = kinematics.cosine - begun.cosine, s = kinematics.sine - begun.sine;
  const double turn = bodies_.info(body).reach * std::sqrt(c * c + s * s);
  const double* limit = settings_.farthest;
  return std::min(limit[0] - std::fabs(kinematics.x - begun.x),
                  limit[1] - std::fabs(kinematics.y - begun.y)) -
         turn;
}

void PlanarHalo::renew(std::vector<int>& to_list) {
  chosen_at_ = own_poses();
  std::vector<std::vector<int>> chosen;
  const std::vector<std::vector<double>> sent = choose(chosen);
  std::vector<std::vector<double>> messages;
  ranks_.exchange(sent, messages);
  connect(chosen, receive(messages, to_list));
}

void PlanarHalo::hold_back_sent(PlanarDependencies& dependencies) const {
  for (const Partner& partner : partners_)
    for (int body : partner.sent) dependencies.hold_back(body);
}

/// Chooses the own bodies that each rank needs as ghosts; returns the messages about them.
std::vector<std::vector<double>> PlanarHalo::choose(std::vector<std::vector<int>>& chosen) const {
  const Box own = box_around(bodies_);
  const std::vector<double> boxes =
      ranks_.gather({own.low[0], own.low[1], own.high[0], own.high[1], own.reach});
  chosen.assign(ranks_.count(), std::vector<int>());
  std::vector<std::vector<double>> messages(ranks_.count());
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    if (rank == ranks_.rank()) continue;
    const double* values = &boxes[5 * rank];
    const Box box = {{values[0], values[1]}, {values[2], values[3]}, values[4]};
    for (int b = 0; b < bodies_.owned(); ++b) {
      const double reach = bodies_.info(b).reach;
      if (!box.is_near(bodies_.kinematics(b), reach + box.reach + 2.0 * reserve_)) continue;
      chosen[rank].push_back(b);
      PlanarBody body = bodies_.present(b);
      body.jumped = events_.jumped(b);
      if (body.jumped) body.jump = events_.jump(b);
      append_body(body, messages[rank]);
    }
  }
  return messages;
}

/// Makes the bodies of these messages the ghosts; returns those of each rank.
std::vector<std::vector<int>> PlanarHalo::receive(const std::vector<std::vector<double>>& messages,
                                                  std::vector<int>& to_list) {
  std::vector<PlanarBody> bodies;
  std::vector<std::size_t> ends;  // of the bodies of each rank
  for (const std::vector<double>& message : messages) {
    for (const double* next = message.data(); next != message.data() + message.size();) {
      bodies.emplace_back();
      next = unpack_body(next, bodies.back());
    }
    ends.push_back(bodies.size());
  }
  ghosts_.choose(bodies, to_list);
  std::vector<std::vector<int>> ghosts(ranks_.count());
  std::size_t k = 0;
  for (int rank = 0; rank < ranks_.count(); ++rank)
    for (; k < ends[rank]; ++k) ghosts[rank].push_back(ghosts_.of_tag(bodies[k].tag));
  return ghosts;
}

void PlanarHalo::connect(const std::vector<std::vector<int>>& chosen,
                         const std::vector<std::vector<int>>& ghosts) {
  std::size_t links = 0;
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    if (chosen[rank].empty() && ghosts[rank].empty()) continue;
    if (links == links_.size()) {
      links_.push_back(PlanarLink());
      partners_.push_back(Partner());
    }
    PlanarLink& link = links_[links];
    Partner& partner = partners_[links];
    ++links;
    link.rank = rank;
    partner.sent = chosen[rank];
    partner.received = ghosts[rank];
    link.out.resize(most_step_values(partner.sent.size()));
    link.in.resize(most_step_values(partner.received.size()));
  }
  links_.resize(links);
  partners_.resize(links);
}

void PlanarHalo::pack(const Partner& partner, PlanarLink& link) const {
  link.out_count = 0;
  if (partner.sent.empty()) return;
  double* next = link.out.data();
  for (int body : partner.sent) next = pack_kinematics(bodies_.kinematics(body), next);
  double& jumps = *next++;
  jumps = 0.0;
  for (std::size_t k = 0; k < partner.sent.size(); ++k) {
    const int body = partner.sent[k];
    if (!events_.jumped(body)) continue;
    jumps += 1.0;
    *next++ = static_cast<double>(k);
    next = pack_jump(events_.jump(body), next);
  }
  link.out_count = static_cast<int>(next - link.out.data());
}

void PlanarHalo::unpack(const Partner& partner, const PlanarLink& link, std::vector<int>& to_list) {
  if (partner.received.empty()) return;
  const double* next = link.in.data();
  PlanarKinematics kinematics = PlanarKinematics();
  for (int ghost : partner.received) {
    next = unpack_kinematics(next, kinematics);
    ghosts_.move(ghost, kinematics, to_list);
  }
  for (int jumps = static_cast<int>(*next++); jumps > 0; --jumps) {
    const int ghost = partner.received[static_cast<int>(*next++)];
    PlanarJump jump;
    next = unpack_jump(next, jump);
    events_.set_jumped(ghost, jump);
  }
}

}  // namespace rodpack
