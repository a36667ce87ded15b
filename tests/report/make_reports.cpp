// Writes reports of made-up runs below the folder that is its argument.
#include <exception>
#include <filesystem>
#include <iostream>

#include "testbench/report/report.h"
#include "tests/report/made_unit.h"

namespace {

void write(const std::filesystem::path& folder, const ptm::testbench::RunResult& run) {
  const auto paths = write_report(run, ptm::testbench::compare_run(run), folder);
  std::cout << paths.html.string() << ' ' << std::filesystem::file_size(paths.html) << " bytes\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const std::filesystem::path out = argv[1];
  write(out / "one_light", ptm::tests::made_run(512, 512, 1));
  write(out / "many_lights", ptm::tests::made_run(96, 64, 14));
  write(out / "faulty", ptm::tests::made_faulty_run(160, 120, 2));
  write(out / "unit", ptm::tests::made_unit_run(256, 256, 1));
  write(out / "unit_late", ptm::tests::made_late_run(64, 64));
  write(out / "unit_no_duplicates", ptm::tests::made_unit_without_counters(64, 64, true));
  write(out / "unit_no_counters", ptm::tests::made_unit_without_counters(64, 64, false));
  ptm::testbench::RunResult bare = ptm::tests::made_run(1, 1, 1);
  bare.scene_file = "<script>alert('x')</script> & \"quoted\".toml";
  bare.models.resize(1);
  bare.presets.clear();
  bare.probe = nullptr;
  write(out / "one_model", bare);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
