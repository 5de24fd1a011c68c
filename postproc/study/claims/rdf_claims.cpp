// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "reading/number_text.h"
#include "study/claims/claim_groups.h"
#include "study/peaks.h"
#include "study/study_case.h"

namespace rodpack {
namespace {

const Peak* highest_peak(const std::vector<Peak>& peaks) {
  const auto found = std::max_element(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) {
    return a.height.mean < b.height.mean;
  });
  return found == peaks.end() ? nullptr : &*found;
}

// The first peak of the second row of parallel neighbours. Rows that nestle into each other are
// sqrt(3)/2 d_p apart where the spheres of a chain touch, and sqrt(1 - 1/16) d_p where they overlap
// by half: two rows make 1.73 and 1.94 d_p. Between the rows, and only for long smooth particles,
// shifted neighbours of the first row stand at 1.22 and 1.58 d_p.
const Peak* second_row(const std::vector<Peak>& peaks) {
  for (const auto& peak : peaks)
    if (peak.position > 1.65 && peak.position < 2.1) return &peak;
  return nullptr;
}

std::string peak_text(const char* surface, const Peak& peak) {
  return std::string(surface) + " G = " + in_words(peak.height.mean, peak.height.sem, 3) +
         " at r = " + in_words(peak.position, peak.position_error, 3) + " d_p";
}

// Undecided where one of the curves, though it has errors, has no such peak.
void judge_peaks(Claim& claim, const std::optional<Contrast>& difference,
                 const EnsembleCurve& smooth, const EnsembleCurve& coarse) {
  const auto has_errors = [](const EnsembleCurve& curve) {
    return std::any_of(curve.y.begin(), curve.y.end(),
                       [](const EnsembleMean& value) { return value.sem.has_value(); });
  };
  if (!difference && has_errors(smooth) && has_errors(coarse)) {
    claim.verdict = Verdict::undecided;
    claim.remark = "no such peak stands out of the noise for one of the surfaces";
    return;
  }
  judge_above(claim, difference);
}

std::vector<Claim> peak_claims(const Ensemble& ensemble, double aspect_ratio) {
  const std::string ratio = number_text(aspect_ratio, 4);
  Claim higher, nearer;
  higher.name = "coarse_rdf_peaks_higher_AR" + ratio;
  higher.text =
      "Peaks of G(r) are higher for coarse particles than for smooth ones (AR = " + ratio + ")";
  higher.measured = "highest peak of G, coarse less smooth";
  higher.test = "difference over its standard error: Student's t around 0 if alike";
  nearer.name = "coarse_rdf_peaks_nearer_AR" + ratio;
  nearer.text =
      "Peaks of G(r) are at smaller r for coarse particles than for smooth ones (AR = " + ratio +
      ")";
  nearer.measured =
      "position of the first peak from 1.65 to 2.1 d_p, of the second row of parallel neighbours "
      "(nestled rows: 1.73 coarse, 1.94 smooth), smooth less coarse, d_p";
  nearer.test =
      "difference over its error, a bin's width over sqrt(12) each in it: normal around 0 "
      "if alike";
  const EnsembleCurve* curves[2];
  for (const bool coarse : {false, true})
    curves[coarse] = curve_of(
        straight_case(ensemble, coarse ? Surface::coarse : Surface::smooth, aspect_ratio), "rdf.g");
  for (const bool coarse : {false, true})
    if (!curves[coarse])
      return {not_tested(higher, straight_name(coarse, aspect_ratio)),
              not_tested(nearer, straight_name(coarse, aspect_ratio))};
  const auto coarse = find_peaks(*curves[1]), smooth = find_peaks(*curves[0]);

  const auto *high_coarse = highest_peak(coarse), *high_smooth = highest_peak(smooth);
  std::optional<Contrast> difference;
  if (high_coarse && high_smooth) {
    higher.remark = peak_text("coarse", *high_coarse) + ", " + peak_text("smooth", *high_smooth);
    difference = contrast_of({{1, high_coarse->height}, {-1, high_smooth->height}});
  }
  judge_peaks(higher, difference, *curves[0], *curves[1]);

  const auto *near_coarse = second_row(coarse), *near_smooth = second_row(smooth);
  difference.reset();
  if (near_coarse && near_smooth) {
    nearer.remark = peak_text("coarse", *near_coarse) + ", " + peak_text("smooth", *near_smooth);
    const double bin = curves[0]->x[1] - curves[0]->x[0];
    difference = Contrast{near_smooth->position - near_coarse->position,
                          std::sqrt(std::pow(near_smooth->position_error, 2) +
                                    std::pow(near_coarse->position_error, 2) + 2 * bin * bin / 12),
                          1e6};
  }
  judge_peaks(nearer, difference, *curves[0], *curves[1]);
  return {higher, nearer};
}

}  // namespace

std::vector<Claim> rdf_claims(const Ensemble& ensemble) {
  std::vector<Claim> claims;
  std::vector<double> ratios = aspect_ratios(ensemble, false);
  if (ratios.empty()) ratios = {2, 3, 5, 7};
  for (const double aspect_ratio : ratios)
    for (auto& claim : peak_claims(ensemble, aspect_ratio)) claims.push_back(claim);
  return claims;
}

}  // namespace rodpack
