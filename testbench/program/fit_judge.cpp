#include "testbench/program/fit_judge.h"

#include <algorithm>
#include <cmath>

namespace ptm::testbench {
namespace {

using golden::Squares;

/// Grey levels of the residual picture for one level of RMS residual.
constexpr double kResidualGain = 4;

/// Texels looked at for contradictions, at most about.
constexpr std::size_t kSampleTexels = 4096;

}  // namespace

FitJudge::FitJudge(const golden::Capture& training, const golden::Capture& held_out,
                   const golden::LightSolver& solver, const golden::FitOptions& options)
    : training_(training),
      held_out_(held_out),
      solver_(solver),
      options_(options),
      sums_(training.names.size(), held_out.names.size()) {
  const auto texels = static_cast<std::size_t>(training.region.width) *
                      static_cast<std::size_t>(training.region.height);
  stride_ = (texels + kSampleTexels - 1) / kSampleTexels;
  sample_.fitted = training.names.size();
  if (training.frame) {  // each texel has a design of its own
    near_.emplace(training.positions, *training.frame);
    if (held_out.frame) near_held_out_.emplace(held_out.positions, *held_out.frame);
    return;
  }
  auto& design = sample_.designs.emplace_back(
      static_cast<Eigen::Index>(training.names.size() + held_out.names.size()), 6);
  Eigen::Index row = 0;
  for (const golden::Capture* capture : {&training, &held_out}) {
    for (const auto& d : capture->directions) {
      design.row(row++) = golden::light_basis(d[0], d[1]).transpose();
    }
  }
}

void FitJudge::LightSums::add(const LightSums& other) {
  for (std::size_t i = 0; i < real.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      real[i][c] += other.real[i][c];
      stored[i][c] += other.stored[i][c];
    }
  }
}

void FitJudge::add(const golden::Band& band, std::span<const double> coef,
                   std::span<const double> stored, std::span<const std::uint8_t> color,
                   std::span<std::uint8_t> residual_rows) {
  const std::size_t lights = training_.names.size();
  const std::size_t numbers = coef.size() / band.texels, bytes = color.size() / band.texels;
  const double samples = 3 * static_cast<double>(lights);
  const std::size_t above = band.before(training_.region.width);
  std::vector<Sums> tiles(golden::tiles_of(band.texels), Sums(lights, held_out_.names.size()));
  golden::for_each_tile(band.texels, [&](std::size_t tile, std::size_t first, std::size_t count) {
    Sums& sums = tiles[tile];
    const auto real_part = coef.subspan(first * numbers, count * numbers);
    const auto stored_part = stored.subspan(first * numbers, count * numbers);
    const auto color_part = color.subspan(first * bytes, count * bytes);
    const auto compare = [&](const golden::Capture& with, std::size_t photograph, LightSums& to,
                             const std::optional<golden::NearLights>& lit,
                             std::span<double> texels) {
      if (with.names.empty()) return;
      const golden::PhotoTile seen = band.tile(first, count, photograph);
      const golden::NearTexels near{lit ? &*lit : nullptr, above + first};
      golden::add_squares(seen, with.directions, options_.kind, real_part, color_part, to.real, {},
                          near);
      golden::add_squares(seen, with.directions, options_.kind, stored_part, color_part, to.stored,
                          texels, near);
    };
    std::vector<double> texels(residual_rows.empty() ? 0 : count);
    compare(training_, 0, sums.training, near_, texels);
    compare(held_out_, lights, sums.held_out, near_held_out_, {});
    if (options_.robust_passes == 0) {
      golden::add_leave_one_out(band.tile(first, count, 0), solver_, options_.kind,
                                sums.leave_one_out, {near_ ? &*near_ : nullptr, above + first});
    }
    for (std::size_t t = 0; t < texels.size(); ++t) {
      const double level = kResidualGain * std::sqrt(texels[t] / samples);
      residual_rows[first + t] = static_cast<std::uint8_t>(std::min(level + 0.5, 255.0));
    }
  });
  for (const Sums& one : tiles) {
    sums_.training.add(one.training);
    sums_.held_out.add(one.held_out);
    for (std::size_t i = 0; i < lights; ++i) sums_.leave_one_out[i] += one.leave_one_out[i];
  }
  take_sample(band);
  texels_ += static_cast<double>(band.texels);
}

FitJudgement FitJudge::judgement(const golden::Capture& capture, const LightSums& sums) const {
  FitJudgement result;
  Squares real{}, stored{};
  for (std::size_t i = 0; i < capture.names.size(); ++i) {
    result.lights.push_back(golden::to_residual(sums.stored[i], texels_));
    for (std::size_t c = 0; c < 3; ++c) {
      real[c] += sums.real[i][c];
      stored[c] += sums.stored[i][c];
    }
  }
  const double samples = texels_ * static_cast<double>(capture.names.size());
  result.real = golden::to_residual(real, samples);
  result.stored = golden::to_residual(stored, samples);
  result.names = capture.names;
  result.directions = capture.directions;
  return result;
}

/// Texels drawn by a fixed hash, so that no regular pattern of the picture meets a regular one of
/// the sample.
void FitJudge::take_sample(const golden::Band& band) {
  const std::size_t photographs = training_.names.size() + held_out_.names.size();
  for (std::size_t t = 0; t < band.texels; ++t) {
    const auto number = static_cast<std::uint64_t>(texels_) + t;
    if ((number * 0x9E3779B97F4A7C15 >> 32) % stride_ != 0) continue;
    const golden::PhotoTile tile = band.tile(t, 1, 0);
    Eigen::VectorXd& levels = sample_.levels.emplace_back(static_cast<Eigen::Index>(photographs));
    for (std::size_t i = 0; i < photographs; ++i) {
      double y = 0;
      for (std::size_t c = 0; c < 3; ++c) y += golden::kLumaWeights[c] * double{*tile.plane(i, c)};
      levels[static_cast<Eigen::Index>(i)] = y;
    }
    if (near_) take_near_design(number, levels);
  }
}

/// The rows of the basis at one texel; its levels lose their fall-off.
void FitJudge::take_near_design(std::size_t texel, Eigen::VectorXd& levels) {
  auto& design = sample_.designs.emplace_back(levels.size(), 6);
  Eigen::Index row = 0;
  for (const auto* lights : {&near_, &near_held_out_}) {
    for (std::size_t i = 0; *lights && i < (*lights)->size(); ++i, ++row) {
      const golden::NearLights::Seen seen = (*lights)->at(i, texel);
      design.row(row) = golden::light_basis(seen.u, seen.v).transpose();
      levels[row] /= seen.falloff;
    }
  }
}

void FitJudge::find_contradictions(FitOutcome& outcome) const {
  const golden::Contradictions found = golden::find_contradictions(sample_);
  const auto take = [&](FitJudgement& judged, std::size_t first) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    const auto to = from + static_cast<std::ptrdiff_t>(judged.names.size());
    judged.contradicts.assign(found.contradicts.begin() + from, found.contradicts.begin() + to);
    judged.figures.assign(found.figures.begin() + from, found.figures.begin() + to);
  };
  take(outcome.training, 0);
  if (outcome.held_out) take(*outcome.held_out, training_.names.size());
}

void FitJudge::finish(FitOutcome& outcome) const {
  outcome.training = judgement(training_, sums_.training);
  if (!held_out_.names.empty()) outcome.held_out = judgement(held_out_, sums_.held_out);
  find_contradictions(outcome);
  if (options_.robust_passes > 0) return;
  const double samples =
      texels_ * static_cast<double>(golden::fitted_signals(options_.kind).size());
  double all = 0, count = 0;
  for (std::size_t i = 0; i < sums_.leave_one_out.size(); ++i) {
    outcome.leave_one_out.emplace_back();
    if (!golden::has_leave_one_out(solver_, i)) continue;
    outcome.leave_one_out.back() = std::sqrt(sums_.leave_one_out[i] / samples);
    all += sums_.leave_one_out[i];
    count += samples;
  }
  if (count > 0) outcome.leave_one_out_rmse = std::sqrt(all / count);
}

}  // namespace ptm::testbench
