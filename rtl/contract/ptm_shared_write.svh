// Written by scripts/contract from contract/registers.toml and its neighbours.
// Whether a write is of what fragments read: docs/spec/unit.md, Registers.
function automatic logic is_shared_write(input logic [15:0] address,
                                         input logic [31:0] data);
  is_shared_write = address[15:8] == 8'h00 ||
                    (address == ptm_register_pkg::CommandAddr && data[0] != '0) ||
                    address == ptm_register_pkg::MemoryLinesAddr ||
                    address == ptm_register_pkg::MemoryBaseAddr ||
                    (CoefBits > 10 && address == ptm_register_pkg::PaletteUpperAddr) ||
                    address[15:7] == 9'h050 ||
                    address[15:10] == 6'h0c ||
                    address[15:11] == 5'h08 ||
                    address[15] == 1'h1;
endfunction
