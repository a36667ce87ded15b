#include "golden/bump/normal_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "golden/files/input_error.h"

namespace ptm::golden {
namespace {

constexpr double kRounding = 1.7320508075688772 / 255;  ///< sqrt(3) channels of half a level
constexpr double kBlack = 53, kWhite = 247;             ///< levels
constexpr double kSteepest = 0.34;                      ///< w of slopes that count: 70 degrees

using Normal = std::array<double, 3>;

class NormalMapReader {
 public:
  NormalMapReader(const ImageReal& picture, const NormalMapOptions& options,
                  const std::string& file)
      : picture_(picture), options_(options), file_(file) {}

  NormalField read() {
    for (int y = 0; y < picture_.height; ++y) {
      for (int x = 0; x < picture_.width; ++x) {
        vectors_.push_back(vector_at(x, y));
        masked_.push_back(is_background(x, y) ? 1 : 0);
      }
    }
    grow_background();
    NormalField field{.width = picture_.width, .height = picture_.height, .normals = {}};
    for (std::size_t t = 0; t < vectors_.size(); ++t) field.normals.push_back(normal_of(t));
    const auto masked = std::count(masked_.begin(), masked_.end(), 1);
    if (static_cast<std::size_t>(masked) == vectors_.size()) {
      throw InputError(file_, "picture", "no normal, but background only", "a normal map");
    }
    if (masked > 0) {
      field.notes.push_back(std::to_string(masked) + " of " + std::to_string(vectors_.size()) +
                            " texels are background without a normal, taken as flat");
    }
    if (other_green_fits()) {
      field.notes.emplace_back(options_.green_down
                                   ? "the normals look as if green ran up the picture, not down"
                                   : "the normals look as if green ran down the picture, as "
                                     "DirectX has it, not up: dents and bumps lit from the wrong "
                                     "side; --green-down (in a scene kind = \"normal-green-down\") "
                                     "reads them so");
    }
    return field;
  }

 private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
           static_cast<std::size_t>(x);
  }

  [[nodiscard]] Normal vector_at(int x, int y) const {
    const auto part = [&](int c) { return 2 * picture_.at(x, y, c) / 255 - 1; };
    return {part(0), options_.green_down ? -part(1) : part(1), part(2)};
  }

  [[nodiscard]] bool is_background(int x, int y) const {
    const std::array<double, 3> rgb{picture_.at(x, y, 0), picture_.at(x, y, 1),
                                    picture_.at(x, y, 2)};
    const auto [least, most] = std::minmax_element(rgb.begin(), rgb.end());
    const Normal& v = vectors_.back();
    return *most <= kBlack || *least >= kWhite || std::hypot(v[0], v[1], v[2]) < 2 * kRounding;
  }

  /// Spreads the background over neighbours below the horizon.
  void grow_background() {
    std::vector<std::size_t> edge;
    for (std::size_t t = 0; t < masked_.size(); ++t) {
      if (masked_[t] != 0) edge.push_back(t);
    }
    const auto width = static_cast<std::size_t>(picture_.width);
    while (!edge.empty()) {
      const int x = static_cast<int>(edge.back() % width),
                y = static_cast<int>(edge.back() / width);
      edge.pop_back();
      for (int j = std::max(0, y - 1); j <= std::min(picture_.height - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(picture_.width - 1, x + 1); ++i) {
          const std::size_t t = at(i, j);
          if (masked_[t] != 0 || vectors_[t][2] > 0) continue;
          masked_[t] = 1;
          edge.push_back(t);
        }
      }
    }
  }

  [[nodiscard]] Normal normal_of(std::size_t t) const {
    if (masked_[t] != 0) return {0, 0, 1};
    const auto& [u, v, w] = vectors_[t];
    if (!(w > 0)) {
      const auto width = static_cast<std::size_t>(picture_.width);
      const int x = static_cast<int>(t % width), y = static_cast<int>(t / width);
      throw InputError(file_, "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")",
                       "blue " + std::to_string(picture_.at(x, y, 2)),
                       "above 127.5, a normal above the horizon");
    }
    const double s = options_.strength, length = std::hypot(s * u, s * v, w);
    return {s * u / length, s * v / length, w / length};
  }

  /// d(u/w)/dy upwards and d(v/w)/dx at a texel; false where a neighbour does not count.
  bool slopes(int x, int y, double& across, double& along) const {
    std::array<const Normal*, 4> around{};
    const std::array<std::size_t, 4> places{at(x, y - 1), at(x, y + 1), at(x - 1, y), at(x + 1, y)};
    for (std::size_t k = 0; k < 4; ++k) {
      const Normal& v = vectors_[places[k]];
      around[k] = &v;
      if (masked_[places[k]] != 0 || !(v[2] > kSteepest * std::hypot(v[0], v[1], v[2])))
        return false;
    }
    const auto& [above, below, left, right] = around;
    across = ((*above)[0] / (*above)[2] - (*below)[0] / (*below)[2]) / 2;
    along = ((*right)[1] / (*right)[2] - (*left)[1] / (*left)[2]) / 2;
    return true;
  }

  /// Sums of (across - along)^2, zero for a surface as read, and of (across + along)^2, for the
  /// other sign. Of independent slopes their difference, four times the sum of products, is about
  /// 0 with standard deviation 4 sqrt(sum across^2 along^2).
  [[nodiscard]] bool other_green_fits() const {
    double as_read = 0, other = 0, variance = 0;
    for (int y = 1; y + 1 < picture_.height; ++y) {
      for (int x = 1; x + 1 < picture_.width; ++x) {
        double across = 0, along = 0;
        if (!slopes(x, y, across, along)) continue;
        as_read += (across - along) * (across - along);
        other += (across + along) * (across + along);
        variance += 16 * across * across * along * along;
      }
    }
    return as_read > 4 * other && as_read - other > 5 * std::sqrt(variance);
  }

  const ImageReal& picture_;
  NormalMapOptions options_;
  const std::string& file_;
  std::vector<Normal> vectors_;       ///< as the texels have them, green up
  std::vector<std::uint8_t> masked_;  ///< 1: background
};

}  // namespace

NormalField read_normal_map(const ImageReal& picture, const NormalMapOptions& options,
                            const std::string& file) {
  if (picture.width < 1 || picture.height < 1) {
    throw std::invalid_argument("a normal map without pixels");
  }
  if (!std::isfinite(options.strength)) {
    throw std::invalid_argument("a strength that is not finite");
  }
  if (picture.channels != 3) {
    throw InputError(file, "channels", std::to_string(picture.channels), "3, a normal map");
  }
  return NormalMapReader(picture, options, file).read();
}

}  // namespace ptm::golden
