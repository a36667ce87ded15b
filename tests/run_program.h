#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ptm::tests {

/// How a command of the program ended.
struct Outcome {
  int code = -1;  ///< exit code, -1 if a signal ended it
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::string quoted(const std::filesystem::path& path) {
  std::string text(1, '\'');
  text.append(path.string()).push_back('\'');
  return text;
}

/// The program as a user runs it, in a folder of the test's own that is gone afterwards.
class Program : public testing::Test {
 protected:
  Program() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "_" + info->name();
    for (char& c : name) c = c == '/' ? '_' : c;
    folder_ = std::filesystem::temp_directory_path() / (name + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "files");
  }
  ~Program() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// A file of the test.
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_ / "files" / name;
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
    return file(name);
  }
  [[nodiscard]] std::size_t count_files() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::recursive_directory_iterator(folder_ / "files")) {
      ++count;
    }
    return count;
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const auto out = folder_ / "out", err = folder_ / "err";
    std::string command = quoted(PTM_PROGRAM);
    command.append(" ").append(arguments);
    command.append(" >").append(quoted(out)).append(" 2>").append(quoted(err));
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
  }

  /// The command ends with code 3, says what is wrong and where, and leaves nothing behind.
  void expect_refused(const std::string& arguments, const std::string& says) const {
    const std::size_t before = count_files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(": found "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(", expected "), std::string::npos) << outcome.err;
    EXPECT_EQ(count_files(), before) << "something was left behind";
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace ptm::tests
