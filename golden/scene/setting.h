#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// Keys of a scene's [hardware] and [memory]. Which there are and what they may be is the
/// contract's (contract/parameters.toml), of which golden knows nothing.
namespace ptm::golden {

struct Setting {
  enum class Kind : std::uint8_t {
    number,  ///< an integer
    flag,    ///< true or false
    word,    ///< a string
    other,   ///< what is none of these; `text` names it: "an array"
    any      ///< of a command line, which has texts only
  };
  std::string name{};   ///< "guard"
  std::string text{};   ///< "6", "true", "nearest"
  std::string key{};    ///< as errors name it: "hardware.guard"
  std::string place{};  ///< where it is said: "line 12"
  Kind kind = Kind::any;
};

struct Settings {
  std::string place{};          ///< of the table: "line 10 (hardware)"; empty if the scene has none
  std::vector<Setting> list{};  ///< in the order of the file; one that comes later counts
};

}  // namespace ptm::golden
