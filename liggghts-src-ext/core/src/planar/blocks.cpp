// SPDX-License-Identifier: GPL-2.0-or-later
#include "blocks.h"

#include <algorithm>
#include <bitset>
#include <limits>

namespace rodpack {

PlanarBlockPool::PlanarBlockPool(int bodies, int slots, int hole_j, PlanarExtraRows extra)
    : slots_(slots), extra_(extra), of_body_(bodies) {
  hole_.j = hole_j;
  hole_.gap = std::numeric_limits<float>::infinity();
  resize_blocks(0, 0);
}

void PlanarBlockPool::set_head(int place, const PlanarBlockHead& head) {
  PlanarGroupHeads& group = heads_[place / planar_group];
  const int k = place % planar_group, shift = k * planar_lanes;
  const auto set = [shift](std::uint8_t& of_group, std::uint8_t bits) {
    of_group = static_cast<std::uint8_t>((of_group & ~(all_of_block << shift)) | bits << shift);
  };
  group.i[k] = static_cast<std::uint32_t>(head.i) * planar_stride;
  group.j[k] = head.j < 0 ? head.j : head.j * planar_stride;
  group.gap[k] = head.gap;
  set(group.used, head.used);
  set(group.alive, head.alive);
  set(group.full_history, head.full_history);
  set(group.sliding, head.sliding);
}

void PlanarBlockPool::set_fresh(int place) {
  PlanarGroupHeads& group = heads_[place / planar_group];
  if (group.fresh == 0) fresh_groups_.push_back(place / planar_group);
  group.fresh = static_cast<std::uint8_t>(group.fresh | 1 << place % planar_group);
}

void PlanarBlockPool::settle() {
  for (const int group : fresh_groups_) heads_[group].fresh = 0;
  fresh_groups_.clear();
}

int PlanarBlockPool::add(int part, const PlanarBlockHead& head, int law,
                         const PlanarBlockColdData& cold) {
  const int place = take_hole(part);
  ++filled_;
  set_head(place, head);
  set_fresh(place);
  laws_[place] = law;
  cold_[place] = cold;
  of_body_[head.i].push_back(place);
  if (head.j >= 0) of_body_[head.j].push_back(place);
  return place;
}

void PlanarBlockPool::remove(int place) {
  const PlanarBlockHead of_place = head(place);
  forget(of_place.i, place);
  if (of_place.j >= 0) forget(of_place.j, place);
  make_hole(place);
  --filled_;
}

void PlanarBlockPool::remove_all_of(int body) {
  const std::vector<int> places = of_body_[body];
  for (const int place : places) remove(place);
}

std::size_t PlanarBlockPool::contacts() const {
  std::size_t count = 0;
  for (const PlanarGroupHeads& group : heads_) count += std::bitset<8>(group.alive).count();
  return count;
}

std::pair<int, int> PlanarBlockPool::find(int i, int sphere_i, int j, int sphere_j) const {
  for (const int place : of_body_[i]) {
    const PlanarBlockHead of_place = head(place);
    if (of_place.i != i || of_place.j != j) continue;
    const PlanarBlockColdData& cold = cold_[place];
    for (int lane = 0; lane < planar_lanes; ++lane)
      if ((of_place.used & 1 << lane) && cold.sphere_i[lane] == sphere_i &&
          cold.sphere_j[lane] == sphere_j)
        return {place, lane};
  }
  return {-1, 0};
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

/// Makes room for `blocks` blocks in whole groups, and for the spare group; places from `filled` on
/// become holes.
void PlanarBlockPool::resize_blocks(int filled, int blocks) {
  const int places = whole_groups(blocks) + planar_group;
  heads_.resize(places / planar_group);
  all_values_.resize(static_cast<std::size_t>(places) * rows() * planar_lanes);
  laws_.resize(places);
  cold_.resize(places);
  for (int place = spare(); place < places; ++place) empty(place);
  for (int place = size() - 1; place >= filled; --place) make_hole(place);
}

void PlanarBlockPool::empty(int place) {
  set_head(place, hole_);
  double* const of_place = mutable_values(place);
  std::fill_n(of_place + planar_xi, planar_lanes, 1.0);
  for (int row : {planar_yi, planar_xj, planar_yj}) std::fill_n(of_place + row, planar_lanes, 0.0);
}

void PlanarBlockPool::make_hole(int place) {
  empty(place);
  if (place < sorted_)
    early_holes_.push_back({place, part_of(place)});
  else
    holes_.push_back(place);
}

void PlanarBlockPool::forget(int body, int place) {
  std::vector<int>& list = of_body_[body];
  for (int& entry : list) {
    if (entry != place) continue;
    entry = list.back();
    list.pop_back();
    return;
  }
}

void PlanarBlocks::resize(int bodies) {
  for (PlanarBlockPool* pool : {&pairs_, &at_walls_}) pool->resize(bodies);
}

void PlanarBlocks::take_out(int j, int place, std::vector<PlanarLaneState>& contacts) {
  PlanarBlockPool& pool = of(j);
  for (int lane = 0; lane < planar_lanes; ++lane)
    if (pool.head(place).alive & 1 << lane) {
      contacts.push_back(PlanarLaneState());
      pool.save(place, lane, contacts.back());
    }
  pool.remove(place);
}

void PlanarBlocks::remove_all_of(int body) {
  for (PlanarBlockPool* pool : {&pairs_, &at_walls_}) pool->remove_all_of(body);
}

bool PlanarBlocks::restore(const PlanarLaneState& contact) {
  PlanarBlockPool& pool = of(contact.j);
  const std::pair<int, int> at =
      pool.find(contact.i, contact.sphere_i, contact.j, contact.sphere_j);
  if (at.first < 0) return false;
  pool.restore(at.first, at.second, contact);
  return true;
}

void PlanarBlocks::age(int steps) {
  for (PlanarBlockPool* pool : {&pairs_, &at_walls_}) pool->age(steps);
}

void PlanarBlocks::settle() {
  for (PlanarBlockPool* pool : {&pairs_, &at_walls_}) pool->settle();
}

void PlanarBlocks::look_ahead(int steps) {
  for (PlanarBlockPool* pool : {&pairs_, &at_walls_}) pool->look_ahead(steps);
}

}  // namespace rodpack
