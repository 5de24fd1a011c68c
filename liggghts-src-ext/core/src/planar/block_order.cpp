// SPDX-License-Identifier: GPL-2.0-or-later
// Where blocks lie: in the order of the parts of the bodies, so that forces follow the motion.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "blocks.h"
#include "pipeline.h"

namespace rodpack {

/// Puts touching blocks first, each kind in the order in which their bodies have both moved: by
/// counting those of each body that is the later one, of which few share the same.
void PlanarBlockPool::sort(const PlanarParts& parts) {
  const int bodies = static_cast<int>(of_body_.size());
  const auto kind_and_later = [bodies](const PlanarBlockHead& head) {
    return (head.alive != 0 ? 0 : bodies) + std::max(head.i, head.j);
  };
  std::vector<SortedBlock>& blocks = work_.blocks;
  std::vector<int>& ends = work_.ends;  // of each kind and later body
  ends.assign(2 * bodies + 1, 0);
  for (int k = 0; k < size(); ++k) {
    const PlanarBlockHead of_block = head(k);
    if (of_block.used != 0) ++ends[kind_and_later(of_block) + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  blocks.resize(ends.back());
  for (int k = 0; k < size(); ++k) {
    const PlanarBlockHead of_block = head(k);
    if (of_block.used == 0) continue;
    const std::uint32_t earlier = std::min(of_block.i, of_block.j);
    blocks[ends[kind_and_later(of_block)]++] = {earlier, k};
  }
  int begin = 0;
  for (const int end : ends) {
    std::sort(blocks.begin() + begin, blocks.begin() + end);
    begin = end;
  }
  const auto others = blocks.begin() + (bodies > 0 ? ends[bodies - 1] : 0);
  const int touching = whole_groups(static_cast<int>(others - blocks.begin()));
  std::vector<int>& order = work_.order;  // the present place of the k-th block, -1 for a hole
  order.assign(touching, -1);
  const auto place_of = [](const SortedBlock& block) { return block.second; };
  std::transform(blocks.begin(), others, order.begin(), place_of);
  std::transform(others, blocks.end(), std::back_inserter(order), place_of);
  reorder(order);
  find_ends(parts, 0, touching, ends_of_touching_);
  find_ends(parts, touching, sorted_, ends_of_others_);
  for (EarlyHole& hole : early_holes_) hole.part = part_of(hole.place);
}

void PlanarBlockPool::reorder(const std::vector<int>& order) {
  settle();
  heads_.swap(work_.heads);
  laws_.swap(work_.laws);
  all_values_.swap(work_.values);
  cold_.swap(work_.cold);
  for (std::vector<int>& list : of_body_) list.clear();
  early_holes_.clear();
  holes_.clear();
  filled_ = 0;
  const int count = static_cast<int>(order.size());
  sorted_ = whole_groups(count);
  resize_blocks(count, count);
  for (int k = 0; k < count; ++k) {
    if (order[k] < 0) {
      make_hole(k);
      continue;
    }
    ++filled_;
    const PlanarBlockHead of_block = head_in(work_.heads, order[k]);
    set_head(k, of_block);
    laws_[k] = work_.laws[order[k]];
    cold_[k] = work_.cold[order[k]];
    const double* const from = &work_.values[first_value(order[k])];
    double* const to = mutable_values(k);
    for (int row = 0; row < rows(); ++row)
      std::copy_n(from + row * planar_row, planar_lanes, to + row * planar_row);
    of_body_[of_block.i].push_back(k);
    if (of_block.j >= 0) of_body_[of_block.j].push_back(k);
  }
}

/// Where the blocks of each part end among those from `first` up to `end`. Holes name the first
/// body, so that none is in a part before the blocks around it.
void PlanarBlockPool::find_ends(const PlanarParts& parts, int first, int end,
                                std::vector<int>& ends) const {
  ends.clear();
  const auto part_of_bodies = [&](int place) {
    const PlanarBlockHead of_block = head(place);
    return parts.of_pair(of_block.i, of_block.j);
  };
  for (int part = 0; part < parts.last(); ++part) {
    while (first < end && part_of_bodies(first) <= part) ++first;
    ends.push_back(first - first % planar_group);
  }
  ends.push_back(end);
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
  if (place >= sorted_ || last < 0) return std::max(last, 0);
  const std::vector<int>& ends =
      place < ends_of_touching_[last] ? ends_of_touching_ : ends_of_others_;
  return static_cast<int>(std::upper_bound(ends.begin(), ends.end(), place) - ends.begin());
}

void PlanarBlocks::sort(const PlanarParts& parts, PlanarDependencies& dependencies) {
  for (PlanarBlockPool* pool : {&pairs_, &at_walls_}) {
    pool->sort(parts);
    for (int place = 0; place < pool->size(); ++place) {
      const PlanarBlockHead head = pool->head(place);
      if (head.used != 0) dependencies.add_contact(head.i, head.j, pool->part_of(place));
    }
  }
}

}  // namespace rodpack
