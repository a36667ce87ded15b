#include "golden/render/area_average.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ptm::golden {
namespace {

struct Corner {
  double x = 0, y = 0;  ///< texels
};
using Polygon = std::vector<Corner>;

/// The part of a convex polygon where sign * (coordinate - limit) >= 0.
void clip(const Polygon& in, double Corner::*axis, double limit, double sign, Polygon& out) {
  out.clear();
  for (std::size_t n = 0; n < in.size(); ++n) {
    const Corner &a = in[n], &b = in[(n + 1) % in.size()];
    const double da = sign * (a.*axis - limit), db = sign * (b.*axis - limit);
    if (da >= 0) out.push_back(a);
    if ((da >= 0) == (db >= 0)) continue;
    const double t = da / (da - db);
    Corner cut{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    cut.*axis = limit;
    out.push_back(cut);
  }
}

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t n = 1; n + 1 < polygon.size(); ++n) {
    const Corner &o = polygon[0], &a = polygon[n], &b = polygon[n + 1];
    twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
  }
  return std::abs(twice) / 2;
}

template <class Texture>
class Averager {
 public:
  Averager(const Texture& texture, const PixelFootprint& footprint, WrapMode wrap_u,
           WrapMode wrap_v, const std::array<double, 2>& light)
      : texture_(texture),
        wrap_u_(wrap_u),
        wrap_v_(wrap_v),
        light_(light),
        width_(texture.width(0)),
        height_(texture.height(0)) {
    // Whole pairs of periods off: the texels stay, and small differences keep their digits.
    const double u = near_origin(footprint.u, wrap_u), v = near_origin(footprint.v, wrap_v);
    centre_ = {u * width_, v * height_};
    right_ = {footprint.dudx * width_, footprint.dvdx * height_};
    down_ = {footprint.dudy * width_, footprint.dvdy * height_};
  }

  Rgba average() {
    Polygon shape;
    for (const auto& [a, b] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      shape.push_back(at(a, b));
    }
    const auto [left, right] = std::minmax_element(
        shape.begin(), shape.end(), [](const Corner& a, const Corner& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(
        shape.begin(), shape.end(), [](const Corner& a, const Corner& b) { return a.y < b.y; });
    const double x0 = std::floor(left->x), x1 = std::ceil(right->x);
    const double y0 = std::floor(top->y), y1 = std::ceil(bottom->y);
    if (area_of(shape) < kLeastArea) {
      add_samples(kLineGrid);
    } else if ((x1 - x0) * (y1 - y0) > kMostTexels) {
      add_samples(kGrid);
    } else {
      add_exactly(shape, x0, x1, y0, y1);
    }
    for (double& value : sum_) value /= weight_;
    return sum_;
  }

 private:
  static double near_origin(double coordinate, WrapMode mode) {
    // Further beyond a clamped edge than half of any footprint, nothing but the edge is seen.
    constexpr double kBeyond = 1000;
    return mode == WrapMode::clamp ? std::clamp(coordinate, -kBeyond, kBeyond)
                                   : coordinate - 2 * std::floor(coordinate / 2);
  }

  [[nodiscard]] Corner at(double a, double b) const {
    return {centre_.x + a * right_.x + b * down_.x, centre_.y + a * right_.y + b * down_.y};
  }

  void add_exactly(const Polygon& shape, double x0, double x1, double y0, double y1) {
    Polygon half, strip, part, piece;
    for (double y = y0; y < y1; ++y) {
      clip(shape, &Corner::y, y, 1, half);
      clip(half, &Corner::y, y + 1, -1, strip);
      if (strip.size() < 3) continue;
      for (double x = x0; x < x1; ++x) {
        clip(strip, &Corner::x, x, 1, part);
        clip(part, &Corner::x, x + 1, -1, piece);
        if (piece.size() >= 3) add(x, y, area_of(piece));
      }
    }
  }

  void add_samples(int grid) {
    for (int b = 0; b < grid; ++b) {
      for (int a = 0; a < grid; ++a) {
        const Corner c = at((a + 0.5) / grid - 0.5, (b + 0.5) / grid - 0.5);
        add(std::floor(c.x), std::floor(c.y), 1);
      }
    }
  }

  /// The texel of an index beyond the edges too.
  static int index(double position, int side, WrapMode mode) {
    if (mode == WrapMode::clamp) return static_cast<int>(std::clamp(position, 0.0, side - 1.0));
    const double period = std::floor(position / side);
    const int i = static_cast<int>(position - period * side);
    return mode == WrapMode::mirror && std::fmod(period, 2) != 0 ? side - 1 - i : i;
  }

  void add(double x, double y, double weight) {
    const Rgba texel =
        texture_.texel(0, index(x, width_, wrap_u_), index(y, height_, wrap_v_), light_);
    for (std::size_t c = 0; c < 4; ++c) sum_[c] += weight * texel[c];
    weight_ += weight;
  }

  const Texture& texture_;
  WrapMode wrap_u_, wrap_v_;
  std::array<double, 2> light_;
  int width_, height_;
  Corner centre_, right_, down_;
  Rgba sum_{};
  double weight_ = 0;
};

}  // namespace

Rgba area_average(const MipTexture& texture, const PixelFootprint& footprint, WrapMode wrap_u,
                  WrapMode wrap_v, const std::array<double, 2>& light) {
  return Averager(texture, footprint, wrap_u, wrap_v, light).average();
}

Rgba area_average(const AddendView& texture, const PixelFootprint& footprint, WrapMode wrap_u,
                  WrapMode wrap_v, const std::array<double, 2>& light) {
  return Averager(texture, footprint, wrap_u, wrap_v, light).average();
}

}  // namespace ptm::golden
