// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_FRAME_POOL_H
#define RODPACK_READING_CHECKS_FRAME_POOL_H

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "reading/dump.h"

namespace rodpack {

/// Which of several frames count when a measure is taken over all of them. Empty frames, as at the
/// start of a deposition, and frames that came before, in all the same, are passed over. Frames of
/// several runs may be pooled, of the same particles only.
class FramePool {
 public:
  /// `same_particles`: whether all frames need the same particles.
  explicit FramePool(bool same_particles = true) : same_particles_(same_particles) {}
  /// Whether the frame counts.
  /// @throws DataError when it is another course of the same run (its timestep again in the same
  ///   folder, with other content), or has other particles than the frames before: number of
  ///   spheres or curvature of the longest one, or lengths that no spread of sizes explains.
  bool take(const Frame& frame);
  /// "passed over: 2 empty frames, 1 repeated frame" for the report; empty when there is none.
  std::string passed_over() const;

 private:
  void require_same_particles(const Frame& bodies);

  struct ParticleKind {  // the longest one, and the spheres' mean
    std::string file;
    double count, curvature, half_length, radius;
  };
  bool same_particles_;
  std::map<long, std::map<std::size_t, std::string>> known_;   // timestep, content: file
  std::map<std::pair<std::string, long>, std::string> taken_;  // folder, timestep: file
  std::optional<ParticleKind> particles_;
  std::size_t empty_ = 0, repeated_ = 0;
};

}  // namespace rodpack

#endif
