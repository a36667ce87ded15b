#include "golden/scene/scene_parts.h"

namespace ptm::golden {
namespace {

/// An integer that is one of a few.
void read_one_of(const TableReader& table, std::string_view key, int& value,
                 std::initializer_list<int> allowed) {
  table.read(key, value, *allowed.begin(), *(allowed.end() - 1));
  std::string list;
  for (const int a : allowed) {
    if (a == value) return;
    list += (list.empty() ? "" : ", ") + std::to_string(a);
  }
  table.fail(key, std::to_string(value), "one of " + list);
}

void read_dram(const TableReader& table, MemorySpec& memory) {
  table.only({"kind", "banks", "page_lines", "tRCD", "tRP", "CL", "tRAS", "tREFI", "tRFC", "burst",
              "overhead"});
  read_one_of(table, "banks", memory.banks, {1, 2, 4, 8, 16, 32, 64});
  read_one_of(table, "page_lines", memory.page_lines, {1, 2, 4, 8, 16, 32, 64, 128, 256, 512});
  constexpr int most = 10000;
  table.read("tRCD", memory.t_rcd, 0, most);
  table.read("tRP", memory.t_rp, 0, most);
  table.read("CL", memory.cl, 0, most);
  table.read("tRAS", memory.t_ras, 0, most);
  table.read("tREFI", memory.t_refi, 0, 1000000);
  table.read("tRFC", memory.t_rfc, 0, most);
  table.read("burst", memory.burst, 1, most);
  table.read("overhead", memory.overhead, 0, most);
  if (memory.t_refi != 0 && memory.t_rfc + memory.t_rcd >= memory.t_refi) {
    table.fail("tREFI", std::to_string(memory.t_refi),
               "more than tRFC + tRCD, " + std::to_string(memory.t_rfc + memory.t_rcd) +
                   ", or no row is ever read; 0 for no refresh");
  }
}

}  // namespace

HardwareSpec read_hardware_spec(const TableReader& table) {
  table.only({"preset", "tmus", "cache_kib", "ways", "fragment_fifo", "miss_fifo", "shift_groups",
              "palette_lrgb_ports", "palette_rgb_ports", "eval_lanes", "counters",
              "duplicate_lines"});
  HardwareSpec hardware;
  hardware.place = table.place("");
  table.read("preset", hardware.preset);
  hardware.preset_place = table.place("preset");
  table.read("tmus", hardware.tmus, 1, 3);
  read_one_of(table, "cache_kib", hardware.cache_kib, {1, 2, 4, 8, 16, 32, 64});
  read_one_of(table, "ways", hardware.ways, {1, 2, 4});
  table.read("fragment_fifo", hardware.fragment_fifo, 4, 1024);
  table.read("miss_fifo", hardware.miss_fifo, 4 * hardware.tmus, 256);
  if (table.has("shift_groups")) {
    read_one_of(table, "shift_groups", hardware.shift_groups.emplace(3), {3, 6});
  }
  read_one_of(table, "palette_lrgb_ports", hardware.palette_lrgb_ports, {1, 2, 4});
  read_one_of(table, "palette_rgb_ports", hardware.palette_rgb_ports, {1, 2, 4});
  read_one_of(table, "eval_lanes", hardware.eval_lanes, {1, 3});
  table.read("counters", hardware.counters);
  hardware.duplicate_lines = hardware.counters;
  table.read("duplicate_lines", hardware.duplicate_lines);
  if (hardware.duplicate_lines && !hardware.counters) {
    table.fail("duplicate_lines", "true", "false in a unit without counters");
  }
  return hardware;
}

MemorySpec read_memory(const TableReader& table) {
  constexpr std::array<std::pair<std::string_view, MemoryKind>, 3> kinds{
      {{"fixed", MemoryKind::fixed}, {"dram", MemoryKind::dram}, {"random", MemoryKind::random}}};
  MemorySpec memory;
  table.choose<MemoryKind>("kind", memory.kind, kinds);
  constexpr int most = 100000;
  if (memory.kind == MemoryKind::dram) {
    read_dram(table, memory);
  } else if (memory.kind == MemoryKind::fixed) {
    table.only({"kind", "latency", "interval"});
    table.read("latency", memory.latency, 1, most);
    table.read("interval", memory.interval, 1, most);
  } else {
    table.only({"kind", "seed", "latency_min", "latency_max"});
    table.read("seed", memory.seed);
    table.read("latency_min", memory.latency_min, 1, most);
    table.read("latency_max", memory.latency_max, 1, most);
    if (memory.latency_min > memory.latency_max) {
      table.fail("latency_min", std::to_string(memory.latency_min), "at most latency_max");
    }
  }
  return memory;
}

StressSpec read_stress(const TableReader& table) {
  table.only({"input_gap", "output_stall", "seed"});
  StressSpec stress;
  // Of 256 cycles at most 255: at 256 nothing would ever move.
  table.read("input_gap", stress.input_gap, 0, 255);
  table.read("output_stall", stress.output_stall, 0, 255);
  table.read("seed", stress.seed);
  return stress;
}

}  // namespace ptm::golden
