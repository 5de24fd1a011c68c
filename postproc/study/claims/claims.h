// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_CLAIMS_CLAIMS_H
#define RODPACK_STUDY_CLAIMS_CLAIMS_H

#include <optional>
#include <string>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

enum class Verdict { holds, does_not_hold, undecided, not_tested };

/// The verdict in words: "holds", "does not hold", "undecided at this size", "not tested".
std::string words_of(Verdict verdict);

/// Significance from which a claim holds, or does not, in standard deviations of a normal variable
/// that is as unlikely on one side (2: probability 0.023).
constexpr double decisive_sigmas = 2;

/// What the paper says, and what an ensemble says to it.
struct Claim {
  std::string name;                    // phi_falls_with_AR_coarse
  std::string text;                    // the paper's statement
  std::string measured;                // what `value` is, with its unit
  std::optional<double> value, error;  // its standard error
  std::string test;                    // the statistic, and what it is without the effect
  std::optional<double> sigmas;        // in favour of the claim; negative: against it
  Verdict verdict = Verdict::not_tested;
  std::string remark;  // the numbers behind it, or what is missing
};

/// Tests every claim of the paper, in its order.
std::vector<Claim> test_claims(const Ensemble& ensemble);

/// Writes `folder`/claims.csv and claims.json. @throws DataError when one cannot be written.
void write_claims(const std::vector<Claim>& claims, const std::string& folder);

}  // namespace rodpack

#endif
