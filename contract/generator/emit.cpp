#include "contract/generator/emit.h"

#include "contract/generator/table.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

/// The integer that stands for a choice in the RTL, whatever the enumerators' order.
std::string place_of_choice(const Parameter& parameter, const std::string& value) {
  std::vector<std::string> terms;
  for (std::size_t n = 1; n < parameter.choices.size(); ++n) {
    terms.push_back("(" + value + " == " + parameter.type + "::" + parameter.choices[n] + " ? " +
                    std::to_string(n) + " : 0)");
  }
  return joined(terms, " + ");
}

std::vector<ParameterName> names_of(const Parameters& parameters) {
  std::vector<ParameterName> names;
  for (const std::string config : {"evaluator", "unit"}) {
    for (const Parameter& parameter : parameters.config(config).parameters) {
      std::string cpp = (config == "unit" ? "unit." : "config.") + parameter.name;
      if (parameter.kind == Parameter::Kind::choice) cpp = place_of_choice(parameter, cpp);
      names.push_back({parameter.name, parameter.rtl, cpp});
    }
  }
  return names;
}

/// A constant NAME_max says the most that the unit's parameter NAME may be.
void require_same_most(const Parameters& parameters, const RegisterMap& map) {
  constexpr std::string_view kEnd = "_max";
  for (const Constant& constant : map.constants) {
    if (!constant.name.ends_with(kEnd)) continue;
    const std::string name = constant.name.substr(0, constant.name.size() - kEnd.size());
    const Parameter* parameter = parameters.config("unit").find(name);
    if (parameter == nullptr || parameter->high.empty()) continue;
    if (parameter->high == std::to_string(constant.value)) continue;
    throw TableError("registers.toml: " + constant.name + " = " + std::to_string(constant.value) +
                     ", expected " + parameter->high + ", as parameters.toml says of " + name);
  }
}

}  // namespace

Tables read_tables(const std::filesystem::path& folder) {
  const Parameters parameters = read_parameters(folder);
  Tables tables{parameters, read_port_tables(folder, names_of(parameters))};
  require_same_most(tables.parameters, tables.port.map);
  return tables;
}

Outputs all_outputs(const Tables& tables) {
  Outputs outputs;
  emit_cpp_parameters(tables.parameters, outputs);
  emit_sv_parameters(tables.parameters, outputs);
  emit_docs_parameters(tables.parameters, outputs);
  emit_variants(tables.parameters, outputs);
  emit_port_tables(tables.port, outputs);
  return outputs;
}

}  // namespace ptm::contract
