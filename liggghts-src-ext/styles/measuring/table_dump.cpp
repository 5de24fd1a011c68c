// SPDX-License-Identifier: GPL-2.0-or-later
#include "table_dump.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include "domain.h"
#include "sort_buffer.h"
#include "stop_run.h"
#include "update.h"

namespace LAMMPS_NS {

TableDump::TableDump(LAMMPS* lmp, int narg, char** arg) : Dump(lmp, narg, arg) {
  if (narg > 5) stop_run(lmp, *this, std::string("unknown argument ") + arg[5]);
  if (binary) stop_run(lmp, *this, std::string("is text only, not ") + filename);
  gzipped_ = compressed != 0;
  compressed = 0;  // the base class would close a pipe to a shell
}

TableDump::~TableDump() {
  if (multifile || !fp) return;
  // The base class closes what is still open, which is too late for gzip.
  fclose(fp);
  fp = NULL;
  finish_file();
}

void TableDump::init_style() {
  if (domain->triclinic) stop_run(lmp, *this, "does not support a triclinic box");
  require_folder(lmp, *this, filename);
  // Of 'dump_modify format', one conversion for all real numbers makes sense here.
  const char* const format_real = format_user ? format_user : "%.16g";
  const char* const letter = format_real + std::strlen(format_real) - 1;
  if (format_real[0] != '%' || !std::strchr("efgEFG", *letter) ||
      std::strcspn(format_real + 1, "% *lL") != std::strlen(format_real) - 1)
    stop_run(lmp, *this, std::string("format is '") + format_real + "', expected one like %.16g");
  delete[] format;
  format = new char[std::strlen(format_real) + 1];
  std::strcpy(format, format_real);
  domain->boundary_string(boundstr);
  sort_by_column();
  if (!multifile) openfile();
}

/// 'sort id' of the base class takes the rows for the atoms of the group where their number is the
/// same, and a place in the file for each id: a contact's row has an id that others have too.
void TableDump::sort_by_column() {
  if (!sortBuffer || !sortBuffer->sort_set() || sortBuffer->get_sortcol() != 0) return;
  const auto is_id = [this](const rodpack::DumpColumn& column) { return column.name == id_; };
  const auto place = std::find_if(columns_.begin(), columns_.end(), is_id) - columns_.begin();
  const std::string number = std::to_string(place + 1);
  const char* const by_column[] = {"sort", number.c_str()};
  sortBuffer->modify_param(2, by_column);
}

void TableDump::write() {
  Dump::write();
  if (multifile && filewriter) finish_file();
}

// Replaces Dump::openfile, which hands the name of a compressed file to a shell.
void TableDump::openfile() {
  if (singlefile_opened) return;
  if (!multifile) singlefile_opened = 1;
  const std::string name =
      name_at_step(multiproc ? multiname : filename, update->ntimestep, padflag);
  fp = NULL;
  if (!filewriter) return;
  const OutputFile::Kind kind = append_flag ? OutputFile::Kind::appended
                                : multifile ? OutputFile::Kind::whole
                                            : OutputFile::Kind::growing;
  fp = file_.open(name, kind, gzipped_);
  if (!fp)
    stop_run_from_one_rank(lmp, *this, "Cannot open dump file " + name + ": " + strerror(errno));
}

void TableDump::finish_file() {
  const std::string fault = file_.finish();
  if (!fault.empty())
    stop_run_from_one_rank(lmp, *this, "Cannot write dump file " + file_.name() + ": " + fault);
}

int TableDump::count() {
  rows_.clear();
  list_rows();
  return static_cast<int>(rows_.size() / columns_.size());
}

void TableDump::pack(int*) { std::copy(rows_.begin(), rows_.end(), buf); }

void TableDump::write_header(bigint entries) {
  // As LAMMPS writes it: whoever reads metres must not take these numbers for metres.
  if (std::strcmp(update->unit_style, "si") != 0)
    fprintf(fp, "ITEM: UNITS\n%s\n", update->unit_style);
  fprintf(fp, "ITEM: TIMESTEP\n" BIGINT_FORMAT "\n", update->ntimestep);
  fprintf(fp, "ITEM: NUMBER OF %s\n" BIGINT_FORMAT "\n", label_.c_str(), entries);
  fprintf(fp, "ITEM: BOX BOUNDS %s\n", boundstr);
  fprintf(fp, "%.16g %.16g\n%.16g %.16g\n%.16g %.16g\n", boxxlo, boxxhi, boxylo, boxyhi, boxzlo,
          boxzhi);
  fprintf(fp, "ITEM: %s", label_.c_str());
  for (const rodpack::DumpColumn& column : columns_) fprintf(fp, " %s", column.name);
  fputc('\n', fp);
}

void TableDump::write_data(int lines, double* values) {
  for (int line = 0; line < lines; ++line) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (k) fputc(' ', fp);
      if (columns_[k].is_integer)
        fprintf(fp, "%.0f", *values++);
      else
        fprintf(fp, format, *values++);
    }
    fputc('\n', fp);
  }
  const std::string fault = OutputFile::flush(fp);
  if (!fault.empty())
    stop_run_from_one_rank(lmp, *this, "Cannot write dump file " + file_.name() + ": " + fault);
}

}  // namespace LAMMPS_NS
