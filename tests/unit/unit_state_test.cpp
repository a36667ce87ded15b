#include "testbench/run/unit_job.h"
#include "tests/golden/made_scene.h"

namespace ptm::testbench {
namespace {

/// How a scene's textures come into memory and registers.
class UnitStateOfAScene : public golden::MadeScene {
 protected:
  static std::string map(const std::string& name, const std::string& rest = "") {
    return "[[texture]]\nname = \"" + name + "\"\ngenerate = \"noise\"\nsize = [16, 8]\n" + rest;
  }
  static std::string plane(const std::string& name, const std::string& rest = "") {
    return "[[object]]\nkind = \"plane\"\ntexture = \"" + name + "\"\n" + rest;
  }
  [[nodiscard]] UnitJob job(const std::string& text) const {
    return make_unit_job(
        read("[image]\nsize = [8, 8]\n" + text + "[[light]]\ndirection = [0, -3, 4]\n"));
  }
};

const std::string kAdd = "color = \"c\"\ncombine = \"add\"\n";
const std::string kDecal = "color = \"c\"\ncombine = \"decal\"\n";

TEST_F(UnitStateOfAScene, HoldsATextureThatDrawsShareOnce) {
  const std::string textures = map("m") + map("c", "kind = \"picture\"\n");
  const UnitJob one = job(textures + plane("m", kAdd));
  const UnitJob two = job(textures + plane("m", kAdd) + plane("m", kDecal));
  ASSERT_EQ(two.state.draws.size(), 2U);
  EXPECT_EQ(two.state.memory, one.state.memory);
  EXPECT_EQ(two.state.draws[0].map, two.state.draws[1].map);
  EXPECT_EQ(two.state.draws[0].color_texture, two.state.draws[1].color_texture);
  EXPECT_NE(two.state.draws[0].map.base[0], two.state.draws[0].color_texture.base[0]);
  EXPECT_EQ(two.notes.size(), 1U) << "one map, told of once";
}

TEST_F(UnitStateOfAScene, HoldsNoTextureThatNoObjectHas) {
  EXPECT_EQ(job(map("m") + map("spare") + plane("m")).state.memory,
            job(map("m") + plane("m")).state.memory);
}

TEST_F(UnitStateOfAScene, HasLevelsOnlyWhereADrawReadsThem) {
  for (const char* filter : {"point", "bilinear"}) {
    const UnitJob flat = job(map("m", "filter = \"" + std::string(filter) + "\"\n") + plane("m"));
    EXPECT_EQ(flat.state.draws[0].map.levels, 1) << filter;
  }
  for (const char* filter : {"nearest-mip", "trilinear", "point-linear-mip"}) {
    const UnitJob deep = job(map("m", "filter = \"" + std::string(filter) + "\"\n") + plane("m"));
    EXPECT_EQ(deep.state.draws[0].map.levels, 5) << filter;
  }
}

TEST_F(UnitStateOfAScene, GivesAMapLevelsForTheOneDrawWhoseColorAsksForThem) {
  const UnitJob both = job(map("m") + map("c", "kind = \"picture\"\nfilter = \"trilinear\"\n") +
                           plane("m") + plane("m", kAdd));
  ASSERT_EQ(both.state.draws.size(), 2U);
  EXPECT_EQ(both.state.draws[0].mip, reference::Mip::none);
  EXPECT_EQ(both.state.draws[1].mip, reference::Mip::linear);
  EXPECT_EQ(both.state.draws[0].map.levels, 5) << "placed once, with what any draw needs";
  EXPECT_EQ(both.state.draws[0].map, both.state.draws[1].map);
}

TEST_F(UnitStateOfAScene, SaysWhatStoringCoefficientsBeyondTheHardwareChanges) {
  const std::string gain = "[[object.effect]]\nkind = \"diffuse-gain\"\ngain = 1000\n";
  const std::string noise = "[[texture]]\nname = \"m\"\ngenerate = \"noise\"\nsize = [16, 16]\n";
  const auto says = [](const UnitJob& made) {
    return std::count_if(made.notes.begin(), made.notes.end(), [](const std::string& note) {
      return note.find("not in the hardware's range") != std::string::npos;
    });
  };
  EXPECT_EQ(says(job(noise + plane("m"))), 0);
  EXPECT_EQ(says(job(noise + plane("m") + gain)), 1);
}

TEST_F(UnitStateOfAScene, NumbersLrgbPalettesInTheOrderOfTheirDraws) {
  const UnitJob made =
      job(map("a", "palette = 4\nseed = 1\n") + map("b", "palette = 9\nseed = 2\n") + plane("b") +
          plane("a") + plane("a", ""));
  ASSERT_EQ(made.state.draws.size(), 2U);
  EXPECT_EQ(made.state.draws[0].format, reference::TextureFormat::palette_lrgb);
  EXPECT_EQ(made.state.draws[0].palette, 0);
  EXPECT_EQ(made.state.draws[1].palette, 1);
  const auto& table = made.state.palettes.lrgb;
  const auto used = [&](std::size_t palette, std::size_t entry) {
    return table.at(palette * reference::kLrgbEntries + entry) != std::array<std::uint64_t, 2>{};
  };
  EXPECT_TRUE(used(0, 8)) << "b's ninth entry";
  EXPECT_FALSE(used(0, 9));
  EXPECT_TRUE(used(1, 3)) << "a's fourth entry";
  EXPECT_FALSE(used(1, 4));
}

TEST_F(UnitStateOfAScene, HasRoomForOneRgbPaletteBesideThoseOfLrgb) {
  const std::string rgb = "kind = \"rgb\"\npalette = 7\n";
  const UnitJob made = job(map("a", "palette = 4\n") + map("b", rgb) + plane("a") + plane("b"));
  EXPECT_EQ(made.state.draws.at(1).format, reference::TextureFormat::palette_rgb);
  EXPECT_FALSE(made.state.palettes.rgb.empty());
  EXPECT_EQ(
      complaint_of([&] { (void)job(map("a", rgb) + map("b", rgb) + plane("a") + plane("b")); }),
      "line 9 (texture[1])|a second RGB palette|at most one");
}

TEST_F(UnitStateOfAScene, IsLegalAndHasMoreLinesWhereAWordHoldsTwoCoefficients) {
  const UnitJob made = job(map("a", "") + map("b", "kind = \"rgb\"\n") + map("c", "palette = 4\n") +
                           plane("a") + plane("b") + plane("c"));
  const auto state_of = [&made](int coef_bits) {
    reference::EvalConfig config = made.config;
    config.coef_bits = coef_bits;
    config.delta_bits = coef_bits + 1;
    std::vector<std::string> notes;
    const auto state = make_unit_state(made.scene, made.textures, made.extras, config, notes);
    for (const reference::Draw& draw : state.draws) {
      EXPECT_EQ(check_draw(draw, state.memory.size(), {}, config), 0U) << coef_bits;
    }
    return state;
  };
  const auto three = state_of(10), two = state_of(12);
  ASSERT_EQ(two.draws.size(), 3U);
  // LRGB, RGB, palettised: one array of lines behind the other, of as many tiles each.
  const std::size_t lines = three.memory.size() / (3 + 6 + 1);
  EXPECT_EQ(three.memory.size(), lines * (3 + 6 + 1));
  EXPECT_EQ(two.memory.size(), lines * (4 + 9 + 1));
}

TEST_F(UnitStateOfAScene, IsLegalAtEverySizeOfTextureDownToOneTexel) {
  for (const std::string size : {"[1, 1]", "[1, 5]", "[7, 1]", "[3, 3]"}) {
    for (const std::string kind : {"lrgb", "rgb"}) {
      for (const std::string palette : {"", "palette = 2\n"}) {
        const UnitJob made =
            job("[[texture]]\nname = \"m\"\ngenerate = \"noise\"\nsize = " + size + "\nkind = \"" +
                kind + "\"\nfilter = \"trilinear\"\n" + palette + plane("m"));
        EXPECT_EQ(reference::check_draw(made.state.draws.at(0), made.state.memory.size()), 0U)
            << size << kind << palette;
      }
    }
  }
}

}  // namespace
}  // namespace ptm::testbench
