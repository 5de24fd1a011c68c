// SPDX-License-Identifier: GPL-2.0-or-later
// Usage: TARGET FOLDER|FILE ...: feeds the files to the target's entry function, without libFuzzer.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "input_file.h"

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (int k = 1; k < argc; ++k)
    if (fs::is_directory(argv[k]))
      for (const auto& entry : fs::directory_iterator(argv[k])) files.push_back(entry.path());
    else
      files.emplace_back(argv[k]);
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::cout << file.string() << std::endl;  // the last one shown is the one that ended it
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::cout << files.size() << " inputs\n";
  return files.empty() ? 2 : 0;
}
