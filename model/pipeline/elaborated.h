#pragma once
#include <string>
#include <systemc>
#include <vector>

namespace ptm::pipeline {

/// Something that SystemC was asked to make: a module, process, port, export, signal or FIFO.
struct Elaborated {
  std::string name;  ///< full: "unit.address"
  std::string kind;  ///< SystemC's word: "sc_module", "sc_thread_process", ...
  bool operator==(const Elaborated&) const = default;
};

/// The object and all below it, each before its children, in the order of their making.
[[nodiscard]] std::vector<Elaborated> elaborated(const sc_core::sc_object& top);
/// All of the process.
[[nodiscard]] std::vector<Elaborated> elaborated();
/// The modules' names alone.
[[nodiscard]] std::vector<std::string> module_names(const std::vector<Elaborated>& objects);

}  // namespace ptm::pipeline
