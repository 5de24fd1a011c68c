// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_TABLE_DUMP_H
#define LMP_TABLE_DUMP_H

#include <cstddef>
#include <string>
#include <vector>
#include "dump.h"
#include "dump_files.h"
#include "output_file.h"
#include "rodpack/dumps/columns.h"

namespace LAMMPS_NS {

/// Base of our dumps: writes a LIGGGHTS text dump with fixed columns, whose rows the derived style
/// lists anew for each frame. File names are as for any dump: * stands for the step, % for the
/// rank, and .gz compresses. A file per frame appears when it is whole.
class TableDump : public Dump {
 public:
  TableDump(class LAMMPS* lmp, int narg, char** arg);
  ~TableDump();
  void write();

 protected:
  /// Sets the columns of the file; `label` is ATOMS or ENTRIES, as the header lines have it, `id`
  /// the column that 'dump_modify sort id' sorts by.
  template <std::size_t number>
  void set_columns(const std::string& label, const rodpack::DumpColumn (&columns)[number],
                   const rodpack::DumpColumn& id) {
    label_ = label;
    columns_.assign(columns, columns + number);
    size_one = static_cast<int>(number);
    id_ = id.name;
  }
  /// Calls add_row() for each row of this rank.
  virtual void list_rows() = 0;
  /// Adds a row, which has one value per column.
  template <class Row>
  void add_row(const Row& row) {
    static_assert(sizeof(Row) % sizeof(double) == 0, "a row consists of doubles");
    const double* const values = reinterpret_cast<const double*>(&row);
    rows_.insert(rows_.end(), values, values + sizeof(Row) / sizeof(double));
  }

  void init_style();
  void openfile();
  int count();
  void pack(int*);
  void write_header(bigint entries);
  void write_data(int lines, double* values);

 private:
  void finish_file();
  void sort_by_column();

  OutputFile file_;
  bool gzipped_;
  std::string label_, id_;
  std::vector<rodpack::DumpColumn> columns_;
  std::vector<double> rows_;  // of this rank and frame, one after the other
};

}  // namespace LAMMPS_NS

#endif
