#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "testbench/compare/part_difference.h"
#include "testbench/compare/picture_difference.h"
#include "testbench/run/run_result.h"

namespace ptm::testbench {

struct PairDifference {
  std::string a, b;  ///< model names; errors are b - a
  PictureDifference difference;
  bool must_agree = false;  ///< neither is golden: one differing sample is a defect
  /// Against golden, without the samples on edges between texels; nothing if there is no such
  /// sample, or no other.
  std::optional<PartDifference> off_edges;
};

struct PresetDifference {
  std::string preset;
  PictureDifference difference;             ///< preset - golden
  std::optional<PartDifference> off_edges;  ///< as PairDifference's
};

/// One model's account of one pixel.
struct PixelValues {
  std::string model;
  std::array<double, 3> rgb{};     ///< its picture's sample, levels
  std::vector<NamedValue> values;  ///< from RunResult::probe, may be empty
};

struct ProbedPixel {
  std::string a, b;  ///< the pair that differs here
  WorstPixel where;
  std::vector<PixelValues> models;
};

/// All that a report says about differences.
struct RunComparison {
  std::vector<PairDifference> pairs;  ///< every pair, in the order of RunResult::models
  std::vector<PresetDifference> presets;
  /// Up to ten pixels. Pairs that must agree come first, however small their error: there a
  /// difference is a defect. Then by error, then frame, y, x; no pixel twice.
  std::vector<ProbedPixel> worst;
  /// Samples on edges between texels, of all lights (RunResult::edge_pixels).
  std::uint64_t edge_samples = 0;
  [[nodiscard]] bool models_agree() const;  ///< in every pair that must
};

/// A sentence on the samples that lie on edges between texels, and what a pair's error is without
/// them; empty if there is no such sample. The pair is golden's with a model of hardware.
[[nodiscard]] std::string edge_sentence(const RunComparison& comparison,
                                        const PairDifference& pair);

/// Compares every two models over all frames, and every preset's frames with golden's (no golden,
/// no presets).
/// Throws std::invalid_argument, naming model and frame, if a model's frames are not one a light
/// of width x height x 3, if a model's name is not of [A-Za-z0-9_-] or stands twice, if there is
/// no model, or a sample is not finite.
[[nodiscard]] RunComparison compare_run(const RunResult& result);

}  // namespace ptm::testbench
