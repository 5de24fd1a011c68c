// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_HTML_H
#define RODPACK_PAGE_HTML_H

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace rodpack {

/// Returns `text` as it has to be written in HTML, as content or as the value of an attribute in
/// quotes.
std::string escaped(std::string_view text);

/// Returns a script element that holds `data` and does nothing: a script of the page reads it.
/// `id`: of the element. No text in the data can end the element.
std::string data_element(const std::string& id, const nlohmann::ordered_json& data);

/// Returns a number with so many significant digits, as a typesetter would: "−1.5 ×
/// 10<sup>−7</sup>". The whole of it stands beside it in a <data> element. `factor`: the number
/// that is shown is `value` times that.
std::string number_html(double value, int significant_digits = 4, double factor = 1);

/// Returns a mean and its standard error, the latter with two significant digits, both with the
/// same number of decimals; without an error the mean alone with four digits, zeros included.
std::string measured_html(double mean, std::optional<double> standard_error, double factor = 1);

/// Returns `text` with each {{name}} in it replaced by what `parts` holds under that name; what is
/// put in is not searched again. @throws std::logic_error for a name that is not in `parts`.
std::string filled(std::string_view text, const std::map<std::string, std::string>& parts);

}  // namespace rodpack

#endif
