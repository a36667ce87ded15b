#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/fit/capture.h"
#include "golden/fit/fit_quality.h"
#include "golden/fit/light_coverage.h"
#include "model/quantize/balance.h"
#include "testbench/program/map_storage.h"

namespace ptm::testbench {

struct FitJob {
  golden::CaptureRequest capture;
  golden::FitOptions fit;
  std::filesystem::path out;
  std::filesystem::path residual;  ///< picture of the stored map's residuals; empty: none
  std::filesystem::path test;      ///< a second .lp to judge by; empty: none
  int hold_out = 0;                ///< every n-th photograph is for judging only; 0: none
  std::string quantizer = "nearest_plane";
  reference::EvalConfig config;
  std::size_t memory = std::size_t{256} << 20;  ///< bytes of photographs held at once
};

/// The residuals of photographs under one set of lights.
struct FitJudgement {
  std::vector<std::string> names;
  std::vector<std::array<double, 3>> directions;
  golden::Residual real, stored;         ///< over all of them
  std::vector<golden::Residual> lights;  ///< of the stored map, one a photograph
  std::vector<bool> contradicts;         ///< of golden/fit/contradiction.h, as the next
  std::vector<std::optional<double>> figures;
};

struct FitOutcome {
  int width = 0, height = 0;
  int bands = 0;
  golden::LightSolver solver;
  golden::LightCoverage coverage;
  FitJudgement training;
  std::optional<FitJudgement> held_out;
  /// RMS leave-one-out residual of the fitted signals, in levels, one a photograph (none where no
  /// other light determines it) and over those that have one; empty after a robust fit.
  std::vector<std::optional<double>> leave_one_out;
  std::optional<double> leave_one_out_rmse;
  std::array<double, 6> scale{};
  std::array<std::int32_t, 6> bias{};
  std::optional<std::array<int, 6>> shift;
  quantize::Balance balance;  ///< of an LRGB map's luminance and colour
  StorageLoss loss;
  std::uint64_t saturated_samples = 0, black_texels = 0;
  double read_seconds = 0, fit_seconds = 0, quantize_seconds = 0, judge_seconds = 0;
  std::vector<std::string> notes;
};

/// Fits, stores, judges and writes, in bands of bounded memory: docs/design/streaming-fit.md.
/// `step(done, total)` is called after each band; `whole(outcome)` when all outputs are written and
/// none has its name yet. Throws InputError, and what `whole` throws; then no output is there.
[[nodiscard]] FitOutcome run_fit(const FitJob& job,
                                 const std::function<void(std::size_t, std::size_t)>& step = {},
                                 const std::function<void(const FitOutcome&)>& whole = {});

}  // namespace ptm::testbench
