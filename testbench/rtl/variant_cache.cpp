#include "testbench/rtl/variant_cache.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>

#include "golden/files/ending_signals.h"
#include "golden/files/folder_claim.h"
#include "golden/files/input_error.h"
#include "testbench/rtl/command.h"
#include "testbench/rtl/digest.h"
#include "testbench/rtl/sealed_file.h"
#include "testbench/rtl/variant_build.h"
#include "testbench/rtl/work_folder.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

std::string key_of(const std::vector<std::string>& parameters) {
  const VariantBuild& build = variant_build();
  Digest digest;
  for (const std::string& parameter : parameters) digest.add(parameter);
  digest.add(build.tools);
  for (const std::string& option : build.options) digest.add(option);
  for (const EmbeddedSource& source : embedded_sources()) {
    digest.add(source.name);
    digest.add(source.text);
  }
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

std::string text_of(const fs::path& log) {
  std::ostringstream text;
  text << std::ifstream(log).rdbuf();
  return text.str();
}

/// The last lines of a log, for an error.
std::string tail(const std::string& log) {
  std::istringstream file(log);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  std::string text;
  const std::size_t first = lines.size() > 12 ? lines.size() - 12 : 0;
  for (std::size_t n = first; n < lines.size(); ++n) text += "\n  " + lines[n];
  return text;
}

void need(const std::string& tool, const char* package) {
  if (find_program(tool)) return;
  throw ToolError("this unit is not among those that come with the build, and to build it " + tool +
                  " is needed: install the package " + package);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw UnusableCache(folder.string(), error.message());
}

/// Why a tool that failed could not write, empty if that is not why. Some say so, in C's words;
/// some stop without a word, and what follows them stumbles over half a file. So it is tried.
std::string disk_fault(const std::string& log, const fs::path& folder) {
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EROFS}) {
    std::string words = std::generic_category().message(error);
    if (log.find(words) != std::string::npos) return words;
    words.front() = static_cast<char>(std::tolower(words.front()));  // as the linker writes it
    if (log.find(words) != std::string::npos) return std::generic_category().message(error);
  }
  errno = 0;
  std::ofstream probe(folder / "probe", std::ios::binary);
  probe << std::string(1 << 20, 'x');
  probe.close();
  return probe ? "" : std::generic_category().message(errno);
}

/// A file in memory: what tools say of a full disk must not go to that disk.
class Log {
 public:
  Log() : file_(memfd_create("ptmsim-log", MFD_CLOEXEC)) {
    if (file_ < 0) throw std::system_error(errno, std::generic_category(), "file in memory");
  }
  ~Log() { close(file_); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  [[nodiscard]] fs::path path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

void run_tool(const std::vector<std::string>& command, const fs::path& work) {
  const Log file;
  const fs::path log = file.path();
  // Their own temporary files go with the folder.
  const int status = run_command(command, log, ".", {"LC_ALL=C", "TMPDIR=" + work.string()});
  if (status == 0) return;
  const std::string said = text_of(log);
  if (const std::string fault = disk_fault(said, work); !fault.empty()) {
    throw UnusableCache(work.parent_path().string(), fault);
  }
  throw ToolError("building the RTL unit failed: " + command.front() + " ended with status " +
                  std::to_string(status) + ":" + tail(said));
}

/// While it stands, no other program builds the same library. The file has a temporary name, so
/// that the next program removes what is left of one that was killed; it must have claimed the
/// folder as this one has.
class BuildLock {
 public:
  explicit BuildLock(const fs::path& library)
      : path_(library.parent_path() /
              std::string(1, '.').append(library.stem().string()).append(".part-0-0.lock")) {
    do {
      if (file_ >= 0) close(file_);
      file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
      if (file_ < 0 || flock(file_, LOCK_EX) != 0) {
        throw UnusableCache(path_.parent_path().string(), std::generic_category().message(errno));
      }
    } while (!is_current());
    registered_.emplace(path_);
  }
  ~BuildLock() {
    unlink(path_.c_str());
    close(file_);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

 private:
  /// Whether the file that is locked still has the name: whoever had it before has removed it.
  [[nodiscard]] bool is_current() const {
    struct stat locked {
    }, named{};
    return fstat(file_, &locked) == 0 && stat(path_.c_str(), &named) == 0 &&
           locked.st_ino == named.st_ino;
  }

  fs::path path_;
  int file_ = -1;
  std::optional<golden::RemovedOnSignal> registered_;
};

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Sources and all that tools write lie in a folder of their own.
void build(const fs::path& library, const std::vector<std::string>& parameters) {
  const WorkFolder work(library);
  const fs::path source = work.path() / "source", build = work.path() / "build";
  unpack_sources(source);
  std::vector<std::string> configure{"cmake",         "-S",
                                     source.string(), "-B",
                                     build.string(),  "-DPTM_VARIANT=" + joined(parameters, ";")};
  if (fs::exists(source / "extra")) {
    configure.push_back("-DPTM_EFFECTS_EXTRA=" + fs::absolute(source / "extra").string());
  }
  const std::vector<std::string>& options = variant_build().options;
  configure.insert(configure.end(), options.begin(), options.end());
  run_tool(configure, work.path());
  run_tool({"cmake", "--build", build.string(), "--target", "ptm_variant"}, work.path());
  seal_file(build / "ptm_variant.so");
  fs::rename(build / "ptm_variant.so", library);
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
          value("Stages", unit.stages),
          value("Counters", unit.counters),
          value("DuplicateLines", unit.duplicate_lines)};
}

fs::path variant_library(const reference::EvalConfig& config, const reference::UnitConfig& unit) {
  return cache_folder() / ("unit-" + key_of(rtl_parameters(config, unit)) + ".so");
}

fs::path build_variant(const reference::EvalConfig& config, const reference::UnitConfig& unit,
                       const std::function<void(const std::string&)>& say) {
  fs::path library = variant_library(config, unit);
  auto claim = golden::FolderClaim::of(library.parent_path());
  if (is_sealed(library)) return library;
  need("cmake", "cmake");
  need("verilator", "verilator");
  need(variant_build().compiler, "g++");
  if (variant_build().generator == "Ninja") need("ninja", "ninja-build");
  make_folder(library.parent_path());
  claim.reset();  // the folder may be a new one
  claim = golden::FolderClaim::of(library.parent_path());
  const BuildLock lock(library);
  if (is_sealed(library)) return library;  // another program was faster
  const std::vector<std::string> parameters = rtl_parameters(config, unit);
  std::error_code error;
  if (say && fs::exists(library, error)) say(library.string() + " is damaged and is built again");
  if (say) say("building an RTL unit, once: " + joined(parameters, " "));
  try {
    build(library, parameters);
  } catch (const golden::InputError& fault) {
    throw UnusableCache(library.parent_path().string(), fault.found());
  } catch (const std::system_error& fault) {  // of a file system, or a program that cannot start
    throw UnusableCache(library.parent_path().string(), fault.code().message());
  }
  return library;
}

}  // namespace ptm::testbench
