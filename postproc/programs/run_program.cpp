// SPDX-License-Identifier: GPL-2.0-or-later
#include "programs/run_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "reading/data_error.h"

namespace rodpack {
namespace {

// What the new process does before it becomes the program.
class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> result;
  for (const auto& word : words) result.push_back(const_cast<char*>(word.c_str()));
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& variables) {
  std::vector<std::string> result;
  for (char** each = environ; *each; ++each) {
    const std::string text = *each;
    if (!variables.count(text.substr(0, text.find('=')))) result.push_back(text);
  }
  for (const auto& [name, value] : variables) result.push_back(std::string(name) + "=" + value);
  return result;
}

// A file without a name that holds the input: unlike a pipe it takes any length at once.
std::FILE* file_of(const std::string& text) {
  std::FILE* const file = std::tmpfile();
  if (!file || std::fwrite(text.data(), 1, text.size(), file) != text.size() ||
      std::fflush(file) != 0)
    throw DataError("no temporary file for the input of another program");
  std::rewind(file);
  return file;
}

}  // namespace

int run_program(const std::vector<std::string>& words, const ProgramSurroundings& surroundings) {
  const auto variables = environment_with(surroundings.variables);
  FileActions actions;
  std::FILE* const input = file_of(surroundings.input);
  posix_spawn_file_actions_adddup2(actions.get(), ::fileno(input), STDIN_FILENO);
  if (!surroundings.folder.empty())
    posix_spawn_file_actions_addchdir_np(actions.get(), surroundings.folder.c_str());
  if (!surroundings.output.empty()) {
    posix_spawn_file_actions_addopen(actions.get(), STDOUT_FILENO, surroundings.output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(actions.get(), STDOUT_FILENO, STDERR_FILENO);
  }
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, words.at(0).c_str(), actions.get(), nullptr,
                                   pointers(words).data(), pointers(variables).data());
  std::fclose(input);
  const auto& folder = surroundings.folder;
  if (error == ENOENT && (folder.empty() || std::filesystem::is_directory(folder))) return 127;
  if (error != 0) throw DataError(words[0] + ": cannot be started: " + std::strerror(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace rodpack
