#include "testbench/compare/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ptm::testbench {
namespace {

using golden::ImageReal;

ImageReal picture(int width, int height, int channels, std::vector<double> samples) {
  ImageReal image(width, height, channels);
  image.samples = std::move(samples);
  return image;
}

TEST(PictureDifference, OfEqualPicturesIsNothingAtInfinitePsnr) {
  const ImageReal image = picture(2, 1, 3, {0, 10, 255, 7.25, 8, 9});
  const PictureDifference d = compare_pictures(image, image);
  EXPECT_EQ(d.samples, 6U);
  EXPECT_EQ(d.differing, 0U);
  EXPECT_EQ(d.share, 0);
  EXPECT_EQ(d.max, 0);
  EXPECT_EQ(d.mean, 0);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_TRUE(std::isinf(d.psnr_db) && d.psnr_db > 0);
  EXPECT_EQ(d.ssim, 1);
  EXPECT_TRUE(d.worst.empty());
  EXPECT_EQ(d.histogram.counts, std::vector<std::uint64_t>{6});
}

TEST(PictureDifference, OfFourSamplesIsAsComputedByHand) {
  // Errors +3, -4, 0, 0: mean 7/4, mean square 25/4, RMSE 5/2, PSNR 20 log10(102).
  const PictureDifference d =
      compare_pictures(picture(2, 2, 1, {10, 20, 30, 40}), picture(2, 2, 1, {13, 16, 30, 40}));
  EXPECT_EQ(d.samples, 4U);
  EXPECT_EQ(d.differing, 2U);
  EXPECT_DOUBLE_EQ(d.share, 0.5);
  EXPECT_DOUBLE_EQ(d.max, 4);
  EXPECT_DOUBLE_EQ(d.mean, 1.75);
  EXPECT_DOUBLE_EQ(d.rmse, 2.5);
  EXPECT_NEAR(d.psnr_db, 40.172003435238, 1e-11);
  const std::vector<WorstPixel> worst = {{0, 1, 0, 4}, {0, 0, 0, 3}};
  EXPECT_EQ(d.worst, worst);
}

TEST(PictureDifference, FindsOneSampleThatDiffersByOneLevel) {
  ImageReal a(33, 17, 3);
  ImageReal b = a;
  b.at(20, 11, 2) = 1;
  const PictureDifference d = compare_pictures(a, b);
  EXPECT_EQ(d.differing, 1U);
  EXPECT_DOUBLE_EQ(d.share, 1.0 / (33 * 17 * 3));
  EXPECT_NEAR(d.psnr_db, 20 * std::log10(255 * std::sqrt(33 * 17 * 3)), 1e-9);
  const std::vector<WorstPixel> worst = {{0, 20, 11, 1}};
  EXPECT_EQ(d.worst, worst);
  EXPECT_LT(d.ssim, 1);
}

TEST(PictureDifference, CountsARealSampleAsDifferingOnlyIfItsRoundedValueDiffers) {
  // 9.5 rounds to 10 (ties upward), 9.499 to 9, 10.499 to 10; 300 and 255 are both 255.
  const PictureDifference d = compare_pictures(picture(4, 1, 1, {9.5, 9.499, 10.499, 300}),
                                               picture(4, 1, 1, {10, 10, 10, 255}));
  EXPECT_EQ(d.differing, 1U);
  EXPECT_EQ(d.max, 45);  // errors themselves are not rounded or clamped
}

TEST(PictureDifference, CountsSignedErrorsInBinsOfOneLevelBetweenIntegers) {
  const PictureDifference d =
      compare_pictures(picture(5, 1, 1, {5, 5, 5, 5, 5}), picture(5, 1, 1, {3, 4, 5, 5, 6}));
  EXPECT_EQ(d.histogram.bin_width, 1);
  EXPECT_EQ(d.histogram.half_bins, 2);
  const std::vector<std::uint64_t> counts = {1, 1, 2, 1, 0};
  EXPECT_EQ(d.histogram.counts, counts);
  EXPECT_EQ(d.histogram.center(0), -2);
}

TEST(PictureDifference, CountsRealErrorsInFineBinsThatTakeTheirLowerEdge) {
  // Width 1/32: the errors are 0.5 and 1.5 bins below and 1.5 bins above the middle.
  const double bin = 1.0 / 32;
  const PictureDifference d = compare_pictures(
      picture(3, 1, 1, {5 + 0.5 * bin, 5 + 1.5 * bin, 5 - 1.5 * bin}), picture(3, 1, 1, {5, 5, 5}));
  EXPECT_EQ(d.histogram.bin_width, bin);
  const std::vector<std::uint64_t> counts = {0, 1, 1, 0, 1};
  EXPECT_EQ(d.histogram.counts, counts);
}

TEST(PictureDifference, KeepsTheHistogramWithinSixtyFiveBinsAndLosesNoSample) {
  for (const double largest : {1.0, 1.01, 1.02, 32.0, 32.5, 33.0, 64.9, 65.0, 254.0, 255.0}) {
    const PictureDifference d =
        compare_pictures(picture(3, 1, 1, {0, 0, largest}), picture(3, 1, 1, {0, largest, 0}));
    ASSERT_LE(d.histogram.counts.size(), 65U) << largest;
    ASSERT_EQ(d.histogram.counts.size(), 2 * static_cast<std::size_t>(d.histogram.half_bins) + 1);
    std::uint64_t total = 0;
    for (const std::uint64_t count : d.histogram.counts) total += count;
    EXPECT_EQ(total, 3U) << largest;
    EXPECT_GE(d.histogram.counts.front(), 0U);
    EXPECT_EQ(d.histogram.counts[static_cast<std::size_t>(d.histogram.half_bins)], 1U) << largest;
  }
}

TEST(PictureDifference, OrdersWorstPixelsByErrorAndTiesByPosition) {
  ImageReal a(4, 4, 3);
  ImageReal b = a;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) b.at(x, y, (x + y) % 3) = 2;
  }
  b.at(3, 3, 1) = 5;
  b.at(1, 2, 0) = 5;
  const std::vector<WorstPixel> expected = {{0, 1, 2, 5}, {0, 3, 3, 5}, {0, 0, 0, 2}, {0, 1, 0, 2},
                                            {0, 2, 0, 2}, {0, 3, 0, 2}, {0, 0, 1, 2}, {0, 1, 1, 2},
                                            {0, 2, 1, 2}, {0, 3, 1, 2}};
  EXPECT_EQ(compare_pictures(a, b).worst, expected);
}

TEST(PictureDifference, PoolsFramesAsIfTheyWereOnePicture) {
  const std::vector<ImageReal> a = {picture(2, 1, 1, {0, 0}), picture(2, 1, 1, {0, 0})};
  const std::vector<ImageReal> b = {picture(2, 1, 1, {0, 1}), picture(2, 1, 1, {7, 0})};
  const PictureDifference d = compare_frames(a, b);
  EXPECT_EQ(d.samples, 4U);
  EXPECT_EQ(d.differing, 2U);
  EXPECT_DOUBLE_EQ(d.mean, 2);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(50.0 / 4));
  EXPECT_DOUBLE_EQ(d.ssim,
                   (compare_pictures(a[0], b[0]).ssim + compare_pictures(a[1], b[1]).ssim) / 2);
  const std::vector<WorstPixel> worst = {{1, 0, 0, 7}, {0, 1, 0, 1}};
  EXPECT_EQ(d.worst, worst);
}

TEST(PictureDifference, ComparesPicturesOfOnePixel) {
  const PictureDifference d =
      compare_pictures(picture(1, 1, 3, {1, 2, 3}), picture(1, 1, 3, {1, 2, 6}));
  EXPECT_EQ(d.samples, 3U);
  EXPECT_EQ(d.differing, 1U);
  EXPECT_EQ(d.max, 3);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(3.0));
}

void expect_refused(const std::vector<ImageReal>& a, const std::vector<ImageReal>& b,
                    const std::string& naming) {
  try {
    (void)compare_frames(a, b);
    ADD_FAILURE() << "accepted, expected to refuse with: " << naming;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(naming), std::string::npos) << error.what();
  }
}

TEST(PictureDifference, RefusesNotANumberAndInfinityWithTheirPlace) {
  const ImageReal fine = picture(2, 2, 1, {1, 2, 3, 4});
  ImageReal nan = fine, infinite = fine;
  nan.at(1, 1) = std::numeric_limits<double>::quiet_NaN();
  infinite.at(0, 1) = std::numeric_limits<double>::infinity();
  expect_refused({fine}, {nan}, "frame 0, picture b, x 1, y 1, channel 0: found nan");
  expect_refused({fine, infinite}, {fine, infinite},
                 "frame 1, picture a, x 0, y 1, channel 0: found inf");
}

TEST(PictureDifference, RefusesPicturesThatCannotBeCompared) {
  const ImageReal small(2, 2, 3), wide(3, 2, 3), grey(2, 2, 1), two(2, 2, 2), none;
  expect_refused({small}, {wide}, "found 2 x 2 x 3 and 3 x 2 x 3");
  expect_refused({small}, {grey}, "2 x 2 x 1");
  expect_refused({small, wide}, {small, wide}, "frame 1");
  expect_refused({two}, {two}, "1 or 3 channels");
  expect_refused({none}, {none}, "0 x 0 x 0");
  expect_refused({small}, {small, small}, "found 1 and 2 frames");
  expect_refused({}, {}, "at least one");
  ImageReal torn = small;
  torn.samples.pop_back();
  expect_refused({small}, {torn}, "frame 0");
}

}  // namespace
}  // namespace ptm::testbench
