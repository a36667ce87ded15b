#include "testbench/compare/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "golden/scene/toml_reader.h"

namespace ptm::testbench {
namespace {

using golden::Reader;
using golden::TableReader;

constexpr double kAny = std::numeric_limits<double>::max();

std::optional<double> read_limit(const TableReader& table, std::string_view key, double most) {
  if (!table.has(key)) return {};
  double value = 0;
  table.read(key, value, 0, most);
  return value;
}

Limits read_number_limits(const TableReader& table) {
  Limits limits;
  limits.absolute = read_limit(table, "absolute", kAny);
  limits.relative = read_limit(table, "relative", kAny);
  table.read("decrease", limits.decrease);
  return limits;
}

Limits read_pixel_limits(const TableReader& table) {
  Limits limits;
  limits.share = read_limit(table, "share", 1);
  limits.levels = read_limit(table, "levels", 255);
  return limits;
}

std::vector<std::string> read_paths(const Reader& reader, const toml::node& node) {
  std::vector<std::string> paths;
  const toml::array& array = reader.array(node, "ignore");
  for (std::size_t i = 0; i < array.size(); ++i) {
    paths.push_back(reader.text(array[i], "ignore[" + std::to_string(i) + "]"));
  }
  return paths;
}

Tolerance::Rule read_rule(const Reader& reader, const toml::node& node, const std::string& name) {
  const TableReader table(reader, reader.table(node, name), name + ".");
  table.only({"path", "absolute", "relative", "decrease", "share", "levels"});
  Tolerance::Rule rule;
  if (!table.has("path")) table.fail("", "no path", "the path of what may differ");
  table.read("path", rule.path);
  rule.limits = read_number_limits(table);
  const Limits pixels = read_pixel_limits(table);
  rule.limits.share = pixels.share;
  rule.limits.levels = pixels.levels;
  return rule;
}

bool within(const RunDifference& difference, const Limits& limits) {
  if (difference.pixels) {
    const ModelPixels& pixels = *difference.pixels;
    const double share =
        static_cast<double>(pixels.differing) / static_cast<double>(pixels.samples);
    if (!limits.share && !limits.levels) return false;
    return share <= limits.share.value_or(1) && pixels.max <= limits.levels.value_or(255);
  }
  const std::optional<double> amount = difference.amount();
  if (!amount || difference.kind == DifferenceKind::pixels) return false;
  if (limits.decrease && *amount < 0) return true;
  const double whole = std::abs(difference.a.get<double>());
  return std::abs(*amount) <= limits.absolute.value_or(0) + limits.relative.value_or(0) * whole;
}

}  // namespace

bool fits(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0, star = std::string_view::npos, retry = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      retry = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p, ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++retry;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

bool Tolerance::allows(const RunDifference& difference) const {
  const auto fitting = [&](const std::string& pattern) { return fits(pattern, difference.path); };
  if (std::any_of(ignore.begin(), ignore.end(), fitting)) return true;
  // A thing that is there once only, and a setting, has no size: only `ignore` allows it.
  if (difference.kind == DifferenceKind::structure ||
      difference.kind == DifferenceKind::configuration) {
    return false;
  }
  if (difference.kind == DifferenceKind::lists) return lists;
  const auto rule =
      std::find_if(rules.begin(), rules.end(), [&](const Rule& one) { return fitting(one.path); });
  if (rule != rules.end()) return within(difference, rule->limits);
  const auto kind = kinds.find(difference.kind);
  return kind != kinds.end() && within(difference, kind->second);
}

Tolerance read_tolerance(const std::filesystem::path& path) {
  using enum DifferenceKind;
  const toml::table root = golden::parse_toml(path, "a tolerance file in TOML");
  const Reader reader(path.string());
  const TableReader table(reader, root, "");
  table.only({"ignore", "lists", "pixels", "cycles", "counters", "figures", "allow"});
  Tolerance tolerance;
  tolerance.file = path.string();
  if (const toml::node* ignore = table.find("ignore")) {
    tolerance.ignore = read_paths(reader, *ignore);
  }
  table.read("lists", tolerance.lists);
  if (table.has("pixels")) {
    const TableReader limits = table.table("pixels");
    limits.only({"share", "levels"});
    tolerance.kinds[pixels] = read_pixel_limits(limits);
  }
  for (const DifferenceKind kind : {cycles, counters, figures}) {
    if (!table.has(kind_name(kind))) continue;
    const TableReader limits = table.table(kind_name(kind));
    limits.only({"absolute", "relative", "decrease"});
    tolerance.kinds[kind] = read_number_limits(limits);
  }
  if (const toml::node* allow = table.find("allow")) {
    const toml::array& rules = reader.array(*allow, "allow");
    for (std::size_t i = 0; i < rules.size(); ++i) {
      tolerance.rules.push_back(read_rule(reader, rules[i], "allow[" + std::to_string(i) + "]"));
    }
  }
  return tolerance;
}

}  // namespace ptm::testbench
