// SPDX-License-Identifier: GPL-2.0-or-later
#include "output_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

extern char** environ;

namespace LAMMPS_NS {

std::FILE* OutputFile::open(const std::string& name, Kind kind, bool compressed) {
  name_ = name;
  written_to_ = kind == Kind::whole ? name + ".part" : name;
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (kind == Kind::appended ? O_APPEND : O_TRUNC);
  const int file = ::open(written_to_.c_str(), flags, 0666);
  if (file < 0) return NULL;
  return compressed ? open_gzip(file) : fdopen(file, "w");
}

/// gzip, without a shell in between that would take a name apart.
std::FILE* OutputFile::open_gzip(int file) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    close(file);
    return NULL;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, file, STDOUT_FILENO);
  char program[] = "gzip", level[] = "-6", to_output[] = "-c";
  char* const words[] = {program, level, to_output, NULL};
  const int failed = posix_spawnp(&gzip_, program, &actions, NULL, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  close(file);
  if (failed) {
    close(ends[1]);
    gzip_ = -1;
    errno = failed;
    return NULL;
  }
  return fdopen(ends[1], "w");
}

std::string OutputFile::flush(std::FILE* file) {
  errno = 0;
  if (std::fflush(file) == 0 && !std::ferror(file)) return "";
  return errno ? std::strerror(errno) : "an earlier write has failed";
}

std::string OutputFile::finish() {
  if (gzip_ >= 0) {
    int status = 0;
    const bool ended = waitpid(gzip_, &status, 0) == gzip_ && status == 0;
    gzip_ = -1;
    if (!ended) return "gzip has failed";
  }
  if (written_to_ != name_ && std::rename(written_to_.c_str(), name_.c_str()) != 0)
    return std::strerror(errno);
  return "";
}

std::string fault_of_folder(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : file.substr(0, slash + 1);
  struct stat found;
  if (stat(folder.c_str(), &found) != 0)
    return "folder " + folder + ": " + std::strerror(errno) + ", expected a folder that is there";
  if (!S_ISDIR(found.st_mode)) return folder + " is no folder";
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return "folder " + folder + ": " + std::strerror(errno);
  return "";
}

}  // namespace LAMMPS_NS
