#pragma once
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace ptm::tests {

/// A program's exit code (-1 if a signal ended it) and the most memory it held.
struct Measured {
  int code = -1;
  long peak_kib = 0;
};

/// Runs the program with its output thrown away.
inline Measured run_measured(std::vector<std::string> arguments) {
  std::vector<char*> words{const_cast<char*>(PTM_PROGRAM)};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    execv(PTM_PROGRAM, words.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child) return {};
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, usage.ru_maxrss};
}

}  // namespace ptm::tests
