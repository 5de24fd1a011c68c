// SPDX-License-Identifier: GPL-2.0-or-later
#include "refusals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

namespace rodpack::test {

void Refusals::judge(int exit_code, const std::vector<std::string>& lines,
                     const std::vector<std::string>& says, const std::string& what,
                     const std::string& said) {
  if (exit_code == 0) {
    ++accepted;
    ADD_FAILURE() << "accepted: " << what;
    return;
  }
  if (exit_code > 2) {
    ++crash;
    ADD_FAILURE() << "crash, exit code " << exit_code << ": " << what;
    return;
  }
  bool is_clear = lines.size() == 1;
  for (const auto& each : says) is_clear = is_clear && lines[0].find(each) != std::string::npos;
  ++(is_clear ? clear : unclear);
  EXPECT_TRUE(is_clear) << "unclear: " << what << ": " << said
                        << "\nexpected one line with: " << testing::PrintToString(says);
}

std::ostream& operator<<(std::ostream& out, const Refusals& refusals) {
  return out << "clear " << refusals.clear << ", unclear " << refusals.unclear
             << ", accepted wrongly " << refusals.accepted << ", crash " << refusals.crash;
}

}  // namespace rodpack::test
