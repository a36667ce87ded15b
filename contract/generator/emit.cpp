#include "contract/generator/emit.h"

namespace ptm::contract {

Tables read_tables(const std::filesystem::path& folder) { return {read_parameters(folder)}; }

Outputs all_outputs(const Tables& tables) {
  Outputs outputs;
  emit_cpp_parameters(tables.parameters, outputs);
  emit_sv_parameters(tables.parameters, outputs);
  emit_docs_parameters(tables.parameters, outputs);
  emit_variants(tables.parameters, outputs);
  return outputs;
}

}  // namespace ptm::contract
