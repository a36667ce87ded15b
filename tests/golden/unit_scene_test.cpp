#include "golden/scene/unit_scene.h"

#include <iterator>

#include "tests/golden/made_scene.h"

namespace ptm::golden {
namespace {

class UnitSceneFile : public MadeScene {};

const std::string kMap = "[[texture]]\nname = \"m\"\ngenerate = \"noise\"\n";
const std::string kPlain = "[[texture]]\nname = \"c\"\ngenerate = \"noise\"\nkind = \"picture\"\n";
const std::string kPlane = "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n";
const std::string kLight = "[[light]]\ndirection = [0, -3, 4]\n";

TEST_F(UnitSceneFile, HoldsWhatItSaysOfItsObjects) {
  const UnitScene scene = read(kMap + kPlain + R"(
[[object]]
kind = "cylinder"
texture = "m"
color = "c"
combine = "blend"
ka = 0.25
kd = 1.5
origin = [1, 2, 3]
radius = 2
height = 5
a = 3
b = -2
theta0 = 90
z0 = 1
theta = [-90, 270]
z = [1, 4]
translate = [7, 8, 9]
rotate = [10, 20, 30]
scale = 2
uv_scale = [1000, -1]
uv_offset = [-12345.5, 0]
segments = [5, 6]
)" + kLight);
  const ObjectSpec& object = scene.objects.at(0);
  const double degree = std::numbers::pi / 180;
  EXPECT_EQ(object.shape.origin, Vec3(1, 2, 3));
  EXPECT_EQ(object.shape.radius, 2);
  EXPECT_EQ(object.shape.height, 5);
  EXPECT_EQ(object.shape.a, 3);
  EXPECT_EQ(object.shape.b, -2);
  EXPECT_DOUBLE_EQ(object.shape.p0, 90 * degree);
  EXPECT_EQ(object.shape.q0, 1);
  EXPECT_EQ(object.shape.p_range[1], object.shape.p_range[0] + 2 * std::numbers::pi);
  EXPECT_EQ(object.shape.q_range, (std::array<double, 2>{1, 4}));
  EXPECT_EQ(object.transform.scale, Vec3(2, 2, 2));
  EXPECT_EQ(object.transform.rotate, Vec3(10, 20, 30));
  EXPECT_EQ(object.uv_scale[0], 1000);
  EXPECT_EQ(object.uv_offset[0], -12345.5);
  EXPECT_EQ(object.segments, (std::array<int, 2>{5, 6}));
  const DrawSpec& draw = scene.draws.at(0);
  EXPECT_EQ(draw.map, 0);
  EXPECT_EQ(draw.color, 1);
  EXPECT_EQ(draw.combine, CombineMode::blend);
  EXPECT_EQ(draw.ka, 0.25);
  EXPECT_EQ(draw.kd, 1.5);
}

TEST_F(UnitSceneFile, HoldsWhatItSaysOfHardwareMemoryAndStress) {
  const UnitScene scene = read(R"(keep_cache = true
draw_twice = true
models = ["golden"]
)" + kMap + kPlane + kLight + R"(
[image]
size = [30, 20]
traversal = "tiles"
tile = 8
background = [1, 2, 3]
[hardware]
preset = "wide"
tmus = 2
cache_kib = 4
ways = 1
fragment_fifo = 32
miss_fifo = 9
shift_groups = 3
palette_lrgb_ports = 1
palette_rgb_ports = 2
counters = true
duplicate_lines = false
[memory]
kind = "dram"
banks = 4
page_lines = 64
tRCD = 1
tRP = 2
CL = 3
tRAS = 4
tREFI = 500
tRFC = 6
burst = 7
overhead = 8
[stress]
input_gap = 9
output_stall = 10
seed = 11
)");
  EXPECT_EQ(scene.size, (std::array<int, 2>{30, 20}));
  EXPECT_EQ(scene.tile, 8);
  EXPECT_EQ(scene.background, (std::array<double, 3>{1, 2, 3}));
  EXPECT_TRUE(scene.keep_cache && scene.draw_twice);
  EXPECT_EQ(scene.models, std::vector<std::string>{"golden"});
  // As they stand, in the order of the file; what they may be is not golden's business.
  const auto texts = [](const Settings& settings) {
    std::vector<std::string> all;
    for (const Setting& s : settings.list) {
      const char kind = "nfwo"[static_cast<int>(s.kind)];  // number, flag, word, other
      all.push_back(s.key + " " + s.text + " " + kind);
    }
    return all;
  };
  EXPECT_EQ(texts(scene.hardware),
            (std::vector<std::string>{
                "hardware.preset wide w", "hardware.tmus 2 n", "hardware.cache_kib 4 n",
                "hardware.ways 1 n", "hardware.fragment_fifo 32 n", "hardware.miss_fifo 9 n",
                "hardware.shift_groups 3 n", "hardware.palette_lrgb_ports 1 n",
                "hardware.palette_rgb_ports 2 n", "hardware.counters true f",
                "hardware.duplicate_lines false f"}));
  EXPECT_EQ(scene.hardware.list[1].name, "tmus");
  EXPECT_EQ(scene.hardware.list[1].place, "line 20");
  EXPECT_EQ(
      texts(scene.memory),
      (std::vector<std::string>{"memory.kind dram w", "memory.banks 4 n", "memory.page_lines 64 n",
                                "memory.tRCD 1 n", "memory.tRP 2 n", "memory.CL 3 n",
                                "memory.tRAS 4 n", "memory.tREFI 500 n", "memory.tRFC 6 n",
                                "memory.burst 7 n", "memory.overhead 8 n"}));
  EXPECT_EQ(std::tie(scene.stress.input_gap, scene.stress.output_stall), std::make_tuple(9, 10));
  EXPECT_EQ(scene.stress.seed, 11U);
}

TEST_F(UnitSceneFile, TellsThreeKindsOfLightApart) {
  const UnitScene scene = read(kMap + kPlane + kLight +
                               "[[light]]\ndirection = [-1.5, 0.25]\n"
                               "[[light]]\nposition = [1, 2, 3]\n");
  ASSERT_EQ(scene.lights.size(), 3U);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  EXPECT_TRUE(scene.lights[0].vector.isApprox(Vec3(0, -0.6, 0.8)));
  EXPECT_EQ(scene.lights[1].kind, LightKind::local);
  EXPECT_EQ(scene.lights[1].vector, Vec3(-1.5, 0.25, 0));
  EXPECT_EQ(scene.lights[2].kind, LightKind::point);
  EXPECT_EQ(scene.lights[2].vector, Vec3(1, 2, 3));
}

TEST_F(UnitSceneFile, SharesDrawsAmongObjectsThatAgreeAndRefusesAFifth) {
  std::string text = kMap + kPlain + kPlane + kPlane;
  EXPECT_EQ(read(text + kLight).draws.size(), 1U);
  for (const char* combine : {"add", "decal", "modulate"}) {
    text += kPlane + "color = \"c\"\ncombine = \"" + combine + "\"\n";
  }
  EXPECT_EQ(read(text + kLight).draws.size(), 4U);
  EXPECT_EQ(complaint(text + kPlane + "color = \"c\"\ncombine = \"replace\"\n" + kLight),
            "line 29 (object[5])|a fifth combination of textures and how they are combined|at "
            "most four: the unit has four descriptors");
}

TEST_F(UnitSceneFile, GivesADrawTheSamplingOfItsTexturesIfTheyDoNotDiffer) {
  const std::string sampling = "wrap_u = \"mirror\"\nfilter = \"trilinear\"\nprobes = 8\n";
  const std::string object = kPlane + "color = \"c\"\n" + kLight;
  const DrawSpec draw = read(kMap + sampling + kPlain + "wrap_v = \"clamp\"\n" + object).draws[0];
  EXPECT_EQ(draw.wrap_u, WrapMode::mirror);
  EXPECT_EQ(draw.wrap_v, WrapMode::clamp);
  EXPECT_EQ(draw.filter, (FilterMode{true, MipMode::linear}));
  EXPECT_EQ(draw.probes, 8);
  EXPECT_EQ(complaint(kMap + sampling + kPlain + "filter = \"point\"\n" + object),
            "line 15 (object[0].color)|another filter than the map's|the map's: a draw's two "
            "textures share it");
}

TEST_F(UnitSceneFile, IsToldFromAFlatScene) {
  EXPECT_TRUE(is_unit_scene(write("a.toml", kPlane)));
  EXPECT_FALSE(is_unit_scene(write("b.toml", "[map]\nfile = \"a.ptm\"\n")));
}

TEST_F(UnitSceneFile, AsTheSpecificationShowsItCanBeRead) {
  std::ifstream in(std::filesystem::path(PTM_SOURCE_DIR) / "docs" / "spec" / "scene.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = page.rfind("```toml") + 8;
  const UnitScene scene = read(page.substr(begin, page.rfind("```") - begin));
  EXPECT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.draws.size(), 2U);
}

struct Bad {
  std::string text, complaint;
};

TEST_F(UnitSceneFile, RefusesWhatMeansNothingWithItsLine) {
  const std::string object = "[[object]]\nkind = \"plane\"\n";
  const std::vector<Bad> all{
      {kMap + kLight, "the file|no [[object]]|at least one [[object]]"},
      {kMap + kPlane, "the file|no [[light]]|at least one [[light]] with direction or position"},
      {kMap + object + kLight,
       "line 4 (object[0])|neither 'texture' nor 'color'|at least one of "
       "them"},
      {kMap + object + "texture = \"x\"\n" + kLight,
       "line 6 (object[0].texture)|'x'|the name of a [[texture]]"},
      {kPlain + object + "texture = \"c\"\n" + kLight,
       "line 7 (object[0].texture)|'c', a plain picture|a map; a plain picture goes with 'color'"},
      {kMap + kPlane + "combine = \"add\"\n" + kLight,
       "line 7 (object[0].combine)|a combine without a colour texture|'color', or combine = "
       "\"none\""},
      {kPlain + object + "color = \"c\"\ncombine = \"add\"\n" + kLight,
       "line 8 (object[0].combine)|a combine without a map|'texture', or combine = \"replace\""},
      {kMap + kPlane + "kd = 1\n" + kLight,
       "line 7 (object[0].kd)|a weight without blend|combine = \"blend\""},
      {kMap + kPlane + "radius = 1\n" + kLight,
       "line 7|unknown key 'object[0].radius'|one of kind, texture, color, combine, ka, kd, "
       "translate, rotate, scale, uv_scale, uv_offset, effect, origin, i, j, s, t, segments"},
      {kMap + kPlane + "i = [0, 0, 4]\n" + kLight,
       "line 7 (object[0].i)|axes on a line|axes that span a plane"},
      {kMap + kPlane + "s = [1, 1]\n" + kLight,
       "line 7 (object[0].s)|a range that does not rise|two numbers, the second greater"},
      {kMap + kPlane + "scale = [1, 0, 1]\n" + kLight,
       "line 7 (object[0].scale)|a factor of 0|factors of at least 1e-9 in size"},
      {kMap + "probes = 6\n" + kPlane + kLight, "line 4 (texture[0].probes)|6|1, 2, 4, 8 or 16"},
      {kMap + "ptm = \"a.ptm\"\n" + kPlane + kLight,
       "line 3 (texture[0].generate)|a second source beside 'ptm'|one source"},
      {kMap + kMap + kPlane + kLight, "line 5 (texture[1].name)|'m' twice|each name once"},
      {kMap + "strength = 2\n" + kPlane + kLight,
       "line 4|unknown key 'texture[0].strength'|one of generate, size, seed, kind, name, palette, "
       "wrap, wrap_u, wrap_v, filter, probes"},
      {kMap + "wrap = \"clamp\"\nwrap_v = \"clamp\"\n" + kPlane + kLight,
       "line 5 (texture[0].wrap_v)|beside 'wrap'|wrap, or wrap_u and wrap_v"},
      {kPlain + "palette = 4\n" + kPlane + kLight,
       "line 5 (texture[0].palette)|a palette of a plain picture|a map"},
      {kMap + "size = [4097, 1]\n" + kPlane + kLight,
       "line 4 (texture[0].size)|4097|an integer from 1 to 4096"},
      {kMap + kPlane + "[[light]]\ndirection = [0, 0, 0]\n",
       "line 8 (light[0].direction)|(0, 0, 0)|a direction"},
      {kMap + kPlane + "[[light]]\n",
       "line 7 (light[0])|no 'direction'|direction = [x, y, z] or [lu, lv], or position = [x, y, "
       "z]"},
      {kMap + kPlane + kLight + "[camera]\ntarget = [0, -4, 0]\n",
       "line 10 (camera.target)|the camera's own position|another point"},
      {kMap + kPlane + kLight + "[camera]\nup = [0, 1, 0]\n",
       "line 10 (camera.up)|a direction along the view|one across it"},
      {kMap + kPlane + kLight + "[camera]\nheight = 3\n",
       "line 10 (camera.height)|the height of a perspective camera|fov_degrees"},
      {kMap + kPlane + kLight + "[image]\nsize = [16385, 1]\n",
       "line 10 (image.size)|16385|an integer from 1 to 16384"},
      {kMap + kPlane + kLight + "[image]\nsize = [16384, 1025]\n",
       "line 10 (image.size)|16384 x 1025|at most 16777216 pixels"},
      {kMap + kPlane + kLight + "[image]\nbackground = [0, 0, 256]\n",
       "line 10 (image.background[2])|256|a number from 0 to 255"},
      {kMap + kPlane + kLight + "[stress]\noutput_stall = 256\n",
       "line 10 (stress.output_stall)|256|an integer from 0 to 255"}};
  for (const Bad& bad : all) EXPECT_EQ(complaint(bad.text), bad.complaint) << bad.text;
}

}  // namespace
}  // namespace ptm::golden
