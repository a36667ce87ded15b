#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ptm::tests {

/// What a run of the program left behind.
struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string quoted(const std::filesystem::path& path) {
  std::string text(1, '\'');
  text.append(path.string()).push_back('\'');
  return text;
}

/// Runs ptmsim as a user does. Its output goes to files whose names begin with `log`.
inline Outcome run_program(const std::filesystem::path& log, const std::string& arguments) {
  const std::filesystem::path out = log.string() + ".out", err = log.string() + ".err";
  std::string command = quoted(PTM_PROGRAM);
  command.append(" ").append(arguments);
  command.append(" >").append(quoted(out)).append(" 2>").append(quoted(err));
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

}  // namespace ptm::tests
