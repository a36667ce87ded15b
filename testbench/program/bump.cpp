// ptmsim bump: a height field or a normal map becomes a map of diffuse light.
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "golden/bump/normal_map.h"
#include "golden/files/figure_text.h"
#include "golden/files/picture_file.h"
#include "golden/files/picture_header.h"
#include "golden/files/ptm_file.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/expected_file.h"
#include "testbench/program/figures.h"
#include "testbench/run/hardware_map.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

/// 8192 x 8192.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

struct BumpOptions {
  std::string input, out;
  bool height = false, normals = false, green_down = false, json = false;
  std::optional<double> strength;
  std::string domain = "hemisphere";
  ConfigOptions config;
};

const std::map<std::string, golden::BumpDomain> domains{
    {"hemisphere", golden::BumpDomain::hemisphere},
    {"disc", golden::BumpDomain::disc},
    {"square", golden::BumpDomain::square}};

golden::NormalField read_field(const BumpOptions& options) {
  if (options.strength && !std::isfinite(*options.strength)) {
    throw ExitError(ExitCode::usage, "--strength: expected a finite number");
  }
  expect_map_name(options.out);
  expect_file(options.input, golden::FileType::picture);
  const golden::PictureHeader header = golden::read_picture_header(options.input);
  if (std::int64_t{header.width} * header.height > kMostPixels) {
    throw golden::InputError(options.input, "size",
                             std::to_string(header.width) + " x " + std::to_string(header.height),
                             "at most " + std::to_string(kMostPixels) +
                                 " pixels, for each of which some 100 bytes are held");
  }
  const golden::ImageReal picture = golden::read_picture(options.input);
  if (options.normals) {
    return golden::read_normal_map(
        picture, {.strength = options.strength.value_or(1), .green_down = options.green_down},
        options.input);
  }
  return golden::normals_from_heights(picture, options.strength.value_or(16));
}

Json describe(const golden::BumpError& error) {
  return {{"rmse", error.rmse}, {"max", error.max}, {"by_elevation", error.by_elevation}};
}

Json bump(const BumpOptions& options) {
  const reference::EvalConfig config = file_config_of(options.config);
  const golden::NormalField field = read_field(options);
  const std::vector<double> coef =
      golden::bump_coefficients(field, golden::NormalTable(domains.at(options.domain)));
  const quantize::StoredMap stored = quantize::quantize(
      {.width = field.width, .height = field.height, .polynomials = 1, .coef = coef}, config,
      quantize::Method::nearest_plane, quantize::hemisphere_gram());
  std::vector<std::uint8_t> white(field.normals.size() * 3, 255);
  auto notes = field.notes;
  const auto written =
      golden::write_ptm(options.out, to_ptm(stored, golden::MapKind::lrgb, std::move(white)));
  notes.insert(notes.end(), written.begin(), written.end());
  return {{"map", options.out},
          {"width", field.width},
          {"height", field.height},
          {"from", options.normals ? "normals" : "height"},
          {"domain", options.domain},
          {"preset", name_of(config)},
          {"real", describe(golden::measure_bump(field, coef))},
          {"stored", describe(golden::measure_bump(field, quantize::dequantize(stored)))},
          {"quantization_rms", stored.rms_error},
          {"notes", notes}};
}

void print_text(const Json& out) {
  std::cout << out["map"].get<std::string>() << ": " << out["width"] << " x " << out["height"]
            << ", from " << out["from"].get<std::string>() << ", fitted over the "
            << out["domain"].get<std::string>() << '\n';
  for (const char* which : {"real", "stored"}) {
    std::cout << "against max(0, N.L) over the hemisphere, " << which << ": "
              << golden::count_of(figure(out[which]["rmse"]), "level") << " RMS, max "
              << figure(out[which]["max"]) << '\n';
  }
  std::cout << "RMS by elevation of the light, ten degrees each from the horizon up:";
  for (const Json& band : out["stored"]["by_elevation"]) std::cout << ' ' << figure(band);
  std::cout << '\n';
  for (const Json& note : out["notes"]) std::cout << "note: " << note.get<std::string>() << '\n';
}

}  // namespace

void add_bump_command(CLI::App& app) {
  const auto options = std::make_shared<BumpOptions>();
  CLI::App* command = app.add_subcommand("bump", "A height field or normal map to a map");
  command->add_option("IN", options->input, "the picture")->required();
  command->add_option("--out", options->out, "the map to write (.ptm)")->required();
  auto* height = command->add_flag("--height", options->height, "IN holds heights (the default)");
  auto* normals = command->add_flag("--normals", options->normals, "IN holds normals, green up");
  normals->excludes(height);
  command
      ->add_flag("--green-down", options->green_down,
                 "the normals' green runs down the picture, as DirectX has it")
      ->needs(normals);
  command
      ->add_option("--strength", options->strength,
                   "white's height in pixels (16), or a factor on a normal map's slopes (1)")
      ->check(CLI::Range(-1e6, 1e6));
  command->add_option("--domain", options->domain, "what the polynomials are fitted over")
      ->capture_default_str()
      ->check(CLI::IsMember({"hemisphere", "disc", "square"}));
  add_config_options(*command, options->config);
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] {
    const Json out = bump(*options);
    if (options->json) {
      std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    } else {
      print_text(out);
    }
  });
}

}  // namespace ptm::testbench
