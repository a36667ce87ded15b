#pragma once
#include <string>
#include <vector>

#include "contract/generator/counters.h"
#include "contract/generator/formats.h"
#include "contract/generator/output.h"
#include "contract/generator/registers.h"

/// What is made of the tables of registers, counters and texel formats.
namespace ptm::contract {

/// A parameter as each language writes it: "extra_sets", "ExtraSets", "unit.extra_sets".
struct ParameterName {
  std::string name, rtl, cpp;
};

/// What the emitters of this file need.
struct PortTables {
  RegisterMap map;
  Counters counters;
  Formats formats;
  std::vector<ParameterName> parameters;
  [[nodiscard]] const ParameterName& parameter(const std::string& name) const;
};

/// Reads registers.toml, counters.toml and formats.toml of a folder. Throws TableError.
[[nodiscard]] PortTables read_port_tables(const std::filesystem::path& folder,
                                          const std::vector<ParameterName>& parameters);

/// contract/registers.h: constants, enumerations, addresses and fields; contract/stored_bits.inc
/// and contract/capability_words.inc: bodies of functions of model/reference/unit/register_map.cpp.
void emit_cpp_registers(const PortTables& tables, Outputs& outputs);
/// rtl/contract/ptm_register_pkg.sv: constants, addresses, fields, layouts; fragments of modules.
void emit_sv_registers(const PortTables& tables, Outputs& outputs);
/// contract/driver/ptm_unit.h
void emit_driver_header(const PortTables& tables, Outputs& outputs);
/// contract/driver/ptm_unit.rdl
void emit_register_description(const PortTables& tables, Outputs& outputs);
/// Tables of docs/spec.
void emit_docs_registers(const PortTables& tables, Outputs& outputs);
/// contract/counters.h; the rows of docs/spec, the names of docs/spec/report.schema.json.
void emit_counters(const PortTables& tables, Outputs& outputs);
/// contract/formats.h, rtl/contract/ptm_format_pkg.sv and tables of docs/spec.
void emit_formats(const PortTables& tables, Outputs& outputs);

/// All of them.
void emit_port_tables(const PortTables& tables, Outputs& outputs);

}  // namespace ptm::contract
