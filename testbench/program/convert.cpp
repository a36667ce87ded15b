// ptmsim convert: one coding of a map into another. What was written is read back and compared.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "golden/files/ptm_file.h"
#include "testbench/program/commands.h"
#include "testbench/program/exit_code.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertOptions {
  std::string input, output;
  std::string format = "raw";
  std::string version = "1.2";
  int quality = 95;
  bool lossy = false;
  bool inversion = false;
  bool json = false;
};

const std::map<std::string, golden::Coding> codings{{"raw", golden::Coding::raw},
                                                    {"jpeg", golden::Coding::jpeg},
                                                    {"jpegls", golden::Coding::jpegls}};

/// Turns a map of one kind into another. The codings of one kind need nothing; LRGB and LUM to RGB
/// quantise anew and go here.
golden::PtmMap convert_kind(golden::PtmMap map) { return map; }

golden::PtmWriteOptions write_options(const ConvertOptions& options) {
  golden::PtmWriteOptions out;
  out.coding = codings.at(options.format);
  out.version_1_1 = options.version == "1.1";
  out.jpeg_quality = options.quality;
  out.exact = !options.lossy;
  out.inversion = options.inversion;
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

std::vector<std::string> write_map(const ConvertOptions& options, const golden::PtmMap& map) {
  try {
    return golden::write_ptm(options.output, map, write_options(options));
  } catch (const std::invalid_argument& error) {
    throw ExitError(ExitCode::usage, error.what());
  }
}

void print(const ConvertOptions& options, const Json& report) {
  if (options.json) {
    std::cout << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return;
  }
  std::cout << options.output << ": " << report["format"].get<std::string>() << ", "
            << report["file_bytes"] << " bytes, was " << report["input_bytes"] << '\n';
  for (const char* part : {"coefficients", "colors"}) {
    const Json& row = report[part];
    std::cout << part << " read back: " << row["differing"] << " of " << row["bytes"]
              << " bytes differ, max " << row["max"] << ", mean " << row["mean"] << '\n';
  }
  for (const Json& note : report["notes"]) {
    std::cout << "note: " << note.get<std::string>() << '\n';
  }
}

void convert(const ConvertOptions& options) {
  (void)write_options(options);  // wrong usage is told before any work
  golden::PtmFile input = golden::read_ptm(options.input);
  const golden::PtmMap map = convert_kind(std::move(input.map));
  const std::vector<std::string> notes = write_map(options, map);
  const golden::PtmFile output = golden::read_ptm(options.output);
  print(options, {{"file", options.output},
                  {"format", output.info.format},
                  {"version", output.info.version},
                  {"file_bytes", output.info.file_bytes},
                  {"input_bytes", input.info.file_bytes},
                  {"coefficients", compare_bytes(map.coef, output.map.coef)},
                  {"colors", compare_bytes(map.color, output.map.color)},
                  {"notes", notes}});
  if (!options.lossy && output.map != map) {
    throw ExitError(ExitCode::disagree, options.output + " does not read back as it was written");
  }
}

}  // namespace

void add_convert_command(CLI::App& app) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "A .ptm in another coding");
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
  command->add_flag("--lossy", options->lossy, "leave what JPEG changed as it is");
  command->add_flag("--inversion", options->inversion,
                    "JPEG: planes may build on inverted ones, as HP's do (relight refuses them)");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] { convert(*options); });
}

}  // namespace ptm::testbench
