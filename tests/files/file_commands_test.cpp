#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/files/crafted_ptm.h"
#include "tests/run_program.h"
#include "tests/scratch_folder.h"

// `ptmsim info` and `ptmsim convert` as a user meets them.
namespace ptm::tests {
namespace {

class FileCommands : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) { return run_program(log_ / "log", arguments); }
  std::string put(const std::string& name, const Bytes& bytes) {
    std::ofstream file(folder_() / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }
  std::string path(const std::string& name) {
    std::string quoted(1, '\'');
    quoted += (folder_() / name).string();
    quoted += '\'';
    return quoted;
  }
  ScratchFolder& folder_() { return work_.front(); }

  /// The command ends with code 3, says what is wrong, and leaves nothing behind.
  void expect_refused(const std::string& file, const std::string& place,
                      const std::string& command = "convert") {
    const std::size_t before = folder_().files();
    std::string arguments = command;
    arguments.append(" ").append(file);
    if (command == "convert") arguments.append(" ").append(path("o.ptm"));
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find(place), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(": found "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(", expected "), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder_().files(), before);
  }

 private:
  std::array<ScratchFolder, 1> work_;
  std::filesystem::path log_ = make_log_folder();
  static std::filesystem::path make_log_folder() {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("ptmsim-log-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
    return path;
  }
  void TearDown() override { std::filesystem::remove_all(log_); }
};

Bytes good() { return golden::format_ptm(made_map(golden::MapKind::lrgb, 6, 4, 1)); }

TEST_F(FileCommands, MissingAndEmptyFilesEndWithCode3) {
  expect_refused(path("none.ptm"), "none.ptm: file: found No such file or directory");
  expect_refused(put("empty.ptm", {}), "empty.ptm: byte 0: found an empty file");
}

TEST_F(FileCommands, FilesCutAtAnyHeaderLineOrInThePayloadEndWithCode3) {
  const Bytes whole = good();
  int line = 1;
  for (std::size_t i = 6; i < whole.size() && line <= 6; ++i) {
    if (whole[i] != '\n') continue;
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i));
    expect_refused(put("cut.ptm", cut), "cut.ptm: line " + std::to_string(line++));
  }
  EXPECT_EQ(line, 7);
  expect_refused(put("cut.ptm", {whole.begin(), whole.end() - 1}), "(payload)");
}

TEST_F(FileCommands, FilesWithTrailingBytesEndWithCode3) {
  const std::string file = put("long.ptm", good() + Bytes{0});
  expect_refused(file, "(payload): found 1 more byte,");
  expect_refused(file, "(payload): found 1 more byte,", "info");
}

TEST_F(FileCommands, ZeroAndAbsurdSizesEndWithCode3) {
  const auto sized = [](const std::string& size) {
    return to_bytes("PTM_1.2\nPTM_FORMAT_LRGB\n" + size + "\n" + scales_and_biases) + counting(99);
  };
  expect_refused(put("a.ptm", sized("0\n4")), "line 3 (width)");
  expect_refused(put("a.ptm", sized("4\n0")), "line 4 (height)");
  expect_refused(put("a.ptm", sized("2000000000\n2000000000")), "(payload)");
}

TEST_F(FileCommands, ScalesThatAreNoneEndWithCode3) {
  for (const char* bad : {"nan", "inf", "0"}) {
    const std::string text =
        std::string("PTM_1.2\nPTM_FORMAT_LRGB\n1\n1\n1 1 ") + bad + " 1 1 1\n0 0 0 0 0 0\n";
    expect_refused(put("a.ptm", to_bytes(text) + counting(9)), "line 5 (scales)");
  }
}

TEST_F(FileCommands, UnknownFormatsEndWithCode3) {
  expect_refused(put("a.ptm", to_bytes(header_of("PTM_LUT", 1, 1)) + counting(9)),
                 "line 2 (format): found \"PTM_FORMAT_PTM_LUT\"");
  expect_refused(put("a.ptm", to_bytes("#HSH1.2\n")), "byte 0");
}

TEST_F(FileCommands, BrokenJpegStreamsAndSizesThatDoNotAddUpEndWithCode3) {
  CraftedPlanes file(golden::Coding::jpeg, "JPEG_LRGB", 8, 8);
  Bytes bytes = file.bytes();
  bytes.pop_back();
  expect_refused(put("a.ptm", bytes), "(payload)");
  file.streams[4] = Bytes(200, 0x55);
  expect_refused(put("a.ptm", file.bytes()), "plane 4 at byte ");
}

TEST_F(FileCommands, BrokenPicturesEndWithCode3) {
  expect_refused(put("a.png", to_bytes("not a picture")), "a.png: file: found ", "info");
}

TEST_F(FileCommands, WrongUsageEndsWithCode2AndWritesNothing) {
  const std::string file = put("a.ptm", good());
  const std::string lum =
      put("lum.ptm", golden::format_ptm(made_map(golden::MapKind::lum, 6, 4, 1)));
  for (const std::string& arguments :
       {std::string("info"), std::string("convert ") + file, "info --none " + file,
        "convert " + file + " " + path("o.ptm") + " --format gif",
        "convert " + file + " " + path("o.ptm") + " --format raw --lossy",
        "convert " + file + " " + path("o.ptm") + " --format jpeg --version 1.1",
        "convert " + file + " " + path("o.ptm") + " --format jpeg --quality 101",
        "convert " + lum + " " + path("o.ptm") + " --format jpegls"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << outcome.err;
  }
  EXPECT_EQ(folder_().files(), 2U);
}

TEST_F(FileCommands, InfoTellsInJsonWhatTheFileHolds) {
  const Outcome outcome = run("info --all --json " + put("a.ptm", good()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto info = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(info["format"], "PTM_FORMAT_LRGB");
  EXPECT_EQ(info["width"], 6);
  EXPECT_EQ(info["height"], 4);
  EXPECT_EQ(info["bias"][1], -715);
  EXPECT_EQ(info["scale"][2], -0.1);
  EXPECT_EQ(info["payload_bits_per_texel"], 72.0);
  ASSERT_EQ(info["bytes"].size(), 9U);
  const golden::PtmMap map = made_map(golden::MapKind::lrgb, 6, 4, 1);
  int least = 255;
  for (std::size_t i = 1; i < map.color.size(); i += 3) least = std::min<int>(least, map.color[i]);
  EXPECT_EQ(info["bytes"][7]["name"], "G");
  EXPECT_EQ(info["bytes"][7]["min"], least);
}

TEST_F(FileCommands, EveryCodingLeadsBackToTheSameBytes) {
  const Bytes bytes = good();
  const std::string file = put("a.ptm", bytes);
  for (const char* format : {"--format jpeg", "--format jpegls", "--format raw --version 1.1"}) {
    const Outcome there = run("convert " + file + " " + path("b.ptm") + " " + format);
    ASSERT_EQ(there.code, 0) << there.err;
    EXPECT_NE(there.out.find("0 of 144 bytes differ"), std::string::npos) << there.out;
    const Outcome back = run("convert " + path("b.ptm") + " " + path("c.ptm"));
    ASSERT_EQ(back.code, 0) << back.err;
    EXPECT_EQ(text_of(folder_() / "c.ptm"), std::string(bytes.begin(), bytes.end())) << format;
  }
}

TEST_F(FileCommands, LossyConversionReportsItsDifference) {
  const std::string file =
      put("a.ptm", golden::format_ptm(made_map(golden::MapKind::lrgb, 32, 32, 1)));
  const Outcome outcome =
      run("convert --json --format jpeg --lossy --quality 50 " + file + " " + path("b.ptm"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_GT(report["coefficients"]["differing"], 1000);
  EXPECT_GT(report["colors"]["max"], 10);
}

}  // namespace
}  // namespace ptm::tests
