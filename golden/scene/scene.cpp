#include "golden/scene/scene.h"

#include <algorithm>

#include "golden/scene/scene_parts.h"

namespace ptm::golden {
namespace {

void read_image(const Reader& reader, const toml::node& node, Scene& scene) {
  const toml::table& image = reader.table(node, "image");
  reader.only(image, "image.", {"size"});
  const toml::node* size = image.get("size");
  if (!size) return;
  const toml::array& pair = reader.array(*size, "image.size", 2);
  scene.size.emplace();
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string key = "image.size[" + std::to_string(i) + "]";
    (*scene.size)[i] = static_cast<int>(reader.integer(pair[i], key, 1, kLargestPicture));
  }
}

void read_lights(const Reader& reader, const toml::node& node, Scene& scene) {
  const toml::array& lights = reader.array(node, "light");
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::string key = "light[" + std::to_string(i) + "]";
    const toml::table& light = reader.table(lights[i], key);
    reader.only(light, key + ".", {"direction"});
    const toml::node* direction = light.get("direction");
    if (!direction) reader.fail(light, key, "no 'direction'", "direction = [lu, lv]");
    const toml::array& pair = reader.array(*direction, key + ".direction", 2);
    scene.lights.push_back({reader.number(pair[0], key + ".direction[0]"),
                            reader.number(pair[1], key + ".direction[1]"),
                            Reader::place(*direction, key + ".direction")});
  }
}

}  // namespace

std::vector<std::string> read_models(const Reader& reader, const toml::node* node) {
  if (!node) return {kModels.begin(), kModels.end()};
  std::vector<std::string> names;
  const toml::array& models = reader.array(*node, "models");
  if (models.empty()) reader.fail(*node, "models", "an empty list", "at least one model");
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string name = reader.text(models[i], "models[" + std::to_string(i) + "]");
    if (std::find(kModels.begin(), kModels.end(), name) == kModels.end()) {
      reader.fail(models[i], "models", "'" + name + "'", "golden, reference, pipeline or rtl");
    }
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      reader.fail(models[i], "models", "'" + name + "' twice", "each model once");
    }
    names.push_back(name);
  }
  return names;
}

Scene read_scene(const std::filesystem::path& path) {
  const toml::table root = parse_toml(path);
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
  if (const toml::node* hardware = root.get("hardware")) {
    scene.hardware = read_settings({reader, reader.table(*hardware, "hardware"), "hardware."});
  }
  scene.models = read_models(reader, root.get("models"));
  return scene;
}

}  // namespace ptm::golden
