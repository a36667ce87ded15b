#include "testbench/prove/solver.h"

#include <unistd.h>

#include <chrono>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "testbench/rtl/command.h"
#include "testbench/rtl/variant_build.h"
#include "testbench/rtl/variant_cache.h"
#include "testbench/rtl/yosys.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

/// A folder of this process alone that goes when its owner does.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() /
              ("ptmsim-prove-" + std::to_string(getpid()) + "-" + std::to_string(next_++))) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] fs::path operator/(const char* name) const { return path_ / name; }

 private:
  inline static int next_ = 0;
  fs::path path_;
};

/// What the tool printed, and how long it took.
struct Run {
  int status = 0;
  std::string output;
  double seconds = 0;
};

Run run(const std::vector<std::string>& command, const Folder& folder) {
  if (!find_program(command.front())) {
    throw ToolError("to prove, " + command.front() + " is needed: install the package yosys");
  }
  const auto begin = std::chrono::steady_clock::now();
  Run made;
  made.status = run_command(command, folder / "log", variant_build().source_root);
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::ostringstream text;
  text << std::ifstream(folder / "log").rdbuf();
  made.output = text.str();
  return made;
}

[[noreturn]] void fail(const Run& made) {
  const std::size_t tail = made.output.size() < 2000 ? 0 : made.output.size() - 2000;
  throw std::runtime_error("yosys stopped:\n" + made.output.substr(tail));
}

bool has(const Run& made, const char* text) { return made.output.find(text) != std::string::npos; }

/// "  \name   decimal   hex   binary" of sat's table; decimals that are too long for it are "--".
std::vector<std::pair<std::string, std::string>> read_table(const std::string& output) {
  static const std::regex row(R"(^  \\(\S+)\s+(\S+)\s+(\S+)\s+([01x]+)\s*$)");
  std::vector<std::pair<std::string, std::string>> values;
  std::istringstream lines(output);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, row)) {
      values.emplace_back(match[1], match[2] == "--" ? match[4].str() + "b" : match[2].str());
    }
  }
  return values;
}

/// The property as an and-inverter graph. Nothing is optimised on the way, so that both sides of a
/// property, made of the same modules, become the same gates.
double write_graph(const Property& property, const std::vector<std::string>& files,
                   const Folder& folder) {
  std::string script = read_verilog(files) + '\n';
  for (const auto& [name, value] : property.parameters) {
    script += "chparam -set " + name + ' ' + yosys_integer(value) + ' ' + property.top + '\n';
  }
  script += "hierarchy -check -top " + property.top +
            "\nproc\nasync2sync\ndffunmap\nflatten\nopt_clean -purge\nsimplemap\ntechmap\n"
            "aigmap\nsetundef -undriven -zero\nwrite_aiger -zinit \"" +
            (folder / "property.aig").string() + "\"\n";
  std::ofstream(folder / "graph.ys") << script;
  const Run made = run({"yosys", "-q", "-s", (folder / "graph.ys").string()}, folder);
  if (made.status != 0) fail(made);
  return made.seconds;
}

Answer ask_abc(const std::string& commands, const Folder& folder, const char* holds,
               const char* fails) {
  const Run made = run(
      {"yosys-abc", "-c", "read " + (folder / "property.aig").string() + "; " + commands}, folder);
  Answer answer;
  answer.seconds = made.seconds;
  // "UNSATISFIABLE" holds "SATISFIABLE".
  if (has(made, holds)) {
    answer.verdict = Verdict::holds;
  } else if (has(made, fails)) {
    answer.verdict = Verdict::fails;
  }
  return answer;
}

}  // namespace

Answer prove(const Claim& claim, const std::vector<std::string>& files, int seconds) {
  const Folder folder;
  std::ofstream(folder / "claim.sv") << miter(claim);
  std::vector<std::string> all = files;
  all.push_back((folder / "claim.sv").string());
  // What the RTL leaves undefined may be anything; optimised first, it would be what suits best.
  // One multiplier with one pair of operands is one cell after opt_merge, and no question for SAT.
  std::ofstream(folder / "claim.ys")
      << read_verilog(all) << "\nhierarchy -check -top " << claim.name
      << "\nproc\nflatten\nsetundef -undriven -anyseq\nopt -full\nwreduce\nopt_merge\nopt "
         "-full\nsat -timeout "
      << seconds << " -prove differ 0 -show-inputs -show-outputs -show-ports " << claim.name
      << "\n";
  const Run made = run({"yosys", "-s", (folder / "claim.ys").string()}, folder);
  Answer answer;
  answer.seconds = made.seconds;
  if (has(made, "no model found: SUCCESS!")) {
    answer.verdict = Verdict::holds;
  } else if (has(made, "model found: FAIL!")) {
    answer.verdict = Verdict::fails;
    answer.counterexample = read_table(made.output);
  } else if (made.status != 0 && !has(made, "TIMEOUT")) {
    fail(made);
  }
  return answer;
}

Answer prove_always(const Property& property, const std::vector<std::string>& files) {
  const Folder folder;
  const double graph = write_graph(property, files, folder);
  Answer answer = ask_abc("pdr -T 200", folder, "Property proved.", "was asserted in frame");
  answer.seconds += graph;
  return answer;
}

Answer prove_in_cycle(const Property& property, const std::vector<std::string>& files, int cycle) {
  const Folder folder;
  const double graph = write_graph(property, files, folder);
  const std::string at = std::to_string(cycle);
  Answer answer =
      ask_abc("frames -F " + std::to_string(cycle + 1) + " -i; cone -O " + at + "; strash; iprove",
              folder, "UNSATISFIABLE", "SATISFIABLE");
  answer.seconds += graph;
  return answer;
}

}  // namespace ptm::testbench
