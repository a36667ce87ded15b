#include "golden/scene/unit_scene.h"

#include <algorithm>
#include <cmath>

#include "golden/geometry/direction.h"
#include "golden/scene/scene_parts.h"

namespace ptm::golden {
namespace {

/// The tables of [[key]], each with the name "key[i].".
std::vector<TableReader> tables_of(const Reader& reader, const toml::table& root,
                                   const std::string& key) {
  std::vector<TableReader> tables;
  const toml::node* node = root.get(key);
  if (!node) return tables;
  const toml::array& array = reader.array(*node, key);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string name = key + "[" + std::to_string(i) + "]";
    tables.emplace_back(reader, reader.table(array[i], name), name + ".");
  }
  return tables;
}

void read_image(const TableReader& table, UnitScene& scene) {
  table.only({"size", "traversal", "tile", "background"});
  if (const toml::node* size = table.find("size")) {
    const toml::array& pair = table.reader().array(*size, table.name("size"), 2);
    for (std::size_t k = 0; k < 2; ++k) {
      scene.size[k] =
          static_cast<int>(table.reader().integer(pair[k], table.name("size"), 1, kLargestPicture));
    }
    if (std::int64_t{scene.size[0]} * scene.size[1] > kMostPixels) {
      table.fail("size", std::to_string(scene.size[0]) + " x " + std::to_string(scene.size[1]),
                 "at most 16777216 pixels");
    }
  }
  constexpr std::array<std::pair<std::string_view, Traversal>, 2> traversals{
      {{"scan", Traversal::scan}, {"tiles", Traversal::tiles}}};
  table.choose<Traversal>("traversal", scene.traversal, traversals);
  table.read("tile", scene.tile, 1, 1024);
  if (table.has("tile") && scene.traversal == Traversal::scan) {
    table.fail("tile", "a size of tiles", "traversal = \"tiles\"");
  }
  table.read("background", scene.background, 0, 255);
}

void read_camera(const TableReader& table, CameraSpec& camera) {
  table.only({"position", "target", "up", "fov_degrees", "orthographic", "height"});
  table.read("position", camera.position);
  table.read("target", camera.target);
  table.read("up", camera.up);
  table.read("orthographic", camera.orthographic);
  table.read("fov_degrees", camera.fov_degrees, 0.001, 179);
  table.read("height", camera.height, 1e-9, 1e9);
  if (camera.orthographic && table.has("fov_degrees")) {
    table.fail("fov_degrees", "an angle of an orthographic camera", "height");
  }
  if (!camera.orthographic && table.has("height")) {
    table.fail("height", "the height of a perspective camera", "fov_degrees");
  }
  const Vec3 view = camera.target - camera.position;
  if (view.isZero(0)) table.fail("target", "the camera's own position", "another point");
  if (!span_a_plane(view, camera.up, 1e-9)) {
    table.fail("up", camera.up.isZero(0) ? "(0, 0, 0)" : "a direction along the view",
               "one across it");
  }
}

LightSpec read_light(const TableReader& table) {
  table.only({"direction", "position"});
  LightSpec light;
  if (table.has("direction") == table.has("position")) {
    table.fail("", table.has("position") ? "both 'direction' and 'position'" : "no 'direction'",
               "direction = [x, y, z] or [lu, lv], or position = [x, y, z]");
  }
  if (table.has("position")) {
    light.kind = LightKind::point;
    table.read("position", light.vector);
    light.place = table.place("position");
    return light;
  }
  light.place = table.place("direction");
  const toml::array& numbers =
      table.reader().array(*table.find("direction"), table.name("direction"));
  if (numbers.size() == 2) {
    light.kind = LightKind::local;
    light.vector.z() = 0;
    table.read("direction", std::span<double>(light.vector.data(), 2), -1e9, 1e9);
    return light;
  }
  table.read("direction", light.vector);
  if (light.vector.isZero(0)) table.fail("direction", "(0, 0, 0)", "a direction");
  light.vector = unit(light.vector);
  return light;
}

void read_textures(const Reader& reader, const toml::table& root, UnitScene& scene) {
  const auto folder = scene.file.parent_path();
  for (const TableReader& table : tables_of(reader, root, "texture")) {
    TextureSpec texture = read_texture(table, folder);
    const bool taken = std::any_of(scene.textures.begin(), scene.textures.end(),
                                   [&](const auto& t) { return t.name == texture.name; });
    if (taken) table.fail("name", "'" + texture.name + "' twice", "each name once");
    scene.textures.push_back(std::move(texture));
  }
}

void read_objects(const Reader& reader, const toml::table& root, UnitScene& scene) {
  const auto folder = scene.file.parent_path();
  for (const TableReader& table : tables_of(reader, root, "object")) {
    ObjectSpec object = read_object(table, folder);
    const DrawSpec draw = read_draw(table, scene.textures);
    const auto found = std::find(scene.draws.begin(), scene.draws.end(), draw);
    object.draw = static_cast<int>(found - scene.draws.begin());
    if (found == scene.draws.end()) scene.draws.push_back(draw);
    if (scene.draws.size() > kMostDraws) {
      table.fail("", "a fifth combination of textures and how they are combined",
                 "at most four: the unit has four descriptors");
    }
    scene.objects.push_back(std::move(object));
  }
  if (scene.objects.empty()) {
    throw InputError(scene.file.string(), "the file", "no [[object]]", "at least one [[object]]");
  }
}

void read_lights(const Reader& reader, const toml::table& root, UnitScene& scene) {
  for (const TableReader& table : tables_of(reader, root, "light")) {
    scene.lights.push_back(read_light(table));
  }
  if (scene.lights.empty()) {
    throw InputError(scene.file.string(), "the file", "no [[light]]",
                     "at least one [[light]] with direction or position");
  }
}

}  // namespace

bool is_unit_scene(const std::filesystem::path& path) {
  const toml::table root = parse_toml(path);
  return root.contains("object") || root.contains("texture");
}

UnitScene read_unit_scene(const std::filesystem::path& path) {
  const toml::table root = parse_toml(path);
  const Reader reader(path.string());
  const TableReader top(reader, root, "");
  top.only({"image", "camera", "texture", "object", "light", "hardware", "memory", "stress",
            "keep_cache", "draw_twice", "models"});
  UnitScene scene;
  scene.file = path;
  if (top.has("image")) read_image(top.table("image"), scene);
  if (top.has("camera")) read_camera(top.table("camera"), scene.camera);
  read_textures(reader, root, scene);
  read_objects(reader, root, scene);
  read_lights(reader, root, scene);
  if (top.has("hardware")) scene.hardware = read_settings(top.table("hardware"));
  if (top.has("memory")) scene.memory = read_settings(top.table("memory"));
  if (top.has("stress")) scene.stress = read_stress(top.table("stress"));
  top.read("keep_cache", scene.keep_cache);
  top.read("draw_twice", scene.draw_twice);
  scene.models = read_models(reader, top.find("models"));
  return scene;
}

}  // namespace ptm::golden
