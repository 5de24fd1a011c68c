// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/analyse_runs.h"

#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>

#include "reading/data_error.h"

namespace rodpack {
namespace {

/// A process that analyses one run, and the file that takes what it prints.
struct Analysis {
  std::size_t run = 0;
  std::FILE* output = nullptr;
};

// Between fork and exec, where hardly anything may be called.
[[noreturn]] void become(const char* const* arguments, int output, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execv(arguments[0], const_cast<char* const*>(arguments));
  ::_exit(127);
}

std::string last_line(std::FILE* file) {
  std::rewind(file);
  std::string text, last;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
    if (c != '\n')
      text += static_cast<char>(c);
    else if (!text.empty())
      last.swap(text), text.clear();
  }
  return text.empty() ? last : text;
}

std::string ending(int status) {
  if (WIFSIGNALED(status)) return std::string("ended by signal ") + ::strsignal(WTERMSIG(status));
  return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

class Analyses {
 public:
  Analyses(const std::vector<std::string>& folders, const std::string& program)
      : folders_(folders), program_(program) {}

  std::size_t running() const { return running_.size(); }
  bool all_started() const { return next_ == folders_.size(); }
  const std::string& first_error() const { return first_error_; }

  void start() {
    Analysis analysis{next_++, std::tmpfile()};
    if (!analysis.output) throw DataError("no temporary file for the output of an analysis");
    const char* const arguments[] = {program_.c_str(), "analyse", folders_[analysis.run].c_str(),
                                     nullptr};
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0)
      throw DataError("no process for an analysis: " + std::string(std::strerror(errno)));
    if (child == 0) become(arguments, ::fileno(analysis.output), parent);
    running_[child] = analysis;
  }

  /// Waits for one of them to end. Returns its folder.
  const std::string& wait() {
    for (;;) {
      int status = 0;
      const pid_t child = ::wait(&status);
      if (child < 0 && errno == EINTR) continue;
      const auto found = running_.find(child);
      if (found == running_.end()) continue;
      const Analysis ended = found->second;
      running_.erase(found);
      const std::string& folder = folders_[ended.run];
      if (status != 0 && first_error_.empty()) {
        const auto line = last_line(ended.output);
        first_error_ = folder + ": its analysis " + ending(status);
        if (!line.empty()) first_error_.append(": ").append(line);
      }
      std::fclose(ended.output);
      return folder;
    }
  }

 private:
  const std::vector<std::string>& folders_;
  const std::string& program_;
  std::map<pid_t, Analysis> running_;
  std::size_t next_ = 0;
  std::string first_error_;
};

}  // namespace

void analyse_runs(const std::vector<std::string>& folders, int jobs, const std::string& program,
                  const AnalysisProgress& progress) {
  Analyses analyses(folders, program);
  std::size_t done = 0;
  while (!analyses.all_started() || analyses.running() > 0) {
    while (!analyses.all_started() && analyses.running() < static_cast<std::size_t>(jobs))
      analyses.start();
    const std::string& folder = analyses.wait();
    progress(++done, folders.size(), folder);
  }
  if (!analyses.first_error().empty()) throw DataError(analyses.first_error());
}

}  // namespace rodpack
