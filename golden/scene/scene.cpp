#include "golden/scene/scene.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace ptm::golden {
namespace {

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

/// Reads a table key by key; every error names the file, the line and the key.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] static std::string place(const toml::node& node, const std::string& key) {
    return "line " + std::to_string(node.source().begin.line) + " (" + key + ")";
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& key, const std::string& found,
                         const std::string& expected) const {
    throw InputError(file_, place(node, key), found, expected);
  }

  void only(const toml::table& table, const std::string& prefix,
            std::initializer_list<std::string_view> known) const {
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      std::string list;
      for (const std::string_view name : known)
        list += (list.empty() ? "" : ", ") + std::string(name);
      throw InputError(file_, "line " + std::to_string(key.source().begin.line),
                       "unknown key '" + prefix + std::string(key.str()) + "'", "one of " + list);
    }
  }

  const toml::table& table(const toml::node& node, const std::string& key) const {
    const toml::table* found = node.as_table();
    if (!found) fail(node, key, kind_of(node), "a table");
    return *found;
  }

  const toml::array& array(const toml::node& node, const std::string& key) const {
    const toml::array* found = node.as_array();
    if (!found) fail(node, key, kind_of(node), "an array");
    return *found;
  }

  std::string text(const toml::node& node, const std::string& key) const {
    const auto* found = node.as_string();
    if (!found) fail(node, key, kind_of(node), "a string");
    return found->get();
  }

  int integer(const toml::node& node, const std::string& key, int low, int high) const {
    const std::string range =
        "an integer from " + std::to_string(low) + " to " + std::to_string(high);
    const auto* found = node.as_integer();
    if (!found) fail(node, key, kind_of(node), range);
    const std::int64_t value = found->get();
    if (value < low || value > high) fail(node, key, std::to_string(value), range);
    return static_cast<int>(value);
  }

  double number(const toml::node& node, const std::string& key) const {
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    const auto* found = node.as_floating_point();
    if (!found) fail(node, key, kind_of(node), "a finite number");
    if (!std::isfinite(found->get())) {
      fail(node, key, std::isnan(found->get()) ? "nan" : "inf", "a finite number");
    }
    return found->get();
  }

  const toml::array& pair(const toml::node& node, const std::string& key) const {
    const toml::array& found = array(node, key);
    if (found.size() != 2) {
      fail(node, key, std::to_string(found.size()) + " elements", "2 elements");
    }
    return found;
  }

 private:
  std::string file_;
};

void read_image(const Reader& reader, const toml::node& node, Scene& scene) {
  const toml::table& image = reader.table(node, "image");
  reader.only(image, "image.", {"size"});
  const toml::node* size = image.get("size");
  if (!size) return;
  const toml::array& pair = reader.pair(*size, "image.size");
  scene.size = std::array<int, 2>{reader.integer(pair[0], "image.size[0]", 1, kLargestPicture),
                                  reader.integer(pair[1], "image.size[1]", 1, kLargestPicture)};
}

void read_lights(const Reader& reader, const toml::node& node, Scene& scene) {
  const toml::array& lights = reader.array(node, "light");
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::string key = "light[" + std::to_string(i) + "]";
    const toml::table& light = reader.table(lights[i], key);
    reader.only(light, key + ".", {"direction"});
    const toml::node* direction = light.get("direction");
    if (!direction) reader.fail(light, key, "no 'direction'", "direction = [lu, lv]");
    const toml::array& pair = reader.pair(*direction, key + ".direction");
    scene.lights.push_back({reader.number(pair[0], key + ".direction[0]"),
                            reader.number(pair[1], key + ".direction[1]"),
                            Reader::place(*direction, key + ".direction")});
  }
}

void read_hardware(const Reader& reader, const toml::node& node, Scene& scene) {
  const toml::table& hardware = reader.table(node, "hardware");
  reader.only(hardware, "hardware.", {"preset", "tmus"});
  if (const toml::node* preset = hardware.get("preset")) {
    scene.preset = reader.text(*preset, "hardware.preset");
    scene.preset_place = Reader::place(*preset, "hardware.preset");
  }
  if (const toml::node* tmus = hardware.get("tmus")) {
    scene.tmus = reader.integer(*tmus, "hardware.tmus", 1, 3);
  }
}

void read_models(const Reader& reader, const toml::node& node, Scene& scene) {
  const toml::array& models = reader.array(node, "models");
  if (models.empty()) reader.fail(node, "models", "an empty list", "at least one model");
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string name = reader.text(models[i], "models[" + std::to_string(i) + "]");
    if (std::find(kModels.begin(), kModels.end(), name) == kModels.end()) {
      reader.fail(models[i], "models", "'" + name + "'", "golden, reference, pipeline or rtl");
    }
    if (std::find(scene.models.begin(), scene.models.end(), name) != scene.models.end()) {
      reader.fail(models[i], "models", "'" + name + "' twice", "each model once");
    }
    scene.models.push_back(name);
  }
}

toml::table parse(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError(path.string(), "the file", "no such file", "a scene in TOML");
  }
  try {
    return toml::parse_file(path.string());
  } catch (const toml::parse_error& problem) {
    throw InputError(path.string(),
                     "line " + std::to_string(problem.source().begin.line) + ", column " +
                         std::to_string(problem.source().begin.column),
                     std::string(problem.description()), "TOML");
  }
}

}  // namespace

Scene read_scene(const std::filesystem::path& path) {
  const toml::table root = parse(path);
  const Reader reader(path.string());
  reader.only(root, "", {"map", "image", "light", "hardware", "models"});
  Scene scene;
  scene.file = path;

  const toml::node* map = root.get("map");
  if (!map) throw InputError(path.string(), "line 1", "no [map]", "[map] with file = \"...\"");
  const toml::table& map_table = reader.table(*map, "map");
  reader.only(map_table, "map.", {"file"});
  const toml::node* file = map_table.get("file");
  if (!file) reader.fail(map_table, "map", "no 'file'", "file = \"...\"");
  scene.map = path.parent_path() / reader.text(*file, "map.file");

  if (const toml::node* image = root.get("image")) read_image(reader, *image, scene);
  if (const toml::node* lights = root.get("light")) read_lights(reader, *lights, scene);
  if (scene.lights.empty()) {
    throw InputError(path.string(), "the file", "no [[light]]",
                     "at least one [[light]] with direction = [lu, lv]");
  }
  if (const toml::node* hardware = root.get("hardware")) read_hardware(reader, *hardware, scene);
  if (const toml::node* models = root.get("models")) read_models(reader, *models, scene);
  if (scene.models.empty()) scene.models.assign(kModels.begin(), kModels.end());
  return scene;
}

}  // namespace ptm::golden
