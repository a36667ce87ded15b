#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "golden/fit/capture.h"
#include "golden/fit/contradiction.h"
#include "golden/fit/fit_quality.h"
#include "testbench/program/fit_job.h"

namespace ptm::testbench {

/// Compares a fit, band by band, with the photographs that it was made from and with others:
/// docs/spec/fit.md, section 4.
class FitJudge {
 public:
  /// All that is named must stay; bands hold the photographs of `training`, then of `held_out`.
  FitJudge(const golden::Capture& training, const golden::Capture& held_out,
           const golden::LightSolver& solver, const golden::FitOptions& options);

  /// `coef` as fitted, `stored` as the map holds it. `residual_rows`, if not empty, gets each
  /// texel's grey level of the residual picture.
  void add(const golden::Band& band, std::span<const double> coef, std::span<const double> stored,
           std::span<const std::uint8_t> color, std::span<std::uint8_t> residual_rows);

  /// Writes the figures of all bands.
  void finish(FitOutcome& outcome) const;

 private:
  /// Squared differences by light: of the fit, and of the stored map.
  struct LightSums {
    std::vector<golden::Squares> real, stored;
    explicit LightSums(std::size_t lights) : real(lights), stored(lights) {}
    void add(const LightSums& other);
  };
  struct Sums {
    LightSums training, held_out;
    std::vector<double> leave_one_out;
    Sums(std::size_t lights, std::size_t others)
        : training(lights), held_out(others), leave_one_out(lights) {}
  };
  [[nodiscard]] FitJudgement judgement(const golden::Capture& capture, const LightSums& sums) const;
  void take_sample(const golden::Band& band);
  void take_near_design(std::size_t texel, Eigen::VectorXd& levels);
  void find_contradictions(FitOutcome& outcome) const;

  const golden::Capture& training_;
  const golden::Capture& held_out_;
  const golden::LightSolver& solver_;
  std::optional<golden::NearLights> near_, near_held_out_;
  golden::FitOptions options_;
  Sums sums_;
  double texels_ = 0;   ///< seen so far
  std::size_t stride_;  ///< of all texels, one in so many is looked at for contradictions
  golden::ContradictionSample sample_;
};

}  // namespace ptm::testbench
