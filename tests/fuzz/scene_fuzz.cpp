#include <algorithm>
#include <iterator>

#include "golden/scene/scene.h"
#include "golden/scene/unit_scene.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

// Scenes in TOML, flat ones and those of objects. The files that they name are not opened.
namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

void read(const fs::path& file) {
  if (!golden::is_unit_scene(file)) {
    const golden::Scene scene = golden::read_scene(file);
    if (scene.lights.empty() || scene.models.empty()) std::abort();
    return;
  }
  const golden::UnitScene scene = golden::read_unit_scene(file);
  if (scene.objects.empty() || scene.lights.empty() || scene.models.empty()) std::abort();
  const auto textures = static_cast<int>(scene.textures.size());
  for (const golden::DrawSpec& draw : scene.draws) {
    if (draw.map >= textures || draw.color >= textures) std::abort();
  }
  for (const golden::ObjectSpec& object : scene.objects) {
    if (object.draw < 0 || object.draw >= static_cast<int>(scene.draws.size())) std::abort();
  }
}

}  // namespace

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  static const FuzzFolder folder;
  try {
    read(folder.write("fuzz.toml", data, size));
    return true;
  } catch (const golden::InputError&) {
    return false;
  }
}

/// The project's own scenes, which use every key, and odd TOML.
std::vector<FuzzSeed> fuzz_seeds() {
  std::vector<FuzzSeed> seeds{
      {"inline",
       "map={file='a.ptm'}\nlight=[{direction=[0x1,-1e-3]}]\nimage.size=[1,2]\nmodels=['golden']"
       "\n"},
      {"refused_date", "[map]\nfile = 1979-05-27T07:32:00Z\n"},
      {"refused_nested", "a=[[[[[{b=[[{c.d.e.f=[]}]]}]]]]]\n[[light]]\n"},
      {"refused_text", "map.file = \"\"\"\n\\u00e9 \\\n   x\"\"\"\n'a b'.\"c\" = '''x'''\n"}};
  for (const auto& entry : fs::directory_iterator(fs::path(PTM_SOURCE_DIR) / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    seeds.push_back({entry.path().stem().string(), {std::istreambuf_iterator<char>(in), {}}});
  }
  std::sort(seeds.begin(), seeds.end(),
            [](const FuzzSeed& a, const FuzzSeed& b) { return a.name < b.name; });
  return seeds;
}

}  // namespace ptm::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ptm::tests::fuzz_reads(data, size);
  return 0;
}
