// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/frame_pool.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <string_view>

#include "reading/number_text.h"

namespace rodpack {
namespace {

// A number that frames of the same content share, and others do not but once in 2^64 times.
std::size_t content(const Frame& frame) {
  std::size_t sum = frame.rows;
  const auto mix = [&](std::size_t value) {
    sum ^= value + 0x9e3779b97f4a7c15 + (sum << 6U) + (sum >> 2U);
  };
  for (std::size_t c = 0; c < frame.names.size(); ++c) {
    mix(std::hash<std::string>()(frame.names[c]));
    const auto& column = frame.columns[c];
    mix(std::hash<std::string_view>()(
        {reinterpret_cast<const char*>(column.data()), column.size() * sizeof(double)}));
  }
  return sum;
}

}  // namespace

bool FramePool::take(const Frame& frame) {
  if (frame.rows == 0) {
    ++empty_;
    return false;
  }
  if (!known_[frame.timestep].emplace(content(frame), frame.file).second) {
    ++repeated_;
    return false;
  }
  const auto folder = std::filesystem::path(frame.file).parent_path().string();
  const auto place = taken_.emplace(std::make_pair(folder, frame.timestep), frame.file);
  if (!place.second)
    throw DataError(frame.file + ":" + std::to_string(frame.header_line) +
                    ": expected each timestep once, found another frame of timestep " +
                    std::to_string(frame.timestep) + " than in " + place.first->second);
  if (same_particles_ && frame.has("half_length") && frame.has("nspheres"))
    require_same_particles(frame);
  return true;
}

void FramePool::require_same_particles(const Frame& bodies) {
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const auto longest = static_cast<std::size_t>(
      std::max_element(half_length.begin(), half_length.end()) - half_length.begin());
  const ParticleKind found{
      bodies.file, bodies.column("nspheres")[longest],
      bodies.has("curvature") ? bodies.column("curvature")[longest] : 0, half_length[longest],
      std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(bodies.rows)};
  if (!particles_) particles_ = found;
  const auto& first = *particles_;
  // A spread of 5 % lets the diameters of two single particles differ by a factor of 1.105.
  const auto near = [](double a, double b, double factor) {
    return std::abs(a - b) <= (factor - 1) * std::min(a, b);
  };
  if (found.count == first.count && std::abs(found.curvature - first.curvature) < 1e-3 &&
      near(found.half_length, first.half_length, 1.12) && near(found.radius, first.radius, 1.12))
    return;
  const auto text = [](const ParticleKind& each) {
    return number_text(each.count) + " spheres, half length " + number_text(each.half_length, 4) +
           " m, radius " + number_text(each.radius, 4) + " m, curvature " +
           number_text(each.curvature, 4) + " rad";
  };
  throw DataError(bodies.file + ":" + std::to_string(bodies.header_line) +
                  ": expected the particles of " + first.file + " (" + text(first) + "), found " +
                  text(found) + ": other particles are not averaged with them");
}

std::string FramePool::passed_over() const {
  const auto text = [](std::size_t number, const std::string& kind) {
    return std::to_string(number) + " " + kind + (number == 1 ? " frame" : " frames");
  };
  if (empty_ == 0 && repeated_ == 0) return "";
  std::string result = "passed over: ";
  if (empty_ > 0) result += text(empty_, "empty");
  if (repeated_ > 0) result += (empty_ > 0 ? ", " : "") + text(repeated_, "repeated");
  return result;
}

}  // namespace rodpack
