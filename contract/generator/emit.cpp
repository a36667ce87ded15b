#include "contract/generator/emit.h"

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

}  // namespace

Tables read_tables(const std::filesystem::path& folder) {
  const Parameters parameters = read_parameters(folder);
  return {parameters, read_port_tables(folder, names_of(parameters))};
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
