#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/image.h"

namespace ptm::testbench {

/// A counter of one model; names and meanings are the same in every model (docs/spec/pipeline.md).
struct Counter {
  std::string name;
  std::uint64_t value = 0;
};

/// What one model made of a scene.
struct ModelResult {
  std::string model;  ///< "golden", "reference", "pipeline" or "rtl"
  /// One picture a light, RGB, in 8-bit levels: golden's real-valued and clamped to 0..255, the
  /// others' the integers that the hardware gives.
  std::vector<golden::ImageReal> frames;
  double seconds = 0;                   ///< wall time of the model alone, all frames
  std::optional<std::uint64_t> cycles;  ///< models of time only, all frames
  std::vector<Counter> counters;
};

/// An intermediate value of one pixel in one model, ready to print.
struct NamedValue {
  std::string name;  ///< "d0", "uu", "acc", ... as in docs/spec/datapath.md
  std::string value;
};

/// Every operand and intermediate value of one pixel in one model, in order of the datapath.
using PixelProbe =
    std::function<std::vector<NamedValue>(const std::string& model, int frame, int x, int y)>;

/// A preset's reference picture, all frames, beside golden's.
struct PresetFrames {
  std::string preset;
  std::vector<golden::ImageReal> frames;
};

struct RunResult {
  std::string scene_file, map_file, map_format, preset;
  int width = 0, height = 0;
  std::vector<std::array<double, 2>> lights;  ///< (lu, lv), one a frame
  std::vector<ModelResult> models;            ///< in the order golden, reference, pipeline, rtl
  std::vector<PresetFrames> presets;          ///< for the table "error against golden per preset"
  PixelProbe probe;
  std::vector<std::string> notes;  ///< said to the user as they are
};

}  // namespace ptm::testbench
