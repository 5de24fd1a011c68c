// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "reading/number_text.h"
#include "study/claims/claim_groups.h"
#include "study/pressure.h"
#include "study/study_case.h"

namespace rodpack {
namespace {

// Two pressures that differ by less than this part of their mean are alike.
constexpr double alike = 0.1;

std::string part_text(const EnsembleMean& mean) { return in_words(mean.mean, mean.sem) + " N/m"; }

Claim spheres_saturate(const Ensemble& ensemble) {
  Claim claim;
  claim.name = "spheres_follow_janssen";
  claim.text = "The pressure in packings of spheres saturates with depth, after Janssen";
  claim.measured =
      "growth of P_0 from the upper to the middle third of the bed less that from the middle to "
      "the "
      "lower third, N/m";
  claim.test = "over its standard error: Student's t around 0 if P_0 grows like a straight line";
  const auto* spheres = straight_case(ensemble, Surface::sphere, 1);
  const auto end = usable_depth(spheres);
  if (!end) return not_tested(claim, "spheres with a pressure profile");
  const RangeTerm upper{-1, 0, *end / 3}, middle{2, *end / 3, 2 * *end / 3},
      lower{-1, 2 * *end / 3, *end};
  claim.remark = "thirds";
  for (const auto& part : {upper, middle, lower})
    claim.remark += " " + part_text(mean_pressure(*spheres, part.from, part.to));
  std::string why;
  const auto fit = janssen_of(*spheres, why);
  claim.remark +=
      "; " + (fit ? describe(*fit, spheres->parameters["particle_diameter_m"].get<double>()) : why);
  judge_above(claim, contrast_of({{1, sum_of_pressures(*spheres, {upper, middle, lower})}}));
  return claim;
}

Claim keeps_rising(const Ensemble& ensemble, bool coarse, double aspect_ratio) {
  const std::string name = straight_name(coarse, aspect_ratio);
  Claim claim;
  claim.name = "pressure_keeps_rising_" + name;
  claim.text = "For AR = " + number_text(aspect_ratio, 4) +
               " the pressure does not saturate: it keeps rising with depth (" + name + ")";
  claim.measured = "growth of P_0 between the halves of the lower third of the bed, N/m";
  claim.test = "over its standard error: Student's t around 0 if P_0 has saturated";
  const auto* each =
      straight_case(ensemble, coarse ? Surface::coarse : Surface::smooth, aspect_ratio);
  const auto end = usable_depth(each);
  if (!end) return not_tested(claim, name + " with a bed higher than 3 omega");
  const RangeTerm upper{-1, *end * 4 / 6, *end * 5 / 6}, lower{1, *end * 5 / 6, *end};
  const auto growth = sum_of_pressures(*each, {upper, lower});
  if (growth.n == 0) return not_tested(claim, name + " with more depths");
  claim.remark = part_text(mean_pressure(*each, upper.from, upper.to)) + " and " +
                 part_text(mean_pressure(*each, lower.from, lower.to)) + ", down to " +
                 number_text(*end, 3) + " d_p";
  judge_above(claim, contrast_of({{1, growth}}));
  return claim;
}

// Mean pressures of both surfaces in the lower half of the depths that both have.
std::optional<std::pair<EnsembleMean, EnsembleMean>> both_surfaces(const Ensemble& ensemble,
                                                                   double aspect_ratio) {
  const auto* coarse = straight_case(ensemble, Surface::coarse, aspect_ratio);
  const auto* smooth = straight_case(ensemble, Surface::smooth, aspect_ratio);
  const auto end_coarse = usable_depth(coarse), end_smooth = usable_depth(smooth);
  if (!end_coarse || !end_smooth) return std::nullopt;
  const double end = std::min(*end_coarse, *end_smooth);
  const auto of_coarse = mean_pressure(*coarse, end / 2, end);
  const auto of_smooth = mean_pressure(*smooth, end / 2, end);
  if (of_coarse.n == 0 || of_smooth.n == 0) return std::nullopt;
  return std::pair{of_coarse, of_smooth};
}

Claim coarse_above_smooth(const Ensemble& ensemble, double aspect_ratio) {
  const std::string ratio = number_text(aspect_ratio, 4);
  Claim claim;
  claim.name = "coarse_pressure_above_smooth_AR" + ratio;
  claim.text = "The pressure of coarse particles is above that of smooth ones (AR = " + ratio + ")";
  claim.measured = "P_0 in the lower half of the common depths, coarse less smooth, N/m";
  claim.test = "difference over its standard error: Student's t around 0 if alike";
  const auto both = both_surfaces(ensemble, aspect_ratio);
  if (!both) return not_tested(claim, "coarse-AR" + ratio + " and smooth-AR" + ratio);
  claim.remark = "coarse " + part_text(both->first) + ", smooth " + part_text(both->second);
  judge_above(claim, contrast_of({{1, both->first}, {-1, both->second}}));
  return claim;
}

Claim coarse_like_smooth(const Ensemble& ensemble, double aspect_ratio) {
  const std::string ratio = number_text(aspect_ratio, 4);
  Claim claim = coarse_above_smooth(ensemble, aspect_ratio);
  claim.name = "coarse_pressure_like_smooth_AR" + ratio;
  claim.text = "The pressures of coarse and smooth particles are alike (AR = " + ratio + ")";
  claim.test =
      "less than a tenth of their mean apart: a tenth less the difference over its standard error; "
      "Student's t around 0 at a tenth";
  const auto both = both_surfaces(ensemble, aspect_ratio);
  if (!both || !claim.value) return claim;
  const double limit = 0.5 * alike * (both->first.mean + both->second.mean);
  auto margin = contrast_of({{1, both->first}, {-1, both->second}});
  const double difference = margin->value;
  margin->value = limit - std::fabs(difference);
  judge_above(claim, margin);
  claim.value = difference;
  return claim;
}

Claim stress_rises_with_theta(const Ensemble& ensemble, double aspect_ratio) {
  const std::string ratio = number_text(aspect_ratio, 4);
  Claim claim;
  claim.name = "pressure_rises_with_theta_AR" + ratio;
  claim.text = "The stress rises with theta for AR = " + ratio;
  claim.measured = "growth of P_0 in the lower half of the common depths per degree of theta, N/m";
  claim.test = "slope over its standard error: Student's t around 0 if theta changes nothing";
  const auto over_theta = pressure_over_theta(ensemble, aspect_ratio);
  if (over_theta.theta.size() < 2)
    return not_tested(claim, "two of smooth-AR" + ratio + " and curved-AR" + ratio + "-theta...");
  for (std::size_t k = 0; k < over_theta.theta.size(); ++k)
    claim.remark += (k ? ", " : "") + number_text(over_theta.theta[k], 4) + " deg " +
                    part_text(over_theta.pressure[k]);
  judge_above(claim, slope_of(over_theta.theta, over_theta.pressure));
  return claim;
}

}  // namespace

std::vector<Claim> pressure_claims(const Ensemble& ensemble) {
  return {spheres_saturate(ensemble),          keeps_rising(ensemble, true, 7),
          keeps_rising(ensemble, false, 7),    coarse_above_smooth(ensemble, 2),
          coarse_above_smooth(ensemble, 3),    coarse_like_smooth(ensemble, 7),
          stress_rises_with_theta(ensemble, 3)};
}

}  // namespace rodpack
