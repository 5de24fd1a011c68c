// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/dump.h"

#include <glob.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "reading/parsing.h"

namespace rodpack {

bool Frame::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<double>& Frame::column(const std::string& name) const {
  const auto index = column_index(names, name, file + ":" + std::to_string(header_line));
  if (bad_fields[index].line > 0)
    throw DataError(file + ":" + std::to_string(bad_fields[index].line) + ": column '" + name +
                    "': expected a finite number, found '" + bad_fields[index].text + "'");
  return columns[index];
}

VectorColumns vector_columns(const Frame& frame, const std::array<const char*, 3>& names) {
  return {&frame.column(names[0]), &frame.column(names[1]), &frame.column(names[2])};
}

// Lines of a plain or gzip-compressed file (zlib reads both), with the number of the current line.
struct DumpReader::Stream {
  std::string file;
  gzFile handle = nullptr;
  long line_number = 0;
  std::string line;

  explicit Stream(const std::string& name) : file(name) {
    std::error_code ignored;
    if (std::filesystem::is_directory(name, ignored))
      throw DataError(name + ": is a folder, expected a dump file");
    handle = gzopen(name.c_str(), "rb");
    if (!handle) throw DataError(name + ": no such file, or it cannot be read");
    gzbuffer(handle, 1U << 18U);
  }
  ~Stream() { gzclose(handle); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(file + ":" + std::to_string(line_number) + ": " + what);
  }

  bool read_line() {
    line.clear();
    char part[4096];
    while (gzgets(handle, part, sizeof part)) {
      line += part;
      if (line.back() == '\n') break;
    }
    int status = Z_OK;
    gzerror(handle, &status);
    if (status != Z_OK && status != Z_STREAM_END)
      fail("the compressed file is damaged or cut short after this line");
    if (line.empty()) return false;
    ++line_number;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return true;
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
};

// Returns false at the end of the file.
bool DumpReader::Stream::read_frame_start(long& timestep) {
  do {
    if (!read_line()) return false;
  } while (line.empty());
  if (!starts_with(line, "ITEM: TIMESTEP")) {
    const bool surplus_row = line_number > 1 && !starts_with(line, "ITEM:");
    fail("expected 'ITEM: TIMESTEP', found '" + shortened(line) + "'" +
         (surplus_row ? " (more rows than the frame's count states?)" : ""));
  }
  timestep = need_count("a timestep (whole number)");
  return true;
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

  auto flags = in.need_item("BOX BOUNDS");
  for (auto& periodic : frame.periodic) {
    const auto flag = take_word(flags);
    if (starts_with(flag, "x"))
      in.fail("expected an orthogonal box, found a tilted one ('" + shortened(in.line) + "')");
    periodic = starts_with(flag, "p");
  }
  for (auto& bound : frame.bounds) {
    in.need_line("a line 'lo hi' of the box bounds");
    std::string_view rest(in.line);
    for (auto& value : bound)
      if (!parse_number(take_word(rest), value) || !std::isfinite(value))
        in.fail("expected two numbers (box bounds), found '" + shortened(in.line) + "'");
  }

  in.need_line("'ITEM: ATOMS' or 'ITEM: ENTRIES' with the names of the columns");
  std::string_view header(in.line);
  const std::string_view first = take_word(header);
  const std::string_view second = take_word(header);
  if (first != "ITEM:" || (second != "ATOMS" && second != "ENTRIES"))
    in.fail("expected 'ITEM: ATOMS' or 'ITEM: ENTRIES', found '" + shortened(in.line) + "'");
  frame.header_line = in.line_number;
  frame.names.clear();
  for (auto name = take_word(header); !name.empty(); name = take_word(header))
    frame.names.emplace_back(name);
  if (frame.names.empty()) in.fail("this line names no columns");

  const auto width = frame.names.size();
  frame.columns.resize(width);
  for (auto& column : frame.columns) column.clear();
  frame.bad_fields.assign(width, {});
  for (std::size_t row = 0; row < frame.rows; ++row) {
    const auto state = [&] {
      return std::to_string(frame.rows) + " rows, found " + std::to_string(row);
    };
    if (!in.read_line()) in.fail("the frame is cut short here: expected " + state());
    if (starts_with(in.line, "ITEM:")) in.fail("the frame has too few rows: expected " + state());
    std::string_view rest(in.line);
    for (std::size_t c = 0; c < width; ++c) {
      const auto word = take_word(rest);
      if (word.empty())
        in.fail("expected " + std::to_string(width) + " fields, found " + std::to_string(c));
      double value = 0;
      if ((!parse_number(word, value) || !std::isfinite(value)) && frame.bad_fields[c].line == 0)
        frame.bad_fields[c] = {in.line_number, std::string(word)};
      frame.columns[c].push_back(value);
    }
    if (!take_word(rest).empty())
      in.fail("expected " + std::to_string(width) + " fields, found more");
  }
  return true;
}

std::vector<std::string> find_dumps(const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const auto& pattern : patterns) {
    if (std::filesystem::exists(pattern)) {
      names.push_back(pattern);
      continue;
    }
    if (pattern.find_first_of("*?[") == std::string::npos)
      throw DataError(pattern + ": no such file");
    glob_t matches{};
    const int status = glob(pattern.c_str(), 0, nullptr, &matches);
    if (status == 0)
      names.insert(names.end(), matches.gl_pathv, matches.gl_pathv + matches.gl_pathc);
    globfree(&matches);
    if (status != 0) throw DataError("no file matches '" + pattern + "'");
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

Frame frame_at(const std::vector<std::string>& files, long timestep) {
  if (files.empty()) throw DataError("no dump file given");
  // From the last file back to the first one that begins at or before the timestep.
  auto file = files.rbegin();
  while (std::next(file) != files.rend() && DumpReader::first_timestep(*file) > timestep) ++file;
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
