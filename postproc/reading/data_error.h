// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_DATA_ERROR_H
#define RODPACK_READING_DATA_ERROR_H

#include <stdexcept>

namespace rodpack {

/// Input that cannot be used. what() is one line: the file (and line), what was found, what was
/// expected.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rodpack

#endif
