#include <algorithm>

#include "golden/scene/scene_parts.h"

namespace ptm::golden {

Settings read_settings(const TableReader& table) {
  Settings settings;
  settings.place = table.place("");
  std::vector<std::pair<toml::source_position, Setting>> found;
  table.each([&](std::string_view key, const toml::source_region& where, const toml::node& node) {
    Setting setting{.name = std::string(key),
                    .text = {},
                    .key = table.name(key),
                    .place = "line " + std::to_string(where.begin.line),
                    .kind = Setting::Kind::other};
    if (const auto* number = node.as_integer()) {
      setting.kind = Setting::Kind::number;
      setting.text = std::to_string(number->get());
    } else if (const auto* flag = node.as_boolean()) {
      setting.kind = Setting::Kind::flag;
      setting.text = flag->get() ? "true" : "false";
    } else if (const auto* word = node.as_string()) {
      setting.kind = Setting::Kind::word;
      setting.text = word->get();
    } else {
      setting.text = Reader::kind_of(node);
    }
    found.emplace_back(where.begin, std::move(setting));
  });
  // toml++ keeps keys in the order of their names.
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [where, setting] : found) settings.list.push_back(std::move(setting));
  return settings;
}

StressSpec read_stress(const TableReader& table) {
  table.only({"input_gap", "output_stall", "seed"});
  StressSpec stress;
  // Of 256 cycles at most 255: at 256 nothing would ever move.
  table.read("input_gap", stress.input_gap, 0, 255);
  table.read("output_stall", stress.output_stall, 0, 255);
  table.read("seed", stress.seed);
  return stress;
}

}  // namespace ptm::golden
