// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/json_file.h"

#include "reading/text_file.h"
#include "rodpack/version.h"

namespace rodpack {

void write_json(const std::string& file, const nlohmann::ordered_json& content) {
  nlohmann::ordered_json signed_content = content;
  signed_content["rodpack"] = {{"version", version()}, {"commit", commit()}};
  write_text(file, signed_content.dump(2) + "\n");
}

}  // namespace rodpack
