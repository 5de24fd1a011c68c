// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BODY_FLAGS_H
#define RODPACK_PLANAR_BODY_FLAGS_H

#include <cstdint>
#include <cstring>
#include <vector>

#include "parts.h"

namespace rodpack {

/// A byte of flags for each body, mostly 0, in the parts of the bodies.
class PlanarBodyFlags {
 public:
  explicit PlanarBodyFlags(const PlanarParts& parts) : parts_(parts) {}

  void resize(int bodies) { flags_.resize(bodies, 0); }
  std::uint8_t operator[](int body) const { return flags_[body]; }
  void set(int body, int flags) { flags_[body] = static_cast<std::uint8_t>(flags_[body] | flags); }
  /// The flags themselves, for the SIMD loops.
  std::uint8_t* data() { return flags_.data(); }

  /// Calls visit(body) for the bodies of a part that have flags, in their order.
  template <class Visit>
  void each(int part, Visit visit) const {
    const PlanarRange of = range(part);
    for (int body = next(of.first, of.end); body < of.end; body = next(body + 1, of.end))
      visit(body);
  }
  /// The same, and takes the flags away.
  template <class Visit>
  void clear(int part, Visit visit) {
    each(part, [&](int body) {
      visit(body);
      flags_[body] = 0;
    });
  }

 private:
  PlanarRange range(int part) const {
    if (part < parts_.last()) return parts_.bodies(part);
    return {parts_.owned, static_cast<int>(flags_.size())};
  }
  /// The first body from `body` on that has flags, or `end`.
  int next(int body, int end) const {
    const int word = static_cast<int>(sizeof(std::uint64_t));
    for (std::uint64_t several; body + word <= end; body += word) {
      std::memcpy(&several, &flags_[body], sizeof several);
      if (several == 0) continue;
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
      return body + __builtin_ctzll(several) / 8;
#else
      break;
#endif
    }
    while (body < end && flags_[body] == 0) ++body;
    return body;
  }

  PlanarParts parts_;
  std::vector<std::uint8_t> flags_;
};

}  // namespace rodpack

#endif
