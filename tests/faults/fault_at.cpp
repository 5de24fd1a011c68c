// SPDX-License-Identifier: GPL-2.0-or-later
// Runs a program and, at the N-th system call by which it changes a file under a folder, kills it
// or lets the call fail as on a full disk. Settings come from the environment, so that it can stand
// in for the program in scripts:
//   FAULT_PROGRAM  the program
//   FAULT_UNDER    the folder, as /proc names it
//   FAULT_AT       N, counted from 1; 0: never
//   FAULT_KIND     kill or full
//   FAULT_COUNT    file that receives how many such calls there were
// Exit status: the program's, or 128 + its signal; 77 where it cannot trace. Linux on x86-64.
#if defined(__linux__) && defined(__x86_64__)

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

namespace {

std::string setting(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// What a link of /proc leads to.
std::string target(pid_t pid, const std::string& link) {
  char text[4096];
  const std::string name = "/proc/" + std::to_string(pid) + "/" + link;
  const ssize_t size = readlink(name.c_str(), text, sizeof text);
  return size > 0 ? std::string(text, static_cast<std::size_t>(size)) : "";
}

/// A text in the memory of the program.
std::string text_at(pid_t pid, unsigned long long address) {
  std::string text;
  for (;; address += sizeof(long)) {
    errno = 0;
    const long word = ptrace(PTRACE_PEEKDATA, pid, address, 0);
    if (errno) return text;
    for (unsigned shift = 0; shift < 64; shift += 8) {
      const char c = static_cast<char>(static_cast<unsigned long>(word) >> shift);
      if (c == '\0') return text;
      text += c;
    }
  }
}

/// Whether a call changes a file under the folder.
bool changes_a_file(pid_t pid, const user_regs_struct& call, const std::string& under) {
  std::string file;
  switch (call.orig_rax) {
    case SYS_write:
    case SYS_pwrite64:
    case SYS_writev:
    case SYS_fsync:
    case SYS_ftruncate:
      file = target(pid, "fd/" + std::to_string(call.rdi));
      break;
    case SYS_rename:
    case SYS_mkdir:
    case SYS_unlink:
      file = text_at(pid, call.rdi);
      if (!file.empty() && file[0] != '/') file = target(pid, "cwd") + "/" + file;
      break;
    default:
      return false;
  }
  return file.compare(0, under.size(), under) == 0;
}

/// Follows the program to its end and returns its status; sets `count`.
int follow(pid_t pid, long& count) {
  const std::string under = setting("FAULT_UNDER");
  const long at = std::atol(setting("FAULT_AT").c_str());
  const bool kills = setting("FAULT_KIND") == "kill";
  int status = 0;
  bool entering = true, fails = false;
  waitpid(pid, &status, 0);
  ptrace(PTRACE_SETOPTIONS, pid, 0, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
  int deliver = 0;
  while (ptrace(PTRACE_SYSCALL, pid, 0, deliver) == 0 && waitpid(pid, &status, 0) == pid &&
         WIFSTOPPED(status)) {
    deliver = 0;
    if (WSTOPSIG(status) != (SIGTRAP | 0x80)) {
      if (WSTOPSIG(status) != SIGTRAP) deliver = WSTOPSIG(status);
      continue;
    }
    user_regs_struct call;
    ptrace(PTRACE_GETREGS, pid, 0, &call);
    if (entering && changes_a_file(pid, call, under) && ++count == at) {
      if (kills) {
        kill(pid, SIGKILL);
        waitpid(pid, &status, 0);
        return status;
      }
      fails = true;
      call.orig_rax = static_cast<unsigned long long>(-1);  // no call at all
      ptrace(PTRACE_SETREGS, pid, 0, &call);
    } else if (!entering && fails) {
      fails = false;
      call.rax = static_cast<unsigned long long>(-ENOSPC);
      ptrace(PTRACE_SETREGS, pid, 0, &call);
    }
    entering = !entering;
  }
  return status;
}

}  // namespace

int main(int, char** argv) {
  const std::string program = setting("FAULT_PROGRAM");
  const pid_t pid = fork();
  if (pid == 0) {
    if (ptrace(PTRACE_TRACEME, 0, 0, 0) != 0) _exit(77);
    argv[0] = const_cast<char*>(program.c_str());
    execv(program.c_str(), argv);
    _exit(127);
  }
  long count = 0;
  const int status = follow(pid, count);
  if (!setting("FAULT_COUNT").empty()) std::ofstream(setting("FAULT_COUNT")) << count << '\n';
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

#else

int main() { return 77; }

#endif
