#include "testbench/config/configuration.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>
#include <span>

#include "golden/files/input_error.h"

namespace ptm::testbench {
namespace {

using golden::InputError;
using golden::Setting;
using reference::EvalConfig;
using reference::ParameterFault;
using reference::ParameterRow;
using reference::ParameterTable;
using reference::UnitConfig;

std::string full_place(const Setting& setting) {
  if (setting.kind == Setting::Kind::any) return setting.place;  // it has the name
  return setting.place + " (" + setting.key + ")";
}

template <class Config>
void add_names(std::string& list) {
  for (const ParameterRow& row : ParameterTable<Config>::rows()) {
    list.append(list.empty() ? "" : ", ").append(row.name);
  }
}

/// "12 to 256" becomes "an integer from 12 to 256"; a list stays. Of a flag, true is what may be
/// forbidden.
std::string expected_value(const ParameterRow& row, const std::string& range) {
  if (row.kind == reference::ParameterKind::flag) return "false with the others as they are";
  const auto first = static_cast<unsigned char>(range.front());
  const bool bounds = std::isdigit(first) || range.front() == '-';
  if (row.kind != reference::ParameterKind::number || !bounds) return range;
  return range.find(" to ") == std::string::npos ? range : "an integer from " + range;
}

/// Whether TOML's kind of value is the parameter's. A word of a flag or number is none.
bool fits_kind(const ParameterRow& row, Setting::Kind kind) {
  switch (kind) {
    case Setting::Kind::any:
      return true;
    case Setting::Kind::number:
      return row.kind == reference::ParameterKind::number;
    case Setting::Kind::flag:
      return row.kind == reference::ParameterKind::flag;
    case Setting::Kind::word:
      return row.kind == reference::ParameterKind::choice;
    case Setting::Kind::other:
      break;
  }
  return false;
}

std::string kind_words(const Setting& setting) {
  switch (setting.kind) {
    case Setting::Kind::number:
      return "an integer";
    case Setting::Kind::flag:
      return "a boolean";
    case Setting::Kind::word:
      return "a string";
    default:
      return setting.text;
  }
}

/// What a parameter may be with all others as they are: "an integer from 1 to 3".
template <class Config>
std::string expected_of(Config config, std::size_t index) {
  const ParameterRow& row = ParameterTable<Config>::rows()[index];
  if (row.kind != reference::ParameterKind::number) return reference::expected_text(row);
  ParameterTable<Config>::set(config, index, -std::int64_t{1} << 30);
  const auto fault = ParameterTable<Config>::fault(config);
  return fault && fault->name == row.name ? expected_value(row, fault->expected)
                                          : reference::expected_text(row);
}

/// The row of that name in any of the tables; null if there is none.
template <class... Configs>
const ParameterRow* find_row(const std::string& name) {
  const ParameterRow* found = nullptr;
  const auto look = [&](std::span<const ParameterRow> rows) {
    for (const ParameterRow& row : rows) {
      if (row.name == name) found = &row;
    }
  };
  (look(ParameterTable<Configs>::rows()), ...);
  return found;
}

class Maker {
 public:
  explicit Maker(const SettingsOf& settings) : settings_(settings) {}

  Configuration make(bool whole_unit) {
    read_preset();
    for (const Setting& setting : settings_.hardware.list) {
      if (setting.name != "preset") set_hardware(setting);
    }
    // The counter of that name is one of the counters.
    if (!made_.unit.counters && !made_.find_named("duplicate_lines")) {
      made_.unit.duplicate_lines = false;
    }
    check(whole_unit);
    read_memory();
    return std::move(made_);
  }

 private:
  [[noreturn]] void fail(const Setting& setting, const std::string& found,
                         const std::string& expected) const {
    throw InputError(settings_.file, full_place(setting), found, expected);
  }

  void read_preset() {
    for (const Setting& setting : settings_.hardware.list) {
      if (setting.name != "preset") continue;
      if (setting.kind != Setting::Kind::word && setting.kind != Setting::Kind::any) {
        fail(setting, kind_words(setting), "a string");
      }
      try {
        made_.eval = reference::find_preset(setting.text).config;
      } catch (const std::invalid_argument&) {
        fail(setting, "preset '" + setting.text + "'", preset_names());
      }
    }
  }

  static std::string preset_names() {
    std::string names;
    for (std::size_t i = 0; i < reference::kPresets.size(); ++i) {
      names += i == 0 ? "" : i + 1 == reference::kPresets.size() ? " or " : ", ";
      names += reference::kPresets[i].name;
    }
    return names;
  }

  template <class Config>
  bool set_in(Config& config, const Setting& setting) {
    const auto index = reference::find_parameter<Config>(setting.name);
    if (!index) return false;
    const ParameterRow& row = ParameterTable<Config>::rows()[*index];
    if (!fits_kind(row, setting.kind))
      fail(setting, kind_words(setting), expected_of(config, *index));
    const auto value = reference::parse_parameter(row, setting.text);
    if (!value) fail(setting, found_of(setting), expected_of(config, *index));
    // A member has 32 bits unless its range needs more.
    Config changed = config;
    ParameterTable<Config>::set(changed, *index, *value);
    if (ParameterTable<Config>::get(changed, *index) != *value) {
      fail(setting, found_of(setting), expected_of(config, *index));
    }
    config = changed;
    return true;
  }

  static std::string found_of(const Setting& setting) {
    if (setting.kind == Setting::Kind::any) return setting.name + " = " + setting.text;
    return setting.kind == Setting::Kind::word ? "'" + setting.text + "'" : setting.text;
  }

  void set_hardware(const Setting& setting) {
    if (!set_in(made_.eval, setting) && !set_in(made_.unit, setting)) {
      std::string names = "preset";
      add_names<EvalConfig>(names);
      add_names<UnitConfig>(names);
      throw InputError(settings_.file, setting.place, "unknown key '" + setting.key + "'",
                       "one of " + names);
    }
    std::erase_if(made_.named, [&](const Setting& other) { return other.name == setting.name; });
    made_.named.push_back(setting);
  }

  void check(bool whole_unit) const {
    if (const auto fault = whole_unit ? reference::unit_fault(made_.eval, made_.unit)
                                      : ParameterTable<EvalConfig>::fault(made_.eval)) {
      refuse(*fault, settings_.hardware);
    }
    if (const auto fault = ParameterTable<UnitConfig>::fault(made_.unit)) {
      refuse(*fault, settings_.hardware);
    }
  }

  /// Where the parameter is named; else its table, with its name.
  [[noreturn]] void refuse(const ParameterFault& fault, const golden::Settings& table) const {
    const ParameterRow* row = find_row<EvalConfig, UnitConfig, pipeline::FixedMemory,
                                       pipeline::DramMemory, pipeline::RandomMemory>(fault.name);
    const std::string expected = row ? expected_value(*row, fault.expected) : fault.expected;
    const auto found = std::find_if(table.list.rbegin(), table.list.rend(),
                                    [&](const Setting& s) { return s.name == fault.name; });
    if (found != table.list.rend()) fail(*found, found_of(*found), expected);
    std::string place = table.place;
    if (place.empty() && !table.list.empty()) place = full_place(table.list.back());
    throw InputError(settings_.file, place.empty() ? "the parameters" : place,
                     fault.name + " = " + fault.found, expected);
  }

  void read_memory() {
    std::string kind = "fixed";
    for (const Setting& setting : settings_.memory.list) {
      if (setting.name != "kind") continue;
      if (setting.kind != Setting::Kind::word && setting.kind != Setting::Kind::any) {
        fail(setting, kind_words(setting), "a string");
      }
      if (setting.text != "fixed" && setting.text != "dram" && setting.text != "random") {
        fail(setting, "'" + setting.text + "'", "one of fixed, dram, random");
      }
      kind = setting.text;
    }
    if (kind == "dram") {
      made_.memory = read_kind<pipeline::DramMemory>();
    } else if (kind == "random") {
      made_.memory = read_kind<pipeline::RandomMemory>();
    } else {
      made_.memory = read_kind<pipeline::FixedMemory>();
    }
  }

  template <class Memory>
  Memory read_kind() {
    Memory memory;
    for (const Setting& setting : settings_.memory.list) {
      if (setting.name == "kind" || set_in(memory, setting)) continue;
      std::string names = "kind";
      add_names<Memory>(names);
      throw InputError(settings_.file, setting.place, "unknown key '" + setting.key + "'",
                       "one of " + names);
    }
    if (const auto fault = ParameterTable<Memory>::fault(memory)) refuse(*fault, settings_.memory);
    return memory;
  }

  const SettingsOf& settings_;
  Configuration made_;
};

template <class Config>
void write_parameters(const Config& config, std::string& text) {
  using Table = ParameterTable<Config>;
  for (std::size_t i = 0; i < Table::kCount; ++i) {
    const ParameterRow& row = Table::rows()[i];
    const std::string value = reference::parameter_text(row, Table::get(config, i));
    const bool word = row.kind == reference::ParameterKind::choice;
    text += std::string(row.name) + " = " + (word ? "\"" + value + "\"" : value) + "\n";
  }
}

}  // namespace

const Setting* Configuration::find_named(std::string_view parameter) const {
  const auto found = std::find_if(named.begin(), named.end(),
                                  [&](const Setting& s) { return s.name == parameter; });
  return found == named.end() ? nullptr : &*found;
}

Configuration make_configuration(const SettingsOf& settings) { return Maker(settings).make(false); }

Configuration make_unit_configuration(const SettingsOf& settings) {
  return Maker(settings).make(true);
}

bool is_preset(const EvalConfig& config) {
  return std::any_of(reference::kPresets.begin(), reference::kPresets.end(),
                     [&](const reference::Preset& preset) { return preset.config == config; });
}

std::string name_of(const EvalConfig& config) {
  using Table = ParameterTable<EvalConfig>;
  std::string name;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const reference::Preset& preset : reference::kPresets) {
    std::string differences;
    std::size_t count = 0;
    for (std::size_t i = 0; i < Table::kCount; ++i) {
      const std::int64_t value = Table::get(config, i);
      if (value == Table::get(preset.config, i)) continue;
      const ParameterRow& row = Table::rows()[i];
      differences += (count++ == 0 ? " with " : ", ") + std::string(row.name) + " = " +
                     reference::parameter_text(row, value);
    }
    // Of two that are as near, base.
    if (count < fewest || (count == fewest && preset.config == reference::kBase)) {
      fewest = count;
      name = std::string(preset.name) + differences;
    }
  }
  return name;
}

std::string memory_kind(const pipeline::MemoryModel& memory) {
  if (std::holds_alternative<pipeline::DramMemory>(memory)) return "dram";
  return std::holds_alternative<pipeline::RandomMemory>(memory) ? "random" : "fixed";
}

std::string configuration_toml(const Configuration& configuration) {
  std::string text = "[hardware]\n";
  write_parameters(configuration.eval, text);
  write_parameters(configuration.unit, text);
  text += "\n[memory]\nkind = \"" + memory_kind(configuration.memory) + "\"\n";
  std::visit([&](const auto& memory) { write_parameters(memory, text); }, configuration.memory);
  return text;
}

}  // namespace ptm::testbench
