// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

namespace LAMMPS_NS {

namespace {

std::string fault(const std::string& what) { return what + ": " + std::strerror(errno); }

/// Who holds a lock, as it is written into its file.
std::string owner() {
  char host[256] = "?", since[64] = "?";
  gethostname(host, sizeof host - 1);
  const std::time_t now = std::time(NULL);
  std::strftime(since, sizeof since, "%Y-%m-%d %H:%M:%S", std::localtime(&now));
  return "process " + std::to_string(getpid()) + " on " + host + ", since " + since + "\n";
}

std::string first_line(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line.empty() ? "another process" : line;
}

/// Calls `act` with the name of each file of a folder; a folder that is not there has none.
std::string for_each_file(const std::string& folder,
                          const std::function<std::string(const std::string&)>& act) {
  DIR* const directory = opendir(folder.c_str());
  if (!directory) return errno == ENOENT ? "" : fault("cannot read folder " + folder);
  std::vector<std::string> names;
  while (const dirent* entry = readdir(directory)) names.push_back(entry->d_name);
  closedir(directory);
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    std::string what = act(name);
    if (!what.empty()) return what;
  }
  return "";
}

std::string lock_of(const std::string& folder) { return folder + "/.lock"; }

/// The lock files of this process, open, by their folders.
std::map<std::string, int>& locks() {
  static std::map<std::string, int> files;
  return files;
}

/// Whether a folder is still the one whose lock this process took, if it took one: LIGGGHTS makes
/// folders anew for its dumps and restart files.
std::string check_lock(const std::string& folder) {
  const auto lock = locks().find(folder);
  if (lock == locks().end()) return "";
  struct stat there, held;
  const bool same = stat(lock_of(folder).c_str(), &there) == 0 && fstat(lock->second, &held) == 0 &&
                    there.st_ino == held.st_ino && there.st_dev == held.st_dev;
  return same ? "" : "this is no longer the folder that was opened, which was moved or removed";
}

std::string remove_file(const std::string& file) {
  return unlink(file.c_str()) == 0 ? "" : fault("cannot remove " + file);
}

/// Step in a name such as bodies.1200.dump, by an expression whose first group it is; -1 without.
long long step_of(const std::string& name, const char* expression) {
  std::smatch match;
  if (!std::regex_match(name, match, std::regex(expression))) return -1;
  return std::atoll(match[1].str().c_str());
}

}  // namespace

const char* const a_plain_path =
    "a path without blanks, quotes and any of ` $ # & * % ; | < > ( ) \\, that does not begin with "
    "-";

bool is_plain_path(const std::string& text) {
  return !text.empty() && text[0] != '-' &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) {
           return c > ' ' && c != 127 && !std::strchr("\"'`$#&*%;|<>()\\", c);
         });
}

std::string make_folder(const std::string& folder) {
  for (std::size_t end = folder.find('/', 1);; end = folder.find('/', end + 1)) {
    const std::string part = folder.substr(0, end);
    struct stat found;
    if (mkdir(part.c_str(), 0777) != 0 && errno != EEXIST)
      return fault("cannot make folder " + part);
    if (stat(part.c_str(), &found) != 0 || !S_ISDIR(found.st_mode)) return part + " is no folder";
    if (end == std::string::npos) return "";
  }
}

std::string lock_folder(const std::string& folder, double seconds) {
  const std::string name = lock_of(folder);
  // Kept open until the process ends, however that happens: then the system frees the lock.
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return fault("cannot open " + name);
  for (double waited = 0.0; flock(file, LOCK_EX | LOCK_NB) != 0; waited += 0.1) {
    if (errno != EWOULDBLOCK) break;  // a file system without locks
    if (waited >= seconds) {
      close(file);
      return "another run is at work in it: " + first_line(name);
    }
    usleep(100000);
  }
  const std::string text = owner();
  if (ftruncate(file, 0) != 0 ||
      pwrite(file, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    return fault("cannot write " + name);
  locks()[folder] = file;
  return "";
}

std::string write_whole(const std::string& file, const std::string& text) {
  std::string what = check_lock(file.substr(0, file.rfind('/')));
  if (!what.empty()) return what;
  const std::string part = file + ".part";
  std::FILE* const out = std::fopen(part.c_str(), "w");
  if (!out) return fault("cannot write " + part);
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), out) == text.size() &&
                       std::fflush(out) == 0 && fsync(fileno(out)) == 0;
  if (!written) what = fault("cannot write " + part);
  if (std::fclose(out) != 0 && what.empty()) what = fault("cannot write " + part);
  if (what.empty() && std::rename(part.c_str(), file.c_str()) != 0)
    what = fault("cannot write " + file);
  if (!what.empty()) unlink(part.c_str());
  return what;
}

std::string cut_table(const std::string& file, long long step) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return "";
  std::stringstream content;
  content << in.rdbuf();
  const std::string text = content.str();
  std::string kept;
  std::ptrdiff_t commas = -1;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    const std::string row = text.substr(begin, end - begin);
    const std::ptrdiff_t in_row = std::count(row.begin(), row.end(), ',');
    const bool head = commas < 0;
    if (head) commas = in_row;
    if (head || (in_row == commas && std::atoll(row.c_str()) <= step)) kept += row + "\n";
  }
  return kept == text ? "" : write_whole(file, kept);
}

std::string remove_unfinished(const std::string& folder) {
  return for_each_file(folder, [&](const std::string& name) -> std::string {
    if (name.size() < 5 || name.compare(name.size() - 5, 5, ".part") != 0) return "";
    return remove_file(folder + "/" + name);
  });
}

std::string remove_later_dumps(const std::string& folder, long long step) {
  return for_each_file(folder, [&](const std::string& name) -> std::string {
    if (step_of(name, ".*\\.([0-9]+)\\.(dump(\\.gz)?|json)") <= step) return "";
    return remove_file(folder + "/" + name);
  });
}

std::string rename_later_restarts(const std::string& folder, long long step,
                                  const std::string& kept) {
  struct stat of_kept = {};
  stat(kept.c_str(), &of_kept);
  return for_each_file(folder, [&](const std::string& name) -> std::string {
    const bool end = std::regex_match(name, std::regex(".*\\.end\\.restart"));
    if (!end && step_of(name, ".*\\.([0-9]+)\\.restart") <= step) return "";
    const std::string file = folder + "/" + name;
    struct stat found;
    if (stat(file.c_str(), &found) == 0 && found.st_ino == of_kept.st_ino &&
        found.st_dev == of_kept.st_dev)
      return "";
    const std::string away = file + ".superseded";
    return std::rename(file.c_str(), away.c_str()) == 0 ? "" : fault("cannot rename " + file);
  });
}

}  // namespace LAMMPS_NS
