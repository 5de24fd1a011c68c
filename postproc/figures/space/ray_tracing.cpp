// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/ray_tracing.h"

#include <cstdio>
#include <filesystem>

#include "programs/run_program.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

std::string vector_text(const SeenPlace& place) {
  return number_text(place[0], 9) + " " + number_text(place[1], 9) + " " + number_text(place[2], 9);
}

// The texture of a surface that takes the share `ambient` of its colour without any light.
std::string texture(const std::string& colour, double ambient) {
  unsigned red = 0, green = 0, blue = 0;
  std::sscanf(colour.c_str(), "#%2x%2x%2x", &red, &green, &blue);
  return "TEXTURE AMBIENT " + number_text(ambient, 3) + " DIFFUSE " + number_text(1 - ambient, 3) +
         " SPECULAR 0 OPACITY 1 COLOR " + number_text(red / 255.0, 4) + " " +
         number_text(green / 255.0, 4) + " " + number_text(blue / 255.0, 4) + " TEXFUNC 0\n";
}

}  // namespace

void TracedScene::ball(const SeenPlace& centre, double radius, const std::string& colour) {
  objects_ += "SPHERE CENTER " + vector_text(centre) + " RAD " + number_text(radius, 9) + " " +
              texture(colour, 0);
}

void TracedScene::rod(const SeenPlace& from, const SeenPlace& to, double radius,
                      const std::string& colour) {
  objects_ += "FCYLINDER BASE " + vector_text(from) + " APEX " + vector_text(to) + " RAD " +
              number_text(radius, 9) + " " + texture(colour, 0);
}

void TracedScene::line(const SeenPlace& from, const SeenPlace& to, double radius,
                       const std::string& colour) {
  objects_ += "FCYLINDER BASE " + vector_text(from) + " APEX " + vector_text(to) + " RAD " +
              number_text(radius, 9) + " " + texture(colour, 1);
}

void TracedScene::triangle(const std::array<SeenPlace, 3>& corners, const std::string& colour) {
  objects_ += "TRI V0 " + vector_text(corners[0]) + " V1 " + vector_text(corners[1]) + " V2 " +
              vector_text(corners[2]) + " " + texture(colour, 0);
}

std::string TracedScene::text(const Frustum& frustum, std::size_t width, std::size_t height,
                              double near, double far) const {
  // Tachyon's picture has its right at up x view, so that these axes are not mirrored.
  return "BEGIN_SCENE\nRESOLUTION " + std::to_string(width) + " " + std::to_string(height) +
         "\nSHADER_MODE FULL\nAMBIENT_OCCLUSION\nAMBIENT_COLOR 1 1 1\nRESCALE_DIRECT 0.45\n"
         "SAMPLES 12\nEND_SHADER_MODE\n"
         "CAMERA\nPROJECTION PERSPECTIVE\nZOOM 1\nASPECTRATIO 1\nANTIALIASING 3\nRAYDEPTH 4\n"
         "CENTER 0 0 0\nVIEWDIR 0 0 1\nUPDIR 0 1 0\nFRUSTUM " +
         number_text(frustum.left, 9) + " " + number_text(frustum.right, 9) + " " +
         number_text(frustum.bottom, 9) + " " + number_text(frustum.top, 9) +
         "\nEND_CAMERA\nDIRECTIONAL_LIGHT DIRECTION 0.45 -0.8 0.55 COLOR 1 1 1\n"
         "BACKGROUND 1 1 1\nFOG LINEAR START " +
         number_text(near, 6) + " END " + number_text(near + (far - near) * 4, 6) +
         " DENSITY 1 COLOR 1 1 1\n" + objects_ + "END_SCENE\n";
}

void trace_rays(const std::string& scene, const std::string& picture, const std::string& format) {
  namespace fs = std::filesystem;
  const auto input = picture + ".scene", said = picture + ".log";
  write_text(input, scene);
  std::error_code ignored;
  fs::remove(picture, ignored);
  const auto output = fs::absolute(said).string();
  const int status =
      run_program({"tachyon", input, "-format", format, "-o", picture}, {"", "", output, {}});
  const bool drawn = fs::exists(picture) && fs::file_size(picture, ignored) > 0;
  fs::remove(input, ignored);
  fs::remove(said, ignored);
  if (status == 127) throw NoRayTracer("tachyon was not found: install tachyon-bin-nox");
  if (status != 0 || !drawn) throw DataError(picture + ": tachyon failed to draw it");
}

}  // namespace rodpack
