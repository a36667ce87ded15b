#include "testbench/rtl/variant_cache.h"

#include <dlfcn.h>
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

/// What is asked for.
struct Wanted {
  std::string kind;  ///< "unit" or "evaluator"
  std::vector<std::string> parameters;
};

std::string key_of(const Wanted& wanted) {
  const VariantBuild& build = variant_build();
  const std::vector<std::string>& parameters = wanted.parameters;
  Digest digest;
  digest.add(wanted.kind);
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
  throw ToolError("this RTL is not among what comes with the build, and to build it " + tool +
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
  throw ToolError("building the RTL failed: " + command.front() + " ended with status " +
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
void build(const fs::path& library, const Wanted& wanted) {
  const WorkFolder work(library);
  const fs::path source = work.path() / "source", build = work.path() / "build";
  unpack_sources(source);
  std::vector<std::string> configure{"cmake",
                                     "-S",
                                     source.string(),
                                     "-B",
                                     build.string(),
                                     "-DPTM_VARIANT=" + joined(wanted.parameters, ";"),
                                     "-DPTM_VARIANT_KIND=" + wanted.kind};
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

template <class Config>
void add_parameters(const Config& config, std::vector<std::string>& list) {
  using Table = reference::ParameterTable<Config>;
  for (std::size_t i = 0; i < Table::kCount; ++i) {
    list.push_back(std::string(Table::rows()[i].rtl) + "=" + std::to_string(Table::get(config, i)));
  }
}

fs::path library_of(const Wanted& wanted) {
  return cache_folder() / (wanted.kind + "-" + key_of(wanted) + ".so");
}

fs::path build_wanted(const Wanted& wanted, const Say& say) {
  fs::path library = library_of(wanted);
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
  std::error_code error;
  if (say && fs::exists(library, error)) say(library.string() + " is damaged and is built again");
  if (say) say("building an RTL " + wanted.kind + ", once: " + joined(wanted.parameters, " "));
  try {
    build(library, wanted);
  } catch (const golden::InputError& fault) {
    throw UnusableCache(library.parent_path().string(), fault.found());
  } catch (const std::system_error& fault) {  // of a file system, or a program that cannot start
    throw UnusableCache(library.parent_path().string(), fault.code().message());
  }
  return library;
}

Wanted wanted_unit(const reference::EvalConfig& config, const reference::UnitConfig& unit) {
  return {"unit", rtl_parameters(config, unit)};
}

}  // namespace

std::vector<std::string> evaluator_parameters(const reference::EvalConfig& config) {
  std::vector<std::string> list;
  add_parameters(config, list);
  return list;
}

std::vector<std::string> rtl_parameters(const reference::EvalConfig& config,
                                        const reference::UnitConfig& unit) {
  std::vector<std::string> list = evaluator_parameters(config);
  add_parameters(unit, list);
  return list;
}

fs::path variant_library(const reference::EvalConfig& config, const reference::UnitConfig& unit) {
  return library_of(wanted_unit(config, unit));
}

fs::path build_variant(const reference::EvalConfig& config, const reference::UnitConfig& unit,
                       const Say& say) {
  return build_wanted(wanted_unit(config, unit), say);
}

fs::path build_variant(const reference::EvalConfig& config, const Say& say) {
  return build_wanted({"evaluator", evaluator_parameters(config)}, say);
}

void* find_in_library(const fs::path& library, const char* name) {
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const symbol = handle ? dlsym(handle, name) : nullptr;
  if (!symbol)
    throw std::runtime_error(std::string("verilated RTL cannot be loaded: ") + dlerror());
  return symbol;
}

}  // namespace ptm::testbench
