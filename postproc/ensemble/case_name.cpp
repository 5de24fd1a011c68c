// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/case_name.h"

#include <tuple>

#include "reading/number_text.h"

namespace rodpack {
namespace {
using Json = nlohmann::json;

double number(const Json& parameters, const char* key, double paper) {
  const auto found = parameters.find(key);
  return found != parameters.end() && found->is_number() ? found->get<double>() : paper;
}

std::string surface(const Json& parameters) {
  const auto found = parameters.find("surface");
  return found != parameters.end() && found->is_string() ? found->get<std::string>() : "smooth";
}

std::string shape_name(const Json& parameters) {
  const double ratio = number(parameters, "aspect_ratio", 5);
  if (ratio == 1) return "spheres";
  std::string look = surface(parameters);
  if (look == "overlap") look += number_text(number(parameters, "overlap", 0.5), 9);
  const double theta = number(parameters, "curvature_deg", 0);
  const std::string length = "-AR" + number_text(ratio, 9);
  if (theta == 0) return look + length;
  return "curved" + (look == "smooth" ? "" : "-" + look) + length + "-theta" +
         number_text(theta, 9);
}

auto order_of(const Json& parameters, const std::string& name) {
  const double ratio = number(parameters, "aspect_ratio", 5);
  const double theta = number(parameters, "curvature_deg", 0);
  return std::make_tuple(ratio != 1, theta != 0, surface(parameters), ratio, theta, name);
}

}  // namespace

std::string case_name(const Json& parameters) {
  std::string name = shape_name(parameters);
  const double kn = number(parameters, "normal_stiffness_N_m", 2000);
  const double kt = number(parameters, "tangential_stiffness_N_m", 1000);
  const double eta_n = number(parameters, "damping_ratio_normal", 0.2);
  const double eta_t = number(parameters, "damping_ratio_tangential", 0.2);
  const double mu = number(parameters, "friction", 0.3);
  if (kn != 2000) name += "-kn" + number_text(kn, 9);
  if (kt != kn / 2) name += "-kt" + number_text(kt, 9);
  if (eta_n != 0.2 && eta_n == eta_t)
    name += "-eta" + number_text(eta_n, 9);
  else {
    if (eta_n != 0.2) name += "-etan" + number_text(eta_n, 9);
    if (eta_t != 0.2) name += "-etat" + number_text(eta_t, 9);
  }
  if (mu != 0.3) name += "-mu" + number_text(mu, 9);
  return name;
}

bool case_before(const Json& a, const std::string& name_a, const Json& b,
                 const std::string& name_b) {
  return order_of(a, name_a) < order_of(b, name_b);
}

}  // namespace rodpack
