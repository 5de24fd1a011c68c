// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/run_cost.h"

#include <cstddef>
#include <fstream>
#include <sstream>
#include <vector>

#include "reading/parsing.h"

namespace rodpack {
namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// All words of the line as numbers; empty unless every one is.
std::vector<double> numbers_of(const std::vector<std::string>& words) {
  std::vector<double> numbers;
  for (const auto& word : words) {
    double number = 0;
    if (!parse_number(word, number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

class LogReader {
 public:
  void read(const std::string& line) {
    const auto words = words_of(line);
    if (words.empty()) return;
    if (line.find("MPI processor grid") != std::string::npos) {
      end_loop(cpu_);  // an earlier attempt was cut short
      const auto grid =
          words.size() > 4 ? numbers_of({words[0], words[2], words[4]}) : std::vector<double>();
      if (grid.size() == 3) ranks_ = grid[0] * grid[1] * grid[2];
    } else if (words[0] == "Step") {
      end_loop(cpu_);
      cpu_column_ = 0;
      while (cpu_column_ < words.size() && words[cpu_column_] != "CPU") ++cpu_column_;
      columns_ = words.size();
      in_loop_ = true;
      cpu_ = 0;
    } else if (words.size() > 3 && line.compare(0, 13, "Loop time of ") == 0) {
      const auto time = numbers_of({words[3]});
      if (!time.empty()) end_loop(time[0]);
    } else if (in_loop_ && words.size() == columns_ && cpu_column_ < columns_) {
      const auto row = numbers_of(words);
      if (!row.empty()) cpu_ = row[cpu_column_];
    }
  }
  std::optional<RunCost> cost() {
    end_loop(cpu_);
    if (!any_) return std::nullopt;
    return cost_;
  }

 private:
  void end_loop(double seconds) {
    if (!in_loop_) return;
    cost_.wall_time_s += seconds;
    cost_.core_seconds += seconds * ranks_;
    any_ = true;
    in_loop_ = false;
  }

  RunCost cost_;
  bool any_ = false, in_loop_ = false;
  double ranks_ = 1;
  double cpu_ = 0;  // s, what the loop told last
  std::size_t cpu_column_ = 0, columns_ = 0;
};

}  // namespace

std::optional<RunCost> cost_of_run(const std::string& log) {
  std::ifstream in(log);
  LogReader reader;
  for (std::string line; std::getline(in, line);) reader.read(line);
  return reader.cost();
}

}  // namespace rodpack
