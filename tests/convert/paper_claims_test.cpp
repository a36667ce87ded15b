// The paper's claims on storage, printed as "paper / ours" (Polynomial Texture Maps, section 5).
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "golden/files/ptm_file.h"
#include "golden/fit/light_solver.h"
#include "golden/render/light_map.h"
#include "model/quantize/quantize.h"
#include "testbench/compare/lit_difference.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/map_steps.h"
#include "tests/convert/lrgb_fit.h"
#include "tests/shared_data.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;
using golden::PtmMap;

PtmMap fit_capture(const std::filesystem::path& lp) {
  tests::LrgbFit fit = tests::fit_lrgb(lp);
  return to_ptm(quantize::quantize({fit.width, fit.height, 1, fit.coef}, reference::kBase,
                                   quantize::Method::nearest_plane, quantize::hemisphere_gram()),
                MapKind::lrgb, std::move(fit.color));
}

LitDifference print_palette(const std::string& name, const PtmMap& map, int entries) {
  const SteppedMap palette = palette_map(map, reference::kBase, {.entries = entries});
  const LitDifference lit = compare_lit(map, palette.map, comparison_lights());
  std::cout << name << ", palette of " << entries << ": paper indistinguishable / ours "
            << lit.psnr_db << " dB, SSIM " << lit.ssim << ", " << 100 * lit.visible_share
            << " % of samples differ by more than 5 levels\n";
  return lit;
}

TEST(PaperClaims, APaletteOf256IsHardToTellFromTheOriginal) {
  // Diffuse things as the paper's; the measure is docs/spec/quantize.md's.
  for (const char* file : {"tablet2/tablet2_LRGB.ptm", "ushabti/ushabti.ptm"}) {
    PTM_SHARED_DATA_OR_SKIP(path, file);
    const LitDifference lit = print_palette(path.stem().string(), golden::read_ptm(path).map, 256);
    EXPECT_GT(lit.psnr_db, 38);
    EXPECT_GT(lit.ssim, 0.95);
  }
  for (const char* file : {"icon/dirs.lp", "dome/Dome/dirs.lp"}) {
    PTM_SHARED_DATA_OR_SKIP(lp, file);
    const bool diffuse = std::string(file).starts_with("icon");
    const LitDifference lit = print_palette(file, fit_capture(lp), 256);
    EXPECT_GT(lit.psnr_db, diffuse ? 43 : 32.5) << file;  // dome has shadows and gloss
  }
}

TEST(PaperClaims, ARgbPaletteOf4096IsHardToTellFromTheOriginal) {
  PTM_SHARED_DATA_OR_SKIP(lp, "icon/dirs.lp");
  const PtmMap rgb = to_rgb_map(fit_capture(lp), reference::kBase, quantize::Dither::none).map;
  const LitDifference lit = print_palette("icon as RGB", rgb, 4096);
  EXPECT_GT(lit.psnr_db, 40);
  EXPECT_GT(lit.ssim, 0.95);
}

struct Row {
  const char* name;
  std::array<double, 4> paper;
  PtmMap map;
};

/// What errors of variance 1 (in steps) in every byte, independent of each other, make of the lit
/// channels at most, in levels RMS. Lit is c L / 255, and c' L' - c L = (c' - c) L + c' (L' - L)
/// with c' at most 255; clamping brings no more.
double rms_of_bytes(const PtmMap& map) {
  double squares = 0;
  for (const auto& [u, v] : comparison_lights()) {
    const auto basis = golden::light_basis(u, v);
    for (std::size_t t = 0; t < map.texels(); ++t) {
      const golden::Coefficients a = golden::real_coefficients(map, t);
      double l = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        const double b = basis[static_cast<Eigen::Index>(i)];
        l += a[i] * b;
        squares += map.scale[i] * map.scale[i] * b * b;
      }
      squares += l * l / (255 * 255);
    }
  }
  return std::sqrt(squares / static_cast<double>(map.texels() * comparison_lights().size()));
}

void print_table_1(const Row& row) {
  constexpr std::array<int, 4> losses{0, 1, 2, 4};
  const double bytes_rms = rms_of_bytes(row.map);
  double before = 1e9;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    const auto bytes =
        golden::format_ptm(row.map, {.coding = golden::Coding::jpegls, .near = losses[i]});
    const golden::PtmFile file = golden::parse_ptm(bytes, "claims");
    const double bits = 8.0 * static_cast<double>(bytes.size() - file.info.header_bytes) /
                        static_cast<double>(row.map.texels());
    const LitDifference lit = compare_lit(row.map, file.map, comparison_lights());
    // JPEG-LS rounds to every (2 n + 1)-th value: errors from -n to n, evenly.
    const double bound = std::sqrt(losses[i] * (losses[i] + 1) / 3.0) * bytes_rms;
    std::cout << row.name << ", loss " << losses[i] << ": bits a texel, paper " << row.paper[i]
              << " / ours " << bits << "; rendered channels off by " << lit.rmse
              << " levels RMS, 99.9 % within " << lit.within_999 << ", max " << lit.max
              << "; at most " << bound << " RMS\n";
    EXPECT_LT(bits, before);
    EXPECT_LE(lit.rmse, bound);
    before = bits;
  }
}

TEST(PaperClaims, BitsATexelAtLosses0124) {
  PTM_SHARED_DATA_OR_SKIP(tablet, "tablet2/tablet2_LRGB.ptm");
  PTM_SHARED_DATA_OR_SKIP(ushabti, "ushabti/ushabti.ptm");
  PTM_SHARED_DATA_OR_SKIP(icon, "icon/dirs.lp");
  print_table_1({"tablet", {33.8, 21.3, 16.9, 13.0}, golden::read_ptm(tablet).map});
  print_table_1({"ushabti", {31.3, 19.8, 15.9, 12.3}, golden::read_ptm(ushabti).map});
  print_table_1({"icon (paper: average)", {27.4, 17.1, 13.5, 10.1}, fit_capture(icon)});
}

}  // namespace
}  // namespace ptm::testbench
