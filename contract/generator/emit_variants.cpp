#include "contract/generator/emit.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

/// "Name=value"
std::string setting(const Parameter& parameter, std::int64_t value) {
  return parameter.rtl + "=" + std::to_string(value);
}

/// Read by scripts/synthesize: a line a preset.
std::string presets_text(const Parameters& parameters) {
  Text text;
  text.line("# Parameters of ptm_evaluator, by preset (docs/spec/datapath.md).");
  text.line(
      "# Written by scripts/contract from contract/parameters.toml; scripts/synthesize reads it.");
  for (const std::string& preset : parameters.presets) {
    std::string row = preset;
    for (const Parameter& parameter : parameters.config("evaluator").parameters) {
      row += ' ' + setting(parameter, parameter.in_preset(preset));
    }
    text.line(row);
  }
  return text.str();
}

}  // namespace

void emit_variants(const Parameters& parameters, Outputs& outputs) {
  outputs.push_back({Output::Kind::committed, "rtl/presets.txt", presets_text(parameters)});
}

}  // namespace ptm::contract
