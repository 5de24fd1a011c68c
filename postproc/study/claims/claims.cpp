// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/claims/claims.h"

#include <algorithm>
#include <cmath>

#include "reading/csv_file.h"
#include "reading/json_file.h"
#include "reading/number_text.h"
#include "reading/text_file.h"
#include "study/claims/claim_groups.h"

namespace rodpack {
namespace {

Verdict verdict_of(double sigmas) {
  if (sigmas >= decisive_sigmas) return Verdict::holds;
  return sigmas <= -decisive_sigmas ? Verdict::does_not_hold : Verdict::undecided;
}

void add_remark(Claim& claim, const std::string& remark) {
  claim.remark += (claim.remark.empty() ? "" : "; ") + remark;
}

// Fields of a CSV table hold no commas and no line ends.
std::string field(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

nlohmann::ordered_json optional_json(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

}  // namespace

std::string words_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::does_not_hold:
      return "does not hold";
    case Verdict::undecided:
      return "undecided at this size";
    case Verdict::not_tested:
      break;
  }
  return "not tested";
}

std::string in_words(double value, const std::optional<double>& error, int digits) {
  return number_text(value, digits) + (error ? " +- " + number_text(*error, 2) : "");
}

std::string straight_name(bool coarse, double aspect_ratio) {
  return (coarse ? "coarse-AR" : "smooth-AR") + number_text(aspect_ratio, 4);
}

std::string curved_name(double aspect_ratio, double theta) {
  return "curved-AR" + number_text(aspect_ratio, 4) + "-theta" + number_text(theta, 4);
}

void judge_above(Claim& claim, const std::optional<Contrast>& contrast) {
  claim.verdict = Verdict::undecided;
  if (!contrast) {
    add_remark(claim, "single runs have no error");
    return;
  }
  claim.value = contrast->value;
  claim.error = contrast->error;
  claim.sigmas = contrast->sigmas_above();
  claim.verdict = verdict_of(*claim.sigmas);
}

void judge_all_above(Claim& claim, const std::vector<std::optional<Contrast>>& contrasts) {
  claim.verdict = Verdict::undecided;
  const Contrast* weakest = nullptr;
  for (const auto& contrast : contrasts) {
    if (!contrast) {
      add_remark(claim, "single runs have no error");
      return;
    }
    if (!weakest || contrast->sigmas_above() < weakest->sigmas_above()) weakest = &*contrast;
  }
  if (!weakest) return;
  claim.value = weakest->value;
  claim.error = weakest->error;
  claim.sigmas = weakest->sigmas_above();
  if (*claim.sigmas < 0) {
    const double chance = 0.5 * std::erfc(-*claim.sigmas / std::sqrt(2.0));
    claim.sigmas = -sigmas_of(std::min(0.5, chance * static_cast<double>(contrasts.size())));
  }
  claim.verdict = verdict_of(*claim.sigmas);
}

Claim not_tested(Claim claim, const std::string& missing) {
  claim.verdict = Verdict::not_tested;
  claim.remark = "missing: " + missing;
  return claim;
}

std::vector<Claim> test_claims(const Ensemble& ensemble) {
  std::vector<Claim> all;
  for (const auto& group : {solid_fraction_claims(ensemble), orientation_claims(ensemble),
                            rdf_claims(ensemble), pressure_claims(ensemble)})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

void write_claims(const std::vector<Claim>& claims, const std::string& folder) {
  std::string csv = "name,claim,measured,value,error,sigmas,verdict,test,remark\n";
  nlohmann::ordered_json json;
  json["format"] = "rodpack-claims 1";
  json["decisive_sigmas"] = decisive_sigmas;
  json["claims"] = nlohmann::ordered_json::array();
  for (const auto& claim : claims) {
    csv +=
        csv_line({claim.name, field(claim.text), field(claim.measured), csv_number(claim.value, 5),
                  csv_number(claim.error, 5), csv_number(claim.sigmas, 5), words_of(claim.verdict),
                  field(claim.test), field(claim.remark)}) +
        "\n";
    nlohmann::ordered_json row;
    row["name"] = claim.name;
    row["claim"] = claim.text;
    row["measured"] = claim.measured;
    row["value"] = optional_json(claim.value);
    row["error"] = optional_json(claim.error);
    row["sigmas"] = optional_json(claim.sigmas);
    row["verdict"] = words_of(claim.verdict);
    row["test"] = claim.test;
    row["remark"] = claim.remark;
    json["claims"].push_back(row);
  }
  write_text(folder + "/claims.csv", csv);
  write_json(folder + "/claims.json", json);
}

}  // namespace rodpack
