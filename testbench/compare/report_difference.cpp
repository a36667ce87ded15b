#include "testbench/compare/report_difference.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;
using enum DifferenceKind;

bool has(const std::string& path, const char* part) { return path.find(part) != std::string::npos; }

/// Long lists, of which it is said only that they differ.
bool is_list(const std::string& path) {
  return path == "worst" || path == "unit.window" || path.ends_with(".histogram") ||
         path.ends_with(".lines_per_window");
}

bool is_configuration(const std::string& path) {
  if (path.starts_with("unit.draws[")) return !path.ends_with(".cycles_per_pixel");
  return path.starts_with("scene.") || path.starts_with("config.") || path == "unit.memory" ||
         path == "unit.effect_blocks" || path.ends_with(".together");
}

DifferenceKind kind_of(const std::string& path) {
  if (is_configuration(path)) return configuration;
  if (path == "agree" || path == "unit.late_pixels" || path == "unit.differing_counters") {
    return agreement;
  }
  if (is_list(path)) return lists;
  if (path == "notes" || path == "effects.notes") return notes;
  if (path.ends_with(".cycles")) return cycles;
  const bool costs =
      path.starts_with("effects.") &&
      (has(path, ".multiplies.") || path.ends_with(".words") || path.ends_with(".lines_read"));
  return costs || has(path, ".counters.") ? counters : figures;
}

/// The name of a list's entry, where lists hold entries with names.
std::string name_of(const std::string& path, const Json& entry) {
  const auto text = [&](const char* key) {
    const auto found = entry.find(key);
    return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  if (!entry.is_object()) return {};
  if (path == "differences") return text("a") + "-" + text("b");
  if (path == "presets") return text("preset");
  if (path == "unit.draws") return text("object");
  if (path == "effects.without") return text("effect");
  return {};
}

/// Entries by their names; nothing unless all have one, each another.
std::optional<Json> by_names(const std::string& path, const Json& list) {
  Json named = Json::object();
  for (const Json& entry : list) {
    const std::string name = name_of(path, entry);
    if (name.empty() || named.contains(name)) return {};
    named[name] = entry;
  }
  return named;
}

const Json* at(const Json& json, std::initializer_list<std::string> keys) {
  const Json* found = &json;
  for (const std::string& key : keys) {
    if (!found->is_object() || !found->contains(key)) return nullptr;
    found = &(*found)[key];
  }
  return found;
}

class Walk {
 public:
  Walk(const Json& a, const Json& b) : a_(a), b_(b) {
    for (const auto* other : {&a, &b}) {
      const Json& here = *at(other == &a ? a : b, {"models"});
      const Json& there = *at(other == &a ? b : a, {"models"});
      for (const auto& [name, ignored] : here.items()) {
        if (!there.contains(name)) lonely_.insert(name);
      }
    }
  }

  std::vector<RunDifference> run() {
    visit("", a_, b_);
    return std::move(found_);
  }

 private:
  /// What is not looked at, or stands elsewhere too.
  [[nodiscard]] bool passed_over(const std::string& path) const {
    static const std::set<std::string> outside{"version", "made_by", "timing"};
    if (outside.contains(path)) return true;
    for (const char* name : {".picture", ".pictures", ".digests"}) {
      if (path.starts_with("models.") && path.ends_with(name)) return true;
    }
    return of_a_lonely_model(path) || repeats(path);
  }

  /// Pairs with a model that one run has not, and its times: that it is missing is said once.
  [[nodiscard]] bool of_a_lonely_model(const std::string& path) const {
    for (const std::string& model : lonely_) {
      if (path.starts_with("differences[") &&
          (has(path, ("[" + model + "-").c_str()) || has(path, ("-" + model + "]").c_str()))) {
        return true;
      }
      if (path == "unit.timings." + model) return true;
      if (model == "pipeline" && path == "unit.timings.loose") return true;
      if (model == "golden" && path.starts_with("presets[")) return true;
      if (path == "worst") return true;  // its entries hold values of every model
    }
    return false;
  }

  /// A counter of a unit's model that `models` has as well, a counter of cycles, and the sentence
  /// on a memory whose parameters differ.
  [[nodiscard]] bool repeats(const std::string& path) const {
    if (path == "unit.memory") {
      const Json *x = at(a_, {"config", "memory"}), *y = at(b_, {"config", "memory"});
      return x != nullptr && y != nullptr && *x != *y;
    }
    const std::string timings = "unit.timings.", middle = ".counters.";
    const std::size_t cut = path.find(middle);
    if (cut == std::string::npos) return false;
    const std::string counter = path.substr(cut + middle.size());
    if (path.starts_with(timings)) {
      const std::string model = path.substr(timings.size(), cut - timings.size());
      return same({"unit", "timings", model, "counters", counter},
                  {"models", model, "counters", counter});
    }
    const std::string models = "models.";
    const std::string model = path.substr(models.size(), cut - models.size());
    return counter == "cycles" &&
           same({"models", model, "counters", counter}, {"models", model, "cycles"});
  }

  /// Whether two places of a report are there and equal, in both reports.
  [[nodiscard]] bool same(std::initializer_list<std::string> one,
                          std::initializer_list<std::string> other) const {
    for (const Json* json : {&a_, &b_}) {
      const Json *x = at(*json, one), *y = at(*json, other);
      if (x == nullptr || y == nullptr || *x != *y) return false;
    }
    return true;
  }

  void visit(const std::string& path, const Json& a, const Json& b) {
    if (a == b) return;
    if (a.is_object() && b.is_object() && !is_list(path)) return visit_members(path, a, b, false);
    if (a.is_array() && b.is_array()) {
      const auto x = by_names(path, a), y = by_names(path, b);
      if (x && y && !(x->empty() && y->empty())) return visit_members(path, *x, *y, true);
    }
    // In what order an object's members stand does not matter, within lists either.
    if (nlohmann::json(a) != nlohmann::json(b)) add(kind_of(path), path, a, b);
  }

  void visit_members(const std::string& path, const Json& a, const Json& b, bool list) {
    const auto inner = [&](const std::string& key) {
      return list ? path + "[" + key + "]" : path.empty() ? key : path + "." + key;
    };
    for (const auto& [key, value] : a.items()) {
      const std::string place = inner(key);
      if (passed_over(place)) continue;
      if (b.contains(key)) {
        visit(place, value, b[key]);
      } else {
        add(structure, place, value, nullptr, "A");
      }
    }
    for (const auto& [key, value] : b.items()) {
      const std::string place = inner(key);
      if (!a.contains(key) && !passed_over(place)) add(structure, place, nullptr, value, "B");
    }
  }

  void add(DifferenceKind kind, const std::string& path, const Json& a, const Json& b,
           const std::string& only = {}) {
    RunDifference& found = found_.emplace_back();
    found.kind = kind;
    found.path = path;
    // What a long list, or all of a section, holds is nothing to be read in a message.
    const bool whole = kind == lists || kind == structure;
    found.a = whole ? Json(nullptr) : a;
    found.b = whole ? Json(nullptr) : b;
    found.only = only;
  }

  const Json &a_, &b_;
  std::set<std::string> lonely_;
  std::vector<RunDifference> found_;
};

}  // namespace

std::vector<RunDifference> compare_reports(const Json& a, const Json& b) {
  return Walk(a, b).run();
}

}  // namespace ptm::testbench
