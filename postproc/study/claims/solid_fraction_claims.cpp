// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/number_text.h"
#include "study/claims/claim_groups.h"
#include "study/study_case.h"

namespace rodpack {
namespace {

const char* const solid_fraction = "solid_fraction";

Claim falls_with_aspect_ratio(const Ensemble& ensemble, bool coarse) {
  const std::string surface = coarse ? "coarse" : "smooth";
  Claim claim;
  claim.name = "solid_fraction_falls_with_AR_" + surface;
  claim.text = "The solid fraction of " + surface + " particles falls with their aspect ratio";
  claim.measured = "smallest fall from one aspect ratio to the next";
  claim.test = "each fall over its standard error: Student's t around 0 if there is none";
  std::vector<EnsembleMean> means;
  for (const double aspect_ratio : aspect_ratios(ensemble, false)) {
    const auto* mean =
        number_of(straight_case(ensemble, surface_of(coarse), aspect_ratio), solid_fraction);
    if (!mean) continue;
    means.push_back(*mean);
    claim.remark += (claim.remark.empty() ? "" : ", ") + straight_name(coarse, aspect_ratio) + " " +
                    in_words(mean->mean, mean->sem);
  }
  if (means.size() < 2) return not_tested(claim, "two " + surface + " cases with solid fractions");
  std::vector<std::optional<Contrast>> falls;
  for (std::size_t k = 0; k + 1 < means.size(); ++k)
    falls.push_back(contrast_of({{1, means[k]}, {-1, means[k + 1]}}));
  judge_all_above(claim, falls);
  return claim;
}

Claim falls_with_theta(const Ensemble& ensemble, double aspect_ratio) {
  const std::string ratio = number_text(aspect_ratio, 4);
  Claim claim;
  claim.name = "curvature_lowers_solid_fraction_AR" + ratio;
  claim.text = "Curvature lowers the solid fraction for AR = " + ratio;
  claim.measured = "fall of the solid fraction per degree of theta, by a straight line";
  claim.test = "slope over its standard error: Student's t around 0 if theta changes nothing";
  std::vector<double> x;
  std::vector<EnsembleMean> means;
  for (const double theta : angles_from_straight(ensemble, aspect_ratio)) {
    const auto* mean = number_of(curved_case(ensemble, aspect_ratio, theta), solid_fraction);
    if (!mean) continue;
    x.push_back(theta);
    means.push_back(*mean);
    claim.remark += (claim.remark.empty() ? "" : ", ") + number_text(theta, 4) + " deg " +
                    in_words(mean->mean, mean->sem);
  }
  if (x.size() < 2)
    return not_tested(claim, "two of smooth-AR" + ratio + " and curved-AR" + ratio + "-theta...");
  auto slope = slope_of(x, means);
  if (slope) slope->value = -slope->value;
  judge_above(claim, slope);
  return claim;
}

}  // namespace

std::vector<Claim> solid_fraction_claims(const Ensemble& ensemble) {
  return {falls_with_aspect_ratio(ensemble, true), falls_with_aspect_ratio(ensemble, false),
          falls_with_theta(ensemble, 5), falls_with_theta(ensemble, 7)};
}

}  // namespace rodpack
