// The hard cases of every effect, from a scene file to pixels: golden stays finite and within its
// levels, reference and RTL agree in every pixel, `exact` and RTL in every cycle.
#include "golden/files/ptm_file.h"
#include "tests/run_program.h"
#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {
namespace {

struct HardCase {
  std::string name;
  std::string texture;  ///< the [[texture]]'s source
  std::string effects;  ///< [[object.effect]] tables
  std::string light = "direction = [-0.5, -1, 0.7]";
  std::string camera = "position = [0, -4, 0]";
};
void PrintTo(const HardCase& which, std::ostream* out) { *out << which.name; }

const std::string kRelief = "generate = \"relief\"\n", kNoise = "generate = \"noise\"\n",
                  kZero = "ptm = \"zero.ptm\"\n";
std::string effect(const std::string& kind, const std::string& keys = "") {
  return "[[object.effect]]\nkind = \"" + kind + "\"\n" + keys + "\n";
}
std::string highlight(const std::string& keys) { return effect("half-vector", keys); }
std::string enhanced(const std::string& keys) { return effect("specular-enhancement", keys); }

const std::vector<HardCase> kCases{
    {"exponent_1", kRelief, highlight("exponent = 1")},
    {"exponent_255", kRelief, highlight("exponent = 255")},
    {"no_weight", kRelief, highlight("ks = 0")},
    {"most_weight", kRelief, highlight("ks = 1.99609375\nexponent = 1")},
    {"half_vector_of_zero_coefficients", kZero, highlight("")},
    {"half_vector_of_noise", kNoise, highlight("ks = 1.5\nexponent = 3")},
    {"half_vector_at_grazing", kRelief, highlight("exponent = 5"), "direction = [0, 1, 0.001]",
     "position = [0, -4, 0.002]\ntarget = [0, 0, 0]"},
    {"light_opposite_to_the_viewer", kRelief, highlight(""), "direction = [0, 1, 0]"},
    {"light_behind_the_surface", kRelief, highlight("ks = 1.5\nexponent = 1"),
     "direction = [0, 1, -0.2]"},
    {"light_on_the_surface", kRelief, highlight(""), "position = [0, -1, 0]"},
    {"enhancement_of_zero_coefficients", kZero, enhanced("exponent = 1")},
    {"enhancement_of_every_curvature", kNoise, enhanced("ks = 1.9\nexponent = 255")},
    {"gain_0", kNoise, effect("diffuse-gain", "gain = 0")},
    {"gain_very_large", kNoise, effect("diffuse-gain", "gain = 1000")},
    {"gain_of_zero_coefficients", kZero, effect("diffuse-gain", "gain = 1000")},
    {"normals_of_zero_coefficients", kZero, effect("normals")},
    {"normals_of_every_curvature", kNoise, effect("normals")},
    {"extrapolated_to_the_last_code", kNoise, effect("light-extrapolation", "gain = 2"),
     "direction = [1, 0]"},
    {"focus_at_the_corner", "generate = \"focus\"\n", effect("focus", "coordinates = [1, -1]")},
};

class HardCaseResult : public tests::Program {
 protected:
  UnitJob job(const HardCase& which) const {
    golden::PtmMap zero;
    zero.width = zero.height = 8;
    zero.kind = golden::MapKind::lrgb;
    zero.scale = {1, 1, 1, 1, 1, 1};
    zero.coef.assign(zero.texels() * 6, 0);
    zero.color.assign(zero.texels() * 3, 200);
    golden::write_ptm(file("zero.ptm"), zero);
    const bool sized = which.texture.starts_with("generate");
    return make_unit_job(golden::read_unit_scene(
        write("scene.toml", "[image]\nsize = [32, 24]\n[camera]\n" + which.camera +
                                "\n[[texture]]\nname = \"m\"\nfilter = \"bilinear\"\n" +
                                which.texture + (sized ? "size = [24, 24]\n" : "") +
                                "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n" + which.effects +
                                "[[light]]\n" + which.light + "\n")));
  }
};

class HardCases : public HardCaseResult, public testing::WithParamInterface<HardCase> {};

TEST_P(HardCases, StayFiniteAndAgree) {
  const UnitJob made = job(GetParam());
  ASSERT_FALSE(made.frames[0].fragments.empty());
  for (const double level : render_unit_golden(made).frames[0].samples) {
    ASSERT_TRUE(level >= 0 && level <= 255) << level;
  }
  expect_agreement(made, run_pair(made));
}

INSTANTIATE_TEST_SUITE_P(Effects, HardCases, testing::ValuesIn(kCases),
                         [](const auto& which) { return which.param.name; });

/// The one case of that name.
const HardCase& named(const std::string& name) {
  return *std::find_if(kCases.begin(), kCases.end(),
                       [&](const HardCase& which) { return which.name == name; });
}

/// The pictures of two cases' first frames.
bool same_pixels(const UnitJob& a, const UnitJob& b) { return unit_pixels(a) == unit_pixels(b); }

TEST_F(HardCaseResult, OfNoWeightIsThePictureWithoutTheEffect) {
  HardCase plain = named("no_weight");
  const UnitJob with = job(plain);
  plain.effects.clear();
  EXPECT_TRUE(same_pixels(with, job(plain)));
}

TEST_F(HardCaseResult, OfALightBehindTheSurfaceIsBlackAndHasNoHighlight) {
  const UnitJob behind = job(named("light_behind_the_surface"));
  const auto pixels = unit_pixels(behind);
  for (const reference::UnitPixel& pixel : pixels[0]) {
    ASSERT_EQ(pixel.rgb, (std::array<std::uint8_t, 3>{0, 0, 0}));
  }
}

TEST_F(HardCaseResult, OfZeroCoefficientsIsNormalsThatPointUp) {
  const UnitJob flat = job(named("normals_of_zero_coefficients"));
  const auto pixels = unit_pixels(flat);
  for (const reference::UnitPixel& pixel : pixels[0]) {
    ASSERT_EQ(pixel.rgb, (std::array<std::uint8_t, 3>{128, 128, 255}));
  }
}

/// What is stored as a shape and a strength must not take the strength from N . H.
TEST_F(HardCaseResult, OfAPaletteIsTheHighlightOfTheMapItself) {
  HardCase metal{"", "generate = \"metal\"\n", highlight("ks = 1\nexponent = 20")};
  const auto plain = unit_pixels(job(metal));
  metal.texture += "palette = true\n";
  const auto palettised = unit_pixels(job(metal));
  for (std::size_t i = 0; i < plain[0].size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_LE(std::abs(plain[0][i].rgb[c] - palettised[0][i].rgb[c]), 1) << "pixel " << i;
    }
  }
}

TEST_F(HardCaseResult, OfALightBeyondTheLastCodeIsRefused) {
  HardCase beyond = named("extrapolated_to_the_last_code");
  beyond.effects = effect("light-extrapolation", "gain = 2.01");
  EXPECT_THROW((void)job(beyond), golden::InputError);
}

}  // namespace
}  // namespace ptm::testbench
