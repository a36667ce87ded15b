#include "model/pipeline/elaborated.h"

namespace ptm::pipeline {
namespace {

void append(const sc_core::sc_object& top, std::vector<Elaborated>& out) {
  out.push_back({top.name(), top.kind()});
  for (const sc_core::sc_object* child : top.get_child_objects()) append(*child, out);
}

}  // namespace

std::vector<Elaborated> elaborated(const sc_core::sc_object& top) {
  std::vector<Elaborated> out;
  append(top, out);
  return out;
}

std::vector<Elaborated> elaborated() {
  std::vector<Elaborated> out;
  for (const sc_core::sc_object* top : sc_core::sc_get_top_level_objects()) append(*top, out);
  return out;
}

std::vector<std::string> module_names(const std::vector<Elaborated>& objects) {
  std::vector<std::string> out;
  for (const Elaborated& object : objects) {
    if (object.kind == "sc_module") out.push_back(object.name);
  }
  return out;
}

}  // namespace ptm::pipeline
