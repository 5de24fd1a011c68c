// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_RAY_TRACING_H
#define RODPACK_FIGURES_SPACE_RAY_TRACING_H

#include <array>
#include <string>

#include "figures/space/camera.h"
#include "reading/data_error.h"

namespace rodpack {

/// A scene of balls, rods and triangles as the ray tracer Tachyon reads it, in the camera's frame.
/// Colours are "#rrggbb".
class TracedScene {
 public:
  void ball(const SeenPlace& centre, double radius, const std::string& colour);
  /// A cylinder without ends.
  void rod(const SeenPlace& from, const SeenPlace& to, double radius, const std::string& colour);
  /// The same in its own colour, whatever the light.
  void line(const SeenPlace& from, const SeenPlace& to, double radius, const std::string& colour);
  void triangle(const std::array<SeenPlace, 3>& corners, const std::string& colour);

  /// The text of a picture of so many pixels: light from above to the left and from all around,
  /// shadows, and white fog from the depth `near` on, which has taken a quarter of the colour at
  /// `far`.
  std::string text(const Frustum& frustum, std::size_t width, std::size_t height, double near,
                   double far) const;

 private:
  std::string objects_;
};

/// No ray tracer on this machine; what() names the package.
class NoRayTracer : public DataError {
  using DataError::DataError;
};

/// Draws `scene`, a TracedScene's text, as `picture`, in the format "PNG" or "PPM".
/// @throws NoRayTracer, DataError when it fails.
void trace_rays(const std::string& scene, const std::string& picture,
                const std::string& format = "PNG");

}  // namespace rodpack

#endif
