#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/image.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_counters.h"
#include "testbench/run/effect_cost.h"
#include "testbench/run/made_by.h"
#include "testbench/run/run_config.h"

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

/// One timed model of the whole unit: "pipeline" is the timing `exact`, "loose" the other one.
struct UnitTiming {
  std::string model;  ///< "pipeline", "loose" or "rtl"
  double seconds = 0;
  bool estimate = false;  ///< loose: knows fragments, pixels, cycles, beats and lines_read only
  reference::UnitCounters counters;  ///< over all frames
  /// Lines that arrived in each window of `UnitSection::window` cycles, frames one after another;
  /// empty for loose.
  std::vector<std::uint32_t> lines_per_window;
};

/// A draw of the scene, for the table of hit rates.
struct UnitDraw {
  std::string object;                  ///< as the scene names it
  std::string texture;                 ///< of the map; empty if it has none
  std::string color;                   ///< of the colour texture; empty if it has none
  double cycles_per_pixel = 0;         ///< warm, by the formula of docs/spec/unit-timing.md
  std::vector<std::string> effects{};  ///< names
};

/// What only scenes of the whole unit have (docs/spec/unit-timing.md).
struct UnitSection {
  /// What effects had built in: a sentence a block; empty if none needs hardware of its own.
  std::vector<std::string> effect_blocks;
  reference::UnitConfig config;
  std::string memory;        ///< one sentence
  std::uint64_t window = 1;  ///< cycles
  std::vector<UnitDraw> draws;
  std::vector<UnitTiming> timings;
  std::uint64_t late_pixels = 0;                ///< pipeline against rtl, 0 if one did not run
  std::vector<std::string> differing_counters;  ///< pipeline against rtl
};

/// What lit a frame: (lu, lv) in every point's own frame, or in a unit scene's world the direction
/// toward a light or the position of one.
struct FrameLight {
  double x = 0, y = 0, z = 0;  ///< lu, lv and 0 if local
  enum class Kind : std::uint8_t { local, direction, position } kind = Kind::local;
};

struct RunResult {
  std::string scene_file, map_file, map_format, preset;
  int width = 0, height = 0;
  RunConfig config;                   ///< of the models
  MadeBy made_by;                     ///< set by the command that runs
  std::vector<FrameLight> lights;     ///< one a frame
  std::vector<ModelResult> models;    ///< in the order golden, reference, pipeline, rtl
  std::vector<PresetFrames> presets;  ///< for the table "error against golden per preset"
  /// 1 for each pixel, [height][width], whose sample lies on an edge between texels
  /// (edge_samples.h), the same under every light; empty if none does.
  std::vector<std::uint8_t> edge_pixels;
  std::optional<UnitSection> unit;   ///< nothing for a flat map
  std::optional<EffectCosts> costs;  ///< nothing unless they were asked for
  PixelProbe probe;
  std::vector<std::string> notes;  ///< said to the user as they are
};

}  // namespace ptm::testbench
