#include "testbench/compare/ssim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "testbench/compare/picture_difference.h"

namespace ptm::testbench {
namespace {

using golden::ImageReal;

constexpr double kC1 = 2.55 * 2.55, kC2 = 7.65 * 7.65;

ImageReal flat(int width, int height, int channels, double level) {
  ImageReal image(width, height, channels);
  for (double& sample : image.samples) sample = level;
  return image;
}

ImageReal pattern(int width, int height, int channels, double phase) {
  ImageReal image(width, height, channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    const double t = static_cast<double>(i);
    image.samples[i] =
        std::floor(127.5 + 80 * std::sin(0.7 * t + phase) + 47 * std::cos(t * t * 0.01));
  }
  return image;
}

/// The paper's formula as it stands: two-dimensional windows, variances from differences to the
/// mean, no sum-and-difference planes and nothing separable. `rx`, `ry`: the window's radii.
double plainly(const ImageReal& a, const ImageReal& b, int rx, int ry) {
  double total = 0;
  int windows = 0;
  for (int y = ry; y < a.height - ry; ++y) {
    for (int x = rx; x < a.width - rx; ++x, ++windows) {
      double weight = 0, ma = 0, mb = 0, va = 0, vb = 0, vab = 0;
      for (int pass = 0; pass < 2; ++pass) {
        for (int j = -ry; j <= ry; ++j) {
          for (int i = -rx; i <= rx; ++i) {
            const double w = std::exp(-(i * i + j * j) / 4.5);
            const double p = a.at(x + i, y + j), q = b.at(x + i, y + j);
            if (pass == 0) {
              weight += w, ma += w * p, mb += w * q;
            } else {
              va += w * (p - ma) * (p - ma), vb += w * (q - mb) * (q - mb);
              vab += w * (p - ma) * (q - mb);
            }
          }
        }
        if (pass == 0) ma /= weight, mb /= weight;
      }
      va /= weight, vb /= weight, vab /= weight;
      total +=
          (2 * ma * mb + kC1) * (2 * vab + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
    }
  }
  return total / windows;
}

TEST(Ssim, OfEqualPicturesIsOne) {
  const ImageReal image = pattern(40, 30, 3, 0);
  EXPECT_NEAR(structural_similarity(image, image), 1, 1e-12);
}

TEST(Ssim, OfFlatPicturesIsTheLuminanceFactorAlone) {
  const double expected = (2 * 100.0 * 110 + kC1) / (100.0 * 100 + 110.0 * 110 + kC1);
  EXPECT_NEAR(structural_similarity(flat(16, 12, 1, 100), flat(16, 12, 1, 110)), expected, 1e-12);
  EXPECT_NEAR(structural_similarity(flat(16, 12, 3, 100), flat(16, 12, 3, 110)), expected, 1e-12);
  EXPECT_NEAR(structural_similarity(flat(1, 1, 1, 100), flat(1, 1, 1, 110)), expected, 1e-12);
}

TEST(Ssim, OfBlackAndWhiteIsAlmostNothing) {
  EXPECT_NEAR(structural_similarity(flat(11, 11, 1, 0), flat(11, 11, 1, 255)),
              kC1 / (255.0 * 255 + kC1), 1e-15);
}

TEST(Ssim, EqualsThePapersFormulaComputedPlainly) {
  const ImageReal a = pattern(31, 24, 1, 0), b = pattern(31, 24, 1, 0.3);
  EXPECT_NEAR(structural_similarity(a, b), plainly(a, b, 5, 5), 1e-11);
  const ImageReal exact(11, 11, 1);
  EXPECT_NEAR(structural_similarity(exact, pattern(11, 11, 1, 1)),
              plainly(exact, pattern(11, 11, 1, 1), 5, 5), 1e-11);
}

TEST(Ssim, ShrinksTheWindowToTheLargestOddSizeThatFits) {
  struct Tiny {
    int width, height, rx, ry;
  };
  for (const Tiny& t : {Tiny{10, 20, 4, 5}, Tiny{9, 9, 4, 4}, Tiny{2, 3, 0, 1}, Tiny{30, 1, 5, 0},
                        Tiny{4, 5, 1, 2}}) {
    const ImageReal a = pattern(t.width, t.height, 1, 0), b = pattern(t.width, t.height, 1, 1);
    EXPECT_NEAR(structural_similarity(a, b), plainly(a, b, t.rx, t.ry), 1e-11)
        << t.width << " x " << t.height;
  }
}

TEST(Ssim, WeighsChannelsByRec709) {
  const ImageReal grey = flat(1, 1, 3, 100);
  const double weights[3] = {0.2126, 0.7152, 0.0722};
  for (int c = 0; c < 3; ++c) {
    ImageReal tinted = grey;
    tinted.at(0, 0, c) += 50;
    const double luma = 100 + 50 * weights[c];
    EXPECT_NEAR(structural_similarity(grey, tinted),
                (200 * luma + kC1) / (10000 + luma * luma + kC1), 1e-12)
        << c;
  }
}

}  // namespace
}  // namespace ptm::testbench
