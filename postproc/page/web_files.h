// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_WEB_FILES_H
#define RODPACK_PAGE_WEB_FILES_H

#include <string_view>

namespace rodpack {

/// Returns what the file `name` of page/web/ held when the program was built; empty when there is
/// none of that name.
std::string_view web_file(std::string_view name);

}  // namespace rodpack

#endif
