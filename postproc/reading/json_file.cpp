// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/json_file.h"

#include "reading/text_file.h"

namespace rodpack {

void write_json(const std::string& file, const nlohmann::ordered_json& content) {
  write_text(file, content.dump(2) + "\n");
}

}  // namespace rodpack
