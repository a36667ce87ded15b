// The options of `ptmsim fit`, run as a user runs them on photographs of a made-up relief.
#include <cmath>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "golden/render/light_map.h"
#include "testbench/program/fit_job.h"
#include "tests/run_program.h"

namespace ptm::testbench {
namespace {

using nlohmann::json;
using tests::Outcome;
using tests::quoted;

class FitOptions : public tests::Program {
 protected:
  /// Twenty photographs of 48 x 48 pixels.
  void SetUp() override {
    ASSERT_EQ(run("synthesize --size 48 --lights 20 --out " + quoted(file("c"))).code, 0);
  }
  [[nodiscard]] std::string capture() const { return quoted(file("c/capture.lp")); }
  [[nodiscard]] json fit(const std::string& arguments, const std::string& map = "m.ptm") const {
    const Outcome outcome = run("fit " + arguments + " --json --out " + quoted(file(map)));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? json::parse(outcome.out) : json();
  }
  void grey(const std::string& name, std::uint8_t level) const {
    golden::Image8 image(4, 3, 1);
    for (auto& sample : image.samples) sample = level;
    std::filesystem::create_directories(file(name).parent_path());
    golden::write_picture(file(name), image);
  }
};

TEST_F(FitOptions, BandsOfAnySizeGiveTheSameMapAndTheSameFigures) {
  const json whole = fit(capture() + " --residual " + quoted(file("whole.png")), "whole.ptm");
  EXPECT_EQ(whole.at("bands"), 1);
  // 48 x 48 texels of 20 photographs are 0.6 MiB of samples: more photographs for more bands.
  ASSERT_EQ(run("synthesize --size 192 --lights 30 --out " + quoted(file("big"))).code, 0);
  const std::string big = quoted(file("big/capture.lp"));
  for (const char* format : {"lrgb", "rgb", "lum"}) {
    const std::string arguments = big + " --format " + format;
    json one = fit(arguments + " --residual " + quoted(file("1.png")), "one.ptm");
    json many = fit(arguments + " --memory 1 --residual " + quoted(file("2.png")), "many.ptm");
    EXPECT_GT(many.at("bands"), 10);
    EXPECT_EQ(tests::text_of(file("one.ptm")), tests::text_of(file("many.ptm"))) << format;
    EXPECT_EQ(tests::text_of(file("1.png")), tests::text_of(file("2.png"))) << format;
    EXPECT_NEAR(one.at("real_fit").at("rmse"), many.at("real_fit").at("rmse"), 1e-9);
    EXPECT_NEAR(one.at("leave_one_out_rmse"), many.at("leave_one_out_rmse"), 1e-9);
    EXPECT_EQ(one.at("saturated"), many.at("saturated"));
    EXPECT_EQ(one.at("saturated_samples"), many.at("saturated_samples"));
  }
}

TEST_F(FitOptions, TakesTheLightsOfAListForThePicturesOfAnotherFolder) {
  (void)fit(capture(), "listed.ptm");
  // The same photographs under names that a camera gives, and what else lies in such folders.
  std::filesystem::create_directories(file("new"));
  std::istringstream list(tests::text_of(file("c/capture.lp")));
  std::string line;
  std::getline(list, line);
  for (int n = 9; std::getline(list, line) && !line.empty(); ++n) {
    std::filesystem::copy_file(file("c/" + line.substr(0, line.find(' '))),
                               file("new/IMG_" + std::to_string(n) + ".png"));
  }
  write("new/capture.txt", "no picture");
  const json found = fit(capture() + " --pictures " + quoted(file("new")));
  EXPECT_EQ(found.at("photographs"), 20);
  EXPECT_EQ(found.at("lights").at(19).at("picture"), "IMG_28.png");
  EXPECT_TRUE(found.at("notes").empty()) << found.at("notes");
  EXPECT_EQ(tests::text_of(file("m.ptm")), tests::text_of(file("listed.ptm")));
  std::filesystem::remove(file("new/IMG_20.png"));
  expect_refused(
      "fit " + capture() + " --pictures " + quoted(file("new")) + " --out " + quoted(file("n.ptm")),
      "found 19 pictures, expected 20, one for each light of capture.lp");
}

TEST_F(FitOptions, LeavesOutMissingPhotographsIfAskedTo) {
  const json all = fit(capture());
  const std::string gone = all.at("lights").at(4).at("picture");
  std::filesystem::remove(file("c/" + gone));
  expect_refused("fit " + capture() + " --out " + quoted(file("n.ptm")), "--skip-missing");
  const json rest = fit(capture() + " --skip-missing");
  EXPECT_EQ(rest.at("photographs"), 19);
  EXPECT_EQ(rest.at("lights").at(4).at("picture"), all.at("lights").at(5).at("picture"));
  ASSERT_EQ(rest.at("notes").size(), 1U);
  EXPECT_EQ(rest.at("notes").at(0),
            "1 of 20 lights are left out, as their photographs are missing: " + gone);
}

TEST_F(FitOptions, NamesThePhotographThatContradictsTheOthers) {
  const json good = fit(capture() + " --hold-out 5");
  EXPECT_TRUE(good.at("notes").empty()) << good.at("notes");
  const auto overexpose = [&](const std::string& name) {
    golden::Image8 picture(48, 48, 3);
    const golden::ImageReal dark = golden::read_picture(file("c/" + name));
    for (std::size_t n = 0; n < picture.samples.size(); ++n) {
      picture.samples[n] = static_cast<std::uint8_t>(std::min(255.0, 60 + 3 * dark.samples[n]));
    }
    golden::write_picture(file("c/" + name), picture);
  };
  const std::string fitted = good.at("lights").at(6).at("picture");
  const std::string held = good.at("held_out").at("lights").at(2).at("picture");
  overexpose(fitted);
  overexpose(held);
  for (const char* more : {"", " --robust 3", " --format rgb", " --format lum"}) {
    const json out = fit(capture() + " --hold-out 5" + more);
    for (const json& light : out.at("lights")) {
      EXPECT_EQ(light.at("contradicts"), light.at("picture") == fitted) << more << light;
    }
    for (const json& light : out.at("held_out").at("lights")) {
      EXPECT_EQ(light.at("contradicts"), light.at("picture") == held) << more << light;
    }
    const std::string notes = out.at("notes").dump();
    EXPECT_NE(notes.find("1 of 16 photographs contradict the others"), std::string::npos) << notes;
    EXPECT_NE(notes.find("1 held-out of 4 photographs"), std::string::npos) << notes;
    EXPECT_NE(notes.find(fitted), std::string::npos) << notes;
    EXPECT_NE(notes.find(held), std::string::npos) << notes;
  }
}

TEST_F(FitOptions, NamesTwoPhotographsThatAreExchanged) {
  const json good = fit(capture());
  const std::string a = good.at("lights").at(8).at("picture"),
                    b = good.at("lights").at(9).at("picture");
  std::filesystem::rename(file("c/" + a), file("c/x.png"));
  std::filesystem::rename(file("c/" + b), file("c/" + a));
  std::filesystem::rename(file("c/x.png"), file("c/" + b));
  const json out = fit(capture());
  EXPECT_NE(out.at("notes").dump().find("2 of 20 photographs contradict"), std::string::npos)
      << out.at("notes");
}

TEST_F(FitOptions, SaysWhichDirectionsTheLightsLeaveToExtrapolation) {
  EXPECT_LT(fit(capture()).at("extrapolated"), 0.3);
  // The list without the lights from the left.
  std::istringstream list(tests::text_of(file("c/capture.lp")));
  std::string line, right;
  std::getline(list, line);
  while (std::getline(list, line)) {
    double u = 0;
    std::string name;
    if (std::istringstream(line) >> name >> u && u > -0.1) right += line + "\n";
  }
  const json out = fit(quoted(write("c/right.lp", right)));
  EXPECT_GT(out.at("extrapolated"), 0.3);
  const std::string notes = out.at("notes").dump();
  EXPECT_NE(notes.find("from the left below 90 degrees"), std::string::npos) << notes;
  EXPECT_EQ(notes.find("from the right below 90"), std::string::npos) << notes;
}

/// A lumpy Lambertian surface 100 mm wide under lamps 130 mm away, rendered from its equations.
class FitNearLights : public tests::Program {
 protected:
  static constexpr int kSide = 40;
  using Vector = std::array<double, 3>;

  static Vector normal_at(int x, int y) {
    const double across = 0.5 * std::sin(0.35 * x), up = 0.5 * std::cos(0.29 * y);
    const double length = std::sqrt(across * across + up * up + 1);
    return {across / length, up / length, 1 / length};
  }

  /// Photographs and lists of near lamps, and of lamps far away in the same directions.
  void SetUp() override {
    std::ostringstream near, far;
    near << std::setprecision(12);
    far << std::setprecision(12);
    for (int i = 0; i < 36; ++i) {
      const double elevation = (25 + 20 * (i % 3)) * std::numbers::pi / 180;
      const double angle = 2 * std::numbers::pi * i / 36, radius = 130 + 4 * (i % 4);
      const Vector unit{std::cos(elevation) * std::cos(angle),
                        std::cos(elevation) * std::sin(angle), std::sin(elevation)};
      const std::string name = std::to_string(i) + ".png";
      photograph("near" + name, unit, radius);
      photograph("far" + name, unit, 1e9);
      near << "near" << name;
      far << "far" << name;
      for (const double c : unit) near << ' ' << radius * c;
      for (const double c : unit) far << ' ' << c;
      near << '\n';
      far << '\n';
    }
    write("near.lp", near.str());
    write("far.lp", far.str());
  }

  void photograph(const std::string& name, const Vector& unit, double radius) const {
    golden::Image8 image(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const double pixel = 100.0 / kSide;
        const double px = (x + 0.5 - kSide / 2) * pixel, py = (kSide / 2 - y - 0.5) * pixel;
        const Vector to{radius * unit[0] - px, radius * unit[1] - py, radius * unit[2]};
        const double square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
        const Vector n = normal_at(x, y);
        const double dot = (n[0] * to[0] + n[1] * to[1] + n[2] * to[2]) / std::sqrt(square);
        const double level = 90 * std::max(0.0, dot) * radius * radius / square;
        for (int c = 0; c < 3; ++c) {
          image.at(x, y, c) = static_cast<std::uint8_t>(std::min(255L, std::lround(level)));
        }
      }
    }
    golden::write_picture(file(name), image);
  }

  [[nodiscard]] json fit(const std::string& arguments, const std::string& map) const {
    const Outcome outcome = run("fit " + arguments + " --json --out " + quoted(file(map)));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? json::parse(outcome.out) : json();
  }
  /// RMS distance of two maps' pictures over some lights, in levels.
  [[nodiscard]] double distance(const std::string& a, const std::string& b) const {
    const golden::PtmMap one = golden::read_ptm(file(a)).map, two = golden::read_ptm(file(b)).map;
    double squares = 0, count = 0;
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {0.6, 0.1}, {-0.4, 0.5}, {0.1, -0.7}}) {
      const golden::ImageReal p = golden::light_map(one, u, v), q = golden::light_map(two, u, v);
      for (std::size_t n = 0; n < p.samples.size(); ++n) {
        squares += (p.samples[n] - q.samples[n]) * (p.samples[n] - q.samples[n]);
        count += 1;
      }
    }
    return std::sqrt(squares / count);
  }
};

TEST_F(FitNearLights, GivesTheMapThatFarLightsOfTheSameDirectionsGive) {
  (void)fit(quoted(file("far.lp")), "wanted.ptm");
  const json near = fit(quoted(file("near.lp")) + " --width-mm 100", "near.ptm");
  const json plain = fit(quoted(file("near.lp")), "plain.ptm");
  // The polynomial's own misfit depends on the light vectors; what is left is that and rounding.
  EXPECT_LT(distance("near.ptm", "wanted.ptm"), distance("plain.ptm", "wanted.ptm") / 4);
  EXPECT_LT(near.at("real_fit").at("rmse"), plain.at("real_fit").at("rmse").get<double>() / 2);
  EXPECT_EQ(near.at("width_mm"), 100);
  EXPECT_NE(plain.at("notes").dump().find("they are taken as directions"), std::string::npos);
  EXPECT_EQ(near.at("notes").dump().find("taken as directions"), std::string::npos);
  EXPECT_NE(near.at("notes").dump().find("--linear"), std::string::npos);
}

TEST_F(FitNearLights, AreNearForTheJudgeTooAndInEveryBandAndRegion) {
  const std::string near = quoted(file("near.lp")) + " --width-mm 100 --format rgb";
  const json whole = fit(near, "whole.ptm");
  const json held = fit(near + " --hold-out 5", "held.ptm");
  const json tested = fit(near + " --test " + quoted(file("near.lp")), "tested.ptm");
  EXPECT_EQ(tested.at("held_out").at("real_fit"), tested.at("real_fit"));
  const json far = fit(quoted(file("near.lp")) + " --format rgb --hold-out 5", "far.ptm");
  EXPECT_LT(held.at("held_out").at("real_fit").at("rmse"),
            far.at("held_out").at("real_fit").at("rmse").get<double>() / 2);
  EXPECT_LT(held.at("leave_one_out_rmse"), far.at("leave_one_out_rmse").get<double>() / 2);
  // A part is lit as it lies in the whole.
  const json part = fit(near + " --region 24,2,12,30 --quantizer plain", "part.ptm");
  (void)fit(near + " --quantizer plain", "plain.ptm");
  const golden::ImageReal one = golden::light_map(golden::read_ptm(file("part.ptm")).map, 0.3, 0.2);
  const golden::ImageReal all =
      golden::light_map(golden::read_ptm(file("plain.ptm")).map, 0.3, 0.2);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 12; ++x) ASSERT_NEAR(one.at(x, y), all.at(x + 24, y + 2), 4);
  }
  // Lists of directions, and lamps that stand in the picture.
  expect_refused("fit " + quoted(file("far.lp")) + " --width-mm 100 --out " + quoted(file("n.ptm")),
                 "found unit vectors, which are directions");
  write("in.lp", "near0.png 20 10 0\nnear1.png 0 0 100\n");
  expect_refused("fit " + quoted(file("in.lp")) + " --width-mm 100 --out " + quoted(file("n.ptm")),
                 "line 1: found a light within the picture");
  EXPECT_EQ(run("fit " + near + " --width-mm -3 --out " + quoted(file("n.ptm"))).code, 2);
}

TEST_F(FitNearLights, AreWhereTheyAreInBandsOfFewRows) {
  FitJob job;
  job.capture.source = file("near.lp");
  job.capture.width_mm = 100;
  job.config = reference::kBase;
  job.out = file("whole.ptm");
  const FitOutcome whole = run_fit(job);
  job.out = file("rows.ptm");
  job.memory = 50000;
  const FitOutcome rows = run_fit(job);
  EXPECT_EQ(whole.bands, 1);
  EXPECT_GT(rows.bands, 5);
  EXPECT_TRUE(golden::read_ptm(file("rows.ptm")).map == golden::read_ptm(file("whole.ptm")).map);
  EXPECT_NEAR(rows.training.real.rmse, whole.training.real.rmse, 1e-9);
  EXPECT_NEAR(*rows.leave_one_out_rmse, *whole.leave_one_out_rmse, 1e-9);
  EXPECT_EQ(rows.training.contradicts, whole.training.contradicts);
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_NEAR(*rows.training.figures[i], *whole.training.figures[i], 1e-9);
  }
}

TEST_F(FitNearLights, NamesAContradictingPhotograph) {
  golden::write_picture(file("near14.png"), golden::Image8(kSide, kSide, 3));  // black
  const json out = fit(quoted(file("near.lp")) + " --width-mm 100", "m.ptm");
  for (const json& light : out.at("lights")) {
    EXPECT_EQ(light.at("contradicts"), light.at("picture") == "near14.png") << light;
  }
}

TEST_F(FitOptions, EveryFormatWritesItsKindOfMapAndRgbFitsBest) {
  std::map<std::string, double> psnr;
  for (const auto& [format, kind] : {std::pair{"lrgb", golden::MapKind::lrgb},
                                     {"rgb", golden::MapKind::rgb},
                                     {"lum", golden::MapKind::lum}}) {
    const json out = fit(capture() + " --format " + format);
    psnr[format] = out.at("stored_fit").at("psnr_db");
    EXPECT_EQ(golden::read_ptm(file("m.ptm")).map.kind, kind);
    EXPECT_NEAR(out.at("real_fit").at("psnr_db"), psnr[format], 0.1) << format;
  }
  EXPECT_GE(psnr["rgb"], psnr["lrgb"]);
  EXPECT_GE(psnr["rgb"], psnr["lum"]);
}

TEST_F(FitOptions, HoldOutKeepsEveryNthPhotographForJudging) {
  const json out = fit(capture() + " --hold-out 5");
  EXPECT_EQ(out.at("photographs"), 16);
  ASSERT_EQ(out.at("held_out").at("lights").size(), 4U);
  const json all = fit(capture());
  EXPECT_FALSE(all.contains("held_out"));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(out.at("held_out").at("lights")[i].at("picture"),
              all.at("lights")[i * 5 + 4].at("picture"));
  }
  EXPECT_GT(out.at("held_out").at("stored_fit").at("rmse"), out.at("stored_fit").at("rmse"));
}

TEST_F(FitOptions, TestJudgesByASecondListOfLights) {
  const json out = fit(capture() + " --test " + capture());
  EXPECT_EQ(out.at("held_out").at("stored_fit"), out.at("stored_fit"));
  grey("small.png", 9);
  write("small.lp", "small.png 0 0 1\n");
  expect_refused("fit " + capture() + " --test " + quoted(file("small.lp")) + " --out " +
                     quoted(file("n.ptm")),
                 "4 x 3 pixels, expected 48 x 48");
}

TEST_F(FitOptions, RegionFitsAPartAsTheWholeFitsIt) {
  const json whole = fit(capture(), "whole.ptm");
  const json part = fit(capture() + " --region 8,4,20,10 --quantizer plain", "part.ptm");
  EXPECT_EQ(part.at("width"), 20);
  EXPECT_EQ(part.at("height"), 10);
  const golden::PtmMap a = golden::read_ptm(file("whole.ptm")).map;
  const golden::PtmMap b = golden::read_ptm(file("part.ptm")).map;
  for (std::size_t y = 0; y < 10; ++y) {
    for (std::size_t n = 0; n < 60; ++n) {
      ASSERT_EQ(b.color[y * 60 + n], a.color[((y + 4) * 48 + 8) * 3 + n]);
    }
  }
  for (const char* bad : {"1,2,3", "1,2,3,4,5", "a,b,c,d", "1,2,3,4x"}) {
    EXPECT_EQ(run("fit " + capture() + " --out x.ptm --region " + bad).code, 2) << bad;
  }
  expect_refused("fit " + capture() + " --region 40,0,9,9 --out " + quoted(file("n.ptm")),
                 "within 48 x 48 pixels");
}

TEST_F(FitOptions, TableAndResidualAreFilesOfWhatIsPrinted) {
  const json out = fit(capture() + " --table " + quoted(file("t.json")) + " --residual " +
                       quoted(file("r.png")));
  const json table = json::parse(tests::text_of(file("t.json")));
  EXPECT_EQ(table, out);
  EXPECT_EQ(table.at("lights").size(), 20U);
  for (const char* key : {"rmse", "psnr_db", "channel_rmse", "channel_psnr_db", "light", "picture",
                          "leave_one_out_rmse"}) {
    EXPECT_TRUE(table.at("lights")[7].contains(key)) << key;
  }
  // Grey levels are four times the RMS residual of a texel: its mean square is that of the table.
  const golden::ImageReal picture = golden::read_picture(file("r.png"));
  ASSERT_EQ(picture.width, 48);
  double squares = 0;
  for (const double level : picture.samples) squares += level * level / 16;
  const double rmse = std::sqrt(squares / double(picture.samples.size()));
  EXPECT_NEAR(rmse, out.at("stored_fit").at("rmse"), 0.125);  // half a grey level
}

TEST_F(FitOptions, UnivariateMapsFollowTheirOneParameter) {
  std::ostringstream table;
  for (int i = 0; i < 6; ++i) {
    std::string name("focus/p");
    name.append(1, static_cast<char>('0' + i)).append(".png");
    grey(name, static_cast<std::uint8_t>(20 + 8 * i * i));
    table << i * 60 << '\n';
  }
  const auto seconds = write("seconds.txt", table.str());
  const json out =
      fit(quoted(file("focus")) + " --univariate --format rgb --lights " + quoted(seconds));
  EXPECT_EQ(out.at("rank"), 3);
  ASSERT_EQ(out.at("notes").size(), 1U) << out.at("notes");
  EXPECT_NE(out.at("notes")[0].get<std::string>().find("moved to -1..1"), std::string::npos);
  EXPECT_LT(out.at("real_fit").at("rmse"), 1e-3);
  EXPECT_LT(out.at("stored_fit").at("rmse"), 1);
  EXPECT_EQ(run("fit " + capture() + " --univariate --out x.ptm").code, 2);
}

TEST_F(FitOptions, LinearAndRobustFitsDifferFromThePlainOne) {
  const json plain = fit(capture(), "plain.ptm"), linear = fit(capture() + " --linear", "lin.ptm"),
             robust = fit(capture() + " --robust 4", "robust.ptm");
  EXPECT_EQ(linear.at("linear"), true);
  EXPECT_NE(tests::text_of(file("plain.ptm")), tests::text_of(file("lin.ptm")));
  EXPECT_NE(tests::text_of(file("plain.ptm")), tests::text_of(file("robust.ptm")));
  EXPECT_TRUE(robust.at("leave_one_out_rmse").is_null());
  EXPECT_GT(robust.at("real_fit").at("rmse"), plain.at("real_fit").at("rmse"));
}

TEST_F(FitOptions, SaysWhenLightsAreIllConditionedOrLieOnARing) {
  std::ostringstream ring, nearly;
  for (int i = 0; i < 8; ++i) {
    std::string name(1, static_cast<char>('a' + i));
    name.append(".png");
    grey(name, static_cast<std::uint8_t>(90 + i));
    const double angle = 0.8 * i;
    const auto light = [&](double radius) {
      std::ostringstream line;
      line << std::setprecision(9) << name << ' ' << radius * std::cos(angle) << ' '
           << radius * std::sin(angle) << ' ' << std::sqrt(1 - radius * radius) << '\n';
      return line.str();
    };
    ring << light(0.6);
    nearly << light(i == 0 ? 0.6002 : 0.6);
  }
  const json flat = fit(quoted(write("ring.lp", ring.str())));
  EXPECT_EQ(flat.at("rank"), 5);
  EXPECT_NE(flat.at("notes")[0].get<std::string>().find("5 of 6 coefficients"), std::string::npos);
  EXPECT_NE(flat.at("notes")[0].get<std::string>().find("condition number"), std::string::npos);
  const json ill = fit(quoted(write("nearly.lp", nearly.str())));
  EXPECT_EQ(ill.at("rank"), 6);
  EXPECT_NE(ill.at("notes")[0].get<std::string>().find("ill-conditioned"), std::string::npos);
}

TEST_F(FitOptions, RefusesOnePhotographAndTablesThatDoNotFit) {
  grey("one.png", 50);
  write("one.lp", "one.png 0 0 1\n");
  const std::string out = " --out " + quoted(file("n.ptm"));
  expect_refused("fit " + quoted(file("one.lp")) + out, "found 1 to fit, expected two or more");
  expect_refused("fit " + quoted(file("c")) + out, "--lights TABLE");
  write("table.txt", "0 0 1\n0 0 nan\n");
  const std::string table = " --lights " + quoted(file("table.txt"));
  expect_refused("fit " + quoted(file("c")) + table + out, "line 2: found \"nan\"");
  write("table.txt", "0 0 1\n0 0.6 0.8\n");
  expect_refused("fit " + quoted(file("c")) + table + out, "20 pictures, expected 2");
}

TEST_F(FitOptions, CountsSaturatedSamplesAndBlackTexels) {
  grey("white.png", 255);
  grey("black.png", 0);
  write("w.lp", "white.png 0 0 1\nblack.png 0.6 0 0.8\n");
  write("b.lp", "black.png 0 0 1\nblack.png 0.6 0 0.8\n");
  EXPECT_EQ(fit(quoted(file("w.lp"))).at("saturated_samples"), 36);
  const json black = fit(quoted(file("b.lp")) + " --share-pictures");
  EXPECT_EQ(black.at("black_texels"), 12);
  EXPECT_EQ(black.at("stored_fit").at("rmse"), 0);
  for (const double scale : black.at("scale")) EXPECT_TRUE(std::isfinite(scale) && scale > 0);
  const json hp = fit(quoted(file("b.lp")) + " --share-pictures --quantizer hp");
  EXPECT_EQ(hp.at("stored_fit").at("rmse"), 0);
}

TEST_F(FitOptions, EndsWithCode2OnWrongUsage) {
  EXPECT_EQ(run("fit " + capture() + " --out x.ptm --memory 0").code, 2);
  EXPECT_EQ(run("fit " + capture() + " --out x.ptm --hold-out 1").code, 2);
  EXPECT_EQ(run("fit " + capture() + " --out x.ptm --hold-out 3 --test y.lp").code, 2);
}

}  // namespace
}  // namespace ptm::testbench
