#pragma once
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace ptm::tests {

/// The program in a process of its own, so that it can be killed at any moment. Processes that it
/// leaves behind become children of the test, which finds them so.
class StartedProgram {
 public:
  /// What it prints goes to `log`.
  StartedProgram(std::vector<std::string> words, const std::filesystem::path& log) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    words.insert(words.begin(), PTM_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }

  void send(int signal) const { kill(process_, signal); }
  /// Its wait status.
  [[nodiscard]] int wait() const {
    int status = 0;
    waitpid(process_, &status, 0);
    return status;
  }

  /// How many processes it left that have not ended within a time; they are ended.
  [[nodiscard]] static int orphans(std::chrono::milliseconds time = std::chrono::seconds(5)) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + time;
    int left = 0;
    for (;;) {
      siginfo_t child{};
      const pid_t ended = waitpid(-1, nullptr, WNOHANG);
      if (ended < 0) return left;
      if (ended > 0) continue;
      if (Clock::now() > end && waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0) {
        ++left;
        end_children();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

 private:
  static void end_children() {
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "stat");
      std::string text;
      std::getline(file, text);
      const std::size_t name = text.rfind(')');
      if (name == std::string::npos) continue;
      char state = 0;
      pid_t parent = 0;
      std::istringstream(text.substr(name + 1)) >> state >> parent;
      if (parent == getpid()) kill(std::stoi(entry.path().filename().string()), SIGKILL);
    }
  }

  pid_t process_ = -1;
};

}  // namespace ptm::tests
