#pragma once
#include <stdexcept>
#include <string>

namespace ptm::golden {

/// Input that cannot be used: a file, a scene, a number in it. The program ends with exit code 3.
///
///     FILE: PLACE: found FOUND, expected EXPECTED
///
/// `place` is what a person would look for: "line 5 (scales)", "byte 1234 (payload)", "light[2]".
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::string place, std::string found, std::string expected)
      : std::runtime_error(file + ": " + place + ": found " + found + ", expected " + expected),
        file_(std::move(file)),
        place_(std::move(place)),
        found_(std::move(found)),
        expected_(std::move(expected)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] const std::string& found() const { return found_; }
  [[nodiscard]] const std::string& expected() const { return expected_; }

 private:
  std::string file_, place_, found_, expected_;
};

}  // namespace ptm::golden
