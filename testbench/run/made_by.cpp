#include "testbench/run/made_by.h"

#include <sys/utsname.h>

#include <array>
#include <ctime>
#include <fstream>
#include <systemc>
#include <thread>

namespace ptm::testbench {
namespace {

std::string or_unknown(std::string text) { return text.empty() ? "unknown" : text; }

/// What follows the key, separators and quotes left out, in the first line that begins with it.
std::string value_of(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t first = line.find_first_not_of("\t =:\"", key.size());
    const std::size_t last = line.find_last_not_of(" \"");
    return first == std::string::npos ? "" : line.substr(first, last - first + 1);
  }
  return {};
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text.data(), length};
}

std::string kernel_text() {
  utsname system{};
  if (uname(&system) != 0) return {};
  return std::string(system.sysname) + " " + system.release + " " + system.machine;
}

}  // namespace

MadeBy made_by(const Invocation& invocation) {
  MadeBy made;
  made.invocation = invocation;
  made.date = now();
  made.compiler = PTM_COMPILER;
  made.verilator = PTM_VERILATOR_VERSION;
  made.systemc = sc_core::sc_release();
  made.cpu = or_unknown(value_of("/proc/cpuinfo", "model name"));
  made.cores = std::thread::hardware_concurrency();
  made.system = or_unknown(value_of("/etc/os-release", "PRETTY_NAME"));
  made.kernel = or_unknown(kernel_text());
  return made;
}

std::string program_text(const Invocation& invocation) {
  std::string text = "ptmsim " + invocation.version + ", commit " + invocation.commit;
  if (invocation.changed.value_or(false)) text += ", sources changed since";
  return text;
}

}  // namespace ptm::testbench
