#include "golden/render/unit_picture.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <iostream>

#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "tests/golden/made_scene.h"

namespace ptm::golden {
namespace {

class UnitPicture : public MadeScene {
 protected:
  ImageReal draw(const std::string& text) {
    scene_ = read(text);
    textures_ = load_textures(scene_);
    const UnitRenderer renderer(scene_, textures_);
    samples_ = make_samples(scene_, textures_, 0);
    return render_samples(scene_, renderer, samples_);
  }
  UnitScene scene_;
  LoadedTextures textures_;
  std::vector<SurfaceSample> samples_;
};

/// A plane that fills a picture of its map's own size, texel for pixel.
std::string square_on(int width, int height, const std::string& object) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return "[image]\nsize = [" + w + ", " + h + "]\n[camera]\northographic = true\nheight = " + h +
         "\n[[object]]\nkind = \"plane\"\norigin = [-" + std::to_string(width / 2.0) + ", 0, " +
         std::to_string(height / 2.0) + "]\ni = [" + w + ", 0, 0]\nj = [0, 0, -" + h + "]\n" +
         object;
}

PtmMap made_map(MapKind kind, int width, int height) {
  PtmMap map;
  map.kind = kind;
  map.width = width;
  map.height = height;
  map.scale = {0.5, 0.5, 1, 1, 1, 1};
  map.bias = {128, 128, 128, 128, 128, 20};
  map.lum_matrix = {1.4, 1, 0, -179, -0.7, 1, -0.34, 135, 0, 1, 1.77, -226, 0, 0, 0, 1};
  unsigned state = 1;
  const auto byte = [&state] {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::uint8_t>(state >> 24);
  };
  map.coef.resize(map.texels() * map.polynomials() * 6);
  map.color.resize(map.texels() * map.color_bytes());
  for (auto& value : map.coef) value = byte();
  for (auto& value : map.color) value = byte();
  return map;
}

TEST_F(UnitPicture, OfAMapSeenSquareOnIsTheLitMap) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    const PtmMap map = made_map(kind, 12, 8);
    write_ptm(folder_ / "m.ptm", map);
    for (const char* filter : {"point", "bilinear", "trilinear"}) {
      const ImageReal picture =
          draw("[[texture]]\nname = \"m\"\nptm = \"m.ptm\"\nfilter = \"" + std::string(filter) +
               "\"\n" + square_on(12, 8, "texture = \"m\"\n") +
               "[[light]]\ndirection = [0.36, -0.48, 0.8]\n[[light]]\ndirection = [0, 0]\n");
      // 0.36 to the right; -0.48 goes into the plane's normal (0, -1, 0); 0.8 up.
      const ImageReal lit = light_map(map, 0.36, 0.8);
      for (std::size_t i = 0; i < lit.samples.size(); ++i) {
        ASSERT_NEAR(picture.samples[i], lit.samples[i], 1e-9) << filter << " " << i;
      }
    }
    EXPECT_EQ(textures_[0].stored.has_value(), kind != MapKind::lum);
  }
}

TEST_F(UnitPicture, LightsTexelsOfLevelZeroAsTheMapsOwnRendererDoesToTheBit) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    const PtmMap map = made_map(kind, 12, 8);
    write_ptm(folder_ / "m.ptm", map);
    draw("[[texture]]\nname = \"m\"\nptm = \"m.ptm\"\n" + square_on(12, 8, "texture = \"m\"\n") +
         "[[light]]\ndirection = [0.3, 0.7]\n");
    const MipTexture mips(textures_[0], false);
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 12; ++i) {
        const Rgb lit = light_texel(map, static_cast<std::size_t>(j * 12 + i), 0.3, 0.7);
        const Rgba texel = mips.texel(0, i, j, {0.3, 0.7});
        for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(texel[c], lit[c]);
      }
    }
  }
}

TEST_F(UnitPicture, StandsUprightOnEveryShape) {
  const std::string gradient =
      "[[texture]]\nname = \"g\"\ngenerate = \"gradient\"\nkind = \"picture\"\nfilter = "
      "\"bilinear\"\nwrap = \"clamp\"\n";
  for (const char* object :
       {"kind = \"plane\"", "kind = \"cylinder\"\ntheta = [180, 360]\na = 2\ntheta0 = 180",
        "kind = \"sphere\"\ntheta = [180, 360]\na = 2\ntheta0 = 180"}) {
    const ImageReal picture = draw(gradient + "[image]\nsize = [64, 64]\n[[object]]\n" + object +
                                   "\ncolor = \"g\"\n[[light]]\ndirection = [0, -1, 0]\n");
    // red is u, green is v
    EXPECT_GT(picture.at(40, 32, 0), picture.at(24, 32, 0) + 30) << object;
    EXPECT_GT(picture.at(32, 40, 1), picture.at(32, 24, 1) + 30) << object;
    EXPECT_NEAR(picture.at(32, 32, 0), 128, 6) << object;
    EXPECT_NEAR(picture.at(32, 32, 1), 128, 6) << object;
  }
}

TEST_F(UnitPicture, LightsBumpsOfASphereFromTheLightsSide) {
  // The dome at the middle of a stud is brighter on the side where the light comes from.
  const std::string scene =
      "[[texture]]\nname = \"s\"\ngenerate = \"studs\"\nsize = [120, 60]\n[image]\nsize = [129, "
      "129]\n[camera]\nposition = [0, -4, 0]\nfov_degrees = 20\n[[object]]\nkind = \"sphere\"\n"
      "texture = \"s\"\ntheta0 = 30\nphi0 = 15\n[[light]]\ndirection = ";
  const ImageReal left = draw(scene + "[-1, -1, 0]\n"), top = draw(scene + "[0, -1, 1]\n");
  // The middle of the picture is u = 240 / 360 = 4 / 6, v = 75 / 180 = 2.5 / 6 and so lies between
  // two domes of the same row; the dome to its right is centred an eighth of a turn / 1.5 away.
  const auto [x, y] = std::pair{64 + 38, 64};
  EXPECT_GT(left.at(x - 15, y, 0), left.at(x + 15, y, 0) + 40);
  EXPECT_GT(top.at(x, y - 15, 0), top.at(x, y + 15, 0) + 40);
  EXPECT_NEAR(top.at(x - 8, y, 1), top.at(x + 8, y, 1), 60);
}

TEST_F(UnitPicture, IsBackgroundWhereNothingIsAndBlackWhereLightComesFromBehind) {
  const ImageReal picture = draw(
      "[[texture]]\nname = \"m\"\ngenerate = \"noise\"\n[image]\nsize = [32, 32]\nbackground = "
      "[10, 20, 30]\n[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n[[light]]\ndirection = [1, "
      "0, 0]\n");
  EXPECT_EQ(picture.at(0, 0, 0), 10);
  EXPECT_EQ(picture.at(0, 0, 2), 30);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(picture.at(10, 16, c), 0);
  EXPECT_GT(picture.at(24, 16, 0) + picture.at(24, 16, 1) + picture.at(24, 16, 2), 0);
}

TEST(CombineColors, FollowsStepU11InRealNumbers) {
  const Rgba p{200, 100, 50, 255}, c{100, 250, 40, 51};
  const auto out = [&](CombineMode mode) {
    DrawSpec draw;
    draw.combine = mode;
    draw.ka = 0.5;
    draw.kd = 1.5;
    return combine_colors(draw, p, c);
  };
  EXPECT_EQ(out(CombineMode::none), (Rgb{200, 100, 50}));
  EXPECT_EQ(out(CombineMode::modulate), (Rgb{200 * 100 / 255.0, 100 * 250 / 255.0, 2000 / 255.0}));
  const Rgb decal = out(CombineMode::decal);
  EXPECT_DOUBLE_EQ(decal[0], 0.2 * 100 + 0.8 * 200);
  EXPECT_DOUBLE_EQ(decal[1], 0.2 * 250 + 0.8 * 100);
  EXPECT_EQ(out(CombineMode::blend), (Rgb{255, 255, 95})) << "350 and 275 are limited";
  EXPECT_EQ(out(CombineMode::add), (Rgb{255, 255, 90}));
  EXPECT_EQ(out(CombineMode::replace), (Rgb{100, 250, 40}));
}

TEST_F(UnitPicture, LooksUpTheColourTextureAtALevelOfItsOwn) {
  const std::string textures =
      "[[texture]]\nname = \"m\"\ngenerate = \"gradient\"\nsize = [16, 16]\nfilter = "
      "\"trilinear\"\n[[texture]]\nname = \"c\"\ngenerate = \"noise\"\nkind = \"picture\"\nsize = "
      "[64, 32]\n";
  draw(textures + square_on(16, 16, "texture = \"m\"\ncolor = \"c\"\ncombine = \"replace\"\n") +
       "[[light]]\ndirection = [0, -1, 0]\n");
  EXPECT_EQ(color_lod(scene_.draws[0], textures_), 2);
  // A texel of the map a pixel: four of the colour's across, so its level 2, 16 x 8.
  const MipTexture mips(textures_[1], true);
  const UnitRenderer renderer(scene_, textures_);
  for (const SurfaceSample& s : samples_) {
    EXPECT_NEAR(s.lod, 0, 1e-9);
    const double row = (s.y + 0.5) / 2 - 0.5;
    const int j = static_cast<int>(std::floor(row)) & 7, below = (j + 1) & 7;
    const double f = row - std::floor(row);
    const double expected =
        (1 - f) * mips.texel(2, s.x, j, {})[0] + f * mips.texel(2, s.x, below, {})[0];
    EXPECT_NEAR(renderer.shade(s, s.light)[0], expected, 1e-6);
  }
}

TEST_F(UnitPicture, OfAMinifiedMapComesNearTheExactAreaAverage) {
  const std::string scene =
      "filter = \"trilinear\"\nprobes = 16\n[image]\nsize = [64, 64]\n[camera]\nposition = [0, "
      "-3, 0.5]\n[[object]]\nkind = \"plane\"\ntexture = \"m\"\norigin = [-4, 8, -0.5]\ni = [8, "
      "0, 0]\nj = [0, -16, 0]\n[[light]]\ndirection = [-0.5, 0.5, 1]\n";
  const std::string map = "[[texture]]\nname = \"m\"\ngenerate = \"relief\"\nsize = [256, 256]\n";
  const auto rms = [&](const std::string& text) {
    const ImageReal filtered = draw(text);
    const UnitRenderer renderer(scene_, textures_);
    const ImageReal exact = exact_area_average(scene_, renderer, samples_);
    double sum = 0;
    for (std::size_t i = 0; i < exact.samples.size(); ++i) {
      sum += std::pow(filtered.samples[i] - exact.samples[i], 2);
    }
    return std::sqrt(sum / static_cast<double>(exact.samples.size()));
  };
  const double good = rms(map + scene);
  const double point = rms(map + "filter = \"point\"\n" + scene.substr(scene.find("probes")));
  const double one = rms(map + "filter = \"trilinear\"\n" + scene.substr(scene.find("[image]")));
  EXPECT_LT(good, one / 2) << "probes along the long axis keep what one round footprint blurs";
  EXPECT_LT(good, point / 2) << "and do not alias";
  std::cout << "RMS against the exact average, levels: 16 probes " << good << ", one " << one
            << ", point sampling " << point << '\n';
}

TEST_F(UnitPicture, TakesAlphaOfAPictureWithoutMultiplyingIt) {
  const auto png = OIIO::ImageOutput::create("png");
  OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeDesc::UINT8);
  spec["oiio:UnassociatedAlpha"] = 1;
  const std::array<std::uint8_t, 8> samples{10, 20, 30, 40, 250, 60, 70, 0};
  ASSERT_TRUE(png->open((folder_ / "a.png").string(), spec) &&
              png->write_image(OIIO::TypeDesc::UINT8, samples.data()) && png->close());
  EXPECT_EQ(read_picture_with_alpha(folder_ / "a.png").samples,
            (std::vector<double>{10, 20, 30, 40, 250, 60, 70, 0}));
  EXPECT_EQ(read_picture(folder_ / "a.png").samples,
            (std::vector<double>{10, 20, 30, 250, 60, 70}));
  std::ofstream(folder_ / "c.ppm") << "P3 2 1 255 10 20 30 40 50 60\n";
  const ImageReal plain = read_picture_with_alpha(folder_ / "c.ppm");
  EXPECT_EQ(plain.samples, (std::vector<double>{10, 20, 30, 255, 40, 50, 60, 255}));
  std::ofstream(folder_ / "g.pgm") << "P2 1 1 255 77\n";
  EXPECT_EQ(read_picture_with_alpha(folder_ / "g.pgm").samples,
            (std::vector<double>{77, 77, 77, 255}));
}

TEST_F(UnitPicture, HasCapturesAndBumpMapsAsTheirOwnProgramsFitThem) {
  // Lambert's law on a flat white surface, and a ramp that rises to the right.
  std::string lights = "8\n";
  for (int n = 0; n < 8; ++n) {
    const double w = n < 4 ? 0.9 : 0.5, r = std::sqrt(1 - w * w), angle = 0.7 * n;
    const std::string name = std::to_string(n) + ".png";
    write_picture(folder_ / name, [&] {
      Image8 flat(3, 2, 3);
      for (auto& s : flat.samples) s = static_cast<std::uint8_t>(200 * w);
      return flat;
    }());
    lights += name + " " + std::to_string(r * std::cos(angle)) + " " +
              std::to_string(r * std::sin(angle)) + " " + std::to_string(w) + "\n";
  }
  write("c.lp", lights);
  Image8 ramp(3, 1, 1);
  ramp.samples = {0, 51, 102};
  write_picture(folder_ / "ramp.png", ramp);
  const UnitScene scene = read(
      "[[texture]]\nname = \"c\"\ncapture = \"c.lp\"\n[[texture]]\nname = \"r\"\ncapture = "
      "\"c.lp\"\nformat = \"rgb\"\n[[texture]]\nname = \"b\"\nbump = \"ramp.png\"\nstrength = 5"
      "\n[[object]]\nkind = \"plane\"\ntexture = \"c\"\n[[light]]\ndirection = [0, 0]\n");
  const LoadedTextures textures = load_textures(scene);
  EXPECT_EQ(textures[0].width, 3);
  EXPECT_EQ(textures[0].polynomials, 1);
  EXPECT_EQ(textures[1].polynomials, 3);
  for (std::size_t t = 0; t < 2; ++t) {
    const MipTexture mips(textures[t], false);
    EXPECT_NEAR(mips.texel(0, 2, 1, {0.4358, 0})[1], 180, 2) << t;
  }
  // Slope 5 * 51 / 255 = 1: the normal leans to the left by 45 degrees.
  const MipTexture bump(textures[2], false);
  const double from_left = bump.texel(0, 1, 0, {-0.7, 0})[0];
  EXPECT_GT(from_left, bump.texel(0, 1, 0, {0.7, 0})[0] + 100);
}

TEST_F(UnitPicture, RefusesTexturesThatHardwareCannotHold) {
  write_ptm(folder_ / "m.ptm", made_map(MapKind::lrgb, 4, 4));
  const auto complain = [&](const std::string& texture) {
    return complaint_of([&] {
      (void)load_textures(read("[[texture]]\nname = \"m\"\n" + texture +
                               "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n"
                               "[[light]]\ndirection = [0, 0]\n"));
    });
  };
  EXPECT_EQ(complain("ptm = \"m.ptm\"\npalette = 257\n"),
            "line 1 (texture[0])|a palette of 257 entries|at most 256 for an LRGB map");
  EXPECT_EQ(complain("ptm = \"m.ptm\"\npalette = true\n"), "nothing");
  write_picture(folder_ / "wide.png", Image8(4097, 1, 1));
  EXPECT_EQ(complain("bump = \"wide.png\"\n"),
            "size of texture 'm'|4097 x 1 texels|at most 4096 a side; make the picture smaller");
}

}  // namespace
}  // namespace ptm::golden
