#pragma once
#include <cstdlib>

#include "tests/faults/commands.h"
#include "tests/faults/small_disk.h"

namespace ptm::tests {

/// A scene whose unit does not come with the build, a cache of the test's own, and cmake replaced
/// by a script, so that no test but the first needs a compiler's time.
class VariantCache : public Program {
 protected:
  VariantCache() {
    write("scene.toml", R"(models = ["reference", "rtl"]
[image]
size = [16, 16]
[camera]
position = [0.5, -1.6, 1.0]
target = [0.5, -0.45, 0]
fov_degrees = 40
[[texture]]
name = "relief"
generate = "relief"
size = [16, 16]
kind = "lrgb"
[[object]]
kind = "plane"
origin = [0, 0, 0]
i = [1, 0, 0]
j = [0, -1, 0]
texture = "relief"
[[light]]
direction = [-0.5, 0.5, 0.8]
[hardware]
tmus = 1
cache_kib = 2
)");
    std::filesystem::create_directories(file("tools"));
  }

  static std::string path_variable() { return std::getenv("PATH"); }

  /// A cmake of the test's own, before all others in $PATH. $build is the folder that it builds in.
  void replace_cmake(const std::string& configures, const std::string& builds) const {
    write("tools/cmake", "#!/bin/sh\nif [ \"$1\" = --build ]; then build=$2; " + builds +
                             "\nelse build=$4; mkdir -p \"$build\"; " + configures + "\nfi\n");
    std::filesystem::permissions(file("tools/cmake"), std::filesystem::perms::owner_all);
  }
  /// One that gives the library that was built for all tests.
  void replace_cmake_by_copy() const {
    std::string text = built();
    text.resize(text.rfind("\nptmsim digest "));
    write("good.so", text);
    replace_cmake("", "cp " + quoted(file("good.so")) + " \"$build/ptm_variant.so\"");
  }

  [[nodiscard]] std::string with_tools() const {
    return "PATH=" + tests::quoted(file("tools").string() + ":" + path_variable()) + " ";
  }
  [[nodiscard]] Outcome run_scene(const std::filesystem::path& cache,
                                  const std::string& environment = "",
                                  const std::filesystem::path& program = PTM_PROGRAM) const {
    const std::string line = environment + " PTMSIM_CACHE=" + quoted(cache) + " " +
                             quoted(program) + " run " + quoted(file("scene.toml")) + " --out " +
                             quoted(file("out")) + " >" + quoted(file("log.out")) + " 2>" +
                             quoted(file("log.err"));
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(file("log.out")),
            text_of(file("log.err"))};
  }

  /// The library, as really built, once for all tests of this build.
  [[nodiscard]] std::string built() const {
    const std::filesystem::path shared =
        std::filesystem::path(std::getenv("PTMSIM_CACHE")) / "faults";
    const Outcome outcome = run_scene(shared);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // The sources may have changed since the last build: the newest is this one's.
    std::filesystem::path newest;
    for (const std::string& name : names_in(shared)) {
      if (!name.ends_with(".so")) continue;
      const auto time = std::filesystem::last_write_time(shared / name);
      if (newest.empty() || time > std::filesystem::last_write_time(newest)) {
        newest = shared / name;
      }
    }
    return text_of(newest);
  }
};

}  // namespace ptm::tests
