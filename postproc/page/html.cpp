// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/html.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr const char* minus = "\u2212";

// A number as printf writes it, with a typesetter's minus and power of ten.
std::string typeset(const std::string& text) {
  const auto e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.front() == '-') mantissa = minus + mantissa.substr(1);
  if (e == std::string::npos) return mantissa;
  const int exponent = std::stoi(text.substr(e + 1));
  return mantissa + "\u00a0×\u00a010<sup>" + (exponent < 0 ? minus : "") +
         std::to_string(std::abs(exponent)) + "</sup>";
}

std::string data(double value, const std::string& shown) {
  return "<data value=\"" + nlohmann::json(value).dump() + "\">" + shown + "</data>";
}

// Four digits, zeros at the end too: all numbers of a column look alike. Counts stay whole.
std::string without_error(double value, double factor) {
  if (!std::isfinite(value)) return "none";
  const double shown = value * factor;
  if (std::fabs(shown - std::round(shown)) <= 1e-12 * std::fabs(shown) && std::fabs(shown) < 1e9)
    return number_html(value, 10, factor);
  char text[40];
  std::snprintf(text, sizeof text, "%#.4g", shown);
  std::string digits = text;
  if (digits.back() == '.') digits.pop_back();
  return data(value, typeset(digits));
}

std::string with_decimals(double value, int decimals) {
  return typeset(fixed_text(value, decimals));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string data_element(const std::string& id, const nlohmann::ordered_json& data) {
  // A "<" might begin "</script>"; JSON has another way to write it. Bytes that are no UTF-8 can
  // come in with the name of a folder.
  const auto text = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return "<script type=\"application/json\" id=\"" + escaped(id) + "\">" + safe + "</script>\n";
}

std::string number_html(double value, int significant_digits, double factor) {
  if (!std::isfinite(value)) return "none";
  return data(value, typeset(number_text(value * factor, significant_digits)));
}

std::string measured_html(double mean, std::optional<double> standard_error, double factor) {
  if (!standard_error || !(*standard_error > 0) || !std::isfinite(mean))
    return without_error(mean, factor);
  const double value = mean * factor, error = *standard_error * factor;
  const double larger = std::max(std::fabs(value), error);
  int exponent = static_cast<int>(std::floor(std::log10(larger)));
  if (exponent >= -3 && exponent < 5) exponent = 0;
  const double unit = std::pow(10.0, exponent);
  const int decimals =
      std::clamp(1 - static_cast<int>(std::floor(std::log10(error / unit))), 0, 12);
  std::string both = data(mean, with_decimals(value / unit, decimals)) + "\u00a0±\u00a0" +
                     data(*standard_error, with_decimals(error / unit, decimals));
  if (exponent == 0) return both;
  return "(" + both + ")\u00a0×\u00a010<sup>" + (exponent < 0 ? minus : "") +
         std::to_string(std::abs(exponent)) + "</sup>";
}

std::string filled(std::string_view text, const std::map<std::string, std::string>& parts) {
  std::string result;
  for (auto open = text.find("{{"); open != std::string_view::npos; open = text.find("{{")) {
    const auto close = text.find("}}", open);
    const std::string name(text.substr(open + 2, close - open - 2));
    const auto part = parts.find(name);
    if (part == parts.end()) throw std::logic_error("page: nothing to put in for " + name);
    result.append(text.substr(0, open)).append(part->second);
    text.remove_prefix(close + 2);
  }
  return result.append(text);
}

}  // namespace rodpack
