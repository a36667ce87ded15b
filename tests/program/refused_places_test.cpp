// Where the program can read nothing or write nothing: devices, pipes, full disks, links.
#include <fstream>

#include "golden/files/ptm_file.h"
#include "tests/program/small_map.h"
#include "tests/run_program.h"

namespace ptm {
namespace {

class RefusedPlaces : public tests::Program {
 protected:
  std::filesystem::path map() const {
    golden::write_ptm(file("map.ptm"), tests::small_map(golden::MapKind::rgb, 64, 64));
    return file("map.ptm");
  }
};

TEST_F(RefusedPlaces, ReadsNoDeviceNoPipeAndNoFolder) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  const std::string pipe = tests::quoted(file("pipe"));
  expect_refused("info /dev/zero", "/dev/zero: file: found a device");
  expect_refused("info " + pipe, "a pipe");
  expect_refused("fit /dev/zero --out " + tests::quoted(file("a.ptm")), "a device");
  expect_refused("fit " + pipe + " --out " + tests::quoted(file("a.ptm")), "a pipe");
  expect_refused("bump /dev/zero --out " + tests::quoted(file("a.ptm")), "a device");
  expect_refused("run /dev/zero --out " + tests::quoted(file("out")), "a device");
  expect_refused("render /dev --light 0,0 --out " + tests::quoted(file("a.png")), "a folder");
}

TEST_F(RefusedPlaces, SaysThatStandardOutputIsFull) {
  const std::string command = tests::quoted(PTM_PROGRAM) + " info --json " + tests::quoted(map()) +
                              " >/dev/full 2>/dev/null";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
}

TEST_F(RefusedPlaces, WritesNoHalfPictureOfAnyFormatWhereTheDiskIsFull) {
  const auto source = map();
  const std::size_t before = count_files();
  for (const std::string end : {"png", "bmp", "tga", "sgi", "jpg", "tif", "ppm", "gif", "jp2"}) {
    const auto out = file("picture." + end);
    const std::string command = "ulimit -f 1; " + tests::quoted(PTM_PROGRAM) + " render " +
                                tests::quoted(source) + " --light 0.3,0.2 --size 512x512 --out " +
                                tests::quoted(out) + " >/dev/null 2>&1";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status)) << end;
    EXPECT_EQ(WEXITSTATUS(status), 3) << end;
    EXPECT_FALSE(std::filesystem::exists(out)) << end;
    EXPECT_EQ(count_files(), before) << end;
    EXPECT_EQ(run("render " + tests::quoted(source) + " --light 0.3,0.2 --out " +
                  tests::quoted(out))
                  .code,
              0)
        << end;
    std::filesystem::remove(out);
  }
}

TEST_F(RefusedPlaces, WritesWhatALinkStandsForAndKeepsTheLink) {
  const auto source = map();
  std::ofstream(file("old.ptm")) << "old";
  std::filesystem::create_symlink("old.ptm", file("link.ptm"));
  EXPECT_EQ(run("convert " + tests::quoted(source) + " " + tests::quoted(file("link.ptm"))).code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(file("link.ptm")));
  EXPECT_EQ(golden::read_ptm(file("old.ptm")).map.width, 64);
  std::filesystem::create_symlink("b.ptm", file("a.ptm"));
  std::filesystem::create_symlink("a.ptm", file("b.ptm"));
  expect_refused("convert " + tests::quoted(source) + " " + tests::quoted(file("a.ptm")),
                 "symbolic links");
}

TEST_F(RefusedPlaces, RemovesWhatAKilledProgramLeft) {
  // No process has this number: it is beyond the largest that Linux gives.
  std::ofstream(file(".picture.part-1000000000-0.png")) << "left";
  EXPECT_EQ(run("render " + tests::quoted(map()) + " --light 0,0 --out " +
                tests::quoted(file("picture.png")))
                .code,
            0);
  EXPECT_FALSE(std::filesystem::exists(file(".picture.part-1000000000-0.png")));
}

TEST_F(RefusedPlaces, RefusesNegativeCountsAndKeysWithoutEnd) {
  EXPECT_EQ(run("vectors --count -5").code, 2);
  EXPECT_EQ(run("vectors --count 1 --seed=-1").code, 2);
  std::string key = "a";
  for (int i = 0; i < 40000; ++i) key += ".a";
  expect_refused("run " + tests::quoted(write("deep.toml", "x = '. . .'\n" + key + " = 1\n")) +
                     " --out " + tests::quoted(file("out")),
                 "line 2: found a key of more than 64 parts");
}

}  // namespace
}  // namespace ptm
