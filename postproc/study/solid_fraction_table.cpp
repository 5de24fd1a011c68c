// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "reading/csv_file.h"
#include "reading/number_text.h"
#include "reading/text_file.h"
#include "study/published.h"

namespace rodpack {
namespace {

const char* const to_surface = "solid_fraction";
const char* const below_surface = "solid_fraction_to_3_omega_below_surface";

std::string csv_row(const PublishedComparison& row) {
  const auto& published = row.published;
  return csv_line({row.case_name, row.quantity, averaging_of(row.quantity),
                   number_text(row.measured.mean, 6), csv_number(row.measured.sem, 6),
                   std::to_string(row.measured.n),
                   published ? number_text(published->value, 6) : "",
                   published ? number_text(published->error, 6) : "",
                   published ? number_text(published->rounding, 3) : "",
                   published ? number_text(row.difference, 4) : "",
                   published ? csv_number(row.combined_error, 6) : "",
                   csv_number(row.deviation(), 6), published ? published->source : ""});
}

std::string measured_text(const EnsembleMean& mean) {
  return fixed_text(mean.mean, 4) + (mean.sem ? " ± " + fixed_text(*mean.sem, 4) : "");
}

std::string deviation_text(const PublishedComparison& row) {
  if (!row.published) return "";
  const auto deviation = row.deviation();
  return (row.difference < 0 ? "−" : "+") + fixed_text(std::fabs(row.difference), 4) +
         (deviation ? " (" + fixed_text(std::fabs(*deviation), 1) + " σ)" : " (one run: no error)");
}

// The other average of the same case and published value.
const PublishedComparison* partner(const std::vector<PublishedComparison>& rows,
                                   const PublishedComparison& row) {
  for (const auto& other : rows)
    if (other.case_name == row.case_name &&
        (!row.published || (other.published && other.published->source == row.published->source)))
      return &other;
  return nullptr;
}

}  // namespace

std::string averaging_of(const std::string& quantity) {
  if (quantity == to_surface) return "3 omega above the floor to the surface";
  if (quantity == below_surface) return "3 omega above the floor to 3 omega below the surface";
  return "";
}

bool write_solid_fraction_table(const Ensemble& ensemble,
                                const std::vector<PublishedValue>& published,
                                const std::string& stem) {
  const auto upper = compare_with_published(ensemble, published, to_surface);
  const auto inner = compare_with_published(ensemble, published, below_surface);
  if (upper.empty()) return false;
  std::string csv =
      "case,quantity,averaged_from,solid_fraction,sem,n,published,published_error,rounding_error,"
      "difference,combined_error,difference_over_combined_error,source\n";
  std::string markdown =
      "Mean solid fraction in the central slice, from 3ω above the floor up to the surface (as the "
      "paper, which names no distance from the surface) and up to 3ω below it, ± standard error of "
      "the mean over n runs. Differences from the published value in units of the combined error "
      "σ: "
      "standard error, published error and the rounding of the published value (last digit / √12), "
      "added in squares.\n\n"
      "| case | n | up to the surface | up to 3ω below | published | difference, up to the surface "
      "| difference, up to 3ω below |\n|---|---|---|---|---|---|---|\n";
  for (const auto& row : upper) {
    const auto* other = partner(inner, row);
    csv += csv_row(row) + "\n" + (other ? csv_row(*other) + "\n" : "");
    markdown +=
        "| " + row.case_name + " | " + std::to_string(row.measured.n) + " | " +
        measured_text(row.measured) + " | " + (other ? measured_text(other->measured) : "") +
        " | " +
        (row.published
             ? number_text(row.published->value, 6) + " ± " + number_text(row.published->error, 6)
             : "") +
        " | " + deviation_text(row) + " | " + (other ? deviation_text(*other) : "") + " |\n";
  }
  write_text(stem + ".csv", csv);
  write_text(stem + ".md", markdown);
  return true;
}

}  // namespace rodpack
