// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "reading/angles.h"
#include "reading/number_text.h"
#include "study/claims/claim_groups.h"
#include "study/claims/histogram_tests.h"
#include "study/study_case.h"

namespace rodpack {
namespace {

const char* const distribution = "orientation.probability_density_per_deg";
// A relative departure, root mean square over the angles, that nobody would see in a figure.
constexpr double negligible = 0.05;

// <cos 2 gamma>, 1 when all lie flat and 0 when isotropic, of the mean distribution. Its error is
// that of the nematic order of the runs together, which is the same number when the director lies
// flat.
std::optional<EnsembleMean> flatness(const EnsembleCase* each) {
  const auto* curve = curve_of(each, distribution);
  const auto* order = number_of(each, "nematic_order_S2_pooled");
  if (!curve || !order) return std::nullopt;
  EnsembleMean mean;
  double total = 0;
  for (std::size_t k = 0; k < curve->x.size(); ++k) {
    mean.mean += curve->y[k].mean * std::cos(2 * curve->x[k] * degree);
    total += curve->y[k].mean;
  }
  mean.mean /= total;
  mean.sem = order->sem;
  mean.n = order->n;
  return mean;
}

std::vector<Claim> flat_claims(const Ensemble& ensemble, bool coarse) {
  const std::string surface = coarse ? "coarse" : "smooth";
  Claim flat, flatter;
  flat.name = "lie_flat_" + surface;
  flat.text = "Elongated particles lie flat (" + surface + ")";
  flat.measured = "smallest <cos 2 gamma> (1: all flat, 0: isotropic)";
  flat.test = "<cos 2 gamma> over the standard error of S2: Student's t around 0 if isotropic";
  flatter.name = "longer_lie_flatter_" + surface;
  flatter.text = "Longer particles lie flatter (" + surface + ")";
  flatter.measured = "smallest rise of <cos 2 gamma> from one aspect ratio to the next";
  flatter.test = "each rise over its standard error: Student's t around 0 if there is none";
  std::vector<std::optional<Contrast>> values, rises;
  std::optional<EnsembleMean> last;
  for (const double aspect_ratio : aspect_ratios(ensemble, false)) {
    const auto mean = flatness(straight_case(ensemble, surface_of(coarse), aspect_ratio));
    if (!mean) continue;
    flat.remark += (flat.remark.empty() ? "" : ", ") + straight_name(coarse, aspect_ratio) + " " +
                   in_words(mean->mean, mean->sem, 3);
    values.push_back(contrast_of({{1, *mean}}));
    if (last) rises.push_back(contrast_of({{1, *mean}, {-1, *last}}));
    last = mean;
  }
  flatter.remark = flat.remark;
  if (values.empty())
    return {not_tested(flat, surface + " cases with orientations"),
            not_tested(flatter, "two " + surface + " cases with orientations")};
  judge_all_above(flat, values);
  if (rises.empty())
    flatter = not_tested(flatter, "two " + surface + " cases with orientations");
  else
    judge_all_above(flatter, rises);
  return {flat, flatter};
}

std::string in_percent(const Departure& departure) {
  return number_text(100 * departure.relative(), 3) + " % (F = " + number_text(departure.f(), 3) +
         " of " + number_text(departure.above) + " and " + number_text(departure.below) +
         " degrees of freedom)";
}

// Holds by F; does not hold when the departure is negligible with the same certainty.
void judge_departure(Claim& claim, const std::optional<Departure>& departure) {
  claim.verdict = Verdict::undecided;
  if (!departure) {
    claim.remark = "single runs have no error";
    return;
  }
  claim.value = departure->relative();
  claim.error = departure->relative() > 0
                    ? departure->relative_square_error() / (2 * departure->relative())
                    : std::sqrt(departure->relative_square_error());
  claim.sigmas = departure->sigmas();
  claim.remark = in_percent(*departure);
  if (*claim.sigmas >= decisive_sigmas)
    claim.verdict = Verdict::holds;
  else if (departure->relative_square() + decisive_sigmas * departure->relative_square_error() <
           negligible * negligible)
    claim.verdict = Verdict::does_not_hold;
}

std::vector<Claim> discrete_angle_claims(const Ensemble& ensemble, double aspect_ratio) {
  const std::string ratio = number_text(aspect_ratio, 4);
  Claim coarse, smooth;
  coarse.name = "coarse_prefer_discrete_angles_AR" + ratio;
  coarse.text = "Coarse particles of AR = " + ratio + " prefer discrete angles";
  coarse.measured =
      "relative departure of the distribution from harmonics 0, 2 and 4 of gamma, root mean "
      "square, "
      "noise subtracted";
  coarse.test = "residuals over the scatter between runs: F around 1 if the distribution is smooth";
  smooth.name = "smooth_prefer_none_AR" + ratio;
  smooth.text = "Smooth particles of AR = " + ratio + " do not prefer discrete angles";
  smooth.measured = coarse.measured;
  smooth.test =
      "its square is below a quarter of that of the coarse ones: difference over its standard "
      "error; normal around 0 at just half of the departure";
  const auto* coarse_curve =
      curve_of(straight_case(ensemble, Surface::coarse, aspect_ratio), distribution);
  const auto* smooth_curve =
      curve_of(straight_case(ensemble, Surface::smooth, aspect_ratio), distribution);
  std::optional<Departure> of_coarse, of_smooth;
  if (coarse_curve) {
    of_coarse = narrow_peaks(*coarse_curve);
    judge_departure(coarse, of_coarse);
  } else {
    coarse = not_tested(coarse, straight_name(true, aspect_ratio));
  }
  if (!coarse_curve || !smooth_curve)
    return {coarse, not_tested(smooth, straight_name(!coarse_curve, aspect_ratio))};
  of_smooth = narrow_peaks(*smooth_curve);
  std::optional<Contrast> margin;
  if (of_coarse && of_smooth) {
    margin = Contrast{
        0.25 * of_coarse->relative_square() - of_smooth->relative_square(),
        std::hypot(0.25 * of_coarse->relative_square_error(), of_smooth->relative_square_error()),
        std::min(of_coarse->above, of_smooth->above)};
    smooth.remark = in_percent(*of_smooth);
  }
  judge_above(smooth, margin);
  if (of_smooth) {
    smooth.value = of_smooth->relative();
    smooth.error.reset();
  }
  return {coarse, smooth};
}

Claim asymmetry_claim(const Ensemble& ensemble, double aspect_ratio, double theta) {
  const std::string name = curved_name(aspect_ratio, theta);
  Claim claim;
  claim.name = "not_symmetric_about_vertical_" + name;
  claim.text =
      "The distribution of curved particles is not symmetric about the vertical (" + name + ")";
  claim.measured =
      "relative difference of p(gamma) and p(180 deg - gamma), root mean square, noise subtracted";
  claim.test = "differences over the scatter between runs: F around 1 if symmetric";
  const auto* curve = curve_of(curved_case(ensemble, aspect_ratio, theta), distribution);
  if (!curve) return not_tested(claim, name);
  judge_departure(claim, asymmetry(*curve));
  const double width = 360.0 / static_cast<double>(curve->x.size());
  double up = 0;
  for (std::size_t k = 0; k < curve->x.size(); ++k)
    if (std::cos(curve->x[k] * degree) > 1e-9) up += width * curve->y[k].mean;
  claim.remark += "; fraction that bulges up " + number_text(up, 3);
  return claim;
}

}  // namespace

std::vector<Claim> orientation_claims(const Ensemble& ensemble) {
  std::vector<Claim> claims;
  const auto add = [&](const std::vector<Claim>& more) {
    claims.insert(claims.end(), more.begin(), more.end());
  };
  for (const double aspect_ratio : {2.0, 3.0}) add(discrete_angle_claims(ensemble, aspect_ratio));
  for (const bool coarse : {true, false}) add(flat_claims(ensemble, coarse));
  for (const double aspect_ratio : {3.0, 5.0, 7.0}) {
    const auto angles = opening_angles(ensemble, aspect_ratio);
    add({asymmetry_claim(ensemble, aspect_ratio, angles.empty() ? 120 : angles.back())});
  }
  return claims;
}

}  // namespace rodpack
