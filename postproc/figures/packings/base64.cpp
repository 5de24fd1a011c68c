// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/packings/base64.h"

namespace rodpack {

std::string base64(std::string_view bytes) {
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    unsigned triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple =
          triple << 8U | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      result += at + k <= bytes.size() ? digits[triple >> (18 - 6 * k) & 63U] : '=';
  }
  return result;
}

}  // namespace rodpack
