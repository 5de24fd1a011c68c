// SPDX-License-Identifier: GPL-2.0-or-later
#include "restart_seal.h"

#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <vector>

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "output_file.h"
#include "run_parameters.h"

using LAMMPS_NS::LAMMPS;

namespace rodpack {

namespace {

/// Names of the files that are being written; several where a name has a %.
std::map<std::FILE*, std::string>& open_files() {
  static std::map<std::FILE*, std::string> files;
  return files;
}

std::string part_of(const std::string& name) { return name + ".part"; }

/// The last line of a file.
std::string seal(unsigned long long content, unsigned long long parameters, uLong crc) {
  char text[seal_size + 1];
  std::snprintf(text, sizeof text, "rodpack-restart-1 %016llx %016llx %08lx\n",
                content + parameters + seal_size, content, static_cast<unsigned long>(crc));
  return text;
}

/// CRC-32 of `size` bytes from the current place on; goes on from `crc`.
uLong crc_of(std::FILE* file, unsigned long long size, uLong crc) {
  std::vector<unsigned char> block(1 << 16);
  while (size > 0) {
    const std::size_t wanted = size < block.size() ? static_cast<std::size_t>(size) : block.size();
    const std::size_t count = std::fread(block.data(), 1, wanted, file);
    if (count == 0) break;
    crc = crc32(crc, block.data(), static_cast<uInt>(count));
    size -= count;
  }
  return crc;
}

/// Adds the seal; false where the file cannot be read or written.
bool add_seal(std::FILE* file) {
  const std::string parameters = LAMMPS_NS::run_parameters();
  if (std::ferror(file)) {
    // Once more, for the reason, which is not known any more.
    std::clearerr(file);
    std::fputc(0, file);
    std::fflush(file);
    return false;
  }
  if (std::fflush(file) != 0) return false;
  const long content = std::ftell(file);
  if (content < 0) return false;
  std::rewind(file);
  uLong crc = crc_of(file, static_cast<unsigned long long>(content), crc32(0, Z_NULL, 0));
  crc = crc32(crc, reinterpret_cast<const unsigned char*>(parameters.data()),
              static_cast<uInt>(parameters.size()));
  std::fseek(file, 0, SEEK_END);
  const std::string end =
      parameters + seal(static_cast<unsigned long long>(content), parameters.size(), crc);
  return std::fwrite(end.data(), 1, end.size(), file) == end.size() && std::fflush(file) == 0 &&
         !std::ferror(file) && fsync(fileno(file)) == 0;
}

}  // namespace

std::FILE* open_restart(const char* name) {
  std::FILE* const file = std::fopen(part_of(name).c_str(), "w+b");
  if (file) open_files()[file] = name;
  return file;
}

void close_restart(LAMMPS* lmp, std::FILE* file) {
  const std::string name = open_files()[file], part = part_of(name);
  open_files().erase(file);
  errno = 0;
  bool written = add_seal(file);
  int reason = errno;
  if (std::fclose(file) != 0 && written) {
    written = false;
    reason = errno;
  }
  if (written && std::rename(part.c_str(), name.c_str()) != 0) {
    written = false;
    reason = errno;
  }
  if (written) return;
  unlink(part.c_str());
  const std::string text = "Cannot write restart file " + name +
                           (reason ? std::string(": ") + std::strerror(reason) : "");
  lmp->error->one(FLERR, text.c_str());
}

void require_folder_of_restart(LAMMPS* lmp, const char* name) {
  if (lmp->comm->me != 0) return;
  const std::string fault = LAMMPS_NS::fault_of_folder(name);
  if (fault.empty()) return;
  const std::string text = std::string("Cannot write restart file ") + name + ": " + fault;
  lmp->error->one(FLERR, text.c_str());
}

std::string fault_of_restart(const char* name, std::string& parameters) {
  parameters.clear();
  std::FILE* const file = std::fopen(name, "rb");
  if (!file) return std::string("cannot be read: ") + std::strerror(errno);
  const std::string no_seal = "has no seal at its end: it is cut off or of another program";
  std::string fault;
  char line[seal_size + 1] = {};
  unsigned long long size = 0, content = 0;
  unsigned long crc = 0;
  std::fseek(file, 0, SEEK_END);
  const long length = std::ftell(file);
  if (length < seal_size || std::fseek(file, -seal_size, SEEK_END) != 0 ||
      std::fread(line, 1, seal_size, file) != seal_size ||
      std::sscanf(line, "rodpack-restart-1 %llx %llx %lx\n", &size, &content, &crc) != 3) {
    fault = no_seal;
  } else if (size != static_cast<unsigned long long>(length) || content > size - seal_size ||
             line != seal(content, size - seal_size - content, crc)) {
    fault = "is damaged: its length is " + std::to_string(length) + ", its seal says " +
            std::to_string(size);
  } else {
    std::rewind(file);
    if (crc_of(file, size - seal_size, crc32(0, Z_NULL, 0)) != crc)
      fault = "is damaged: its checksum is not that of its seal";
  }
  if (fault.empty()) {
    parameters.resize(static_cast<std::size_t>(size - seal_size - content));
    std::fseek(file, static_cast<long>(content), SEEK_SET);
    if (std::fread(&parameters[0], 1, parameters.size(), file) != parameters.size())
      fault = "cannot be read";
  }
  std::fclose(file);
  return fault;
}

void require_whole_restart(LAMMPS* lmp, const char* name, bool unsealed) {
  std::string parameters;
  const std::string fault = fault_of_restart(name, parameters);
  LAMMPS_NS::parameters_of_restart() = parameters;
  if (fault.empty()) return;
  const bool no_seal = fault.find("no seal") != std::string::npos;
  if (unsealed && no_seal) return;
  const std::string text = std::string("Restart file ") + name + " " + fault +
                           (no_seal ? " (then: 'read_restart FILE unsealed')" : "");
  lmp->error->one(FLERR, text.c_str());
}

}  // namespace rodpack
