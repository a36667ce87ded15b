// The most memory that `ptmsim fit` takes, on captures larger than it may hold. Slow.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "golden/files/picture_row_writer.h"
#include "golden/scene/relief.h"
#include "tests/scratch_folder.h"

namespace ptm {
namespace {

using tests::ScratchFolder;

/// Runs the program; its most memory in MiB, or -1 if it failed.
double peak_mib(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), PTM_PROGRAM);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child) return -1;
  return status == 0 ? double(usage.ru_maxrss) / 1024 : -1;
}

/// A relief-like RGB pattern that no codec shrinks to nothing.
void write_pattern(const std::filesystem::path& path, int width, int height) {
  golden::PictureRowWriter writer(path, width, height, 3);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width) * 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width * 3; ++x) {
      row[static_cast<std::size_t>(x)] =
          static_cast<std::uint8_t>(128 + (x / 3 * 5 + y * 3) % 97 - x % 3 * 20);
    }
    writer.write(row);
  }
  writer.commit();
}

/// A capture whose photographs are all the same file: decoding and memory do not notice.
std::filesystem::path write_capture(const ScratchFolder& folder, const std::string& picture,
                                    int lights) {
  std::string text;
  for (const auto& d : golden::spread_lights(lights)) {
    text += picture + ' ' + std::to_string(d[0]) + ' ' + std::to_string(d[1]) + ' ' +
            std::to_string(d[2]) + '\n';
  }
  return folder.write("capture.lp", text);
}

TEST(FitMemory, StaysFlatWhenTheHeightGrowsSixteenfold) {
  for (const char* format : {"lrgb", "rgb"}) {
    for (const char* extension : {"jpg", "png", "tif"}) {
      double peak[2] = {};
      for (const int tall : {0, 1}) {
        const ScratchFolder folder;
        const std::string picture = std::string("p.") + extension;
        write_pattern(folder / picture, 1000, tall == 1 ? 16000 : 1000);
        const auto lp = write_capture(folder, picture, 8);
        peak[tall] =
            peak_mib({"fit", lp.string(), "--out", (folder / "m.ptm").string(), "--format", format,
                      "--memory", "32", "--residual", (folder / "r.png").string()});
      }
      std::printf("%s, %s: 1,000 rows %.0f MiB, 16,000 rows %.0f MiB\n", format, extension, peak[0],
                  peak[1]);
      ASSERT_GT(peak[0], 0);
      ASSERT_GT(peak[1], 0);
      // One photograph of 16,000 rows decoded is 46 MiB, all of them as they are fitted 1.4 GiB.
      EXPECT_LT(peak[1], peak[0] + 24) << format << ' ' << extension;
    }
  }
}

TEST(FitMemory, OfSixtyPhotographsOfAHundredMegapixelsIsBelowTwoGibibytes) {
  const ScratchFolder folder;
  write_pattern(folder / "p.jpg", 10000, 10000);
  const auto lp = write_capture(folder, "p.jpg", 60);
  const double peak = peak_mib({"fit", lp.string(), "--out", (folder / "m.ptm").string()});
  std::printf("60 photographs of 10,000 x 10,000: %.0f MiB\n", peak);
  ASSERT_GT(peak, 0);
  EXPECT_LT(peak, 2048);
  EXPECT_EQ(std::filesystem::file_size(folder / "m.ptm") / 1000000, 900U);
}

}  // namespace
}  // namespace ptm
