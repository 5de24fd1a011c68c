// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/dump.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "reading/checks/column_range.h"
#include "reading/number_text.h"
#include "reading/parsing.h"
#include "reading/wildcard.h"

namespace rodpack {

bool Frame::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<double>& Frame::column(const std::string& name) const {
  const auto index = column_index(names, name, file + ":" + std::to_string(header_line));
  if (bad_fields[index].line > 0)
    throw DataError(file + ":" + std::to_string(bad_fields[index].line) + ": column '" + name +
                    "': expected " + bad_fields[index].expected + ", found '" +
                    bad_fields[index].text + "'");
  return columns[index];
}

VectorColumns vector_columns(const Frame& frame, const std::array<const char*, 3>& names) {
  return {&frame.column(names[0]), &frame.column(names[1]), &frame.column(names[2])};
}

// Whole numbers up to here are exact as double, as which timesteps are written to VTK files.
constexpr long largest_timestep = 9007199254740992;
constexpr double largest_box = 1e6;  // m
// A frame of 2 GB: a few kB of compressed text can hold any number of rows.
constexpr std::size_t most_numbers = 250000000;

// Lines of a plain or gzip-compressed file (zlib reads both), with the number of the current line.
struct DumpReader::Stream {
  std::string file;
  gzFile handle = nullptr;
  long line_number = 0;
  std::string line;
  bool line_ended = false;  // by a line end, not by the end of the file

  explicit Stream(const std::string& name) : file(name), buffer_(1U << 16U) {
    std::error_code ignored;
    if (std::filesystem::is_directory(name, ignored))
      throw DataError(name + ": is a folder, expected a dump file");
    // Files are read more than once, and a pipe without a writer would never answer.
    if (std::filesystem::exists(name, ignored) && !std::filesystem::is_regular_file(name, ignored))
      throw DataError(name + ": is no regular file, expected a dump file");
    handle = gzopen(name.c_str(), "rb");
    if (!handle) throw DataError(name + ": no such file, or it cannot be read");
    gzbuffer(handle, static_cast<unsigned>(buffer_.size()));  // more than a read asks for is no use
  }
  ~Stream() { gzclose(handle); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(file + ":" + std::to_string(line_number) + ": " + what);
  }

  bool read_line() {
    line.clear();
    line_ended = false;
    while (!line_ended && (at_ < filled_ || fill())) {
      const char* const begin = buffer_.data() + at_;
      const void* const end = std::memchr(begin, '\n', filled_ - at_);
      line_ended = end != nullptr;
      const auto length = line_ended
                              ? static_cast<std::size_t>(static_cast<const char*>(end) - begin)
                              : filled_ - at_;
      line.append(begin, length);
      at_ += length + (line_ended ? 1 : 0);
      if (line.size() > longest_line)
        fail("expected lines of at most " + std::to_string(longest_line) +
             " characters, found a longer one after this line");
    }
    if (line.empty() && !line_ended) return false;
    ++line_number;
    if (line.find('\0') != std::string::npos)
      fail("expected text, found a NUL character: the file is damaged, or no text dump");
    while (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  }

  // A number that ends with the file may have lost its last digits.
  void need_line_end() const {
    if (!line_ended) fail("the file is cut short here: this line has no line end");
  }

  void need_line(const std::string& expected) {
    if (!read_line()) fail("the frame is cut short here: expected " + expected);
  }

  std::string_view need_item(const std::string& item) {
    need_line("'ITEM: " + item + "'");
    if (!starts_with(line, "ITEM: " + item))
      fail("expected 'ITEM: " + item + "', found '" + shortened(line) + "'");
    return std::string_view(line).substr(6 + item.size());
  }

  long need_count(const std::string& what) {
    need_line(what);
    long value = 0;
    std::string_view rest(line);
    const auto word = take_word(rest);
    if (!parse_number(word, value) || value < 0 || !take_word(rest).empty())
      fail("expected " + what + ", found '" + shortened(line) + "'");
    return value;
  }

  bool read_frame_start(long& timestep);
  void read_box(Frame& frame);
  void read_names(Frame& frame);
  void read_rows(Frame& frame);

 private:
  bool fill() {
    const int got = gzread(handle, buffer_.data(), static_cast<unsigned>(buffer_.size()));
    at_ = 0;
    filled_ = got > 0 ? static_cast<std::size_t>(got) : 0;
    if (filled_ > 0) return true;
    int status = Z_OK;
    gzerror(handle, &status);
    if (got < 0 || (status != Z_OK && status != Z_STREAM_END))
      fail("the compressed file is damaged or cut short after this line");
    return false;
  }

  std::vector<char> buffer_;
  std::size_t at_ = 0, filled_ = 0;
};

// Returns false at the end of the file.
bool DumpReader::Stream::read_frame_start(long& timestep) {
  do {
    if (!read_line()) return false;
  } while (line.empty());
  // What LAMMPS's "dump_modify units yes time yes" writes before it.
  if (line == "ITEM: UNITS") {
    need_line("the units");
    if (line != "si")
      fail("expected a dump in SI units ('si'), found units '" + shortened(line) + "'");
    need_line("'ITEM: TIMESTEP'");
  }
  if (line == "ITEM: TIME") {
    need_line("a time");
    need_line("'ITEM: TIMESTEP'");
  }
  if (!starts_with(line, "ITEM: TIMESTEP")) {
    const bool surplus_row = line_number > 1 && !starts_with(line, "ITEM:");
    fail("expected 'ITEM: TIMESTEP', found '" + shortened(line) + "'" +
         (surplus_row ? " (more rows than the frame's count states?)" : ""));
  }
  timestep = need_count("a timestep (whole number)");
  if (timestep > largest_timestep)
    fail("expected a timestep of at most " + std::to_string(largest_timestep) + ", found '" +
         shortened(line) + "'");
  return true;
}

// An upright box has nothing or three flags of two letters behind "BOX BOUNDS", and two numbers in
// a line. Tilted ones have names ("xy xz yz", "abc origin") there, or a third number here.
void DumpReader::Stream::read_box(Frame& frame) {
  auto rest = need_item("BOX BOUNDS");
  std::vector<std::string_view> flags;
  for (auto word = take_word(rest); !word.empty(); word = take_word(rest)) flags.push_back(word);
  const auto is_flag = [](std::string_view word) {
    return word.size() == 2 && word.find_first_not_of("fpsm") == std::string_view::npos;
  };
  if (!flags.empty() && (flags.size() != 3 || !std::all_of(flags.begin(), flags.end(), is_flag)))
    fail("expected the three boundary flags of an upright box, such as 'ff ff pp', found '" +
         shortened(line) + "' (a tilted box?)");
  for (std::size_t axis = 0; axis < 3; ++axis)
    frame.periodic[axis] = !flags.empty() && flags[axis][0] == 'p';
  for (auto& bound : frame.bounds) {
    need_line("a line 'lo hi' of the box bounds");
    std::string_view numbers(line);
    for (auto& value : bound)
      if (!parse_number(take_word(numbers), value) || !std::isfinite(value))
        fail("expected two numbers (box bounds), found '" + shortened(line) + "'");
    if (!take_word(numbers).empty())
      fail("expected two numbers (the bounds of an upright box), found '" + shortened(line) +
           "' (a tilted box?)");
    if (!(bound[0] < bound[1]) || bound[0] < -largest_box || bound[1] > largest_box)
      fail("expected box bounds lo < hi within " + number_text(-largest_box) + " to " +
           number_text(largest_box) + " m, found '" + shortened(line) + "'");
  }
}

void DumpReader::Stream::read_names(Frame& frame) {
  need_line("'ITEM: ATOMS' or 'ITEM: ENTRIES' with the names of the columns");
  std::string_view header(line);
  const std::string_view first = take_word(header);
  const std::string_view second = take_word(header);
  if (first != "ITEM:" || (second != "ATOMS" && second != "ENTRIES"))
    fail("expected 'ITEM: ATOMS' or 'ITEM: ENTRIES', found '" + shortened(line) + "'");
  frame.header_line = line_number;
  frame.names.clear();
  std::set<std::string_view> known;
  for (auto name = take_word(header); !name.empty(); name = take_word(header)) {
    if (!known.insert(name).second)
      fail("expected each column once, found '" + shortened(name) + "' twice");
    frame.names.emplace_back(name);
  }
  if (frame.names.empty()) fail("this line names no columns");
  if (frame.rows > most_numbers / frame.names.size())
    fail("expected a frame of at most " + std::to_string(most_numbers) + " numbers, found one of " +
         std::to_string(frame.rows) + " rows and " + std::to_string(frame.names.size()) +
         " columns");
}

namespace {

/// What the fields of a column of this frame may be.
NumberRange range_in(const Frame& frame, const std::string& name) {
  if (const int axis = place_axis(name); axis >= 0) {
    // Bodies that touch across a periodic border stand in the image outside the box.
    const auto& bound = frame.bounds[static_cast<std::size_t>(axis)];
    const double size = bound[1] - bound[0];
    return {bound[0] - size, bound[1] + size};
  }
  if (const NumberRange* const range = column_range(name)) return *range;
  return {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
}

std::string expectation(const NumberRange& range, const std::string& name) {
  if (range.high == std::numeric_limits<double>::max()) return "a finite number";
  return range.text() + (place_axis(name) >= 0 ? " (up to a box size outside the box)" : "");
}

/// Calls `refuse` with the rows of the first particle that has the same id as another, or of the
/// first contact that is in all the same as another.
template <class Refuse>
void find_repeated_row(const Frame& frame, Refuse refuse) {
  std::vector<const std::vector<double>*> keys;
  if (frame.has("body_i")) {
    if (!frame.has("sphere_i") || !frame.has("sphere_j")) return;  // what tells contacts apart
    for (const auto& column : frame.columns) keys.push_back(&column);
  } else {
    const auto id = std::find(frame.names.begin(), frame.names.end(), "id") - frame.names.begin();
    const auto index = static_cast<std::size_t>(id);
    if (index == frame.names.size() || frame.bad_fields[index].line > 0) return;
    keys.push_back(&frame.columns[index]);
  }
  const auto compare = [&](std::size_t a, std::size_t b) {
    for (const auto* key : keys)
      if ((*key)[a] != (*key)[b]) return (*key)[a] < (*key)[b] ? -1 : 1;
    return 0;
  };
  std::vector<std::size_t> rows(frame.rows);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    const int order = compare(a, b);
    return order != 0 ? order < 0 : a < b;
  });
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (compare(rows[k - 1], rows[k]) == 0) refuse(rows[k - 1], rows[k], (*keys[0])[rows[k]]);
}

}  // namespace

void DumpReader::Stream::read_rows(Frame& frame) {
  const auto width = frame.names.size();
  frame.columns.resize(width);
  for (auto& column : frame.columns) column.clear();
  frame.bad_fields.assign(width, {});
  std::vector<NumberRange> ranges;
  for (const auto& name : frame.names) ranges.push_back(range_in(frame, name));
  for (std::size_t row = 0; row < frame.rows; ++row) {
    const auto state = [&] {
      return std::to_string(frame.rows) + " rows, found " + std::to_string(row);
    };
    if (!read_line()) fail("the frame is cut short here: expected " + state());
    if (starts_with(line, "ITEM:")) fail("the frame has too few rows: expected " + state());
    std::string_view rest(line);
    for (std::size_t c = 0; c < width; ++c) {
      const auto word = take_word(rest);
      if (word.empty())
        fail("expected " + std::to_string(width) + " fields, found " + std::to_string(c));
      double value = 0;
      const bool finite = parse_number(word, value) && std::isfinite(value);
      if (!(finite && ranges[c].contains(value)) && frame.bad_fields[c].line == 0)
        frame.bad_fields[c] = {
            line_number, shortened(word),
            finite ? expectation(ranges[c], frame.names[c]) : std::string("a finite number")};
      frame.columns[c].push_back(value);
    }
    if (!take_word(rest).empty()) fail("expected " + std::to_string(width) + " fields, found more");
    need_line_end();
  }
  find_repeated_row(frame, [&](std::size_t first, std::size_t second, double id) {
    line_number = frame.header_line + 1 + static_cast<long>(second);
    fail((frame.has("body_i")
              ? std::string("expected each contact once, found that of line ")
              : "expected each particle once, found id " + number_text(id, 16) + " of line ") +
         std::to_string(frame.header_line + 1 + static_cast<long>(first)) + " again");
  });
}

DumpReader::DumpReader(const std::string& file) : stream_(std::make_unique<Stream>(file)) {}
DumpReader::~DumpReader() = default;

long DumpReader::first_timestep(const std::string& file) {
  Stream in(file);
  long timestep = 0;
  if (!in.read_frame_start(timestep)) throw DataError(file + ": no frame in this file");
  return timestep;
}

bool DumpReader::next(Frame& frame) {
  Stream& in = *stream_;
  if (!in.read_frame_start(frame.timestep)) return false;
  frame.file = in.file;
  in.need_item("NUMBER OF ");
  frame.rows = static_cast<std::size_t>(in.need_count("the number of rows (whole number)"));
  in.read_box(frame);
  in.read_names(frame);
  in.read_rows(frame);
  return true;
}

std::vector<std::string> find_dumps(const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const auto& pattern : patterns) {
    const auto found = files_matching(pattern);
    if (found.empty())
      throw DataError(is_wildcard(pattern) ? "no file matches '" + pattern + "'"
                                           : pattern + ": no such file");
    names.insert(names.end(), found.begin(), found.end());
  }

  std::vector<std::pair<long, std::string>> ordered;
  for (const auto& name : names) ordered.emplace_back(DumpReader::first_timestep(name), name);
  std::sort(ordered.begin(), ordered.end());
  ordered.erase(std::unique(ordered.begin(), ordered.end()), ordered.end());
  names.clear();
  for (auto& [timestep, name] : ordered) names.push_back(std::move(name));
  return names;
}

void for_each_frame(const std::vector<std::string>& files,
                    const std::function<void(const Frame&)>& visit) {
  Frame frame;
  for (const auto& file : files) {
    DumpReader reader(file);
    while (reader.next(frame)) visit(frame);
  }
}

Frame last_frame(const std::vector<std::string>& files) {
  if (files.empty()) throw DataError("no dump file given");
  Frame frame;
  DumpReader reader(files.back());
  while (reader.next(frame)) {
  }
  return frame;
}

Frame frame_beside(const Frame& frame, const std::vector<std::string>& files) {
  const auto folder = [](const std::string& file) {
    return std::filesystem::path(file).parent_path();
  };
  std::vector<std::string> chosen;
  for (const auto& file : files)
    if (folder(file) == folder(frame.file)) chosen.push_back(file);
  if (chosen.empty()) chosen = files;
  const auto first = std::lower_bound(chosen.begin(), chosen.end(), frame.timestep,
                                      [](const std::string& file, long timestep) {
                                        return DumpReader::first_timestep(file) < timestep;
                                      });
  const auto begins_there = [&](auto file) {
    return file != chosen.end() && DumpReader::first_timestep(*file) == frame.timestep;
  };
  if (begins_there(first) && begins_there(std::next(first)))
    throw DataError(*std::next(first) + ": begins with timestep " + std::to_string(frame.timestep) +
                    " as does " + *first + ", expected one file to go with " + frame.file);
  return frame_at(chosen, frame.timestep);
}

Frame frame_at(const std::vector<std::string>& files, long timestep) {
  if (files.empty()) throw DataError("no dump file given");
  // The last one that begins at or before the timestep; by halves, for each has to be opened.
  auto file = std::upper_bound(files.begin(), files.end(), timestep,
                               [](long wanted, const std::string& each) {
                                 return wanted < DumpReader::first_timestep(each);
                               });
  if (file != files.begin()) --file;
  Frame frame;
  DumpReader reader(*file);
  long nearest = DumpReader::first_timestep(*file);
  while (reader.next(frame)) {
    if (frame.timestep == timestep) return frame;
    if (frame.timestep < timestep) nearest = frame.timestep;
  }
  throw NoSuchFrame(*file + ": expected a frame of timestep " + std::to_string(timestep) +
                    ", found timestep " + std::to_string(nearest));
}

}  // namespace rodpack
