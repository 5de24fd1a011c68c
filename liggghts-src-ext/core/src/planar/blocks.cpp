// SPDX-License-Identifier: GPL-2.0-or-later
// Where blocks lie: in the order of the parts of the bodies, so that forces follow the motion.
#include <algorithm>
#include <cstdint>

#include "blocks.h"
#include "halo.h"
#include "scene_data.h"

namespace rodpack {

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
  ordered_ = whole_groups(count);
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

namespace {

// Of the first block that does not touch.
const std::uint64_t apart = std::uint64_t{1} << 63;

/// Touching blocks first, each kind in the order in which their bodies have both moved.
std::uint64_t place_in_order(const PlanarBlockHead& head) {
  const std::uint64_t later = std::max(head.i, head.j);
  const std::uint32_t earlier = std::min(head.i, head.j);
  return (head.alive != 0 ? 0 : apart) | later << 32 | earlier;
}

}  // namespace

void PlanarScene::Data::sort_blocks() {
  longest_sweep = next_longest_sweep;
  next_longest_sweep = steps_in_sweep;
  for (int part = 0; part < parts.count(); ++part) completed_by[part] = part;
  if (halo) halo->hold_back_sent(*this);
  for (PlanarBlockPool* pool : {&pairs, &at_walls}) {
    const AlignedVector<PlanarBlockHead>& heads = pool->heads;
    in_order.clear();
    for (int k = 0; k < pool->size(); ++k)
      if (heads[k].used != 0) in_order.push_back({place_in_order(heads[k]), k});
    std::sort(in_order.begin(), in_order.end());
    const auto others = std::lower_bound(in_order.begin(), in_order.end(), Placed{apart, 0});
    const int touching = static_cast<int>(others - in_order.begin());
    order.assign(whole_groups(touching), -1);
    std::transform(in_order.begin(), others, order.begin(),
                   [](const Placed& b) { return b.second; });
    for (auto block = others; block != in_order.end(); ++block) order.push_back(block->second);
    pool->reorder(order, whole_groups(touching), parts);
    for (int part = 0; part < parts.count(); ++part)
      for (const PlanarRange& range : {pool->touching(part), pool->others(part)})
        for (int k = range.first; k < range.end; ++k)
          if (heads[k].used != 0) completes(heads[k], part);
  }
}

/// The forces on the bodies of a block are not complete before this part.
void PlanarScene::Data::completes(const PlanarBlockHead& head, int part) {
  for (const int body : {head.i, head.j})
    if (body >= 0) completed_by[parts.of(body)] = std::max(completed_by[parts.of(body)], part);
}

}  // namespace rodpack
