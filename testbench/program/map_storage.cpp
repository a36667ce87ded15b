#include "testbench/program/map_storage.h"

#include <algorithm>
#include <cmath>

namespace ptm::testbench {
namespace {

StorageLoss loss_of(const quantize::StoredMap& stored) {
  StorageLoss loss;
  loss.saturated = stored.saturated;
  loss.polynomials = stored.coef.size() / 6;
  loss.worst = stored.worst_error;
  loss.squares = stored.rms_error * stored.rms_error * static_cast<double>(loss.polynomials);
  return loss;
}

void to_bytes(const quantize::StoredMap& stored, std::span<std::uint8_t> bytes) {
  std::transform(stored.coef.begin(), stored.coef.end(), bytes.begin(),
                 [](std::uint16_t c) { return static_cast<std::uint8_t>(c); });
}

}  // namespace

void StorageLoss::add(const StorageLoss& other) {
  for (std::size_t k = 0; k < 6; ++k) saturated[k] += other.saturated[k];
  squares += other.squares;
  worst = std::max(worst, other.worst);
  polynomials += other.polynomials;
}

double StorageLoss::rms() const {
  return polynomials > 0 ? std::sqrt(squares / static_cast<double>(polynomials)) : 0;
}

MapStorage::MapStorage(const std::string& quantizer, const reference::EvalConfig& config)
    : by_hp_(quantizer == "hp"),
      method_(quantizer == "plain" ? quantize::Method::plain : quantize::Method::nearest_plane),
      config_(config),
      gram_(quantize::hemisphere_gram()) {}

quantize::RealMap MapStorage::as_map(std::span<const double> coef) const {
  return {.width = static_cast<int>(coef.size() / 6), .height = 1, .polynomials = 1, .coef = coef};
}

void MapStorage::choose(std::span<const double> sample, const golden::CoefficientRange& range) {
  if (by_hp_) {
    hp_ = golden::hp_grid(range);
    return;
  }
  const auto stored = quantize::quantize(as_map(sample), config_, method_, gram_);
  grid_ = {.bias = stored.bias, .shift = stored.shift};
  for (std::size_t k = 0; k < 6; ++k) {
    hp_.scale[k] = std::ldexp(1.0, -grid_.shift[k]);
    hp_.bias[k] = grid_.bias[k];
  }
}

StorageLoss MapStorage::encode(std::span<const double> coef, std::span<std::uint8_t> bytes) const {
  if (!by_hp_) {
    const auto stored = quantize::quantize_on_grid(as_map(coef), grid_, config_, method_, gram_);
    to_bytes(stored, bytes);
    return loss_of(stored);
  }
  StorageLoss loss;
  golden::hp_store(coef, hp_, bytes, loss.saturated);
  const std::vector<double> stored = decode(bytes);
  loss.polynomials = coef.size() / 6;
  for (std::size_t n = 0; n < coef.size(); n += 6) {
    Eigen::Matrix<double, 6, 1> e;
    for (std::size_t k = 0; k < 6; ++k) {
      e[static_cast<Eigen::Index>(k)] = stored[n + k] - coef[n + k];
    }
    const double square = e.dot(gram_ * e);
    loss.squares += square;
    loss.worst = std::max(loss.worst, std::sqrt(std::max(0.0, square)));
  }
  return loss;
}

std::vector<double> MapStorage::decode(std::span<const std::uint8_t> bytes) const {
  std::vector<double> coef(bytes.size());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    coef[n] = (int{bytes[n]} - hp_.bias[n % 6]) * hp_.scale[n % 6];
  }
  return coef;
}

std::optional<std::array<int, 6>> MapStorage::shift() const {
  if (by_hp_) return std::nullopt;
  return grid_.shift;
}

}  // namespace ptm::testbench
