#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "golden/files/light_positions.h"
#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "tests/program/small_map.h"
#include "tests/run_program.h"

namespace ptm::tests {

/// A command of the program that writes files.
struct WritingCommand {
  std::string name;
  /// Its words; OUT stands for the folder that it is to write in.
  std::vector<std::string> words;
  /// What it writes there.
  std::vector<std::string> files;
};

/// A small capture of one surface under lights all around.
inline void write_capture(const std::filesystem::path& list, int side) {
  std::vector<golden::LitPicture> pictures;
  for (int n = 0; n < 8; ++n) {
    golden::Image8 image(side, side, 3);
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
      image.samples[i] = static_cast<std::uint8_t>(40 + (i * 7 + i / 64) % 60 +
                                                   static_cast<std::size_t>(n % 4) * 12);
    }
    const double lu = 0.3 * (n % 3) - 0.3, lv = 0.25 * (n / 3) - 0.3;
    pictures.push_back({.picture = list.parent_path() /
                                   std::string("light").append(std::to_string(n)).append(".png"),
                        .direction = {lu, lv, std::sqrt(1 - lu * lu - lv * lv)}});
    golden::write_picture(pictures.back().picture, image);
  }
  golden::write_light_positions(list, pictures);
}

inline std::string flat_scene(const std::string& map, const std::string& models, int lights) {
  std::string text = "models = [" + models + "]\n[map]\nfile = \"" + map + "\"\n";
  for (int n = 0; n < lights; ++n) {
    text += "[[light]]\ndirection = [0." + std::to_string(n + 1) + ", 0.2]\n";
  }
  return text;
}

/// One of each, small; the inputs lie in `in`. `size` scales the work of those that are killed.
inline std::vector<WritingCommand> writing_commands(const std::filesystem::path& in, int size) {
  std::filesystem::create_directories(in);
  write_capture(in / "capture.lp", size);
  golden::write_ptm(in / "map.ptm", small_map(golden::MapKind::lrgb, size, size));
  golden::write_ptm(in / "small.ptm", small_map(golden::MapKind::lrgb, 48, 48));
  golden::Image8 heights(size, size, 1);
  for (std::size_t i = 0; i < heights.samples.size(); ++i) {
    heights.samples[i] = static_cast<std::uint8_t>(i * 31 % 200);
  }
  golden::write_picture(in / "heights.png", heights);
  std::ofstream(in / "scene.toml")
      << flat_scene("small.ptm", R"("golden", "reference", "pipeline", "rtl")", 2);
  const std::string map = (in / "map.ptm").string(), capture = (in / "capture.lp").string();
  return {
      {"fit",
       {"fit", capture, "--out", "OUT/f.ptm", "--residual", "OUT/r.png", "--table", "OUT/t.json",
        "--memory", "1"},
       {"f.ptm", "r.png", "t.json"}},
      {"render", {"render", map, "--light", "0.3,0.2", "--out", "OUT/p.bmp"}, {"p.bmp"}},
      {"run",
       {"run", (in / "scene.toml").string(), "--out", "OUT"},
       {"golden_00.png", "golden_01.png", "pipeline_00.png", "pipeline_01.png", "reference_00.png",
        "reference_01.png", "report.html", "report.json", "rtl_00.png", "rtl_01.png"}},
      {"convert", {"convert", map, "OUT/c.ptm", "--format", "jpegls"}, {"c.ptm"}},
      {"convert_mip",
       {"convert", (in / "small.ptm").string(), "OUT/m.ptm", "--mip"},
       {"m.0.ptm", "m.1.ptm", "m.2.ptm", "m.3.ptm", "m.4.ptm", "m.5.ptm"}},
      {"bump", {"bump", (in / "heights.png").string(), "--out", "OUT/b.ptm"}, {"b.ptm"}},
      {"synthesize",
       {"synthesize", "--out", "OUT", "--size", "64", "--lights", "3"},
       {"capture.lp", "photo_001.png", "photo_002.png", "photo_003.png"}}};
}

inline std::vector<std::string> words_for(const WritingCommand& command,
                                          const std::filesystem::path& out) {
  std::vector<std::string> words = command.words;
  for (std::string& word : words) {
    if (word.starts_with("OUT")) word = out.string().append(word, 3);
  }
  return words;
}

inline std::string shell_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text.append(text.empty() ? "" : " ").append(tests::quoted(word));
  return text;
}

/// Names in a folder, sorted; hidden ones too.
inline std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; entry != end; ++entry) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace ptm::tests
