#pragma once
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "tests/faults/commands.h"
#include "tests/faults/started_program.h"

namespace ptm::tests {

/// Ends a command in turn by SIGKILL, SIGTERM and SIGINT, where nothing was before or where an
/// earlier run's files are: at moments drawn from its whole duration, and every other time at one
/// soon after it began to write, which is a small part of the whole.
class Kills : public Program, public testing::WithParamInterface<const char*> {
 protected:
  using Duration = std::chrono::duration<double>;
  static constexpr int kSide = 160;
  static constexpr unsigned kSeed = 20240;

  void SetUp() override {
    for (const WritingCommand& command : writing_commands(file("in"), kSide)) {
      if (command.name == GetParam()) command_ = command;
    }
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run(shell_words(words_for(command_, made("new")))).code, 0);
    duration_ = std::chrono::steady_clock::now() - start;
    for (const std::string& name : command_.files) whole_[name] = text_of(file("new") / name);
    ASSERT_EQ(names_in(file("new")), command_.files);
  }

  void kill_at_moments(int count) {
    std::mt19937 random(kSeed);
    // A little beyond the end: the last moments of a slow run count, too.
    std::uniform_real_distribution<double> share(0, 1.2);
    for (int n = 0; n < count; ++n) {
      const int signal = std::array{SIGKILL, SIGTERM, SIGINT}[static_cast<std::size_t>(n) % 3];
      const bool writing = n % 2 == 1;
      const Duration moment = writing ? kWriting * share(random) : duration_ * share(random);
      SCOPED_TRACE("kill " + std::to_string(n) + " by signal " + std::to_string(signal) + ", " +
                   std::to_string(moment.count()) + " s after its " +
                   (writing ? "first file" : "start"));
      kill_once(signal, moment, writing, n / 3 % 2 == 1);
    }
    std::cout << killed_ << " of " << count << " were killed before their end, " << left_
              << " left temporary files\n";
    EXPECT_GT(killed_, count / 4);
  }

 private:
  static constexpr Duration kWriting = std::chrono::milliseconds(3);

  [[nodiscard]] std::filesystem::path made(const std::string& name) const {
    std::filesystem::create_directories(file(name));
    return file(name);
  }

  void kill_once(int signal, Duration moment, bool writing, bool over_old_files) {
    std::filesystem::remove_all(file("out"));
    const std::filesystem::path out = made("out");
    for (const std::string& name : command_.files) {
      if (over_old_files) std::ofstream(out / name) << "old";
    }
    const StartedProgram program(words_for(command_, out), file("log"));
    const auto begin = std::chrono::steady_clock::now();
    while (writing && names_in(out).size() <= (over_old_files ? command_.files.size() : 0) &&
           std::chrono::steady_clock::now() - begin < 2 * duration_) {
    }
    std::this_thread::sleep_for(moment);
    program.send(signal);
    const int status = program.wait();
    EXPECT_EQ(StartedProgram::orphans(), 0) << "processes that go on";
    if (WIFSIGNALED(status)) {
      EXPECT_EQ(WTERMSIG(status), signal);
      ++killed_;
    } else {
      EXPECT_EQ(WEXITSTATUS(status), 0) << text_of(file("log"));
    }
    for (const std::string& name : names_in(out)) {
      if (whole_.contains(name)) {
        EXPECT_TRUE(is_whole(name, text_of(out / name), over_old_files)) << name;
        continue;
      }
      EXPECT_EQ(signal, SIGKILL) << "a signal that can be caught leaves " << name;
      EXPECT_EQ(name.front(), '.') << "a temporary file is hidden: " << name;
      ++left_;
    }
    if (signal != SIGKILL) return;
    EXPECT_EQ(run(shell_words(words_for(command_, out))).code, 0);
    EXPECT_EQ(names_in(out), command_.files) << "the next run removes what is left";
  }

  /// Reports hold durations, so no two are equal.
  [[nodiscard]] bool is_whole(const std::string& name, const std::string& text,
                              bool old_files) const {
    if (text == whole_.at(name) || (old_files && text == "old")) return true;
    if (name.ends_with(".json")) return nlohmann::json::accept(text);
    return name.ends_with(".html") && text.ends_with("</html>\n");
  }

  WritingCommand command_;
  Duration duration_{};
  std::map<std::string, std::string> whole_;
  int killed_ = 0, left_ = 0;
};

inline std::string kills_name(const testing::TestParamInfo<const char*>& command) {
  return command.param;
}

}  // namespace ptm::tests
