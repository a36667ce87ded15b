#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "golden/scene/unit_scene.h"

namespace ptm::golden {

/// Files of one test, removed afterwards.
class MadeScene : public testing::Test {
 protected:
  MadeScene() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string(info->name()) + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
  }
  ~MadeScene() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  [[nodiscard]] UnitScene read(const std::string& text) const {
    return read_unit_scene(write("scene.toml", text));
  }
  /// What reading a scene complains about: "place|found|expected", or "nothing".
  [[nodiscard]] std::string complaint(const std::string& text) const {
    return complaint_of([&] { (void)read(text); });
  }
  template <class Work>
  [[nodiscard]] static std::string complaint_of(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      return error.place() + "|" + error.found() + "|" + error.expected();
    }
    return "nothing";
  }

  std::filesystem::path folder_;
};

}  // namespace ptm::golden
