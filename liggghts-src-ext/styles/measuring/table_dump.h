// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_TABLE_DUMP_H
#define LMP_TABLE_DUMP_H

#include <cstddef>
#include <string>
#include <vector>
#include "dump.h"

namespace LAMMPS_NS {

/// `name` with its * replaced by the step, padded with zeros to `width` digits.
std::string name_at_step(std::string name, long long step, int width);

/// Base of our dumps: a LIGGGHTS text dump with fixed columns, whose rows the derived style lists
/// anew for each frame. File names as for any dump (* the step, % the rank, .gz compressed).
class TableDump : public Dump {
 public:
  TableDump(class LAMMPS* lmp, int narg, char** arg);

 protected:
  struct Column {
    std::string name;
    bool integer;
  };

  /// `label` is ATOMS or ENTRIES.
  void set_columns(const std::string& label, const std::vector<Column>& columns);
  /// Stops with a message that names this dump.
  void stop(const std::string& text) const;
  /// Appends the rows of this rank to `rows_`, one value per column, and an id per row to `ids_`.
  virtual void list_rows() = 0;

  void init_style();
  void openfile();
  int count();
  void pack(int* ids);
  void write_header(bigint entries);
  void write_data(int lines, double* values);

  std::vector<double> rows_;
  std::vector<int> ids_;  // what 'dump_modify sort id' sorts by

 private:
  std::string label_;
  std::vector<Column> columns_;
};

}  // namespace LAMMPS_NS

#endif
