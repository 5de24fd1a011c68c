// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_DUMP_H
#define RODPACK_READING_DUMP_H

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reading/data_error.h"

namespace rodpack {

/// The data are sound, but hold too few particles in the right place for this measurement.
class TooFewParticles : public DataError {
 public:
  using DataError::DataError;
};

/// The dumps hold no frame of the timestep asked for.
class NoSuchFrame : public DataError {
 public:
  using DataError::DataError;
};

/// One frame of a LIGGGHTS text dump (`ITEM: ATOMS` or `ITEM: ENTRIES`), stored by column.
struct Frame {
  struct BadField {  // first field of a column that is not what it may be, see
                     // checks/column_range.h
    long line = 0;   // 0: the column is sound
    std::string text, expected;
  };

  std::string file;
  long header_line = 0;  // line that names the columns, counted from 1
  long timestep = 0;
  std::array<std::array<double, 2>, 3> bounds{};  // simulation box, lo and hi of x, y, z, m
  std::array<bool, 3> periodic{};
  std::size_t rows = 0;
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::vector<BadField> bad_fields;  // per column

  /// Whether there is a column of this name.
  bool has(const std::string& name) const;
  /// Returns the values of the named column, one per row, in the dump's own unit.
  /// @throws DataError when there is no such column (the message lists those there are), or when a
  ///   field of it is not a finite number in the column's range.
  const std::vector<double>& column(const std::string& name) const;
};

/// Three columns of a frame that hold the components of a vector, x to z, in the dump's own unit.
using VectorColumns = std::array<const std::vector<double>*, 3>;
/// Takes them by their names. They live as long as `frame`. @throws DataError as Frame::column().
VectorColumns vector_columns(const Frame& frame, const std::array<const char*, 3>& names);

/// Streams the frames of one dump, plain or gzip-compressed; memory for one frame only.
class DumpReader {
 public:
  /// @throws DataError when the file cannot be opened.
  explicit DumpReader(const std::string& file);
  ~DumpReader();
  DumpReader(const DumpReader&) = delete;
  DumpReader& operator=(const DumpReader&) = delete;

  /// Reads the next frame. Returns false, and leaves `frame` alone, at the end of the file.
  /// @throws DataError naming file and line when the frame is cut short or malformed, its box is
  ///   not upright, its units are not SI, or a particle or contact stands in it twice.
  bool next(Frame& frame);

  /// Reads the timestep of the first frame of a file. @throws DataError when the file holds no
  /// frame.
  static long first_timestep(const std::string& file);

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

/// Finds the files that the given names and wildcard patterns stand for, each once, and orders them
/// by the timestep of their first frame. A file or folder of just that name comes before what it
/// matches as a pattern: run[1] is that folder where there is one.
/// @throws DataError for a name without a file and for a pattern that matches nothing.
std::vector<std::string> find_dumps(const std::vector<std::string>& patterns);

/// Calls `visit` with every frame of every file, in order.
void for_each_frame(const std::vector<std::string>& files,
                    const std::function<void(const Frame&)>& visit);

/// Reads the last frame of the last file.
Frame last_frame(const std::vector<std::string>& files);

/// Reads the frame of the timestep of `frame`, of another dump; `files` as find_dumps() orders
/// them. Where they are of several runs, those in the folder of `frame` count. @throws NoSuchFrame
/// as frame_at(), DataError when two of them begin with that timestep.
Frame frame_beside(const Frame& frame, const std::vector<std::string>& files);

/// Reads the frame of the given timestep; `files` as find_dumps() orders them. @throws NoSuchFrame
/// naming the closest timestep before it, or the first one.
Frame frame_at(const std::vector<std::string>& files, long timestep);

}  // namespace rodpack

#endif
