// ptmsim fit: photographs under known lights become a map that the hardware holds as it stands.
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "golden/files/ptm_file.h"
#include "golden/fit/fit_report.h"
#include "testbench/program/commands.h"
#include "testbench/run/stored_texture.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct FitOptions {
  std::string capture, out;
  std::string format = "lrgb", preset = "base", method = "nearest_plane";
  bool json = false;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Json describe(const golden::Residual& residual) {
  return {{"rmse", residual.rmse},
          {"psnr_db", residual.psnr_db},
          {"channel_rmse", residual.channel_rmse}};
}

Json describe_lights(const golden::Capture& capture, const golden::FitReport& report) {
  Json lights = Json::array();
  for (std::size_t i = 0; i < capture.names.size(); ++i) {
    lights.push_back({{"picture", capture.names[i]},
                      {"light", capture.directions[i]},
                      {"rmse", report.lights[i].rmse},
                      {"psnr_db", report.lights[i].psnr_db}});
  }
  return lights;
}

void describe_solver(const golden::LightSolver& solver, std::size_t lights, Json& out) {
  out["rank"] = solver.rank;
  out["condition"] = solver.condition;
  out["singular_values"] = std::vector<double>(
      solver.singular_values.data(), solver.singular_values.data() + solver.singular_values.size());
  if (solver.rank < 6) {
    out["notes"].push_back("the " + std::to_string(lights) + " lights determine " +
                           std::to_string(solver.rank) +
                           " of 6 coefficients; the smallest polynomials that fit were taken");
  }
}

void describe_stored(const quantize::StoredMap& stored, const FitOptions& options, Json& out) {
  out["preset"] = options.preset;
  out["method"] = options.method;
  out["shift"] = stored.shift;
  out["bias"] = stored.bias;
  out["saturated"] = stored.saturated;
  out["quantization_rms"] = stored.rms_error;
}

/// Reads, fits, stores, judges and writes; what there is to say about it.
Json fit(const FitOptions& options) {
  Json out;
  auto start = Clock::now();
  const golden::Capture capture = golden::read_capture(options.capture);
  const double read_seconds = seconds_since(start);
  out["capture"] = options.capture;
  out["map"] = options.out;
  out["format"] = options.format;
  out["width"] = capture.width;
  out["height"] = capture.height;
  out["photographs"] = capture.photographs.size();
  out["notes"] = capture.notes;

  start = Clock::now();
  const golden::LightSolver solver = golden::solve_lights(capture.directions);
  const golden::LrgbFit real = golden::fit_lrgb(capture, solver);
  const double fit_seconds = seconds_since(start);
  describe_solver(solver, capture.photographs.size(), out);

  start = Clock::now();
  const quantize::Method method =
      options.method == "plain" ? quantize::Method::plain : quantize::Method::nearest_plane;
  const quantize::StoredMap stored = quantize::quantize(
      {.width = real.width, .height = real.height, .polynomials = 1, .coef = real.coef},
      reference::find_preset(options.preset).config, method, quantize::hemisphere_gram());
  const double quantize_seconds = seconds_since(start);
  describe_stored(stored, options, out);

  const golden::FitReport report =
      golden::compare_lrgb(capture, quantize::dequantize(stored), real.color);
  out["real_fit"] = describe(golden::compare_lrgb(capture, real.coef, real.color).all);
  out["stored_fit"] = describe(report.all);
  out["lights"] = describe_lights(capture, report);
  out["seconds"] = {{"read", read_seconds}, {"fit", fit_seconds}, {"quantize", quantize_seconds}};
  const auto notes =
      golden::write_ptm(options.out, to_ptm(stored, golden::MapKind::lrgb, real.color));
  for (const std::string& note : notes) out["notes"].push_back(note);
  return out;
}

void print_text(const Json& out) {
  for (const auto& note : out["notes"]) std::cout << "note: " << note.get<std::string>() << '\n';
  std::cout << out["photographs"] << " photographs of " << out["width"] << " x " << out["height"]
            << " pixels, rank " << out["rank"] << ", condition " << out["condition"] << '\n';
  const auto residual = [&](const char* title, const Json& r) {
    std::cout << title << r["rmse"] << " levels RMSE, " << r["psnr_db"] << " dB\n";
  };
  residual("against the photographs, real-valued: ", out["real_fit"]);
  residual("against the photographs, as stored:   ", out["stored_fit"]);
  std::cout << "stored by " << out["method"].get<std::string>() << " for "
            << out["preset"].get<std::string>() << ": shift " << out["shift"].dump() << ", bias "
            << out["bias"].dump() << ", saturated " << out["saturated"].dump() << ", "
            << out["quantization_rms"] << " levels RMS\n"
            << "map: " << out["map"].get<std::string>() << '\n';
}

}  // namespace

void add_fit_command(CLI::App& app) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Photographs under known lights to a map");
  command->add_option("CAPTURE", options->capture, "light positions (.lp) beside photographs")
      ->required();
  command->add_option("--out", options->out, "the map to write (.ptm)")->required();
  command->add_option("--format", options->format, "kind of map")
      ->check(CLI::IsMember({"lrgb"}))
      ->capture_default_str();
  std::vector<std::string> presets;
  for (const reference::Preset& preset : reference::kPresets) presets.emplace_back(preset.name);
  command->add_option("--preset", options->preset, "hardware that is to hold the map")
      ->check(CLI::IsMember(presets))
      ->capture_default_str();
  command->add_option("--method", options->method, "how coefficients are rounded")
      ->check(CLI::IsMember({"nearest_plane", "plain"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] {
    const Json out = fit(*options);
    if (options->json) {
      std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    } else {
      print_text(out);
    }
  });
}

}  // namespace ptm::testbench
