// Written by scripts/contract from contract/registers.toml and its neighbours.
//
// The register port of the texture unit.
package ptm_register_pkg;
  `include "contract/ptm_registers.svh"
endpackage
