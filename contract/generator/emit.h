#pragma once
#include <filesystem>

#include "contract/generator/emit_registers.h"
#include "contract/generator/output.h"
#include "contract/generator/parameters.h"

/// From tables to files: one emitter a kind of output.
namespace ptm::contract {

/// Every table of the folder.
struct Tables {
  Parameters parameters;
  PortTables port;
};

/// Throws TableError.
[[nodiscard]] Tables read_tables(const std::filesystem::path& folder);

/// The files of all emitters.
[[nodiscard]] Outputs all_outputs(const Tables& tables);

/// Structs of C++ with their presets, ranges and texts.
void emit_cpp_parameters(const Parameters& parameters, Outputs& outputs);
/// Parameter lists and maps of SystemVerilog modules, and the modules that check parameters.
void emit_sv_parameters(const Parameters& parameters, Outputs& outputs);
/// Presets and verilated variants, for CMake, scripts and C++.
void emit_variants(const Parameters& parameters, Outputs& outputs);
/// Tables of docs/spec.
void emit_docs_parameters(const Parameters& parameters, Outputs& outputs);

}  // namespace ptm::contract
