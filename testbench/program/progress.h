#pragma once
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <iostream>
#include <string>

namespace ptm::testbench {

/// A progress bar on the error stream, where that is a terminal and the work takes over two
/// seconds; silent otherwise.
class Progress {
 public:
  Progress(std::string what, std::size_t total)
      : what_(std::move(what)), total_(total), start_(Clock::now()), shown_(start_) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (drawn_) std::cerr << "\r\033[K" << std::flush;
  }

  void step() {
    ++done_;
    const auto now = Clock::now();
    if (!terminal_ || now - start_ < std::chrono::seconds(2)) return;
    if (drawn_ && now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    drawn_ = true;
    const std::size_t filled = total_ > 0 ? kWidth * done_ / total_ : kWidth;
    std::cerr << '\r' << what_ << " [" << std::string(filled, '#')
              << std::string(kWidth - filled, '.') << "] " << done_ << " of " << total_
              << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kWidth = 40;

  std::string what_;
  std::size_t total_, done_ = 0;
  Clock::time_point start_, shown_;
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  bool drawn_ = false;
};

}  // namespace ptm::testbench
