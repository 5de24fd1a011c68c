// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_FUZZ_INPUT_FILE_H
#define RODPACK_TESTS_FUZZ_INPUT_FILE_H

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

/// The entry function of each target: libFuzzer calls it with one input after the other, and so
/// does replay.cpp. A refusal of the input (DataError) is right; all else that ends it is a find.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace rodpack::test {

/// A file in memory that holds the input, for readers that want the name of a file.
class InputFile {
 public:
  InputFile(const std::uint8_t* data, std::size_t size) : handle_(::memfd_create("input", 0)) {
    if (handle_ < 0 || ::write(handle_, data, size) != static_cast<ssize_t>(size)) std::abort();
  }
  ~InputFile() { ::close(handle_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(handle_); }

 private:
  int handle_;
};

}  // namespace rodpack::test

#endif
