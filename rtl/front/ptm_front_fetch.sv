// F and D: reads a beat's texels from the data banks of the TMUs' caches.
//
// Four banks a TMU by texel parity; a line is a row in each. F reads as it leaves for D, K writes
// at the end of the cycle in which it commits; a read sees what stood before. D holds a word of
// each bank and hands them to the taps. docs/spec/unit-timing.md, Commit and fetch.
module ptm_front_fetch #(
  parameter int Tmus = 3,
  parameter int Rows = 256,  // lines of a TMU's cache
  localparam int RowBits   = ptm_front_pkg::RowBits,
  localparam int LineWidth = ptm_front_pkg::LineWidth,
  localparam int TakenW    = ptm_front_pkg::TakenW,
  localparam int ReadsW    = ptm_front_pkg::ReadsW,
  localparam int TapsW     = ptm_unit_pkg::TapsW
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  // Lines from K
  input  logic                           commit_i,
  input  logic [Tmus-1:0]                rank_i,
  input  logic [Tmus*RowBits-1:0]        row_i,
  input  logic [Tmus*LineWidth-1:0]      line_i,
  input  logic [Tmus-1:0]                failed_i,  // lines that could not be read
  // Beat
  input  logic                valid_i,
  output logic                ready_o,
  input  ptm_unit_pkg::beat_t beat_i,
  input  logic [2*TakenW-1:0]    taken_i,
  input  logic [Tmus*ReadsW-1:0] reads_i,
  // D
  output logic                valid_o,
  input  logic                ready_i,
  output ptm_unit_pkg::beat_t beat_o,
  output logic [Tmus*TapsW-1:0] taps_o,
  output logic                failed_o  // a fetched tap is of a line that could not be read
);
  logic                f_valid, f_ready, f_load, d_load;
  ptm_unit_pkg::beat_t f_beat_q, d_beat_q;
  ptm_stream_reg u_f (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(f_load),
    .valid_o(f_valid), .ready_i(f_ready)
  );
  ptm_stream_reg u_d (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(f_valid), .ready_o(f_ready), .load_o(d_load),
    .valid_o(valid_o), .ready_i(ready_i)
  );
  ptm_front_pkg::taken_t f_map_q, f_color_q;
  always_ff @(posedge clk_i) begin
    if (f_load) begin
      f_beat_q             <= beat_i;
      {f_color_q, f_map_q} <= taken_i;
    end
    if (d_load) d_beat_q <= f_beat_q;
  end
  assign beat_o = d_beat_q;

  // Where either texture's taps lie
  ptm_front_pkg::sources_t map_sources, color_sources;
  ptm_front_taps u_map (.taken_i(f_map_q), .sources_o(map_sources));
  ptm_front_taps u_color (.taken_i(f_color_q), .sources_o(color_sources));

  logic [Tmus-1:0] f_color;  // the texture of the TMU's word
  logic [Tmus-1:0] failed;
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    ptm_front_tmu_fetch #(
      .Rows(Rows)
    ) u_tmu (
      .clk_i(clk_i), .write_i(commit_i && rank_i[t]), .write_row_i(row_i[t*RowBits +: RowBits]),
      .line_i(line_i[t*LineWidth +: LineWidth]), .failed_i(failed_i[t]), .f_load_i(f_load),
      .reads_i(reads_i[t*ReadsW +: ReadsW]), .f_color_o(f_color[t]),
      .sources_i(f_color[t] ? color_sources : map_sources), .d_load_i(d_load),
      .taps_o(taps_o[t*TapsW +: TapsW]), .failed_o(failed[t])
    );
  end
  assign failed_o = failed != '0;
endmodule
