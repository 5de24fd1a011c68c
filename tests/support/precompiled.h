// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PRECOMPILED_H
#define RODPACK_PRECOMPILED_H

// The headers that take the compiler longest, read once for all tests. Sources include what they
// use nevertheless.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#endif
