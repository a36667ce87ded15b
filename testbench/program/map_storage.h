#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "golden/files/ptm_map.h"
#include "golden/fit/hp_quantizer.h"
#include "model/quantize/quantize.h"

namespace ptm::testbench {

/// What storing lost: coefficients at the end of their range, and the squared change of the
/// luminance summed over polynomials (mean over the hemisphere's lights), in levels squared.
struct StorageLoss {
  std::array<std::uint64_t, 6> saturated{};
  double squares = 0;
  double worst = 0;  ///< RMS over the lights, of the polynomial that lost most
  std::uint64_t polynomials = 0;

  void add(const StorageLoss& other);
  [[nodiscard]] double rms() const;
};

/// How a fitted map becomes bytes: by the hardware's quantiser or by HP's.
///
/// choose() sees a part of the map and its whole range, and settles scales and biases; encode()
/// then stores the map in any pieces, from several threads if need be.
class MapStorage {
 public:
  /// `quantizer` is nearest_plane, plain or hp; the configuration holds at most 8 bits.
  MapStorage(const std::string& quantizer, const reference::EvalConfig& config);

  void choose(std::span<const double> sample, const golden::CoefficientRange& range);
  /// coef [..][6] to bytes of the same layout; returns what was lost.
  [[nodiscard]] StorageLoss encode(std::span<const double> coef,
                                   std::span<std::uint8_t> bytes) const;
  /// The real coefficients that bytes stand for.
  [[nodiscard]] std::vector<double> decode(std::span<const std::uint8_t> bytes) const;

  [[nodiscard]] const std::array<double, 6>& scale() const { return hp_.scale; }
  [[nodiscard]] const std::array<std::int32_t, 6>& bias() const { return hp_.bias; }
  /// Only where every scale is 2^-shift by choice of the hardware's quantiser.
  [[nodiscard]] std::optional<std::array<int, 6>> shift() const;

 private:
  [[nodiscard]] quantize::RealMap as_map(std::span<const double> coef) const;

  bool by_hp_;
  quantize::Method method_;
  reference::EvalConfig config_;
  quantize::Gram gram_;
  quantize::Grid grid_;
  golden::HpGrid hp_;  ///< scale and bias, whoever chose them
};

}  // namespace ptm::testbench
