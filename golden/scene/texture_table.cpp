#include <algorithm>

#include "golden/scene/generate.h"
#include "golden/scene/scene_parts.h"
#include "golden/scene/textures.h"

namespace ptm::golden {
namespace {

using Names = std::vector<std::string_view>;

constexpr std::array<std::pair<std::string_view, WrapMode>, 3> kWraps{
    {{"repeat", WrapMode::repeat}, {"mirror", WrapMode::mirror}, {"clamp", WrapMode::clamp}}};

constexpr std::array<std::pair<std::string_view, FilterMode>, 6> kFilters{
    {{"point", {false, MipMode::none}},
     {"bilinear", {true, MipMode::none}},
     {"nearest-mip", {true, MipMode::nearest}},
     {"trilinear", {true, MipMode::linear}},
     {"point-nearest-mip", {false, MipMode::nearest}},
     {"point-linear-mip", {false, MipMode::linear}}}};

constexpr std::array<std::pair<std::string_view, MapKind>, 2> kMapKinds{
    {{"lrgb", MapKind::lrgb}, {"rgb", MapKind::rgb}}};

/// Which of the sources the table names; exactly one.
std::string_view source_key(const TableReader& table) {
  constexpr std::array<std::string_view, 5> sources{"ptm", "capture", "bump", "picture",
                                                    "generate"};
  std::string_view found;
  for (const std::string_view key : sources) {
    if (!table.has(key)) continue;
    if (!found.empty()) {
      table.fail(key, "a second source beside '" + std::string(found) + "'", "one source");
    }
    found = key;
  }
  if (found.empty()) {
    table.fail("", "no source", "one of ptm, capture, bump, picture, generate");
  }
  return found;
}

void read_bump(const TableReader& table, TextureSpec& texture) {
  enum class Kind : std::uint8_t { height, normal, green_down };
  constexpr std::array<std::pair<std::string_view, Kind>, 3> kinds{
      {{"height", Kind::height},
       {"normal", Kind::normal},
       {"normal-green-down", Kind::green_down}}};
  Kind kind = Kind::height;
  table.choose<Kind>("kind", kind, kinds);
  texture.source = kind == Kind::height ? TextureSource::bump_heights : TextureSource::bump_normals;
  texture.green_down = kind == Kind::green_down;
  if (!table.has("strength")) return;
  table.read("strength", texture.strength.emplace(0), -1e6, 1e6);
}

std::string listed(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

void read_generate(const TableReader& table, TextureSpec& texture) {
  table.read("generate", texture.pattern);
  if (std::find(kPatterns.begin(), kPatterns.end(), texture.pattern) == kPatterns.end()) {
    table.fail("generate", "'" + texture.pattern + "'", "one of " + listed(kPatterns));
  }
  const auto kinds = pattern_kinds(texture.pattern);
  std::string kind(kinds[0]);
  table.read("kind", kind);
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    table.fail("kind", "'" + kind + "' of " + texture.pattern, "one of " + listed(kinds));
  }
  if (kind == "picture") {
    texture.plain = true;
  } else {
    texture.kind = kind == "rgb" ? MapKind::rgb : MapKind::lrgb;
  }
  if (const toml::node* size = table.find("size")) {
    const toml::array& pair = table.reader().array(*size, table.name("size"), 2);
    for (std::size_t i = 0; i < 2; ++i) {
      texture.size[i] = static_cast<int>(
          table.reader().integer(pair[i], table.name("size"), 1, pattern_side(texture.pattern)));
    }
  }
  table.read("seed", texture.seed);
}

/// The source's own keys.
Names read_source(const TableReader& table, const std::filesystem::path& folder,
                  TextureSpec& texture) {
  const std::string_view key = source_key(table);
  if (key == "generate") {
    read_generate(table, texture);
    return {"generate", "size", "seed", "kind"};
  }
  std::string file;
  table.read(key, file);
  texture.file = folder / file;
  if (key == "bump") {
    read_bump(table, texture);
    return {"bump", "kind", "strength"};
  }
  if (key == "capture") {
    texture.source = TextureSource::capture;
    table.choose<MapKind>("format", texture.kind, kMapKinds);
    return {"capture", "format"};
  }
  texture.source = key == "ptm" ? TextureSource::ptm : TextureSource::picture;
  return {key};
}

void read_sampling(const TableReader& table, TextureSpec& texture) {
  if (table.has("wrap")) {
    for (const std::string_view key : {"wrap_u", "wrap_v"}) {
      if (table.has(key)) table.fail(key, "beside 'wrap'", "wrap, or wrap_u and wrap_v");
    }
    table.choose<WrapMode>("wrap", texture.wrap_u.emplace(), kWraps);
    texture.wrap_v = texture.wrap_u;
  }
  if (table.has("wrap_u")) table.choose<WrapMode>("wrap_u", texture.wrap_u.emplace(), kWraps);
  if (table.has("wrap_v")) table.choose<WrapMode>("wrap_v", texture.wrap_v.emplace(), kWraps);
  if (table.has("filter")) table.choose<FilterMode>("filter", texture.filter.emplace(), kFilters);
  if (table.has("probes")) {
    int& probes = texture.probes.emplace(1);
    table.read("probes", probes, 1, 16);
    if ((probes & (probes - 1)) != 0) {
      table.fail("probes", std::to_string(probes), "1, 2, 4, 8 or 16");
    }
  }
}

void read_palette(const TableReader& table, TextureSpec& texture) {
  const toml::node* palette = table.find("palette");
  if (!palette) return;
  if (texture.is_picture()) table.fail("palette", "a palette of a plain picture", "a map");
  if (palette->is_boolean()) {
    texture.palette = palette->as_boolean()->get() ? kFullPalette : 0;
  } else {
    table.read("palette", texture.palette, 2, 4096);
  }
}

}  // namespace

TextureSpec read_texture(const TableReader& table, const std::filesystem::path& folder) {
  TextureSpec texture;
  texture.place = table.place("");
  Names known = read_source(table, folder, texture);
  const Names common{"name", "palette", "wrap", "wrap_u", "wrap_v", "filter", "probes"};
  known.insert(known.end(), common.begin(), common.end());
  table.only(known);
  if (!table.has("name")) table.fail("", "no 'name'", "name = \"...\"");
  table.read("name", texture.name);
  read_palette(table, texture);
  read_sampling(table, texture);
  return texture;
}

}  // namespace ptm::golden
