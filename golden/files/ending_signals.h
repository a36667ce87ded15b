#pragma once
#include <sys/types.h>

#include <filesystem>

/// What is to be gone when a signal ends the program: temporary files and folders, and programs it
/// started.
///
/// The signals meant are those that a person or a system sends to end a program (SIGINT, SIGTERM,
/// SIGHUP, SIGPIPE and the like). The program still ends by the signal itself, so that whoever
/// waits for it sees which it was. SIGKILL cannot be caught: what it leaves, FolderClaim removes.
namespace ptm::golden {

/// From now on these signals remove what is registered below. A signal that is ignored stays
/// ignored. Called once, by main().
void catch_ending_signals();

/// For a process that was forked: signals end it at once and remove nothing, since all that is
/// registered is its parent's. Safe to call between fork() and exec().
void leave_ending_signals();

/// A path that is removed if a signal ends the program while this object stands. Every other end
/// of the path is the owner's duty. Register a path before it is created.
class RemovedOnSignal {
 public:
  /// `folder`: one that is removed only if nothing lies in it.
  explicit RemovedOnSignal(const std::filesystem::path& path, bool folder = false);
  ~RemovedOnSignal();
  RemovedOnSignal(const RemovedOnSignal&) = delete;
  RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;

  struct Entry;

 private:
  Entry* entry_;
};

/// A process that gets SIGTERM when a signal arrives that HeldSignals hold back; one at a time.
class TerminatedOnSignal {
 public:
  explicit TerminatedOnSignal(pid_t process);
  ~TerminatedOnSignal();
  TerminatedOnSignal(const TerminatedOnSignal&) = delete;
  TerminatedOnSignal& operator=(const TerminatedOnSignal&) = delete;
};

/// While one stands, a signal waits: for work that must be undone by more than removing a file, or
/// that should not stop half-way. The last one that goes lets the signal end the program.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
};

}  // namespace ptm::golden
