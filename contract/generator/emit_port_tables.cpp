#include "contract/generator/emit_registers.h"

namespace ptm::contract {

const ParameterName& PortTables::parameter(const std::string& name) const {
  for (const ParameterName& one : parameters) {
    if (one.name == name) return one;
  }
  throw std::out_of_range("no parameter " + name);
}

PortTables read_port_tables(const std::filesystem::path& folder,
                            const std::vector<ParameterName>& parameters) {
  std::vector<std::string> names;
  for (const ParameterName& parameter : parameters) names.push_back(parameter.name);
  PortTables tables;
  tables.parameters = parameters;
  tables.formats = read_formats(folder / "formats.toml");
  tables.counters = read_counters(folder / "counters.toml", names);

  tables.map = read_registers(folder / "registers.toml", {{}, {tables.formats.codes()}, names});

  return tables;
}

void emit_port_tables(const PortTables& tables, Outputs& outputs) {
  emit_cpp_registers(tables, outputs);
  emit_sv_registers(tables, outputs);
  emit_driver_header(tables, outputs);
  emit_register_description(tables, outputs);
  emit_docs_registers(tables, outputs);
  emit_counters(tables, outputs);
  emit_formats(tables, outputs);
}

}  // namespace ptm::contract
