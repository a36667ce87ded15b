// ptmsim convert: one coding or kind of a map into another, palettes, mip levels. What was written
// is read back and compared.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "golden/files/figure_text.h"
#include "golden/files/pending_file.h"
#include "golden/files/ptm_file.h"
#include "model/quantize/mip.h"
#include "testbench/compare/lit_difference.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/expected_file.h"
#include "testbench/program/figures.h"
#include "testbench/program/option_checks.h"
#include "testbench/program/progress.h"
#include "testbench/program/region_option.h"
#include "testbench/run/crop_map.h"
#include "testbench/run/map_steps.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertOptions {
  std::string input, output;
  std::string format = "raw";
  std::string version = "1.2";
  std::string kind = "keep", dither = "none", crop;
  ConfigOptions config;
  int quality = 95, near = 0, palette = 0;
  std::uint64_t seed = 1;
  bool mip = false;
  bool lossy = false;
  bool inversion = false;
  bool json = false;
};

const std::map<std::string, golden::Coding> codings{{"raw", golden::Coding::raw},
                                                    {"jpeg", golden::Coding::jpeg},
                                                    {"jpegls", golden::Coding::jpegls}};
const std::map<std::string, quantize::Dither> dithers{{"none", quantize::Dither::none},
                                                      {"ordered", quantize::Dither::ordered},
                                                      {"diffused", quantize::Dither::diffused}};

/// Whether the written bytes may differ from the map's.
bool loses_bytes(const ConvertOptions& options) { return options.lossy || options.near > 0; }

golden::PtmWriteOptions write_options(const ConvertOptions& options) {
  golden::PtmWriteOptions out;
  out.coding = codings.at(options.format);
  out.version_1_1 = options.version == "1.1";
  out.jpeg_quality = options.quality;
  out.exact = !options.lossy;
  out.inversion = options.inversion;
  out.near = options.near;
  if (options.near > 0 && out.coding != golden::Coding::jpegls) {
    throw ExitError(ExitCode::usage, "--near goes with --format jpegls only");
  }
  if (options.mip && options.palette > 0) {
    throw ExitError(ExitCode::usage, "--mip and --palette do not go together");
  }
  if (out.coding != golden::Coding::jpeg && (options.lossy || options.inversion)) {
    throw ExitError(ExitCode::usage, "--lossy and --inversion go with --format jpeg only");
  }
  return out;
}

/// How one list of bytes differs from another of the same length.
Json compare_bytes(const std::vector<std::uint8_t>& wanted,
                   const std::vector<std::uint8_t>& found) {
  std::uint64_t differing = 0, sum = 0;
  int greatest = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const int error = std::abs(wanted[i] - found[i]);
    differing += error != 0 ? 1 : 0;
    sum += static_cast<std::uint64_t>(error);
    greatest = std::max(greatest, error);
  }
  const double mean =
      wanted.empty() ? 0 : static_cast<double>(sum) / static_cast<double>(wanted.size());
  return {{"bytes", wanted.size()}, {"differing", differing}, {"max", greatest}, {"mean", mean}};
}

/// The steps that change the map itself, each with a sentence; empty if none was asked for.
golden::PtmMap apply_steps(golden::PtmMap map, const ConvertOptions& options, Json& steps) {
  const reference::EvalConfig config = file_config_of(options.config);
  const quantize::Dither dither = dithers.at(options.dither);
  const auto take = [&](const char* name, SteppedMap stepped) {
    steps.push_back({{"step", name}, {"how", stepped.how}});
    map = std::move(stepped.map);
  };
  if (options.kind == "rgb" && map.kind != golden::MapKind::rgb) {
    take("rgb", to_rgb_map(map, config, dither));
  } else if (options.config.any() || dither != quantize::Dither::none) {
    take("hold", hold_map(map, config, dither));
  }
  if (options.palette > 0) {
    quantize::PaletteOptions palette{.entries = options.palette, .seed = options.seed};
    Progress progress("palette", static_cast<std::size_t>(quantize::palette_steps(palette)));
    palette.step = [&progress] { progress.step(); };
    take("palette", palette_map(map, config, palette));
  }
  return map;
}

/// OUT.ptm becomes OUT.0.ptm, OUT.1.ptm and so on, the largest level first.
std::string level_name(const std::string& output, std::size_t level) {
  std::filesystem::path path(output);
  const std::string ending = path.extension().string();
  return path.replace_extension("." + std::to_string(level) + ending).string();
}

/// Levels that an earlier conversion of a larger map left behind ours: files that halve each other
/// down to one texel, as a chain's do. Anything else is not touched.
std::vector<std::string> stale_levels(const std::string& output, std::size_t level) {
  std::vector<std::string> stale;
  for (int width = 0, height = 0; width != 1 || height != 1; ++level) {
    stale.push_back(level_name(output, level));
    golden::PtmMap map;
    try {
      map = golden::read_ptm(stale.back()).map;
    } catch (const golden::InputError&) {
      return {};
    }
    const bool half =
        map.width == quantize::half_side(width) && map.height == quantize::half_side(height);
    if (width != 0 && !half) return {};
    width = map.width;
    height = map.height;
  }
  return stale;
}

Json describe_difference(const golden::PtmMap& before, const golden::PtmMap& after) {
  const LitDifference lit = compare_lit(before, after, comparison_lights());
  return {{"lights", comparison_lights().size()},
          {"rmse", lit.rmse},
          {"psnr_db", lit.psnr_db},
          {"max", lit.max},
          {"within_999", lit.within_999},
          {"visible_share", lit.visible_share},
          {"ssim", lit.ssim},
          {"ssim_least", lit.ssim_least}};
}

/// Writes a map, reads it back and says how the file differs from it. The file has its name when it
/// is committed.
Json write_and_check(const ConvertOptions& options, const std::string& name,
                     const golden::PtmMap& map, golden::PendingFile& file) {
  std::vector<std::string> notes;
  try {
    notes = golden::write_ptm(file, map, write_options(options));
  } catch (const std::invalid_argument& error) {
    throw ExitError(ExitCode::usage, error.what());
  }
  const golden::PtmFile output = golden::read_ptm(file.path());
  const double payload =
      8.0 * static_cast<double>(output.info.file_bytes - output.info.header_bytes);
  Json report{{"file", name},
              {"format", output.info.format},
              {"version", output.info.version},
              {"width", map.width},
              {"height", map.height},
              {"file_bytes", output.info.file_bytes},
              {"payload_bits_per_texel", payload / static_cast<double>(map.texels())},
              {"coefficients", compare_bytes(map.coef, output.map.coef)},
              {"colors", compare_bytes(map.color, output.map.color)},
              {"notes", notes}};
  if (loses_bytes(options)) report["coding_lit"] = describe_difference(map, output.map);
  if (!loses_bytes(options) && output.map != map) {
    throw ExitError(ExitCode::disagree, name + " does not read back as it was written");
  }
  return report;
}

void print_lit(const char* what, const Json& lit) {
  std::cout << what << " under " << golden::count_of(lit["lights"].get<int>(), "light") << ": ";
  if (lit["max"] == 0.0) {
    std::cout << "unchanged\n";
    return;
  }
  std::cout << golden::count_of(figure(lit["rmse"]), "level") << " RMS, " << figure(lit["psnr_db"])
            << " dB, SSIM " << figure(lit["ssim"]) << " (least " << figure(lit["ssim_least"])
            << "), 99.9 % within " << figure(lit["within_999"]) << ", max " << figure(lit["max"])
            << '\n';
}

void print_file(const Json& report, const Json& input_bytes) {
  std::cout << report["file"].get<std::string>() << ": " << report["format"].get<std::string>()
            << ", " << report["width"] << " x " << report["height"] << ", " << report["file_bytes"]
            << " bytes (" << figure(report["payload_bits_per_texel"]) << " bits a texel), was "
            << input_bytes << '\n';
  for (const char* part : {"coefficients", "colors"}) {
    const Json& row = report[part];
    std::cout << part << " read back: " << row["differing"] << " of " << row["bytes"]
              << " bytes differ, max " << row["max"] << ", mean " << figure(row["mean"]) << '\n';
  }
  if (report.contains("coding_lit")) print_lit("what coding changed", report["coding_lit"]);
  for (const Json& note : report["notes"]) {
    std::cout << "note: " << note.get<std::string>() << '\n';
  }
}

void print(const ConvertOptions& options, const Json& report) {
  if (options.json) {
    std::cout << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return;
  }
  for (const Json& step : report["steps"]) {
    std::cout << step["step"].get<std::string>() << ": " << step["how"].get<std::string>() << '\n';
  }
  if (report.contains("lit")) print_lit("what the steps changed", report["lit"]);
  if (!report.contains("levels")) return print_file(report, report["input_bytes"]);
  for (const Json& level : report["levels"]) print_file(level, report["input_bytes"]);
}

/// The part that was asked for, in place of the whole.
void crop(const ConvertOptions& options, golden::PtmMap& map, Json& steps) {
  if (options.crop.empty()) return;
  const std::string whole = std::to_string(map.width) + " x " + std::to_string(map.height);
  map = crop_map(map, parse_region("--crop", options.crop), options.input);
  steps.push_back({{"step", "crop"}, {"how", options.crop + " of " + whole + " texels"}});
}

void check_names(const ConvertOptions& options) {
  expect_file(options.input, golden::FileType::map);
  expect_map_name(options.output);
}

void convert(const ConvertOptions& options) {
  (void)write_options(options);  // wrong usage is told before any work
  if (!options.crop.empty()) (void)parse_region("--crop", options.crop);
  check_names(options);
  golden::PtmFile input = golden::read_ptm(options.input);
  Json steps = Json::array();
  crop(options, input.map, steps);
  const std::size_t unchanging = steps.size();
  golden::PtmMap map;
  try {
    map = apply_steps(input.map, options, steps);
  } catch (const golden::InputError& error) {
    throw golden::InputError(options.input, error.place(), error.found(), error.expected());
  }
  Json report;
  std::deque<golden::PendingFile> files;  // all levels appear, or none
  std::vector<std::string> stale;
  const auto write = [&](const std::string& name, const golden::PtmMap& level) {
    return write_and_check(options, name, level, files.emplace_back(name));
  };
  if (options.mip) {
    const std::vector<golden::PtmMap> chain = mip_chain(map, file_config_of(options.config));
    Json levels = Json::array();
    for (std::size_t level = 0; level < chain.size(); ++level) {
      levels.push_back(write(level_name(options.output, level), chain[level]));
    }
    report["levels"] = levels;
    stale = stale_levels(options.output, chain.size());
    if (chain.front() != map) report["lit"] = describe_difference(map, chain.front());
  } else {
    report = write(options.output, map);
  }
  {
    const golden::HeldSignals held;
    for (golden::PendingFile& file : files) file.commit();
    std::error_code kept;  // the levels that were asked for are there
    for (const std::string& name : stale) std::filesystem::remove(name, kept);
  }
  report["input_bytes"] = input.info.file_bytes;
  report["steps"] = steps;
  if (steps.size() > unchanging) report["lit"] = describe_difference(input.map, map);
  print(options, report);
}

void add_step_options(CLI::App& command, ConvertOptions& options) {
  command.add_option("--kind", options.kind, "rgb: one polynomial a channel")
      ->capture_default_str()
      ->check(CLI::IsMember({"keep", "rgb"}));
  add_config_options(command, options.config);
  command.add_option("--dither", options.dither, "where the map is quantised anew")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "ordered", "diffused"}));
  command.add_option("--palette", options.palette, "at most so many different polynomials")
      ->check(CLI::Range(2, 65536));
  command.add_option("--seed", options.seed, "of the palette")
      ->check(whole_number())
      ->capture_default_str();
  command.add_option("--crop", options.crop,
                     "X,Y,W,H: this part only, in texels from the picture's top left");
  command.add_flag("--mip", options.mip, "write OUT.0.ptm, OUT.1.ptm ... down to one texel");
}

}  // namespace

void add_convert_command(CLI::App& app) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "A .ptm in another coding or of another kind");
  command->add_option("IN", options->input, "the .ptm to read")->required();
  command->add_option("OUT", options->output, "the .ptm to write")->required();
  command->add_option("--format", options->format, "coding of the output")
      ->capture_default_str()
      ->check(CLI::IsMember({"raw", "jpeg", "jpegls"}));
  command->add_option("--version", options->version, "1.1 is interleaved, raw LRGB only")
      ->capture_default_str()
      ->check(CLI::IsMember({"1.1", "1.2"}));
  command->add_option("--quality", options->quality, "of JPEG planes")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  command->add_option("--near", options->near, "JPEG-LS: how far a byte may be off")
      ->capture_default_str()
      ->check(CLI::Range(0, 127));
  add_step_options(*command, *options);
  command->add_flag("--lossy", options->lossy, "leave what JPEG changed as it is");
  command->add_flag("--inversion", options->inversion,
                    "JPEG: planes may build on inverted ones, as HP's do (relight refuses them)");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] { convert(*options); });
}

}  // namespace ptm::testbench
