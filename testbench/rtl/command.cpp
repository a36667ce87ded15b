#include "testbench/rtl/command.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "golden/files/ending_signals.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

/// How a program ended, as one process tells another through a pipe.
struct Ending {
  int error = 0;   ///< errno if it could not be started
  int status = 0;  ///< waitpid's
};

/// What exec() needs, made before fork(): between the two nothing may be allocated.
struct Execution {
  std::vector<char*> argv, envp;
  std::string log, folder;
};

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

/// Ours, with some replaced.
std::vector<std::string> environment_with(const std::vector<std::string>& replaced) {
  std::vector<std::string> all = replaced;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    const std::string name = text.substr(0, text.find('=') + 1);
    bool ours = true;
    for (const std::string& other : replaced) ours = ours && !other.starts_with(name);
    if (ours) all.push_back(text);
  }
  return all;
}

void tell(int pipe, const Ending& ending) {
  // Shorter than PIPE_BUF: written as a whole. Without a reader there is nobody to tell.
  [[maybe_unused]] const ssize_t written = write(pipe, &ending, sizeof ending);
}

[[noreturn]] void execute(const Execution& execution, const sigset_t& mask, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  const int input = open("/dev/null", O_RDONLY);
  if (input >= 0 && dup2(input, STDIN_FILENO) >= 0 && chdir(execution.folder.c_str()) == 0) {
    const int log = open(execution.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0644);
    if (log >= 0 && dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0) {
      execvpe(execution.argv[0], execution.argv.data(), execution.envp.data());
    }
  }
  tell(pipe, {errno, 0});
  _exit(127);
}

/// The number of a process's parent, 0 if it is gone: "pid (any name) state parent ...".
pid_t parent_of(const fs::path& process) {
  std::ifstream file(process / "stat");
  std::string text;
  std::getline(file, text, '\0');
  const std::size_t name = text.rfind(')');
  pid_t parent = 0;
  char state = 0;
  if (name != std::string::npos) std::istringstream(text.substr(name + 1)) >> state >> parent;
  return parent;
}

/// Ends all processes below this one. A process whose parent has ended becomes this one's child.
void end_children() {
  do {
    std::error_code error;
    for (fs::directory_iterator entry("/proc", error), end; !error && entry != end;
         entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      pid_t process = 0;
      std::from_chars(name.data(), name.data() + name.size(), process);
      if (process > 0 && parent_of(entry->path()) == getpid()) kill(process, SIGKILL);
    }
    if (error) return;  // no /proc: those that it would name end with their parents
  } while (waitpid(-1, nullptr, 0) > 0);
}

/// A process between this program and the other one: whatever ends this program, the guard lives
/// long enough to end all that the other one has started. (Ninja's compilers, say, are in process
/// groups of their own and would go on.)
[[noreturn]] void guard(const Execution& execution, pid_t program, int pipe) {
  sigset_t watched, before;
  sigemptyset(&watched);
  for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&watched, signal);
  sigprocmask(SIG_BLOCK, &watched, &before);
  golden::leave_ending_signals();
  for (const int signal : {SIGCHLD, SIGTERM}) std::signal(signal, SIG_DFL);  // were they ignored
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != program) _exit(127);
  const pid_t child = fork();
  if (child == 0) execute(execution, before, pipe);
  if (child < 0) {
    tell(pipe, {errno, 0});
    _exit(127);
  }
  for (;;) {
    int signal = 0;
    sigwait(&watched, &signal);
    if (signal != SIGCHLD) break;
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(-1, &status, WNOHANG)) > 0 && ended != child) {
    }
    if (ended != child) continue;
    end_children();
    tell(pipe, {0, status});
    _exit(0);
  }
  end_children();
  _exit(127);
}

}  // namespace

bool find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / name;
    if (access(file.c_str(), X_OK) == 0 && !fs::is_directory(file)) return true;
  }
  return false;
}

int run_command(const std::vector<std::string>& command, const fs::path& log,
                const fs::path& folder, const std::vector<std::string>& environment) {
  std::vector<std::string> words = command, variables = environment_with(environment);
  const Execution execution{pointers(words), pointers(variables), log.string(), folder.string()};
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t program = getpid();
  const pid_t process = fork();
  if (process == 0) guard(execution, program, ends[1]);
  const int error = errno;
  close(ends[1]);
  Ending ending{0, SIGTERM};  // of a guard that was told to end
  if (process > 0) {
    const golden::TerminatedOnSignal told(process);
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
    [[maybe_unused]] const ssize_t count = read(ends[0], &ending, sizeof ending);
  } else {
    ending.error = error;
  }
  close(ends[0]);
  if (ending.error != 0) {
    throw std::system_error(ending.error, std::generic_category(), command.front());
  }
  return WIFEXITED(ending.status) ? WEXITSTATUS(ending.status) : 128 + WTERMSIG(ending.status);
}

}  // namespace ptm::testbench
