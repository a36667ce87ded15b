// Effects in scene files: what is read, and what is refused with its line.
#include "golden/effects/effect.h"
#include "tests/golden/made_scene.h"

namespace ptm::golden {
namespace {

class EffectScene : public MadeScene {
 protected:
  /// What preparing a scene complains about.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    return complaint_of([&] {
      UnitScene scene = read(text);
      LoadedTextures textures = load_textures(scene);
      (void)prepare_effects(scene, textures);
    });
  }
};

const std::string kMap = "[[texture]]\nname = \"m\"\ngenerate = \"noise\"\nsize = [8, 4]\n";
const std::string kRgb =
    "[[texture]]\nname = \"rgb\"\ngenerate = \"noise\"\nkind = \"rgb\"\nsize = [8, 4]\n";
const std::string kPicture =
    "[[texture]]\nname = \"c\"\ngenerate = \"noise\"\nkind = \"picture\"\nsize = [8, 4]\n";
const std::string kLight = "[[light]]\ndirection = [0, -3, 4]\n";

std::string plane(const std::string& map) {
  return "[[object]]\nkind = \"plane\"\ntexture = \"" + map + "\"\n";
}
std::string effect(const std::string& keys) { return "[[object.effect]]\n" + keys + "\n"; }
std::string kind(const std::string& name) { return "kind = \"" + name + "\""; }

TEST_F(EffectScene, HoldsEffectsInTheOrderOfTheRowsWithDefaultsFilledIn) {
  const UnitScene scene = read(kMap + plane("m") + effect(kind("fresnel") + "\nior = 1.5") +
                               effect(kind("half-vector") + "\nexponent = 7") + kLight);
  const auto& effects = scene.draws.at(0).effects;
  ASSERT_EQ(effects.size(), 2U);
  EXPECT_EQ(effects[0].effect, "half-vector");
  EXPECT_EQ(effect_number(effects[0], "ks"), 0.5);
  EXPECT_EQ(effect_number(effects[0], "exponent"), 7);
  EXPECT_EQ(effects[1].effect, "fresnel");
  EXPECT_EQ(effect_numbers(effects[1], "ior"), std::vector<double>{1.5});
  EXPECT_TRUE(effect_numbers(effects[1], "n").empty());
  EXPECT_NE(effects[1].place.find("object[0].effect[0]"), std::string::npos);
}

TEST_F(EffectScene, SharesADrawBetweenObjectsWhoseEffectsSayTheSame) {
  const std::string shiny = plane("m") + effect(kind("half-vector"));
  EXPECT_EQ(read(kMap + shiny + shiny + kLight).draws.size(), 1U);
  EXPECT_EQ(read(kMap + shiny + plane("m") + kLight).draws.size(), 2U);
  EXPECT_EQ(read(kMap + shiny + shiny + "ks = 1\n" + kLight).draws.size(), 2U);
}

TEST_F(EffectScene, NamesWordsTexturesAndPairs) {
  const UnitScene scene =
      read(kMap + kRgb + plane("m") + effect(kind("half-vector")) +
           effect(kind("modulated-specular") + "\nmap = \"rgb\"") +
           effect(kind("anisotropic") + "\npattern = \"linear\"") + plane("rgb") +
           effect(kind("focus") + "\ncoordinates = [[0, 1], [-1, 0.5]]") + plane("rgb") +
           effect(kind("time") + "\ncoordinates = [0.25, 0]") + kLight + kLight);
  const auto& draws = scene.draws;
  EXPECT_EQ(effect_number(draws[0].effects[1], "map"), 1);
  EXPECT_EQ(effect_number(draws[0].effects[2], "pattern"), 1);
  EXPECT_EQ(effect_numbers(draws[1].effects[0], "coordinates"),
            (std::vector<double>{0, 1, -1, 0.5}));
  EXPECT_EQ(effect_numbers(draws[2].effects[0], "coordinates"), (std::vector<double>{0.25, 0}));
}

TEST_F(EffectScene, RefusesWhatItDoesNotKnowAndListsWhatItHas) {
  const std::string unknown = complaint(kMap + plane("m") + effect(kind("bloom")) + kLight);
  EXPECT_NE(unknown.find("line 9 (object[0].effect[0].kind)|'bloom'|"), std::string::npos)
      << unknown;
  for (const Effect* known : effects()) {
    EXPECT_NE(unknown.find(known->name), std::string::npos) << known->name;
  }
  const auto said = [&](const std::string& keys) {
    return complaint(kMap + kPicture + plane("m") + effect(keys) + kLight);
  };
  EXPECT_NE(said("ks = 1").find("no 'kind'"), std::string::npos);
  EXPECT_NE(said(kind("half-vector") + "\nshine = 1").find("unknown key"), std::string::npos);
  EXPECT_NE(said(kind("half-vector") + "\nks = 2").find("2|a number from 0"), std::string::npos);
  EXPECT_NE(said(kind("half-vector") + "\nexponent = 0").find("0|an integer from 1 to 255"),
            std::string::npos);
  EXPECT_NE(said(kind("half-vector") + "\nexponent = 1.5").find("a number|an integer"),
            std::string::npos);
  EXPECT_NE(said(kind("modulated-specular")).find("no 'map'"), std::string::npos);
  EXPECT_NE(said(kind("modulated-specular") + "\nmap = \"x\"").find("'x'|the name of a"),
            std::string::npos);
  EXPECT_NE(said(kind("anisotropic") + "\npattern = \"x\"").find("'x'|one of disc, linear"),
            std::string::npos);
  EXPECT_NE(said(kind("focus") + "\ncoordinates = [0, 1.5]").find("1.5|a number from -1 to 1"),
            std::string::npos);
  EXPECT_NE(said(kind("focus") + "\ncoordinates = [[0, 1], [0]]").find("1 element|2 elements"),
            std::string::npos);
  EXPECT_NE(said(kind("focus") + "\ncoordinates = []").find("0 elements|2 elements"),
            std::string::npos);
  EXPECT_NE(said(kind("focus") + "\ncoordinates = [[0, nan]]").find("nan|a finite number"),
            std::string::npos);
  EXPECT_NE(said(kind("normals") + "\n[[object.effect]]\n" + kind("normals")).find("twice"),
            std::string::npos);
}

TEST_F(EffectScene, RefusesEffectsThatTheirObjectsDoNotAllow) {
  const std::string textures = kMap + kRgb + kPicture +
                               "[[texture]]\nname = \"big\"\ngenerate = \"noise\"\n"
                               "size = [16, 4]\n";
  const auto refused = [&](const std::string& object, const std::string& found) {
    const std::string said = refusal(textures + object + kLight);
    EXPECT_NE(said.find(found), std::string::npos) << said;
    EXPECT_NE(said.find(".effect["), std::string::npos) << "names the effect: " << said;
  };
  const std::string shiny = effect(kind("half-vector"));
  refused(plane("rgb") + shiny, "half-vector: an RGB map");
  refused("[[object]]\nkind = \"plane\"\ncolor = \"c\"\n" + shiny, "half-vector: no map");
  refused("[[object]]\nkind = \"plane\"\ncolor = \"c\"\n" + effect(kind("light-extrapolation")),
          "light-extrapolation: no map");
  refused(plane("m") + effect(kind("specular-enhancement")) + shiny, "a second specular term");
  for (const std::string modulator :
       {"modulated-specular\"\nmap = \"m", "off-specular", "fresnel", "anisotropic"}) {
    refused(plane("m") + effect("kind = \"" + modulator + "\""), "no specular term");
  }
  refused(plane("m") + shiny + effect(kind("modulated-specular") + "\nmap = \"c\""),
          "a plain picture");
  refused(plane("m") + shiny + effect(kind("modulated-specular") + "\nmap = \"big\""), "16 x 4");
  refused(plane("m") + shiny + effect(kind("fresnel") + "\nior = 1.5\nn = [1, 1, 1]"),
          "'ior' beside");
  refused(plane("m") + shiny + effect(kind("fresnel") + "\nn = [1, 1, 1]"), "'n' without 'k'");
  refused(plane("m") + effect(kind("focus") + "\ncoordinates = [0, 0]"), "an LRGB map");
  refused(plane("rgb") + effect(kind("focus") + "\ncoordinates = [0, 0]") +
              effect(kind("time") + "\ncoordinates = [0, 0]"),
          "another effect");
  refused(plane("rgb") + effect(kind("time") + "\ncoordinates = [[0, 0], [1, 0]]"),
          "2 pairs of coordinates");
}

TEST_F(EffectScene, RefusesAGlossMapWhoseTextureSaysAnotherSamplingThanTheMaps) {
  const auto said = [&](const std::string& map, const std::string& gloss) {
    return refusal(kMap + map + "[[texture]]\nname = \"g\"\ngenerate = \"gloss\"\nsize = [8, 4]\n" +
                   gloss + plane("m") + effect(kind("half-vector")) +
                   effect(kind("modulated-specular") + "\nmap = \"g\"") + kLight);
  };
  const std::string sampling = "wrap = \"clamp\"\nfilter = \"trilinear\"\nprobes = 4\n";
  EXPECT_EQ(said(sampling, ""), "nothing");
  EXPECT_EQ(said(sampling, sampling), "nothing");
  EXPECT_EQ(said("palette = 16\n", ""), "nothing");
  const auto refused = [&](const std::string& map, const std::string& gloss,
                           const std::string& found) {
    const std::string refusal = said(map, gloss);
    EXPECT_NE(refusal.find("'g' with " + found), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("(object[0].effect[1])"), std::string::npos) << refusal;
  };
  refused("", "wrap_u = \"clamp\"\n", "another wrap_u");
  refused("", "wrap_v = \"mirror\"\n", "another wrap_v");
  refused(sampling, "filter = \"bilinear\"\n", "another filter");
  refused(sampling, "probes = 1\n", "another probes");
  refused("palette = 16\n", "palette = 16\n", "a palette");
}

TEST_F(EffectScene, RefusesPatternsAsWhatTheyCannotBe) {
  const auto said = [&](const std::string& keys) {
    return complaint("[[texture]]\nname = \"m\"\n" + keys + plane("m") + kLight);
  };
  EXPECT_EQ(said("generate = \"tide\"\nkind = \"lrgb\"\n"),
            "line 4 (texture[0].kind)|'lrgb' of tide|one of rgb");
  EXPECT_EQ(said("generate = \"tablet\"\nkind = \"picture\"\n"),
            "line 4 (texture[0].kind)|'picture' of tablet|one of lrgb");
  EXPECT_EQ(said("generate = \"focus\"\nsize = [513, 8]\n"),
            "line 4 (texture[0].size)|513|an integer from 1 to 512");
  EXPECT_EQ(said("generate = \"focus\"\nsize = [512, 8]\n"), "nothing");
}

TEST_F(EffectScene, TellsOnceHowManyTexelsHaveNoMaximum) {
  UnitScene scene = read(kMap + plane("m") + effect(kind("specular-enhancement")) +
                         effect(kind("diffuse-gain")) + kLight);
  LoadedTextures textures = load_textures(scene);
  const auto extras = prepare_effects(scene, textures);
  ASSERT_EQ(extras[0].notes.size(), 1U);
  EXPECT_NE(extras[0].notes[0].find(" of 32 texels of 'm' have no maximum"), std::string::npos);
}

TEST_F(EffectScene, LetsAnEffectBeTheColorTextureAndNotASecondOne) {
  const auto combine = [&](const std::string& keys) {
    return read(kMap + plane("m") + keys + effect(kind("normals")) + kLight).draws.at(0).combine;
  };
  EXPECT_EQ(combine(""), CombineMode::replace);
  EXPECT_EQ(combine("combine = \"modulate\"\n"), CombineMode::modulate);
  EXPECT_NE(
      complaint(kMap + kPicture + plane("m") + "color = \"c\"\n" + effect(kind("normals")) + kLight)
          .find("a colour texture beside normals"),
      std::string::npos);
}

TEST_F(EffectScene, LeavesSceneAndTexturesWithoutEffectsAlone) {
  UnitScene scene = read(kMap + plane("m") + kLight);
  LoadedTextures textures = load_textures(scene);
  const auto extras = prepare_effects(scene, textures);
  ASSERT_EQ(extras.size(), 1U);
  EXPECT_TRUE(extras[0].passes.empty());
  EXPECT_EQ(textures.size(), 1U);
  EXPECT_EQ(scene.textures.size(), 1U);
}

TEST_F(EffectScene, GivesDrawsWhoseMapChangesATextureOfTheirOwn) {
  UnitScene scene =
      read(kMap + "wrap = \"clamp\"\n" + plane("m") + plane("m") + effect(kind("diffuse-gain")) +
           plane("m") + effect(kind("normals")) + kLight);
  LoadedTextures textures = load_textures(scene);
  const std::vector<double> before = textures[0].coef;
  (void)prepare_effects(scene, textures);
  ASSERT_EQ(textures.size(), 3U);
  ASSERT_EQ(scene.textures.size(), 3U);
  EXPECT_EQ(textures[0].coef, before);
  EXPECT_EQ(scene.draws[0].map, 0);
  EXPECT_EQ(scene.draws[1].map, 1);
  EXPECT_NE(textures[1].coef, before);
  EXPECT_EQ(scene.draws[2].color, 2);
  EXPECT_EQ(scene.draws[2].map, -1) << "what nobody sees is not fetched";
  EXPECT_TRUE(textures[2].is_picture());
  EXPECT_TRUE(scene.textures[2].is_picture());
  EXPECT_EQ(scene.textures[2].wrap_u, WrapMode::clamp);
}

}  // namespace
}  // namespace ptm::golden
