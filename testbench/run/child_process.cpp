#include "testbench/run/child_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "golden/files/ending_signals.h"
#include "golden/files/input_error.h"

namespace ptm::testbench {
namespace {

constexpr std::uint8_t kFine = 1;
constexpr std::uint8_t kThrew = 2;
constexpr int kThrewStatus = 70;

constexpr int kNoRoomStatus = 71;  ///< not even for what the work threw

std::string no_room(const char* reason) {
  return golden::InputError(P_tmpdir, "a model's results", reason,
                            "a folder for temporary files with room for them")
      .what();
}

[[noreturn]] void run_child(ResultFile& file, const ChildProcess::Work& work, pid_t parent) {
  golden::leave_ending_signals();
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // no model outlives the program that waits for it
  if (getppid() != parent) std::_Exit(kThrewStatus);
  // Nothing may be thrown from here: what called is the parent's to clear up.
  int status = 0;
  try {
    file.put(kFine);
    work(file);
    file.flush();
  } catch (const std::exception& error) {
    // A simulator's kernel wraps what is thrown within it.
    const std::string text = file.fault().empty() ? error.what() : file.fault();
    status = kThrewStatus;
    try {
      file.rewind();
      file.put(kThrew);
      file.put(text);
      file.flush();
    } catch (const std::exception&) {
      status = kNoRoomStatus;
    }
  }
  // The parent's buffers and exit handlers are not this process's to run.
  std::_Exit(status);
}

std::string ending(int status) {
  if (WIFSIGNALED(status)) return "ended by signal " + std::to_string(WTERMSIG(status));
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ResultFile::ResultFile() : file_(std::tmpfile(), &std::fclose) {
  if (!file_) fail();
}

void ResultFile::fail() {
  fault_ = no_room(std::strerror(errno));
  throw std::runtime_error(fault_);
}

void ResultFile::write(const void* data, std::size_t bytes) {
  if (bytes != 0 && std::fwrite(data, 1, bytes, file_.get()) != bytes) fail();
}

void ResultFile::read(void* data, std::size_t bytes) {
  if (bytes != 0 && std::fread(data, 1, bytes, file_.get()) != bytes) {
    throw std::runtime_error("a model's result is shorter than it says");
  }
}

void ResultFile::flush() {
  if (std::fflush(file_.get()) != 0) fail();
}

void ResultFile::rewind() { std::rewind(file_.get()); }

ChildProcess::ChildProcess(std::string what, const Work& work) : what_(std::move(what)) {
  std::cout.flush();
  std::cerr.flush();
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ < 0) throw std::system_error(errno, std::generic_category(), "fork for " + what_);
  if (child_ == 0) run_child(file_, work, parent);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : what_(std::move(other.what_)),
      file_(std::move(other.file_)),
      child_(std::exchange(other.child_, -1)) {}

ChildProcess::~ChildProcess() {
  if (child_ <= 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

ResultFile& ChildProcess::wait() {
  int status = 0;
  const pid_t child = std::exchange(child_, -1);
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), what_);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNoRoomStatus) {
    throw std::runtime_error(no_room(std::strerror(ENOSPC)));
  }
  const bool threw = WIFEXITED(status) && WEXITSTATUS(status) == kThrewStatus;
  if (status != 0 && !threw) throw std::runtime_error(what_ + " " + ending(status));
  file_.rewind();
  if (file_.get<std::uint8_t>() == kThrew) {
    const auto text = file_.get_vector<char>();
    throw std::runtime_error(what_ + ": " + std::string(text.begin(), text.end()));
  }
  return file_;
}

}  // namespace ptm::testbench
