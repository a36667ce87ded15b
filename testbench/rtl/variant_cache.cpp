#include "testbench/rtl/variant_cache.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string_view>
#include <system_error>

#include "testbench/rtl/command.h"
#include "testbench/rtl/variant_build.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

/// FNV-1a of 64 bits, twice from different beginnings: a name, not a defence.
class Digest {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) {
      for (std::uint64_t& half : half_) {
        half = (half ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
      }
    }
    for (std::uint64_t& half : half_) half = (half ^ 0x100U) * 0x100000001b3U;  // where it ends
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    out << std::hex << std::setfill('0');
    for (const std::uint64_t half : half_) out << std::setw(16) << half;
    return out.str();
  }

 private:
  std::array<std::uint64_t, 2> half_{0xcbf29ce484222325U, 0x84222325cbf29ce4U};
};

void add_file(const fs::path& path, Digest& digest) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  digest.add(path.filename().string());
  digest.add(content.str());
}

/// Every file below a folder whose name ends so, in an order that does not depend on the file
/// system.
void add_folder(const fs::path& folder, std::string_view end, Digest& digest) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const bool wanted = entry.path().string().ends_with(end);
    if (wanted && entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) add_file(file, digest);
}

std::string key_of(const std::vector<std::string>& parameters) {
  const VariantBuild& build = variant_build();
  const fs::path root = build.source_root;
  Digest digest;
  for (const std::string& parameter : parameters) digest.add(parameter);
  digest.add(build.tools);
  for (const std::string& option : build.options) digest.add(option);
  for (const char* folder : {"rtl", "testbench/sv"}) add_folder(root / folder, "", digest);
  for (const char* folder : {"testbench/rtl", "model/reference", "model/pipeline"}) {
    add_folder(root / folder, ".h", digest);  // what the harness includes
  }
  add_file(root / "cmake/PtmVerilate.cmake", digest);
  add_file(root / "testbench/rtl/unit_variant.cpp.in", digest);
  for (const std::string& file : build.effect_files) add_file(file, digest);
  return digest.text();
}

fs::path cache_folder() {
  const auto from = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const fs::path own = from("PTMSIM_CACHE"); !own.empty()) return own;
  if (const fs::path xdg = from("XDG_CACHE_HOME"); !xdg.empty()) return xdg / "ptmsim";
  if (const fs::path home = from("HOME"); !home.empty()) return home / ".cache" / "ptmsim";
  return fs::temp_directory_path() / "ptmsim";
}

/// The last lines of a log, for an error.
std::string tail(const fs::path& log) {
  std::ifstream file(log);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  std::string text;
  const std::size_t first = lines.size() > 12 ? lines.size() - 12 : 0;
  for (std::size_t n = first; n < lines.size(); ++n) text += "\n  " + lines[n];
  return text;
}

void need(const std::string& tool, const char* package) {
  if (find_program(tool)) return;
  throw MissingTool(
      "this unit is not among those that come with the build, and to build it " + tool +
      " is needed: install the package " + package);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw UnusableCache(folder.string(), error.message());
}

/// What a program that was ended while it built left behind.
void remove_leftovers(const fs::path& library) {
  const std::string begin = library.filename().string() + ".";
  for (const fs::directory_entry& entry : fs::directory_iterator(library.parent_path())) {
    const bool ours = entry.path().filename().string().starts_with(begin);
    std::error_code ignored;
    if (ours && entry.is_directory()) fs::remove_all(entry.path(), ignored);
  }
}

void run_tool(const std::vector<std::string>& command, const fs::path& log) {
  if (run_command(command, log) == 0) return;
  throw std::runtime_error("building the RTL unit failed:" + tail(log));
}

/// A folder that is removed whatever happens.
class Workplace {
 public:
  explicit Workplace(fs::path path) : path_(std::move(path)) { fs::create_directories(path_); }
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// While it stands, no other program builds the same library.
class BuildLock {
 public:
  explicit BuildLock(const fs::path& file) : file_(open(file.c_str(), O_RDWR | O_CREAT, 0644)) {
    if (file_ < 0 || flock(file_, LOCK_EX) != 0) {
      throw std::system_error(errno, std::generic_category(), file.string());
    }
  }
  ~BuildLock() { close(file_); }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

 private:
  int file_;
};

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace

std::vector<std::string> rtl_parameters(const reference::EvalConfig& config,
                                        const reference::UnitConfig& unit) {
  const auto value = [](const char* name, auto number) {
    return std::string(name) + "=" + std::to_string(static_cast<long long>(number));
  };
  return {value("CoefBits", config.coef_bits),
          value("DeltaBits", config.delta_bits),
          value("LightInt", config.light_int),
          value("LightFrac", config.light_frac),
          value("BasisFrac", config.basis_frac),
          value("Guard", config.guard),
          value("RoundNearest", config.rounding == reference::Rounding::nearest),
          value("LumBits", config.lum_bits),
          value("LumFrac", config.lum_frac),
          value("ShiftMin", config.shift_min),
          value("ShiftGroups", config.shift_groups),
          value("FilterFrac", config.filter_frac),
          value("Tmus", unit.tmus),
          value("CacheKib", unit.cache_kib),
          value("Ways", unit.ways),
          value("FragmentFifo", unit.fragment_fifo),
          value("MissFifo", unit.miss_fifo),
          value("PaletteLrgbPorts", unit.palette_lrgb_ports),
          value("PaletteRgbPorts", unit.palette_rgb_ports),
          value("EvalLanes", unit.eval_lanes),
          value("HalfVector", unit.half_vector),
          value("ExtraSets", unit.extra_sets),
          value("ExtraPasses", unit.extra_passes),
          value("Stages", unit.stages)};
}

fs::path variant_library(const reference::EvalConfig& config, const reference::UnitConfig& unit) {
  return cache_folder() / ("unit-" + key_of(rtl_parameters(config, unit)) + ".so");
}

fs::path build_variant(const reference::EvalConfig& config, const reference::UnitConfig& unit,
                       const std::function<void(const std::string&)>& say) {
  fs::path library = variant_library(config, unit);
  if (fs::exists(library)) return library;
  need("cmake", "cmake");
  need("verilator", "verilator");
  need(variant_build().compiler, "g++");
  if (variant_build().generator == "Ninja") need("ninja", "ninja-build");
  make_folder(library.parent_path());
  const BuildLock lock(library.string() + ".lock");
  if (fs::exists(library)) return library;  // another program was faster
  remove_leftovers(library);
  const std::vector<std::string> parameters = rtl_parameters(config, unit);
  if (say) say("building an RTL unit, once: " + joined(parameters, " "));
  const Workplace work(library.string() + "." + std::to_string(getpid()));
  const fs::path log = work.path() / "log";
  std::vector<std::string> configure{"cmake",
                                     "-S",
                                     variant_build().source_root,
                                     "-B",
                                     (work.path() / "build").string(),
                                     "-DPTM_VARIANT=" + joined(parameters, ";")};
  const std::vector<std::string>& options = variant_build().options;
  configure.insert(configure.end(), options.begin(), options.end());
  run_tool(configure, log);
  run_tool({"cmake", "--build", (work.path() / "build").string(), "--target", "ptm_variant"}, log);
  fs::rename(work.path() / "build" / "ptm_variant.so", library);
  return library;
}

}  // namespace ptm::testbench
