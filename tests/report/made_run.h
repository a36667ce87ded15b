#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "testbench/compare/picture_difference.h"
#include "testbench/run/run_result.h"

/// Runs that no model made, for tests of the report: a lit ball on textured ground by "golden", and
/// "hardware" that errs in known places.
namespace ptm::tests {

/// The ball under the light (lu, lv): smooth shading, saturated highlights, a black ground's edge.
inline golden::ImageReal ball(int width, int height, double lu, double lv) {
  golden::ImageReal image(width, height, 3);
  const double lw = std::sqrt(std::max(0.0, 1 - lu * lu - lv * lv));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (2 * (x + 0.5) / width - 1) * 1.2, v = (1 - 2 * (y + 0.5) / height) * 1.2;
      const double rest = 1 - u * u - v * v;
      const double facing = rest > 0 ? u * lu + v * lv + std::sqrt(rest) * lw : 0.3 + 0.4 * lw;
      const double texture = 0.8 + 0.2 * std::sin(23 * u) * std::cos(19 * v + 5 * u);
      const double color[3] = {250, 205, 160};
      for (int c = 0; c < 3; ++c) {
        const double level = std::max(0.0, facing) * texture * color[c] * 1.1;
        image.at(x, y, c) = std::clamp(level, 0.0, 255.0);
      }
    }
  }
  return image;
}

/// `exact` as hardware might give it: an error that wanders within +-`spread`, then 8 bits.
inline golden::ImageReal rounded(const golden::ImageReal& exact, double spread) {
  golden::ImageReal image = exact;
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    const double wander = std::sin(12.9898 * static_cast<double>(i)) * 0.5 +
                          std::sin(0.37 * static_cast<double>(i)) * 0.5;
    image.samples[i] = testbench::level8(image.samples[i] + spread * wander * wander * wander);
  }
  return image;
}

inline std::vector<testbench::NamedValue> made_values(const std::string& model, int x, int y) {
  const bool golden = model == "golden";
  std::vector<testbench::NamedValue> values;
  for (const char* name : {"coef0", "coef1", "coef2", "coef3", "coef4", "coef5", "lu", "lv"}) {
    values.push_back({name, golden ? std::to_string(0.25 * x) : std::to_string(x)});
  }
  if (!golden) {
    for (const char* name : {"d0", "d1", "d2", "d3", "d4", "d5", "uu", "vv", "uv", "p0", "p1",
                             "p2", "p3", "p4", "p5", "t0", "t1", "t2", "t3", "t4", "t5"}) {
      values.push_back({name, std::to_string(-17 * x + y)});
    }
    values.push_back({"acc", std::to_string(model == "rtl" && x == 7 ? 1 : 2)});
  }
  values.push_back({"lum", golden ? "137.4421" : "137"});
  return values;
}

/// Four models; reference, pipeline and RTL agree.
inline testbench::RunResult made_run(int width, int height, std::size_t lights) {
  testbench::RunResult run;
  run.scene_file = "scenes/ball.toml";
  run.map_file = "ball.ptm";
  run.map_format = "PTM_FORMAT_LRGB";
  run.preset = "base";
  run.made_by = {{"0.1.0",
                  "0123456789abcdef0123456789abcdef01234567",
                  false,
                  {"build/release/ptmsim", "run", "scenes/a ball's.toml", "--out", "out"}},
                 "2026-01-31T23:59:59Z",
                 "GNU 12.2.0",
                 "Verilator 5.006",
                 "2.3.4-Accellera",
                 "A Processor",
                 "Debian GNU/Linux 12 (bookworm)",
                 "Linux 6.1.0 x86_64",
                 2};
  run.width = width;
  run.height = height;
  run.models = {{"golden", {}, 0.0412, {}, {}},
                {"reference", {}, 0.00731, {}, {}},
                {"pipeline", {}, 1.318, {}, {}},
                {"rtl", {}, 0.0873, {}, {}}};
  run.presets = {{"paper8", {}}, {"base", {}}, {"wide", {}}};
  for (std::size_t i = 0; i < lights; ++i) {
    const double angle = 2.4 * static_cast<double>(i);
    run.lights.push_back({-0.6 * std::cos(angle), 0.6 * std::sin(angle), 0});
    const golden::ImageReal exact = ball(width, height, run.lights[i].x, run.lights[i].y);
    run.models[0].frames.push_back(exact);
    for (std::size_t m = 1; m < 4; ++m) run.models[m].frames.push_back(rounded(exact, 1.3));
    run.presets[0].frames.push_back(rounded(exact, 9));
    run.presets[1].frames.push_back(rounded(exact, 1.3));
    run.presets[2].frames.push_back(rounded(exact, 0.05));
  }
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(width) * static_cast<unsigned>(height) * lights;
  run.models[2].cycles = run.models[3].cycles = pixels + 11;
  for (std::size_t m = 2; m < 4; ++m) {
    run.models[m].counters = {{"pixels", pixels}, {"stall_cycles", 0}, {"lum_saturated", 4211}};
  }
  run.models[2].counters.push_back({"tmu_words", 3 * pixels});
  run.probe = [](const std::string& model, int, int x, int y) { return made_values(model, x, y); };
  return run;
}

/// The same with an RTL that is wrong in three samples of the last frame and in one counter.
inline testbench::RunResult made_faulty_run(int width, int height, std::size_t lights) {
  testbench::RunResult run = made_run(width, height, lights);
  golden::ImageReal& picture = run.models[3].frames.back();
  for (int i = 0; i < 3; ++i) {
    double& sample = picture.at(7 % width, i % height, i);
    sample += sample < 128 ? 1 + i : -1 - i;
  }
  run.models[3].counters[1].value = 5;
  run.notes = {"2 coefficients of the map saturate at base's 9 bits."};
  return run;
}

}  // namespace ptm::tests
