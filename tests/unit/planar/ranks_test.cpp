// SPDX-License-Identifier: GPL-2.0-or-later
// The planar engine on several ranks, which are threads here.
#include "rodpack/planar/ranks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "heap.h"

namespace rodpack {
namespace {

/// What the threads share.
class Post {
 public:
  explicit Post(int ranks) : letters(ranks, std::vector<std::vector<double>>(ranks)) {}

  void wait_for_all() {
    std::unique_lock<std::mutex> lock(mutex_);
    const long round = round_;
    if (++waiting_ == static_cast<int>(letters.size())) {
      waiting_ = 0;
      ++round_;
      all_here_.notify_all();
    } else {
      all_here_.wait(lock, [&] { return round_ != round; });
    }
  }

  std::vector<std::vector<std::vector<double>>> letters;  // [from][to]

 private:
  std::mutex mutex_;
  std::condition_variable all_here_;
  int waiting_ = 0;
  long round_ = 0;
};

class ThreadRanks : public PlanarRanks {
 public:
  ThreadRanks(Post& post, int rank) : post_(post), rank_(rank) {}

  int rank() const override { return rank_; }
  int count() const override { return static_cast<int>(post_.letters.size()); }

  std::vector<double> gather(const std::vector<double>& own) override {
    std::vector<std::vector<double>> from;
    exchange(std::vector<std::vector<double>>(count(), own), from);
    std::vector<double> all;
    for (const auto& part : from) all.insert(all.end(), part.begin(), part.end());
    return all;
  }

  void largest(double* values, int size) override {
    const auto all = gather(std::vector<double>(values, values + size));
    for (std::size_t k = 0; k < all.size(); ++k)
      values[k % size] = std::max(values[k % size], all[k]);
  }

  void exchange(const std::vector<std::vector<double>>& to,
                std::vector<std::vector<double>>& from) override {
    post_.letters[rank_] = to;
    post_.wait_for_all();
    from.resize(count());
    for (int rank = 0; rank < count(); ++rank) from[rank] = post_.letters[rank][rank_];
    post_.wait_for_all();
  }

  void swap(std::vector<PlanarLink>& links) override {
    for (const PlanarLink& link : links) {
      std::vector<double>& letter = post_.letters[rank_][link.rank];
      letter.assign(link.out.begin(), link.out.begin() + link.out_count);
      sent_.push_back(letter);
    }
    post_.wait_for_all();
    for (PlanarLink& link : links) {
      const std::vector<double>& letter = post_.letters[link.rank][rank_];
      if (link.in.empty()) continue;
      if (letter.empty() || letter.size() > link.in.size()) std::abort();  // as MPI would
      std::copy(letter.begin(), letter.end(), link.in.begin());
    }
    post_.wait_for_all();
    for (const PlanarLink& link : links) post_.letters[rank_][link.rank].clear();
  }

  /// The messages of swap() to all ranks, in their order.
  const std::vector<std::vector<double>>& sent() const { return sent_; }

 private:
  Post& post_;
  int rank_;
  std::vector<std::vector<double>> sent_;
};

/// One scene on several ranks. Bodies are given by their place in the whole.
class SceneOnRanks {
 public:
  using Rank = std::function<int(const PlanarBody&)>;  // of a body

  SceneOnRanks(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies, int ranks,
               const Rank& rank_of)
      : post_(ranks), scenes_(ranks), tags_(ranks), total_(bodies.size()) {
    for (int rank = 0; rank < ranks; ++rank) ranks_.emplace_back(new ThreadRanks(post_, rank));
    std::vector<std::vector<PlanarBody>> own(ranks);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      PlanarBody body = bodies[k];
      body.tag = static_cast<int>(k);
      for (std::size_t s = 0; s < body.spheres.size(); ++s)
        body.spheres[s].tag = static_cast<int>(100 * k + s);
      const int rank = rank_of(body);
      own[rank].push_back(body);
      tags_[rank].push_back(body.tag);
    }
    on_each([&](int rank) {
      scenes_[rank].reset(new PlanarScene(settings, own[rank], ranks_[rank].get()));
    });
  }

  void evaluate() {
    on_each([&](int rank) { scenes_[rank]->evaluate(); });
  }

  long run(long steps) {
    std::vector<long> made(scenes_.size());
    on_each([&](int rank) { made[rank] = scenes_[rank]->run(steps); });
    for (const long other : made) EXPECT_EQ(other, made[0]);
    return made[0];
  }

  /// What a rank has sent in its steps.
  const std::vector<std::vector<double>>& sent(int rank) const { return ranks_[rank]->sent(); }

  /// Bodies and ghosts on all ranks.
  int known() const {
    int count = 0;
    for (const auto& scene : scenes_)
      for (int body = 0; body < scene->size_with_ghosts(); ++body)
        count += scene->spheres(body) > 0;
    return count;
  }

  std::vector<PlanarBody> bodies() const {
    std::vector<PlanarBody> all(total_);
    for (std::size_t rank = 0; rank < scenes_.size(); ++rank)
      for (std::size_t k = 0; k < tags_[rank].size(); ++k)
        all[tags_[rank][k]] = scenes_[rank]->body(static_cast<int>(k));
    return all;
  }

  /// By the tags of the spheres; of each rank that has it.
  using Contacts = std::map<std::pair<int, int>, std::vector<PlanarContactState>>;
  Contacts contacts() const {
    Contacts all;
    for (const auto& scene : scenes_)
      for (const PlanarContactState& contact : scene->contacts()) {
        const int i = scene->sphere_tag(contact.body_i, contact.sphere_i);
        const int j = contact.body_j < 0 ? contact.body_j
                                         : scene->sphere_tag(contact.body_j, contact.sphere_j);
        all[{i, j}].push_back(contact);
      }
    return all;
  }

  void set_contacts(const Contacts& contacts) {
    on_each([&](int rank) {
      PlanarScene& scene = *scenes_[rank];
      std::map<int, std::pair<int, int>> places;
      for (int body = 0; body < scene.size_with_ghosts(); ++body)
        for (int s = 0; s < scene.spheres(body); ++s) places[scene.sphere_tag(body, s)] = {body, s};
      std::vector<PlanarContactState> own;
      for (const auto& entry : contacts) {
        PlanarContactState contact = entry.second[0];
        const auto i = places.find(entry.first.first), j = places.find(entry.first.second);
        const bool wall = entry.first.second < 0;
        const bool is_own = (i != places.end() && i->second.first < scene.size()) ||
                            (!wall && j != places.end() && j->second.first < scene.size());
        if (!is_own) continue;
        std::tie(contact.body_i, contact.sphere_i) = i->second;
        if (!wall) std::tie(contact.body_j, contact.sphere_j) = j->second;
        own.push_back(contact);
      }
      scene.set_contacts(own);
    });
  }

 private:
  void on_each(const std::function<void(int)>& act) {
    std::vector<std::thread> threads;
    std::vector<std::exception_ptr> thrown(scenes_.size());
    for (std::size_t rank = 0; rank < scenes_.size(); ++rank)
      threads.emplace_back([&, rank] {
        try {
          act(static_cast<int>(rank));
        } catch (...) {
          thrown[rank] = std::current_exception();
        }
      });
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& exception : thrown)
      if (exception) std::rethrow_exception(exception);
  }

  Post post_;
  std::vector<std::unique_ptr<ThreadRanks>> ranks_;
  std::vector<std::unique_ptr<PlanarScene>> scenes_;
  std::vector<std::vector<int>> tags_;
  std::size_t total_;
};

std::vector<double> state_of(const std::vector<PlanarBody>& bodies) {
  return state_of(PlanarScene(settings_of(), bodies));
}

/// Slabs along an axis, each `width` wide, the last one without end.
SceneOnRanks::Rank slabs(int axis, double width, int ranks) {
  return [=](const PlanarBody& body) {
    return std::min(ranks - 1, std::max(0, static_cast<int>(body.position[axis] / width)));
  };
}

}  // namespace

// What may differ is the order of sums over the contacts of a body.
TEST(PlanarRanks, MotionIsThatOfOneScene) {
  for (const bool events : {true, false})
    for (const int ranks : {2, 3, 4}) {
      PlanarSettings settings = box(5);
      settings.events = events;
      PlanarScene whole(settings, heap(15, 5));
      whole.evaluate();
      whole.run(5000);
      SceneOnRanks split(settings, heap(15, 5), ranks, slabs(0, 0.0525 / ranks, ranks));
      split.evaluate();
      EXPECT_EQ(split.run(5000), 5000);
      EXPECT_LT(difference(state_of(whole), state_of(split.bodies())), 1e-12) << ranks;
      EXPECT_GT(whole.statistics().general, 100);
      EXPECT_EQ(split.contacts().size(), whole.contacts().size());
    }
}

// In a pass some bodies of a rank are ahead of others, but not of those that it knows of others.
TEST(PlanarRanks, StepsAtOnceAreThoseOfOneScene) {
  PlanarSettings settings = box(5);
  settings.walls.pop_back();
  const std::vector<PlanarBody> bodies = row_of_heaps(90, settings);
  PlanarScene whole(settings, bodies);
  whole.evaluate();
  whole.run(500);
  SceneOnRanks split(settings, bodies, 3, slabs(0, 30 * 3.4 * 5 * diameter, 3));
  split.evaluate();
  EXPECT_EQ(split.run(500), 500);
  EXPECT_LT(difference(state_of(whole), state_of(split.bodies())), 1e-12);
  EXPECT_GT(whole.statistics().general, 1000);
}

// In a pass, a part of the bodies may be steps ahead of the last one, with which messages go out;
// so that one whose bodies are sent must wait for it. Discs in a row, 300 on each rank and so in
// two parts, touch nobody. Those at the border are 6.5 mm apart, far from being candidates for a
// contact (3 mm and two skins), so that nothing but the messages holds their parts back, and near
// enough to be ghosts (3 mm and 4.75 mm): from the first step on, or, where they fly at each other
// from 9 mm apart, since ghosts were chosen anew after 46 steps. Blocks are sorted before the first
// step, and before step 129.
TEST(PlanarRanks, SendsBodiesAtTheStepOfTheMessage) {
  struct Row {
    double border, speed;
    int steps;
  };
  for (const Row& row : {Row{6.5e-3, 1.0, 160}, Row{9e-3, 4.0, 64}}) {
    const int on_a_rank = 300;
    std::vector<PlanarBody> discs;
    for (int k = 0; k < 2 * on_a_rank; ++k) {
      const bool left = k < on_a_rank;
      const double x = 6e-3 * (k - on_a_rank) + (left ? 6e-3 - row.border : 0.0);
      discs.push_back(moving(rod(1, x, 0, 0), row.border > 8e-3 && !left ? -1.0 : row.speed, 0));
    }
    const auto left_or_right = [&](const PlanarBody& body) { return body.tag / on_a_rank; };
    SceneOnRanks at_once(settings_of(), discs, 2, left_or_right);
    SceneOnRanks one_by_one(settings_of(), discs, 2, left_or_right);
    for (SceneOnRanks* scene : {&at_once, &one_by_one}) scene->evaluate();
    at_once.run(row.steps);
    for (int k = 0; k < row.steps; ++k) one_by_one.run(1);
    for (const int rank : {0, 1}) {
      EXPECT_GT(at_once.sent(rank).size(), 10u);
      EXPECT_EQ(at_once.sent(rank), one_by_one.sent(rank)) << row.border << ", rank " << rank;
    }
    EXPECT_EQ(at_once.known(), 2 * on_a_rank + 2) << "a ghost on each rank";
    EXPECT_TRUE(at_once.contacts().empty());
  }
}

// Two ranks evaluate a contact between their bodies, and have to agree for good.
TEST(PlanarRanks, ContactOfTwoRanksHasTheSameHistoryOnBothToTheLastBit) {
  SceneOnRanks split(box(5), heap(15, 5), 3, slabs(0, 0.0175, 3));
  split.evaluate();
  int shared = 0;
  for (int part = 0; part < 30; ++part) {
    split.run(1000);
    for (const auto& entry : split.contacts()) {
      if (entry.second.size() == 1) continue;
      ASSERT_EQ(entry.second.size(), 2u);
      const PlanarHistory &a = entry.second[0].history, &b = entry.second[1].history;
      ++shared;
      EXPECT_EQ(a.spring, b.spring);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(a.velocity[k], b.velocity[k]);
      EXPECT_EQ(a.known, b.known);
      EXPECT_EQ(a.sliding, b.sliding);
      EXPECT_EQ(a.since, b.since);
      EXPECT_EQ(a.viscoelastic, b.viscoelastic);
      EXPECT_EQ(a.touch_rate, b.touch_rate);
      EXPECT_EQ(entry.second[0].normal[0], entry.second[1].normal[0]);
    }
  }
  EXPECT_GT(shared, 10);
}

// Two clouds of rods far apart fly against each other, or side by side and on: nobody is a ghost at
// first, many are in the middle, and none at the end.
TEST(PlanarRanks, GhostsComeAndGo) {
  for (const double aside : {0.0, 0.07}) {
    std::vector<PlanarBody> clouds;
    for (int cloud = 0; cloud < 2; ++cloud)
      for (PlanarBody body : heap(12, 5)) {
        body.position[0] += 0.3 * cloud;
        body.position[1] += aside * cloud;
        body.velocity[0] += cloud == 0 ? 2.0 : -2.0;
        body.velocity[1] = 0;
        clouds.push_back(body);
      }
    const PlanarSettings settings = settings_of();
    PlanarScene whole(settings, clouds);
    whole.evaluate();
    SceneOnRanks split(settings, clouds, 2, slabs(0, 0.15, 2));
    split.evaluate();
    const auto ghosts = [&] { return split.known() - static_cast<int>(clouds.size()); };
    EXPECT_EQ(ghosts(), 0);
    int most = 0;
    for (int part = 0; part < 16; ++part) {
      whole.run(500);
      split.run(500);
      most = std::max(most, ghosts());
    }
    EXPECT_GT(most, 4);
    EXPECT_LT(difference(state_of(whole), state_of(split.bodies())), 1e-11);
    if (aside == 0.0) {
      EXPECT_GT(whole.statistics().general, 100);
      continue;
    }
    split.run(8000);
    EXPECT_EQ(ghosts(), 0);
  }
}

// Events across the border: both bodies are corrected, and both told of the other's jump.
TEST(PlanarRanks, CollisionAcrossTheBorderIsThatOfOneScene) {
  for (const int order : {2, 3, 4}) {
    PlanarSettings settings = settings_of();
    settings.order = order;
    const std::vector<PlanarBody> pair = {moving(rod(5, -4e-3, 0, 1.3), 0.4, 0.03, 15),
                                          moving(rod(5, 4e-3, 2e-3, 0.9), -0.4, 0.01, -20)};
    PlanarScene whole(settings, pair);
    whole.evaluate();
    whole.run(3000);
    EXPECT_GT(whole.statistics().general, 10);
    SceneOnRanks split(settings, pair, 2,
                       [](const PlanarBody& body) { return body.position[0] > 0.0 ? 1 : 0; });
    split.evaluate();
    split.run(3000);
    EXPECT_LT(difference(state_of(whole), state_of(split.bodies())), 1e-14) << order;
  }
}

// A rod of AR = 15 flies between short ones that another rank has, and hits one in the middle:
// cells for the short ones alone would be too small for it.
TEST(PlanarRanks, AGhostMayBeLongerThanAllBodiesOfARank) {
  std::vector<PlanarBody> bodies = {moving(rod(15, -0.1, 0.03, 0), 2.0, 0),
                                    rod(2, 0.06, 0.0305, 1)};
  for (const double y : {0.0, 0.018, 0.042, 0.06})
    for (double x = 0; x < 0.1; x += 0.012) bodies.push_back(rod(2, x, y, 0.5));
  PlanarScene whole(settings_of(), bodies);
  whole.evaluate();
  whole.run(8000);
  EXPECT_GT(std::fabs(whole.body(1).velocity[0]), 0.1);
  SceneOnRanks split(settings_of(), bodies, 2,
                     [](const PlanarBody& body) { return body.tag == 0 ? 0 : 1; });
  split.evaluate();
  split.run(8000);
  EXPECT_LT(difference(state_of(whole), state_of(split.bodies())), 1e-11);
}

TEST(PlanarRanks, MomentumOfAClosedSceneIsConservedToRounding) {
  PlanarSettings settings = settings_of();
  std::vector<PlanarBody> bodies = heap(12, 5);
  double before[2] = {}, after[2] = {}, scale = 0;
  for (PlanarBody& body : bodies) {  // all of them towards the middle
    body.velocity[0] = 8 * (0.025 - body.position[0]);
    body.velocity[1] = 8 * (0.04 - body.position[1]);
    for (int d = 0; d < 2; ++d) {
      before[d] += body.mass * body.velocity[d];
      scale += body.mass * std::fabs(body.velocity[d]);
    }
  }
  SceneOnRanks split(settings, bodies, 3, slabs(1, 0.025, 3));
  split.evaluate();
  split.run(20000);
  for (const PlanarBody& body : split.bodies())
    for (int d = 0; d < 2; ++d)
      after[d] += body.mass * (body.velocity[d] + body.missed_velocity[d]);
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(after[d], before[d], 1e-12 * scale);
}

// Other ranks take over with what bodies() and contacts() tell.
TEST(PlanarRanks, GoesOnOnOtherRanks) {
  const PlanarSettings settings = box(5);
  PlanarScene whole(settings, heap(15, 5));
  whole.evaluate();
  whole.run(5000);
  std::unique_ptr<SceneOnRanks> split(
      new SceneOnRanks(settings, heap(15, 5), 2, slabs(0, 0.025, 2)));
  split->evaluate();
  const auto other_ranks = {
      slabs(1, 0.02, 3), slabs(0, 0.02, 3),
      SceneOnRanks::Rank([](const PlanarBody& body) { return body.tag % 3; })};
  for (const auto& rank_of : other_ranks) {
    split->run(1250);
    const auto bodies = split->bodies();
    const auto contacts = split->contacts();
    split.reset(new SceneOnRanks(settings, bodies, 3, rank_of));
    split->set_contacts(contacts);
    EXPECT_EQ(split->contacts().size(), contacts.size());
  }
  split->run(1250);
  EXPECT_LT(difference(state_of(whole), state_of(split->bodies())), 1e-12);
}

// A rank without bodies takes part in the messages.
TEST(PlanarRanks, ARankMayHaveNoBodies) {
  SceneOnRanks split(box(5), heap(6, 5), 3, [](const PlanarBody& body) { return body.tag % 2; });
  split.evaluate();
  EXPECT_EQ(split.run(2000), 2000);
}

TEST(PlanarRanks, EndsARunBeforeABodyIsTooFarForItsRank) {
  PlanarSettings settings = settings_of();
  settings.farthest[0] = 0.02;
  const std::vector<PlanarBody> apart = {moving(rod(5, 0, 0, 0), 1.0, 0.0), rod(5, 0.1, 0, 0)};
  SceneOnRanks split(settings, apart, 2, [](const PlanarBody& body) { return body.tag; });
  split.evaluate();
  const long steps = split.run(10000);
  EXPECT_LT(steps, 10000);
  const double way = split.bodies()[0].position[0];
  EXPECT_LT(way, 0.02);
  EXPECT_GT(way, 0.018);
}

// From rest to farther than the 9.7 mm that ghosts have in reserve: within the 32 steps between two
// questions, and before the run ends.
TEST(PlanarRanks, RefusesBodiesThatOutrunTheirContacts) {
  for (const long steps : {100, 20}) {
    PlanarSettings settings = settings_of();
    settings.gravity[0] = 1e6;
    SceneOnRanks split(settings, {rod(5, 0, 0, 0), rod(5, 0.1, 0, 0)}, 2,
                       [](const PlanarBody& body) { return body.tag; });
    split.evaluate();
    try {
      split.run(steps);
      FAIL() << "expected an error";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("planar scene: body 0 went 0."));
    }
  }
}

TEST(PlanarRanks, RefusesBodiesWithoutTags) {
  Post post(2);
  ThreadRanks ranks(post, 0);
  EXPECT_THROW(PlanarScene(settings_of(), {rod(5, 0, 0, 0)}, &ranks), std::invalid_argument);
}

TEST(PlanarRanks, RefusesBodiesOfOneTag) {
  Post post(2);
  ThreadRanks ranks(post, 0);
  std::vector<PlanarBody> bodies = {rod(5, 0, 0, 0), rod(5, 0.1, 0, 0), rod(5, 0.2, 0, 0)};
  const int tags[] = {7, 3, 7};
  for (int k = 0; k < 3; ++k) bodies[k].tag = tags[k];
  try {
    PlanarScene(settings_of(), bodies, &ranks);
    FAIL();
  } catch (const std::invalid_argument& reason) {
    EXPECT_NE(std::string(reason.what()).find("7"), std::string::npos) << reason.what();
  }
}

}  // namespace rodpack
