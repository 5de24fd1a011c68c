// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_pairs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rodpack {

namespace {

Vector minus(const Vector& a, const Vector& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }

Vector cross(const Vector& a, const Vector& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

void add(Vector& sum, const Vector& term) {
  for (std::size_t d = 0; d < 3; ++d) sum[d] += term[d];
}

Interaction interaction(const SphereContact& contact) {
  return {contact.centre_i, minus(contact.centre_j, contact.centre_i), contact.force,
          cross(minus(contact.point, contact.centre_i), contact.force), contact.wall};
}

// Whether two contacts of a pair are of the same periodic images: the branch vectors are equal but
// for rounding, or differ by a period.
bool same_image(const Vector& a, const Vector& b) {
  double difference = 0, size = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    difference = std::max(difference, std::fabs(a[d] - b[d]));
    size = std::max(size, std::fabs(a[d]));
  }
  return difference <= 1e-6 * size;
}

}  // namespace

ContactPairs sum_pairs(std::vector<SphereContact> contacts) {
  for (SphereContact& contact : contacts) {
    if (contact.wall || contact.i < contact.j) continue;
    std::swap(contact.i, contact.j);
    std::swap(contact.centre_i, contact.centre_j);
    for (double& component : contact.force) component = -component;
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const SphereContact& a, const SphereContact& b) {
                     return std::tie(a.wall, a.i, a.j) < std::tie(b.wall, b.i, b.j);
                   });

  ContactPairs result;
  std::size_t first_of_pair = 0;  // its first interaction
  for (const SphereContact& contact : contacts) {
    const Interaction next = interaction(contact);
    if (contact.wall) {
      result.interactions.push_back(next);
      continue;
    }
    const bool known = !result.pairs.empty() && result.pairs.back().i == contact.i &&
                       result.pairs.back().j == contact.j;
    if (known) {
      ++result.pairs.back().contacts;
    } else {
      result.pairs.push_back({contact.i, contact.j, 1});
      first_of_pair = result.interactions.size();
    }
    const auto same = std::find_if(
        result.interactions.begin() + static_cast<std::ptrdiff_t>(first_of_pair),
        result.interactions.end(),
        [&](const Interaction& other) { return same_image(other.branch, next.branch); });
    if (same == result.interactions.end()) {
      result.interactions.push_back(next);
    } else {
      add(same->force, next.force);
      // Both moments are about the same centre of mass, in whatever image the contact was listed.
      add(same->moment, next.moment);
    }
  }
  return result;
}

std::vector<TouchingPair> merge_pairs(std::vector<TouchingPair> pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const TouchingPair& a, const TouchingPair& b) {
    return std::tie(a.i, a.j) < std::tie(b.i, b.j);
  });
  std::vector<TouchingPair> merged;
  for (const TouchingPair& pair : pairs)
    if (!merged.empty() && merged.back().i == pair.i && merged.back().j == pair.j)
      merged.back().contacts += pair.contacts;
    else
      merged.push_back(pair);
  return merged;
}

std::vector<Touching> count_touching(const std::vector<TouchingPair>& pairs, std::size_t count) {
  std::vector<Touching> touching(count);
  for (const TouchingPair& pair : pairs)
    for (const long id : {pair.i, pair.j}) {
      Touching& particle = touching.at(static_cast<std::size_t>(id));
      ++particle.particles;
      particle.contacts += pair.contacts;
    }
  return touching;
}

}  // namespace rodpack
