// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PACKINGS_BASE64_H
#define RODPACK_FIGURES_PACKINGS_BASE64_H

#include <string>
#include <string_view>

namespace rodpack {

/// Returns `bytes` in base64, with padding (RFC 4648, section 4), for pictures inside pictures and
/// pages.
std::string base64(std::string_view bytes);

}  // namespace rodpack

#endif
