// The extra passes of the fragment in O, which leave before the map's own: which one is sent, of
// which coefficient set, with which light.                      docs/spec/effects.md, Draw and X1
//
// Twin: extra passes of the evaluator's source in model/pipeline.
module ptm_filter_extra_passes #(
  parameter int HalfVector = 0,
  parameter int ExtraSets  = 0,
  localparam int EffectW = ptm_unit_pkg::EffectW
) (
  input  logic                                    clk_i,
  input  logic                                    rst_ni,
  input  logic [ptm_unit_pkg::Draws*EffectW-1:0]  effects_i,  // effect_t, draw 0 lowest
  input  logic [ptm_unit_pkg::DrawBits-1:0]       draw_i,
  input  logic                                    sent_i,     // a pass leaves O,
  input  logic                                    last_i,     // its fragment's last
  output logic                                    extra_o,    // what O offers is an extra pass
  output logic [1:0]                              number_o,   // which
  output logic [2:0]                              passes_o,   // how many the fragment has
  output logic [2:0]                              set_o,      // 0: the map's polynomial, or set - 1
  output logic                                    half_o,     // with (hu, hv)
  output logic [6*12-1:0]                         bias_o,     // of the set
  output logic [6*ptm_pkg::ShiftBits-1:0]         shift_o
);
  logic [EffectW-1:0] effect;
  ptm_registers_by_draw #(.Width(EffectW)) u_effect (
    .values_i(effects_i), .draw_i(draw_i), .value_o(effect)
  );

  logic [2:0] sent_q;  // extra passes of the fragment that have left
  logic [3:0] pass;
  assign passes_o = effect[ptm_unit_pkg::EffectPassesAt +: 3];
  assign extra_o  = sent_q != passes_o;
  assign number_o = sent_q[1:0];
  always_comb begin
    unique case (number_o)
      2'd0:    pass = effect[ptm_unit_pkg::EffectPassAt +: 4];
      2'd1:    pass = effect[ptm_unit_pkg::EffectPassAt+4 +: 4];
      2'd2:    pass = effect[ptm_unit_pkg::EffectPassAt+8 +: 4];
      default: pass = effect[ptm_unit_pkg::EffectPassAt+12 +: 4];
    endcase
  end
  assign set_o    = extra_o ? pass[2:0] : 3'd0;
  assign half_o   = HalfVector != 0 && extra_o && pass[3];
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) sent_q <= 3'd0;
    else if (sent_i) sent_q <= last_i ? 3'd0 : extra_o ? sent_q + 3'd1 : sent_q;
  end

  always_comb begin
    bias_o  = '0;
    shift_o = '0;
    for (int s = 0; s < ExtraSets; s++) begin
      if (set_o == 3'(s + 1)) begin
        bias_o  = effect[ptm_unit_pkg::EffectBiasAt + 72*s +: 72];
        shift_o = effect[30*s +: 30];
      end
    end
  end

  logic unused;
  assign unused = ^{effect, sent_q[2], pass[3]};
endmodule
