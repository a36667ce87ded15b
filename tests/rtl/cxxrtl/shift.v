// An arithmetic right shift as a logical one of a longer operand, for Yosys' techmap. CXXRTL's own,
// sshr() of cxxrtl.h in Yosys 0.23, writes beyond the value when the amount exceeds its width, and
// fills the wrong bits with the sign when the amount is 32 or more.
(* techmap_celltype = "$sshr" *)
module _ptm_sshr (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH  = 1;
  parameter B_WIDTH  = 1;
  parameter Y_WIDTH  = 1;
  parameter _TECHMAP_CONSTMSK_B_ = 0;
  parameter _TECHMAP_CONSTVAL_B_ = 0;
  input  [A_WIDTH-1:0] A;
  input  [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  // A constant amount is written in 32 bits.
  localparam Constant = _TECHMAP_CONSTMSK_B_ == ~{B_WIDTH{1'b0}};
  localparam Most = Constant ? _TECHMAP_CONSTVAL_B_ : 1 << B_WIDTH;
  wire _TECHMAP_FAIL_ = Constant ? _TECHMAP_CONSTVAL_B_ > 255 : B_WIDTH > 8;
  localparam Wide = (A_WIDTH > Y_WIDTH ? A_WIDTH : Y_WIDTH) + (Most > 256 ? 1 : Most);
  wire [Wide-1:0] wide = {{Wide{A_SIGNED ? A[A_WIDTH-1] : 1'b0}}, A};
  assign Y = wide >> B;
endmodule
