// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "campaigns/comparison/comparison.h"
#include "reading/dump.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

void raise(double& largest, double value) { largest = std::max(largest, std::abs(value)); }

/// Returns the angle of each body's x axis above the x-y plane, rad.
std::vector<double> elevations(const Frame& frame) {
  const auto& w = frame.column("qw");
  const auto& x = frame.column("qx");
  const auto& y = frame.column("qy");
  const auto& z = frame.column("qz");
  std::vector<double> result(frame.rows);
  for (std::size_t i = 0; i < frame.rows; ++i)
    result[i] = std::asin(std::clamp(2 * (x[i] * z[i] - w[i] * y[i]), -1.0, 1.0));
  return result;
}

}  // namespace

BodyHistory read_body_history(const std::vector<std::string>& files, double timestep,
                              double gravity) {
  BodyHistory history;
  std::vector<double> first_z, first_elevation;
  for_each_frame(files, [&](const Frame& frame) {
    const auto& id = frame.column("id");
    const auto& y = frame.column("y");
    const auto& z = frame.column("z");
    const auto& mass = frame.column("mass");
    const auto elevation = elevations(frame);
    if (history.time.empty()) {
      history.body = id;
      first_z = z;
      first_elevation = elevation;
    } else if (id != history.body) {
      throw DataError(frame.file + ":" + std::to_string(frame.header_line) + ": expected the " +
                      std::to_string(history.body.size()) +
                      " bodies of the first frame in their order, found " +
                      std::to_string(frame.rows) + " bodies, or other ones, at timestep " +
                      std::to_string(frame.timestep));
    }
    history.time.push_back(static_cast<double>(frame.timestep) * timestep);
    history.x.push_back(frame.column("x"));
    history.y.push_back(y);
    history.angle.push_back(frame.column("angle"));
    double potential = 0;
    for (std::size_t i = 0; i < frame.rows; ++i) {
      potential += mass[i] * gravity * y[i];
      raise(history.leak.z, z[i] - first_z[i]);
      raise(history.leak.tilt, elevation[i] - first_elevation[i]);
    }
    history.potential.push_back(potential);
    for (const double value : frame.column("vz")) raise(history.leak.vz, value);
    for (const double value : frame.column("omegax")) raise(history.leak.omega_x, value);
    for (const double value : frame.column("omegay")) raise(history.leak.omega_y, value);
    for (const double value : frame.column("omegaz")) raise(history.leak.omega_z, value);
  });
  if (history.body.empty()) throw DataError(files.front() + ": no bodies in its frames");
  return history;
}

std::optional<double> Separation::parting_time() const {
  if (!parted) return std::nullopt;
  return time[*parted];
}

Separation separate(const BodyHistory& a, const BodyHistory& b, double limit) {
  if (a.body != b.body)
    throw DataError("the runs to compare: expected the same bodies, found " +
                    std::to_string(a.body.size()) + " and " + std::to_string(b.body.size()) +
                    ", or other ids");
  if (a.time != b.time)
    throw DataError("the runs to compare: expected frames of the same times, found " +
                    std::to_string(a.time.size()) + " frames up to " + number_text(a.time.back()) +
                    " s and " + std::to_string(b.time.size()) + " up to " +
                    number_text(b.time.back()) + " s");
  Separation result;
  result.time = a.time;
  for (std::size_t frame = 0; frame < a.time.size(); ++frame) {
    double largest = 0;
    double squares = 0;
    for (std::size_t i = 0; i < a.body.size(); ++i) {
      const double distance =
          std::hypot(a.x[frame][i] - b.x[frame][i], a.y[frame][i] - b.y[frame][i]);
      raise(largest, distance);
      squares += distance * distance;
    }
    result.largest.push_back(largest);
    result.rms.push_back(std::sqrt(squares / static_cast<double>(a.body.size())));
    if (!result.parted && largest > limit) result.parted = frame;
  }
  return result;
}

}  // namespace rodpack
