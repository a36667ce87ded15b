#include "golden/files/ending_signals.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <string>

namespace ptm::golden {

/// Entries are reused and never freed: a handler may walk the list at any moment.
struct RemovedOnSignal::Entry {
  std::atomic<bool> used = false;
  bool folder = false;
  std::string path;  ///< changed only while not `used`
  Entry* next = nullptr;
};

namespace {

constexpr std::array kEnding{SIGHUP,  SIGINT,  SIGQUIT,   SIGPIPE, SIGALRM, SIGTERM,
                             SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGXCPU};

std::atomic<RemovedOnSignal::Entry*> first_entry = nullptr;
std::mutex entries_mutex;  ///< for those who register; the handler takes no lock
std::atomic<int> holds = 0;
std::atomic<int> held_signal = 0;
std::atomic<pid_t> terminated = 0;
std::atomic<pid_t> owner = 0;  ///< the process whose entries these are
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free &&
              std::atomic<RemovedOnSignal::Entry*>::is_always_lock_free);

/// Files, then folders until no more become empty. Calls only what a handler may call.
void remove_entries() {
  for (const auto* entry = first_entry.load(); entry != nullptr; entry = entry->next) {
    if (entry->used && !entry->folder) unlink(entry->path.c_str());
  }
  for (bool removed = true; removed;) {
    removed = false;
    for (const auto* entry = first_entry.load(); entry != nullptr; entry = entry->next) {
      if (entry->used && entry->folder && rmdir(entry->path.c_str()) == 0) removed = true;
    }
  }
}

/// Inside a handler the signal is blocked and ends the program when the handler returns.
void end_by(int signal) {
  remove_entries();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void on_signal(int signal) {
  const int error = errno;
  if (getpid() != owner) {  // forked, and not yet at leave_ending_signals()
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  } else {
    held_signal = signal;  // before asking for holds: whoever drops the last one looks after that
    if (holds == 0) {
      end_by(signal);
    } else if (const pid_t process = terminated; process > 0) {
      kill(process, SIGTERM);
    }
  }
  errno = error;
}

}  // namespace

void catch_ending_signals() {
  owner = getpid();
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : kEnding) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_DFL) {
      sigaction(signal, &action, nullptr);
    }
  }
}

void leave_ending_signals() {
  for (const int signal : kEnding) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) == 0 && present.sa_handler == on_signal) {
      std::signal(signal, SIG_DFL);
    }
  }
}

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& path, bool folder) {
  const std::lock_guard lock(entries_mutex);
  entry_ = first_entry;
  while (entry_ != nullptr && entry_->used) entry_ = entry_->next;
  const bool fresh = entry_ == nullptr;
  if (fresh) entry_ = new Entry;
  entry_->path = path.string();
  entry_->folder = folder;
  entry_->used = true;
  if (!fresh) return;
  entry_->next = first_entry;
  first_entry = entry_;
}

RemovedOnSignal::~RemovedOnSignal() { entry_->used = false; }

TerminatedOnSignal::TerminatedOnSignal(pid_t process) {
  terminated = process;
  // One that came since the process was started found nobody to tell.
  if (held_signal != 0) kill(process, SIGTERM);
}

TerminatedOnSignal::~TerminatedOnSignal() { terminated = 0; }

HeldSignals::HeldSignals() { ++holds; }

HeldSignals::~HeldSignals() {
  if (--holds == 0 && held_signal != 0) end_by(held_signal);
}

}  // namespace ptm::golden
