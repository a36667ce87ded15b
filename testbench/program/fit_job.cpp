#include "testbench/program/fit_job.h"

#include <algorithm>
#include <cmath>

#include "golden/files/figure_text.h"
#include "golden/files/lum_matrix.h"
#include "golden/files/number_text.h"
#include "golden/files/picture_row_writer.h"
#include "golden/files/ptm_row_writer.h"
#include "testbench/program/fit_judge.h"
#include "testbench/program/roomy_buffer.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/stopwatch.h"

namespace ptm::testbench {
namespace {

using golden::Band;
using golden::Capture;
using golden::InputError;

/// Polynomials that scales and biases are chosen by, at most about.
constexpr std::size_t kSamplePolynomials = std::size_t{1} << 16;

/// Photographs that a note names one by one.
constexpr std::size_t kPhotographsTold = 8;

/// Adds the time of a scope to a sum.
class Timed {
 public:
  explicit Timed(double& seconds) : seconds_(seconds) {}
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;
  ~Timed() { seconds_ += watch_.seconds(); }

 private:
  double& seconds_;
  Stopwatch watch_;
};

/// Moves every n-th photograph to a capture of its own.
Capture split_off(Capture& capture, int n) {
  Capture kept, held;
  kept.region = held.region = capture.region;
  kept.frame = held.frame = capture.frame;
  kept.notes = std::move(capture.notes);
  for (std::size_t i = 0; i < capture.names.size(); ++i) {
    Capture& to = (i + 1) % static_cast<std::size_t>(n) == 0 ? held : kept;
    to.names.push_back(std::move(capture.names[i]));
    to.directions.push_back(capture.directions[i]);
    if (capture.frame) to.positions.push_back(capture.positions[i]);
    to.photographs.push_back(std::move(capture.photographs[i]));
  }
  capture = std::move(kept);
  return held;
}

class Runner {
 public:
  Runner(const FitJob& job, const std::function<void(std::size_t, std::size_t)>& step,
         const std::function<void(const FitOutcome&)>& whole)
      : job_(job), step_(step), whole_(whole), storage_(job.quantizer, job.config) {
    shape_.kind = job.fit.kind;
    shape_.lum_matrix = golden::jfif_lum_matrix();
  }

  FitOutcome run() {
    open();
    Capture* const both[] = {&training_, &held_out_};
    const std::size_t beside = polynomials() * (12 * sizeof(double) + 6) + 32;
    golden::PhotoBands bands(both, job_.memory, beside);
    out_.bands = bands.bands();
    const std::size_t total = static_cast<std::size_t>(bands.bands()) * 2;
    for (int b = 0; b < bands.bands(); ++b) {
      read(bands, b);
      fit();
      gather();
      if (step_) step_(++steps_, total);
    }
    count_samples(bands);
    choose();
    golden::PtmRowWriter writer(job_.out, shape_);
    if (!job_.residual.empty()) residual_.emplace(job_.residual, shape_.width, shape_.height);
    for (int b = 0; b < bands.bands(); ++b) {
      if (bands.bands() > 1) {
        read(bands, b);
        fit();
      }
      store();
      judge();
      writer.write(band_.first_row, band_.rows, bytes_.all(), color_);
      if (step_) step_(++steps_, total);
    }
    judge_->finish(out_);
    tell_contradictions(out_.training);
    if (out_.held_out) tell_contradictions(*out_.held_out);
    if (residual_) residual_->finish();
    writer.finish();
    if (whole_) whole_(out_);
    const golden::HeldSignals held;
    if (residual_) residual_->commit();
    writer.commit();
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::size_t polynomials() const { return shape_.polynomials(); }

  /// Outputs that cannot be written are refused before hours of work, not after.
  void check_outputs() const {
    const golden::PendingFile map(job_.out);
    if (!job_.residual.empty()) const golden::PendingFile picture(job_.residual);
  }

  void open() {
    check_outputs();
    training_ = golden::open_capture(job_.capture);
    const std::string& name = job_.capture.source.string();
    if (!job_.test.empty()) {
      golden::CaptureRequest other = job_.capture;
      other.source = job_.test;
      other.lights.clear();
      other.pictures.folder.clear();
      held_out_ = golden::open_capture(other);
      if (held_out_.region.width != training_.region.width ||
          held_out_.region.height != training_.region.height) {
        throw InputError(job_.test.string(), "photographs",
                         std::to_string(held_out_.region.width) + " x " +
                             std::to_string(held_out_.region.height) + " pixels",
                         std::to_string(training_.region.width) + " x " +
                             std::to_string(training_.region.height) + " like the ones fitted");
      }
    } else if (job_.hold_out > 1) {
      held_out_ = split_off(training_, job_.hold_out);
    }
    if (training_.names.size() < 2) {
      throw InputError(name, "lights", std::to_string(training_.names.size()) + " to fit",
                       "two or more: one photograph shows no dependence on light");
    }
    out_.width = shape_.width = training_.region.width;
    out_.height = shape_.height = training_.region.height;
    out_.notes = training_.notes;
    if (shape_.kind == golden::MapKind::lum) {
      out_.notes.emplace_back("no other program reads PTM_FORMAT_LUM");
    }
    for (const std::string& note : held_out_.notes) {
      out_.notes.push_back(job_.test.filename().string() + ": " + note);
    }
    solve();
  }

  void solve() {
    out_.solver = golden::solve_lights(training_.directions);
    if (training_.frame) near_.emplace(training_.positions, *training_.frame);
    const int full = job_.capture.univariate ? 3 : 6;
    const std::string lights = "the " + std::to_string(training_.names.size()) + " lights ";
    const std::string condition = golden::format_real(std::round(out_.solver.condition));
    if (out_.solver.rank < full) {
      out_.notes.push_back(lights + "determine " + std::to_string(out_.solver.rank) + " of " +
                           std::to_string(full) +
                           " coefficients; the smallest polynomials that fit were taken, their "
                           "condition number is " +
                           condition);
    } else if (out_.solver.condition > golden::kIllConditioned) {
      out_.notes.push_back(lights + "are ill-conditioned: condition number " + condition);
    }
    tell_coverage();
    judge_.emplace(training_, held_out_, out_.solver, job_.fit);
    const std::size_t all = shape_.texels() * polynomials();
    stride_ = (all + kSamplePolynomials - 1) / kSamplePolynomials;
  }

  void tell_coverage() {
    if (job_.capture.univariate) return;  // a line of lights, not a hemisphere
    out_.coverage = golden::cover_hemisphere(out_.solver);
    if (out_.coverage.extrapolated < golden::kNarrowCoverage) return;
    out_.notes.push_back(
        "the lights leave " +
        std::to_string(static_cast<int>(std::round(100 * out_.coverage.extrapolated))) +
        " % of the hemisphere to extrapolation, where the map tells less than one photograph: "
        "light " +
        out_.coverage.directions);
  }

  void tell_contradictions(const FitJudgement& judged) {
    std::string names;
    std::size_t count = 0;
    for (std::size_t i = 0; i < judged.names.size(); ++i) {
      if (!judged.contradicts[i] || ++count > kPhotographsTold) continue;
      names += (names.empty() ? "" : ", ") + judged.names[i] + " (" +
               golden::format_real(std::round(judged.figures[i].value_or(0) * 10) / 10) +
               " levels RMS)";
    }
    if (count == 0) return;
    if (count > kPhotographsTold) names += ", ...";
    out_.notes.push_back(std::to_string(count) + (&judged == &out_.training ? "" : " held-out") +
                         " of " + std::to_string(judged.names.size()) +
                         " photographs contradict the others; look at exposure, light and place "
                         "in the list of " +
                         names);
  }

  void read(golden::PhotoBands& bands, int index) {
    const Timed timed(out_.read_seconds);
    bands.read(index, band_);
  }

  void fit() {
    const Timed timed(out_.fit_seconds);
    coef_.resize(band_.texels * polynomials() * 6);
    color_.resize(band_.texels * shape_.color_bytes());
    balances_.assign(golden::tiles_of(band_.texels), {});
    golden::for_each_tile(band_.texels, [&](std::size_t tile, std::size_t first, std::size_t n) {
      golden::fit_tile(band_.tile(first, n, 0), out_.solver, job_.fit, coef_of(first, n),
                       color_of(first, n), near_texels(first));
      if (!balances()) return;
      balances_[tile] = quantize::balance_luminance(coef_of(first, n), color_of(first, n),
                                                    balance_lights_, job_.config);
    });
  }

  [[nodiscard]] golden::NearTexels near_texels(std::size_t first) const {
    return {near_ ? &*near_ : nullptr, band_.before(shape_.width) + first};
  }

  /// HP's fitter knows no limit of luminance, and colours of other kinds are no factors.
  [[nodiscard]] bool balances() const {
    return shape_.kind == golden::MapKind::lrgb && job_.quantizer != "hp";
  }

  [[nodiscard]] std::span<double> coef_of(std::size_t first, std::size_t count) {
    return coef_.part(first * polynomials() * 6, count * polynomials() * 6);
  }
  [[nodiscard]] std::span<std::uint8_t> bytes_of(std::size_t first, std::size_t count) {
    return bytes_.part(first * polynomials() * 6, count * polynomials() * 6);
  }
  [[nodiscard]] std::span<std::uint8_t> color_of(std::size_t first, std::size_t count) {
    return std::span(color_).subspan(first * shape_.color_bytes(), count * shape_.color_bytes());
  }

  /// Keeps what scales and biases are chosen by: the range of all, and polynomials of texels drawn
  /// by a fixed hash, so that no regular pattern of the picture meets a regular one of the sample.
  void gather() {
    for (const quantize::Balance& balance : balances_) {
      out_.balance.exceeding += balance.exceeding;
      out_.balance.scaled += balance.scaled;
      out_.balance.remaining += balance.remaining;
    }
    range_.add(coef_.all());
    const std::size_t before =
        static_cast<std::size_t>(band_.first_row) * static_cast<std::size_t>(shape_.width);
    const std::size_t size = polynomials() * 6;
    if (stride_ == 1) sample_.reserve(shape_.texels() * size);
    for (std::size_t t = 0; t < band_.texels; ++t) {
      const double* from = coef_.all().data() + t * size;
      out_.black_texels +=
          std::all_of(from, from + size, [](double a) { return a == 0; }) ? 1U : 0U;
      const std::uint64_t hash = (before + t) * std::uint64_t{0x9E3779B97F4A7C15} >> 32;
      if (hash % stride_ == 0) sample_.insert(sample_.end(), from, from + size);
    }
  }

  void count_samples(const golden::PhotoBands& bands) {
    out_.saturated_samples = bands.counts().saturated;
    if (bands.counts().negative > 0) {
      out_.notes.push_back(golden::count_of(bands.counts().negative, "negative sample") +
                           " taken as black");
    }
    if (out_.balance.exceeding > 0) {
      out_.notes.push_back(
          "luminance of " + golden::count_of(out_.balance.exceeding, "texel") +
          " exceeded the hardware's; " + "colours were scaled up in " +
          golden::count_of(out_.balance.scaled, "texel") + ", and " +
          golden::count_of(out_.balance.remaining, "texel") +
          (out_.balance.remaining == 1 ? " still exceeds it" : " still exceed it"));
    }
    if (bands.bands() > 1 && !bands.all_decode_once()) {
      out_.notes.emplace_back(
          "some photographs cannot be read by rows and are decoded once for each band");
    }
  }

  void choose() {
    const Timed timed(out_.quantize_seconds);
    if (sample_.empty()) sample_.assign(coef_.all().begin(), coef_.all().begin() + 6);
    storage_.choose(sample_, range_);
    sample_ = {};
    out_.scale = shape_.scale = storage_.scale();
    out_.bias = shape_.bias = storage_.bias();
    out_.shift = storage_.shift();
  }

  void store() {
    const Timed timed(out_.quantize_seconds);
    bytes_.resize(coef_.size());
    std::vector<StorageLoss> losses(golden::tiles_of(band_.texels));
    golden::for_each_tile(band_.texels, [&](std::size_t tile, std::size_t first, std::size_t n) {
      losses[tile] = storage_.encode(coef_of(first, n), bytes_of(first, n));
    });
    for (const StorageLoss& loss : losses) out_.loss.add(loss);
  }

  void judge() {
    const Timed timed(out_.judge_seconds);
    residual_rows_.assign(residual_ ? band_.texels : 0, 0);
    judge_->add(band_, coef_.all(), storage_.decode(bytes_.all()), color_, residual_rows_);
    if (residual_) residual_->write(residual_rows_);
  }

  const FitJob& job_;
  const std::function<void(std::size_t, std::size_t)>& step_;
  const std::function<void(const FitOutcome&)>& whole_;
  std::size_t steps_ = 0;
  FitOutcome out_;
  MapStorage storage_;
  golden::PtmMap shape_;  ///< kind, size, scales and biases; no texels
  Capture training_, held_out_;
  std::optional<golden::NearLights> near_;
  Band band_;
  RoomyBuffer<double> coef_;         ///< of the band, [texel][polynomial][6]
  RoomyBuffer<std::uint8_t> bytes_;  ///< the same, stored
  std::vector<std::uint8_t> color_;  ///< of the band
  std::vector<std::array<double, 2>> balance_lights_ = hemisphere_lights();
  std::vector<quantize::Balance> balances_;  ///< of the band, by tile
  std::vector<double> sample_;
  golden::CoefficientRange range_;
  std::size_t stride_ = 1;
  std::optional<FitJudge> judge_;
  std::optional<golden::PictureRowWriter> residual_;
  std::vector<std::uint8_t> residual_rows_;
};

}  // namespace

FitOutcome run_fit(const FitJob& job, const std::function<void(std::size_t, std::size_t)>& step,
                   const std::function<void(const FitOutcome&)>& whole) {
  return Runner(job, step, whole).run();
}

}  // namespace ptm::testbench
