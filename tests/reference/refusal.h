#pragma once
#include <stdexcept>
#include <string>

namespace ptm::tests {

/// The sentence with which act refuses its arguments; "none" if it does not.
template <class Act>
std::string refusal(Act act) {
  try {
    act();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

}  // namespace ptm::tests
