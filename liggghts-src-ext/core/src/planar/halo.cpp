// SPDX-License-Identifier: GPL-2.0-or-later
#include "halo.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rodpack {

namespace {

// Steps to the next question: the fastest point may get this much faster meanwhile; and at most,
// since what rests may be hit.
const double speed_margin = 2.0;
const int most_patience = 32, least_patience = 4;

const int frame_values = 7, change_values = 11, record_values = 7;

int record_length(int spheres) {
  return record_values + frame_values + change_values + 3 * spheres;
}

double* put_frame(const PlanarFrame& frame, double* to) {
  const double values[frame_values] = {frame.x,          frame.y,           frame.cosine,
                                       frame.sine,       frame.velocity[0], frame.velocity[1],
                                       frame.velocity[2]};
  return std::copy(values, values + frame_values, to);
}

const double* get_frame(const double* from, PlanarFrame& frame) {
  frame = {from[0], from[1], from[2], from[3], {from[4], from[5], from[6]}, frame.radius};
  return from + frame_values;
}

double* put_change(const PlanarMotionChange& change, double* to) {
  for (const double(*part)[3] : {&change.acceleration, &change.velocity, &change.displacement})
    to = std::copy(*part, *part + 3, to);
  *to++ = change.cosine;
  *to++ = change.sine;
  return to;
}

const double* get_change(const double* from, PlanarMotionChange& change) {
  for (double(*part)[3] : {&change.acceleration, &change.velocity, &change.displacement}) {
    std::copy(from, from + 3, *part);
    from += 3;
  }
  change.cosine = *from++;
  change.sine = *from++;
  return from;
}

/// Around the centres of a rank's own bodies.
struct Box {
  double low[2], high[2];
  double reach;  // of the longest body; negative: there are no bodies

  bool is_near(const PlanarFrame& frame, double distance) const {
    return reach >= 0.0 && frame.x > low[0] - distance && frame.x < high[0] + distance &&
           frame.y > low[1] - distance && frame.y < high[1] + distance;
  }
};

}  // namespace

PlanarHalo::PlanarHalo(PlanarRanks& ranks, PlanarScene::Data& scene) : ranks_(ranks) {
  for (int b = 0; b < scene.owned; ++b) {
    const PlanarFrame& frame = scene.frames[b];
    begun_.push_back({frame.x, frame.y, frame.cosine, frame.sine});
  }
  ranks_.largest(&scene.longest, 1);
  is_limited_ = std::min(scene.settings.farthest[0], scene.settings.farthest[1]) < 1e300;
  // Ghosts in reserve cost some 80 ns each in every step, those of a bed in a slab a tenth of it.
  way_ = 0.25 * scene.longest + 2.0 * scene.settings.max_skin;
  renew(scene);
}

void PlanarHalo::update(PlanarScene::Data& scene) {
  if (--patience_ <= 0 && ask(scene)) {
    renew(scene);
    return;
  }
  for (std::size_t k = 0; k < links_.size(); ++k) pack(scene, partners_[k], links_[k]);
  ranks_.swap(links_);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    unpack(scene, partners_[k], links_[k]);
    scene.statistics.ghosts += static_cast<long>(partners_[k].received.size());
    scene.statistics.sent += static_cast<long>(links_[k].out_count * sizeof(double));
  }
}

/// The way that the body has gone that has gone farthest since ghosts were chosen.
double PlanarHalo::checked_way(const PlanarScene::Data& scene) const {
  double most = 0.0;
  int farthest = -1;
  for (int b = 0; b < scene.owned; ++b) {
    const double x = scene.frames[b].x - renewed_[b].x, y = scene.frames[b].y - renewed_[b].y;
    if (x * x + y * y <= most) continue;
    most = x * x + y * y;
    farthest = b;
  }
  const double way = std::sqrt(most);
  if (way > way_)
    throw std::runtime_error("planar scene: body " + std::to_string(scene.tags[farthest]) +
                             " went " + std::to_string(way) +
                             " m, faster than its contacts with other ranks could be followed, "
                             "expected at most " +
                             std::to_string(way_) + " m");
  return way;
}

/// Whether ghosts have to be chosen anew, and when to ask again. Collective.
bool PlanarHalo::ask(const PlanarScene::Data& scene) {
  const double way = checked_way(scene);
  double fastest = 0.0, least_room = 1e300;
  for (int b = 0; b < scene.owned; ++b) {
    fastest = std::max(fastest, scene.way_in_step(b));
    if (is_limited_) least_room = std::min(least_room, room(scene, b));
  }
  double values[3] = {way, fastest, -least_room};
  ranks_.largest(values, 3);
  const double way_in_step = speed_margin * values[1];
  const auto patience = [&](double left) {
    if (left <= 0.0) return 0;
    return left < most_patience * way_in_step ? static_cast<int>(left / way_in_step)
                                              : most_patience;
  };
  const int until_far_away = patience(-values[2]);
  far_away_ = until_far_away < least_patience;
  patience_ = std::min(until_far_away, patience(way_ - values[0]));
  if (patience_ >= least_patience || values[0] == 0.0 || far_away_) return false;
  patience_ = std::min(until_far_away, patience(way_));
  return true;
}

/// How much farther a point of the body may go along x and y.
double PlanarHalo::room(const PlanarScene::Data& scene, int body) const {
  const PlanarFrame& frame = scene.frames[body];
  const Place& begun = begun_[body];
  const double c = frame.cosine - begun.cosine, s = frame.sine - begun.sine;
  const double turn = scene.listed[body].reach * std::sqrt(c * c + s * s);
  const double* limit = scene.settings.farthest;
  return std::min(limit[0] - std::fabs(frame.x - begun.x),
                  limit[1] - std::fabs(frame.y - begun.y)) -
         turn;
}

/// Chooses the ghosts anew, and brings all of them to this step.
void PlanarHalo::renew(PlanarScene::Data& scene) {
  renewed_.resize(scene.owned);
  for (int b = 0; b < scene.owned; ++b) {
    const PlanarFrame& frame = scene.frames[b];
    renewed_[b] = {frame.x, frame.y, frame.cosine, frame.sine};
  }
  std::vector<std::vector<int>> chosen;
  const std::vector<std::vector<double>> sent = choose(scene, chosen);
  std::vector<std::vector<double>> records;
  ranks_.exchange(sent, records);
  receive(scene, records);
  std::vector<std::vector<int>> ghosts(ranks_.count());
  for (int rank = 0; rank < ranks_.count(); ++rank)
    for (std::size_t at = 0; at < records[rank].size();) {
      const double* record = &records[rank][at];
      ghosts[rank].push_back(ghost_of_tag_.at(static_cast<int>(record[0])));
      at += record_length(static_cast<int>(record[5]));
    }
  connect(chosen, ghosts);
  hold_back_sent(scene);
}

void PlanarHalo::hold_back_sent(PlanarScene::Data& scene) const {
  for (const Partner& partner : partners_)
    for (int body : partner.sent) scene.completed_by[scene.parts.of(body)] = scene.parts.last();
}

/// The own bodies that each rank needs as ghosts, and their records.
std::vector<std::vector<double>> PlanarHalo::choose(PlanarScene::Data& scene,
                                                    std::vector<std::vector<int>>& chosen) {
  Box own = {{1e300, 1e300}, {-1e300, -1e300}, -1.0};
  for (int b = 0; b < scene.owned; ++b) {
    const double place[2] = {scene.frames[b].x, scene.frames[b].y};
    for (int d = 0; d < 2; ++d) {
      own.low[d] = std::min(own.low[d], place[d]);
      own.high[d] = std::max(own.high[d], place[d]);
    }
    own.reach = std::max(own.reach, scene.listed[b].reach);
  }
  const std::vector<double> boxes =
      ranks_.gather({own.low[0], own.low[1], own.high[0], own.high[1], own.reach});

  chosen.assign(ranks_.count(), std::vector<int>());
  std::vector<std::vector<double>> records(ranks_.count());
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    if (rank == ranks_.rank()) continue;
    const double* values = &boxes[5 * rank];
    const Box box = {{values[0], values[1]}, {values[2], values[3]}, values[4]};
    std::vector<double>& to = records[rank];
    for (int b = 0; b < scene.owned; ++b) {
      const PlanarBodyInfo& info = scene.info[b];
      if (!box.is_near(scene.frames[b], scene.listed[b].reach + box.reach + 2.0 * way_)) continue;
      chosen[rank].push_back(b);
      const std::size_t at = to.size();
      to.resize(at + record_length(info.count));
      const bool jumped = scene.events.jumped(b);
      const double constants[record_values] = {static_cast<double>(scene.tags[b]),
                                               static_cast<double>(info.type),
                                               info.mass,
                                               info.moment,
                                               info.radius,
                                               static_cast<double>(info.count),
                                               jumped ? 1.0 : 0.0};
      double* next = std::copy(constants, constants + record_values, &to[at]);
      next = put_frame(scene.frames[b], next);
      next = put_change(scene.events.motion(b), next);
      for (int k = 0; k < info.count; ++k) {
        const PlanarSphere& sphere = scene.spheres[info.first + k];
        *next++ = sphere.x;
        *next++ = sphere.y;
        *next++ = sphere.tag;
      }
    }
  }
  return records;
}

/// Ghosts that are there already keep their place, and with it their contacts.
void PlanarHalo::receive(PlanarScene::Data& scene,
                         const std::vector<std::vector<double>>& records) {
  struct Record {
    int tag;
    const double* values;
  };
  std::vector<Record> all;
  for (const std::vector<double>& of_rank : records)
    for (std::size_t at = 0; at < of_rank.size();) {
      all.push_back({static_cast<int>(of_rank[at]), &of_rank[at]});
      at += record_length(static_cast<int>(of_rank[at + 5]));
    }

  std::unordered_map<int, int> before;
  before.swap(ghost_of_tag_);
  for (const Record& record : all) {
    const auto known = before.find(record.tag);
    if (known == before.end()) continue;
    ghost_of_tag_.insert(*known);
    before.erase(known);
  }
  // in an order that does not depend on that of the map
  std::vector<int> dropped;
  for (const auto& entry : before) dropped.push_back(entry.second);
  std::sort(dropped.begin(), dropped.end());
  for (int ghost : dropped) drop(scene, ghost);

  int first = 0;
  for (int b = 0; b < scene.owned; ++b) first += scene.info[b].count;
  scene.spheres.resize(first);
  for (const Record& record : all) {
    const bool is_new = ghost_of_tag_.find(record.tag) == ghost_of_tag_.end();
    if (is_new) ghost_of_tag_[record.tag] = place_for_ghost(scene);
    const int ghost = ghost_of_tag_[record.tag];
    const double* const values = record.values;
    PlanarFrame& frame = scene.frames[ghost];
    const double* next = get_frame(values + record_values, frame);
    PlanarMotionChange change;
    next = get_change(next, change);
    if (values[6] != 0.0) scene.events.set_jumped(ghost, change);

    PlanarBodyInfo& info = scene.info[ghost];
    info.first = static_cast<int>(scene.spheres.size());
    info.count = static_cast<int>(values[5]);
    for (int k = 0; k < info.count; ++k, next += 3)
      scene.spheres.push_back({next[0], next[1], static_cast<int>(next[2])});
    if (!is_new) {
      list_if_moved(scene, ghost);
      continue;
    }
    scene.tags[ghost] = record.tag;
    info.type = static_cast<int>(values[1]);
    info.mass = values[2];
    info.moment = values[3];
    info.radius = frame.radius = values[4];
    scene.set_reach(ghost);
    scene.mark_listed(ghost);
    if (!scene.lists_exist) continue;
    scene.grid.add(ghost, frame.x, frame.y);
    scene.to_list.push_back(ghost);
  }
}

void PlanarHalo::drop(PlanarScene::Data& scene, int ghost) {
  scene.pairs.remove_all_of(ghost);
  if (scene.lists_exist) scene.grid.remove(ghost);
  scene.info[ghost].count = 0;
  unused_.push_back(ghost);
}

int PlanarHalo::place_for_ghost(PlanarScene::Data& scene) {
  if (!unused_.empty()) {
    const int place = unused_.back();
    unused_.pop_back();
    return place;
  }
  const int place = static_cast<int>(scene.info.size());
  scene.resize(place + 1);
  return place;
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
    // a frame for each, how many have jumped, and their changes
    const auto most = [](std::size_t bodies) {
      return bodies == 0 ? 0 : bodies * (frame_values + 1 + change_values) + 1;
    };
    link.out.resize(most(partner.sent.size()));
    link.in.resize(most(partner.received.size()));
  }
  links_.resize(links);
  partners_.resize(links);
}

void PlanarHalo::pack(const PlanarScene::Data& scene, const Partner& partner,
                      PlanarLink& link) const {
  link.out_count = 0;
  if (partner.sent.empty()) return;
  double* next = link.out.data();
  for (int body : partner.sent) next = put_frame(scene.frames[body], next);
  double& jumps = *next++;
  jumps = 0.0;
  for (std::size_t k = 0; k < partner.sent.size(); ++k) {
    const int body = partner.sent[k];
    if (!scene.events.jumped(body)) continue;
    jumps += 1.0;
    *next++ = static_cast<double>(k);
    next = put_change(scene.events.motion(body), next);
  }
  link.out_count = static_cast<int>(next - link.out.data());
}

void PlanarHalo::unpack(PlanarScene::Data& scene, const Partner& partner,
                        const PlanarLink& link) const {
  if (partner.received.empty()) return;
  const double* next = link.in.data();
  for (int ghost : partner.received) {
    next = get_frame(next, scene.frames[ghost]);
    list_if_moved(scene, ghost);
  }
  for (int jumps = static_cast<int>(*next++); jumps > 0; --jumps) {
    const int ghost = partner.received[static_cast<int>(*next++)];
    PlanarMotionChange change;
    next = get_change(next, change);
    scene.events.set_jumped(ghost, change);
  }
}

/// As the kernel does with own bodies that have moved; forces on ghosts are of no use.
void PlanarHalo::list_if_moved(PlanarScene::Data& scene, int ghost) const {
  scene.loads[ghost] = PlanarVector();
  const PlanarFrame& frame = scene.frames[ghost];
  const PlanarListed& at = scene.listed[ghost];
  const double rx = frame.x - at.x, ry = frame.y - at.y;
  const double tc = frame.cosine - at.cosine, ts = frame.sine - at.sine;
  double& moved = scene.moved[ghost];
  moved = std::sqrt(2.0 * (rx * rx + ry * ry + at.reach * at.reach * (tc * tc + ts * ts)));
  if (scene.lists_exist && moved > before_its_skin * at.skin) scene.to_list.push_back(ghost);
}

}  // namespace rodpack
