// The miss ring: slots for lines on their way from memory, in the order in which T pushed them.
//
// A rank of up to Tmus lines is pushed at once, into the next slots in the order of TMUs, if as
// many are free at the cycle's start. Requests leave one a cycle in ring order, the tag is the
// slot's number. Slots are numbered modulo MissFifo rounded up to a multiple of four; at most
// MissFifo of them are in use. So slots that follow each other lie in different ones of four banks,
// each a memory with one port to write and one to read.
//
// Responses come in any order and are usable in the second cycle after; one whose tag is not
// outstanding is dropped and reported. K commits ranks in ring order, up to Tmus slots side by
// side, and returns a beat's slots together: free from the cycle after (T5).
//
// The memory may still owe answers to requests from before a reset of the unit. They are counted in
// a register that only mem_rst_ni resets; until the last one has come nothing is asked for, and
// whatever comes is dropped.
// docs/spec/unit-timing.md, Tags and Commit.
`include "ptm_assert.svh"
module ptm_front_miss_ring #(
  parameter int Tmus     = 3,
  parameter int MissFifo = 64,  // slots, 4 * Tmus..256
  localparam int LineBits  = ptm_unit_pkg::LineBits,
  localparam int LineWidth = ptm_front_pkg::LineWidth
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 mem_rst_ni,  // the memory forgets what it owes; low only with rst_ni
  // T
  input  logic [Tmus-1:0]                miss_valid_i,
  input  logic [Tmus*LineBits-1:0]       miss_line_i,
  input  logic                           miss_push_i,
  output logic                           miss_fits_o,
  // Memory
  output logic                 req_valid_o,
  input  logic                 req_ready_i,
  output logic [LineBits-1:0]  req_line_o,
  output logic [7:0]           req_tag_o,
  input  logic                 rsp_valid_i,
  input  logic [7:0]           rsp_tag_i,
  input  logic [LineWidth-1:0] rsp_line_i,
  input  logic                 rsp_failed_i,  // the line could not be read
  output logic                 rsp_error_o,  // no request of that tag is outstanding
  output logic                 line_failed_o, // a line that is waited for could not be read
  output logic                 draining_o,   // answers from before the reset are awaited
  // K: the lines of its rank
  input  logic [Tmus-1:0]      rank_i,       // TMUs that have one
  output logic                 usable_o,     // all of them are there
  input  logic                 commit_i,     // they are taken
  input  logic                 release_i,    // with the beat's last rank, or without misses
  output logic [Tmus*LineWidth-1:0] line_o,
  output logic [Tmus-1:0]           failed_o  // lines that could not be read
);
  localparam int Rows      = (MissFifo + 3) / 4;  // of a bank
  localparam int RowBits   = Rows == 1 ? 1 : $clog2(Rows);
  localparam int Slots     = 4 * Rows;
  localparam int SlotBits  = $clog2(Slots);
  localparam int CountBits = $clog2(MissFifo + 1);

  // Slots wrap where the banks end, which need not be at a power of two
  function automatic logic [SlotBits-1:0] behind(input logic [SlotBits-1:0] slot,
                                                 input logic [1:0] steps);
    logic [SlotBits:0] sum;
    sum    = {1'b0, slot} + (SlotBits+1)'(steps);
    behind = SlotBits'(sum >= (SlotBits+1)'(Slots) ? sum - (SlotBits+1)'(Slots) : sum);
  endfunction

  function automatic logic [RowBits-1:0] row_of(input logic [SlotBits-1:0] slot);
    row_of = RowBits'(slot >> 2);
  endfunction

  // TMU t's place within a rank: how many before it have a line
  function automatic logic [1:0] lines_before(input logic [Tmus-1:0] rank, input int t);
    lines_before = 2'd0;
    for (int other = 0; other < Tmus; other++) begin
      if (other < t) lines_before = lines_before + 2'(rank[other]);
    end
  endfunction

  logic [Slots-1:0] outstanding_q;  // asked for, not answered

  logic [SlotBits-1:0]  tail_q;     // next to be pushed
  logic [SlotBits-1:0]  request_q;  // next to be asked for
  logic [1:0]           head_q;     // bank of the next to be committed
  logic [CountBits-1:0] free_q;
  logic [CountBits-1:0] waiting_q;  // pushed, not asked for
  logic [CountBits-1:0] held_q;     // of the beat in K: committed, not returned

  // Push
  logic [1:0] pushed;
  assign pushed      = lines_before(miss_valid_i, Tmus);
  assign miss_fits_o = free_q >= CountBits'(pushed);
  logic push;
  assign push = miss_push_i && pushed != 2'd0;
  // By bank
  logic [3:0]            address_write;
  logic [4*RowBits-1:0]  address_row;
  logic [4*LineBits-1:0] address;
  logic [LineBits-1:0]   asked [4];
  always_comb begin
    address_write = '0;
    address_row   = '0;
    address       = '0;
    if (push) begin
      for (int b = 0; b < 4; b++) begin
        for (int t = 0; t < Tmus; t++) begin
          if (miss_valid_i[t] &&
              2'(tail_q[1:0] + lines_before(miss_valid_i, t)) == 2'(b)) begin
            address_write[b]                   = 1'b1;
            address_row[b*RowBits +: RowBits]  =
                row_of(behind(tail_q, lines_before(miss_valid_i, t)));
            address[b*LineBits +: LineBits]    = miss_line_i[t*LineBits +: LineBits];
          end
        end
      end
    end
  end
  for (genvar b = 0; b < 4; b++) begin : gen_address
    ptm_memory_register_file #(
      .Depth(Rows), .Width(LineBits)
    ) u_address (
      .clk_i(clk_i), .write_i(address_write[b]),
      .write_address_i(address_row[b*RowBits +: RowBits]),
      .write_data_i(address[b*LineBits +: LineBits]), .read_address_i(row_of(request_q)),
      .read_data_o(asked[b])
    );
  end

  // Requests
  logic draining_q;
  logic request;
  assign req_valid_o = waiting_q != '0 && !draining_q;
  assign req_line_o  = asked[request_q[1:0]];
  assign req_tag_o   = 8'(request_q);
  assign request     = req_valid_o && req_ready_i;

  // Responses
  logic                response;
  logic [SlotBits-1:0] response_slot;
  assign response_slot = rsp_tag_i[SlotBits-1:0];
  // An answer may come in the very cycle in which its request is taken.
  assign response      = rsp_valid_i && 9'(rsp_tag_i) < 9'(Slots) &&
                         (outstanding_q[response_slot] ||
                          (request && response_slot == request_q));

  // What the memory owes. While the ring drains any answer is one of those; tags mean nothing then.
  logic [CountBits-1:0] owed_q;
  logic                 owed;
  assign owed        = draining_q ? rsp_valid_i && owed_q != '0 : response;
  assign rsp_error_o = rsp_valid_i && !owed;
  assign line_failed_o = response && rsp_failed_i;
  assign draining_o  = draining_q;
  always_ff @(posedge clk_i or negedge mem_rst_ni) begin
    if (!mem_rst_ni) owed_q <= '0;
    else if (request != owed) owed_q <= request ? owed_q + 1'b1 : owed_q - 1'b1;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) draining_q <= 1'b1;
    else if (owed_q == '0) draining_q <= 1'b0;
  end

  // Commit
  logic [1:0]             committed;
  logic [3:0]             bank_valid, bank_failed, bank_taken;
  logic [LineWidth-1:0]   bank_line [4];
  assign committed = lines_before(rank_i, Tmus);
  for (genvar b = 0; b < 4; b++) begin : gen_line
    ptm_front_miss_bank #(
      .Rows(Rows), .Width(LineWidth)
    ) u_bank (
      .clk_i(clk_i), .rst_ni(rst_ni), .write_i(response && response_slot[1:0] == 2'(b)),
      .write_row_i(row_of(response_slot)), .write_line_i(rsp_line_i),
      .write_failed_i(rsp_failed_i), .valid_o(bank_valid[b]), .take_i(bank_taken[b]),
      .line_o(bank_line[b]), .failed_o(bank_failed[b])
    );
    // Of the rank's lines, the one that follows the head as far as this bank does
    assign bank_taken[b] = commit_i && 2'(2'(b) - head_q) < committed;
  end
  logic [Tmus-1:0] there;
  for (genvar t = 0; t < Tmus; t++) begin : gen_commit
    logic [1:0]           bank;
    logic [LineWidth-1:0] line;
    assign bank     = head_q + lines_before(rank_i, t);
    assign there[t] = !rank_i[t] || bank_valid[bank];
    // Without a commit nothing moves, and nothing is simulated
    always_comb begin
      line = '0;
      if (commit_i && rank_i[t]) line = bank_line[bank];
    end
    assign line_o[t*LineWidth +: LineWidth] = line;
    assign failed_o[t] = commit_i && rank_i[t] && bank_failed[bank];
  end
  assign usable_o = there == '1;

  logic [CountBits-1:0] held_now;
  assign held_now = held_q + (commit_i ? CountBits'(committed) : '0);
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      tail_q        <= '0;
      request_q     <= '0;
      head_q        <= '0;
      free_q        <= CountBits'(MissFifo);
      waiting_q     <= '0;
      held_q        <= '0;
      outstanding_q <= '0;
    end else begin
      if (push) tail_q <= behind(tail_q, pushed);
      if (commit_i) head_q <= head_q + committed;
      held_q    <= release_i ? '0 : held_now;
      free_q    <= free_q - (push ? CountBits'(pushed) : '0) + (release_i ? held_now : '0);
      waiting_q <= waiting_q + (push ? CountBits'(pushed) : '0) - CountBits'(request);
      if (request) begin
        request_q                <= behind(request_q, 2'd1);
        outstanding_q[request_q] <= 1'b1;
      end
      if (response) outstanding_q[response_slot] <= 1'b0;
    end
  end

  `PTM_ASSERT(PushFits_A, !push || free_q >= CountBits'(pushed))
  `PTM_ASSERT(CommitOfUsable_A, !commit_i || usable_o)
  `PTM_ASSERT(MemoryIsResetWithTheUnit_A, mem_rst_ni)
  `PTM_ASSERT(NoMoreFreeThanThereAre_A, free_q <= CountBits'(MissFifo))
endmodule
