// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_CLAIMS_CLAIM_GROUPS_H
#define RODPACK_STUDY_CLAIMS_CLAIM_GROUPS_H

#include <string>
#include <vector>

#include "study/claims/claims.h"
#include "study/claims/significance.h"

namespace rodpack {

// The claims by what they are about; for the sources of this folder only.

std::vector<Claim> solid_fraction_claims(const Ensemble& ensemble);
std::vector<Claim> orientation_claims(const Ensemble& ensemble);
std::vector<Claim> rdf_claims(const Ensemble& ensemble);
std::vector<Claim> pressure_claims(const Ensemble& ensemble);

/// A mean, or anything else that is measured, in words: "0.8524 +- 0.0026".
std::string in_words(double value, const std::optional<double>& error, int digits = 4);

/// The name of a straight case: coarse-AR2.
std::string straight_name(bool coarse, double aspect_ratio);
/// The name of a curved case: curved-AR5-theta60.
std::string curved_name(double aspect_ratio, double theta);

/// Fills value, error, sigmas and verdict: holds when the contrast is decisively above 0, does not
/// hold when it is decisively below. None: undecided, for want of errors.
void judge_above(Claim& claim, const std::optional<Contrast>& contrast);

/// The same for a claim that every one of several contrasts is above 0. The weakest decides: all
/// are above 0 with the significance of the weakest. It fails with the significance of the weakest,
/// corrected for the choice among so many (Bonferroni).
void judge_all_above(Claim& claim, const std::vector<std::optional<Contrast>>& contrasts);

/// The claim with the remark of what is missing.
Claim not_tested(Claim claim, const std::string& missing);

}  // namespace rodpack

#endif
