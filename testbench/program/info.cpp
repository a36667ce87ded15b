// ptmsim info: what a file holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "golden/files/figure_text.h"
#include "golden/files/picture_header.h"
#include "golden/files/ptm_file.h"
#include "golden/files/ptm_header.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/expected_file.h"
#include "testbench/program/figures.h"
#include "testbench/run/crop_map.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/map_bound.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> channels{"R", "G", "B"};
constexpr const char* kBound = "levels_off_at_most";

/// Least, greatest and mean of every stride-th sample from first.
template <class Sample>
Json statistics(const std::string& name, const std::vector<Sample>& samples, std::size_t first,
                std::size_t stride) {
  Sample least = samples[first], greatest = samples[first];
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = first; i < samples.size(); i += stride, ++count) {
    least = std::min(least, samples[i]);
    greatest = std::max(greatest, samples[i]);
    sum += static_cast<double>(samples[i]);
  }
  return {{"name", name},
          {"min", least},
          {"max", greatest},
          {"mean", sum / static_cast<double>(count)}};
}

/// One name a byte of a texel, in the order of a coded file's planes.
std::vector<std::string> byte_names(golden::MapKind kind) {
  std::vector<std::string> names;
  const bool rgb = kind == golden::MapKind::rgb;
  for (std::size_t c = 0; c < (rgb ? 3U : 1U); ++c) {
    for (int k = 0; k < 6; ++k) {
      names.push_back((rgb ? std::string(channels[c]) + " " : "") + "a" + std::to_string(k));
    }
  }
  if (kind == golden::MapKind::lrgb) names.insert(names.end(), channels.begin(), channels.end());
  if (kind == golden::MapKind::lum) names.insert(names.end(), {"Cr", "Cb"});
  return names;
}

Json byte_statistics(const golden::PtmMap& map) {
  const std::vector<std::string> names = byte_names(map.kind);
  const std::size_t coefs = 6 * map.polynomials();
  Json rows = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i) {
    rows.push_back(i < coefs ? statistics(names[i], map.coef, i, coefs)
                             : statistics(names[i], map.color, i - coefs, map.color_bytes()));
  }
  return rows;
}

Json plane_rows(golden::MapKind kind, const golden::PtmFileInfo& info) {
  const std::vector<std::string> names = byte_names(kind);
  Json rows = Json::array();
  for (std::size_t p = 0; p < info.order.size(); ++p) {
    rows.push_back({{"name", names[p]},
                    {"order", info.order[p]},
                    {"reference", info.references[p]},
                    {"transform", info.transforms[p]},
                    {"compressed_bytes", info.compressed_bytes[p]},
                    {"side_bytes", info.side_bytes[p]}});
  }
  return rows;
}

/// Rows [first, first + rows) of a map as a map.
golden::PtmMap rows_of(const golden::PtmMap& map, int first, int rows) {
  return crop_map(map, {0, first, map.width, rows}, "");
}

/// Of a map that a preset takes verbatim or not: texels whose luminance goes beyond the preset's,
/// and the largest bound of the error.
struct PresetFigures {
  std::uint64_t beyond = 0;
  double most = 0;
};

/// Some rows at a time: real coefficients take 48 bytes a polynomial.
PresetFigures preset_figures(const golden::PtmMap& map, const reference::EvalConfig& config,
                             bool verbatim) {
  constexpr int texels_at_once = 1 << 20;
  PresetFigures figures;
  const int rows = std::max(1, texels_at_once / map.width);
  for (int first = 0; first < map.height; first += rows) {
    const golden::PtmMap part = rows_of(map, first, std::min(rows, map.height - first));
    if (part.kind == golden::MapKind::lrgb) {
      figures.beyond += quantizer_input(part, config).balance.exceeding;
    }
    if (!verbatim) continue;
    const auto bounds = texel_error_bounds(part, import_map(part, config).map.value(), config);
    figures.most = std::max(figures.most, *std::max_element(bounds.begin(), bounds.end()));
  }
  return figures;
}

/// What each preset, and a configuration that was asked for, makes of the map: whether it takes the
/// file's integers as they stand, of an lrgb map how many texels' luminance it cannot hold under
/// some light of the hemisphere, and, if it certainly holds both, how far a lit channel may be off
/// at most.
Json preset_rows(const golden::PtmMap& map, const reference::EvalConfig& own) {
  Json rows = Json::array();
  std::vector<reference::Preset> presets(reference::kPresets.begin(), reference::kPresets.end());
  const std::string own_name = name_of(own);
  if (!is_preset(own)) presets.push_back({own_name, own});
  for (const reference::Preset& preset : presets) {
    const quantize::Import import = import_map(map, preset.config);
    const PresetFigures figures = preset_figures(map, preset.config, import.map.has_value());
    Json row{{"preset", preset.name}, {"verbatim", import.map.has_value()}};
    if (map.kind == golden::MapKind::lrgb) row["luminance_beyond"] = figures.beyond;
    row[kBound] = nullptr;
    if (import.map && std::isfinite(figures.most)) row[kBound] = figures.most;
    row["why_not"] = import.why_not;
    rows.push_back(row);
  }
  return rows;
}

/// What the header says.
Json describe_header(const std::filesystem::path& path, const golden::PtmMap& map,
                     const golden::PtmFileInfo& info) {
  const double payload_bits = 8.0 * static_cast<double>(info.file_bytes - info.header_bytes);
  Json out{{"file", path.string()},
           {"version", info.version},
           {"format", info.format},
           {"width", map.width},
           {"height", map.height},
           {"file_bytes", info.file_bytes},
           {"header_bytes", info.header_bytes},
           {"payload_bits_per_texel", payload_bits / static_cast<double>(map.texels())},
           {"scale", map.scale},
           {"bias", map.bias}};
  if (map.kind == golden::MapKind::lum) out["color_matrix"] = map.lum_matrix;
  if (info.coding != golden::Coding::raw) {
    out["quality"] = info.quality;
    out["planes"] = plane_rows(map.kind, info);
  }
  return out;
}

Json describe_map(const std::filesystem::path& path, bool all,
                  const reference::EvalConfig& config) {
  if (!all) {
    const golden::PtmHeader header = golden::read_ptm_header(path);
    Json out = describe_header(path, header.map, header.info);
    out["notes"] = header.info.notes;
    return out;
  }
  const golden::PtmFile file = golden::read_ptm(path);
  Json out = describe_header(path, file.map, file.info);
  out["bytes"] = byte_statistics(file.map);
  out["presets"] = preset_rows(file.map, config);
  out["notes"] = file.info.notes;
  return out;
}

Json describe_picture(const std::filesystem::path& path, bool all) {
  const golden::PictureHeader header = golden::read_picture_header(path);
  Json out{{"file", path.string()},    {"format", "picture"},     {"kind", header.kind},
           {"width", header.width},    {"height", header.height}, {"channels", header.channels},
           {"samples", header.samples}};
  if (!all) return out;
  const std::vector<golden::LevelRange> ranges = golden::read_level_ranges(path);
  out["levels"] = Json::array();
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    out["levels"].push_back({{"name", ranges.size() == 1 ? "grey" : channels[c]},
                             {"min", ranges[c].least},
                             {"max", ranges[c].greatest},
                             {"mean", ranges[c].mean}});
  }
  return out;
}

/// A list of objects as a table: the keys of the first row, then one line a row.
void print_table(const Json& rows) {
  const std::size_t column = 18;
  const auto cell = [column](const std::string& text) {
    std::cout << "  " << text << std::string(column - std::min(column, text.size()), ' ');
  };
  for (const auto& [key, value] : rows.front().items()) cell(key);
  std::cout << '\n';
  for (const Json& row : rows) {
    for (const auto& [key, value] : row.items()) {
      if (key == kBound && !value.is_null()) {
        cell(golden::four_digits_bound(value.get<double>()));
      } else {
        cell(value.is_null() ? "-" : value.is_string() ? value.get<std::string>() : figure(value));
      }
    }
    std::cout << '\n';
  }
}

void print_text(const Json& description) {
  for (const auto& [key, value] : description.items()) {
    const bool table = value.is_array() && !value.empty() && value.front().is_object();
    if (table) {
      std::cout << key << ":\n";
      print_table(value);
    } else if (key == "notes") {
      for (const Json& note : value) std::cout << "note: " << note.get<std::string>() << '\n';
    } else {
      std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : figure(value))
                << '\n';
    }
  }
}

struct InfoOptions {
  std::string file;
  ConfigOptions config;
  bool json = false, all = false;
};

}  // namespace

void add_info_command(CLI::App& app) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "What a .ptm or a picture holds");
  command->add_option("FILE", options->file, "a .ptm, or a picture")->required();
  command->add_flag("--all", options->all,
                    "read the data too: ranges of bytes or levels, and of a map what each preset "
                    "of the hardware makes of it (default: headers only)");
  add_config_options(*command, options->config);
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] {
    const reference::EvalConfig config = configuration_of(options->config).eval;
    const bool all = options->all || options->config.any();
    const bool map = expect_map_or_picture(options->file) == golden::FileType::map;
    const Json description =
        map ? describe_map(options->file, all, config) : describe_picture(options->file, all);
    if (options->json) {
      std::cout << description.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    } else {
      print_text(description);
    }
  });
}

}  // namespace ptm::testbench
