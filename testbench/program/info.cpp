// ptmsim info: what a file holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "golden/files/whole_file.h"
#include "testbench/program/commands.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/map_bound.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> channels{"R", "G", "B"};

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

Json plane_rows(const golden::PtmFile& file) {
  const std::vector<std::string> names = byte_names(file.map.kind);
  Json rows = Json::array();
  for (std::size_t p = 0; p < file.info.order.size(); ++p) {
    rows.push_back({{"name", names[p]},
                    {"order", file.info.order[p]},
                    {"reference", file.info.references[p]},
                    {"transform", file.info.transforms[p]},
                    {"compressed_bytes", file.info.compressed_bytes[p]},
                    {"side_bytes", file.info.side_bytes[p]}});
  }
  return rows;
}

/// What each preset makes of the map: whether it takes the file's integers as they stand, of an
/// lrgb map how many texels' luminance it cannot hold under some light of the hemisphere, and, if
/// it certainly holds both, how far a lit channel may be off at most.
Json preset_rows(const golden::PtmMap& map) {
  Json rows = Json::array();
  for (const reference::Preset& preset : reference::kPresets) {
    const quantize::Import import = import_map(map, preset.config);
    Json row{{"preset", preset.name}, {"verbatim", import.map.has_value()}};
    if (map.kind == golden::MapKind::lrgb) {
      row["luminance_beyond"] = quantizer_input(map, preset.config).balance.exceeding;
    }
    row["levels_off_at_most"] = nullptr;
    if (import.map) {
      const auto bounds = texel_error_bounds(map, *import.map, preset.config);
      const double most = *std::max_element(bounds.begin(), bounds.end());
      if (std::isfinite(most)) row["levels_off_at_most"] = most;
    }
    row["why_not"] = import.why_not;
    rows.push_back(row);
  }
  return rows;
}

Json describe_map(const std::filesystem::path& path) {
  const golden::PtmFile file = golden::read_ptm(path);
  const golden::PtmFileInfo& info = file.info;
  const double payload_bits = 8.0 * static_cast<double>(info.file_bytes - info.header_bytes);
  Json out{{"file", path.string()},
           {"version", info.version},
           {"format", info.format},
           {"width", file.map.width},
           {"height", file.map.height},
           {"file_bytes", info.file_bytes},
           {"header_bytes", info.header_bytes},
           {"payload_bits_per_texel", payload_bits / static_cast<double>(file.map.texels())},
           {"scale", file.map.scale},
           {"bias", file.map.bias}};
  if (file.map.kind == golden::MapKind::lum) out["color_matrix"] = file.map.lum_matrix;
  out["bytes"] = byte_statistics(file.map);
  if (info.coding != golden::Coding::raw) {
    out["quality"] = info.quality;
    out["planes"] = plane_rows(file);
  }
  out["presets"] = preset_rows(file.map);
  out["notes"] = info.notes;
  return out;
}

Json describe_picture(const std::filesystem::path& path) {
  const golden::ImageReal image = golden::read_picture(path);
  Json rows = Json::array();
  for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
    rows.push_back(statistics(image.channels == 1 ? "grey" : channels[c], image.samples, c,
                              static_cast<std::size_t>(image.channels)));
  }
  return {{"file", path.string()},  {"format", "picture"},        {"width", image.width},
          {"height", image.height}, {"channels", image.channels}, {"levels", rows}};
}

bool looks_like_map(const std::filesystem::path& path) {
  golden::require_plain_file(path, "a .ptm file or a picture");
  if (path.extension() == ".ptm") return true;
  std::array<char, 4> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  return std::string(head.data(), head.size()) == "PTM_";
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
      cell(value.is_null() ? "-" : value.is_string() ? value.get<std::string>() : value.dump());
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
      std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump())
                << '\n';
    }
  }
}

struct InfoOptions {
  std::string file;
  bool json = false;
};

}  // namespace

void add_info_command(CLI::App& app) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "What a .ptm or a picture holds");
  command->add_option("FILE", options->file, "a .ptm, or a picture")->required();
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] {
    const Json description = looks_like_map(options->file) ? describe_map(options->file)
                                                           : describe_picture(options->file);
    if (options->json) {
      std::cout << description.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    } else {
      print_text(description);
    }
  });
}

}  // namespace ptm::testbench
