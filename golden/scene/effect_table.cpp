#include <algorithm>

#include "golden/effects/effect.h"
#include "golden/scene/scene_parts.h"

namespace ptm::golden {
namespace {

std::string listed(const std::vector<const char*>& words) {
  std::string list;
  for (const char* word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return list;
}

double texture_index(const TableReader& table, const EffectKey& key,
                     const std::vector<TextureSpec>& textures) {
  std::string name;
  table.read(key.name, name);
  const auto found = std::find_if(textures.begin(), textures.end(),
                                  [&](const TextureSpec& t) { return t.name == name; });
  if (found == textures.end()) table.fail(key.name, "'" + name + "'", "the name of a [[texture]]");
  return static_cast<double>(found - textures.begin());
}

double word_index(const TableReader& table, const EffectKey& key) {
  std::string word;
  table.read(key.name, word);
  const auto found = std::find(key.words.begin(), key.words.end(), word);
  if (found == key.words.end()) {
    table.fail(key.name, "'" + word + "'", "one of " + listed(key.words));
  }
  return static_cast<double>(found - key.words.begin());
}

/// [a, b] or [[a, b], [c, d], ...]
std::vector<double> read_pairs(const TableReader& table, const EffectKey& key) {
  const toml::array& array = table.reader().array(*table.find(key.name), table.name(key.name));
  const bool nested = !array.empty() && array[0].is_array();
  std::vector<double> numbers(2);
  if (!nested) {
    table.read(key.name, numbers, key.low, key.high);
    return numbers;
  }
  numbers.clear();
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string name = table.name(key.name) + "[" + std::to_string(i) + "]";
    for (const toml::node& node : table.reader().array(array[i], name, 2)) {
      const double value = table.reader().number(node, name);
      if (value < key.low || value > key.high) {
        table.reader().fail(
            node, name, std::to_string(value),
            "numbers from " + std::to_string(key.low) + " to " + std::to_string(key.high));
      }
      numbers.push_back(value);
    }
  }
  return numbers;
}

std::vector<double> read_key(const TableReader& table, const EffectKey& key,
                             const std::vector<TextureSpec>& textures) {
  if (!table.has(key.name)) {
    if (key.need == EffectKeyNeed::required) {
      table.fail("", "no '" + std::string(key.name) + "'", "a value for it");
    }
    if (key.need == EffectKeyNeed::optional) return {};
    return key.kind == EffectKeyKind::word ? std::vector<double>{0} : key.standard;
  }
  std::vector<double> numbers(key.count);
  switch (key.kind) {
    case EffectKeyKind::number:
      if (key.count == 1) {
        table.read(key.name, numbers[0], key.low, key.high);
      } else {
        table.read(key.name, numbers, key.low, key.high);
      }
      break;
    case EffectKeyKind::integer: {
      int value = 0;
      table.read(key.name, value, static_cast<int>(key.low), static_cast<int>(key.high));
      numbers[0] = value;
      break;
    }
    case EffectKeyKind::texture:
      numbers[0] = texture_index(table, key, textures);
      break;
    case EffectKeyKind::word:
      numbers[0] = word_index(table, key);
      break;
    case EffectKeyKind::pairs:
      return read_pairs(table, key);
  }
  return numbers;
}

EffectSpec read_effect(const TableReader& table, const std::vector<TextureSpec>& textures) {
  EffectSpec spec;
  spec.place = table.place("");
  if (!table.has("kind")) table.fail("", "no 'kind'", "the name of an effect");
  table.read("kind", spec.effect);
  const Effect* effect = find_effect(spec.effect);
  if (!effect) {
    std::vector<const char*> names;
    for (const Effect* known : effects()) names.push_back(known->name);
    table.fail("kind", "'" + spec.effect + "'", "one of those of this build: " + listed(names));
  }
  std::vector<std::string_view> known{"kind"};
  for (const EffectKey& key : effect->keys) known.emplace_back(key.name);
  table.only(known);
  for (const EffectKey& key : effect->keys) {
    spec.numbers.push_back(read_key(table, key, textures));
  }
  return spec;
}

std::size_t row_of(const EffectSpec& spec) {
  const auto& all = effects();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), find_effect(spec.effect)) -
                                  all.begin());
}

}  // namespace

std::vector<EffectSpec> read_effects(const TableReader& object,
                                     const std::vector<TextureSpec>& textures) {
  std::vector<EffectSpec> specs;
  const toml::node* node = object.find("effect");
  if (!node) return specs;
  const toml::array& array = object.reader().array(*node, object.name("effect"));
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string name = object.name("effect") + "[" + std::to_string(i) + "]";
    const TableReader table(object.reader(), object.reader().table(array[i], name), name + ".");
    specs.push_back(read_effect(table, textures));
    const auto same = std::count_if(specs.begin(), specs.end(), [&](const EffectSpec& s) {
      return s.effect == specs.back().effect;
    });
    if (same > 1) table.fail("kind", "'" + specs.back().effect + "' twice", "each effect once");
  }
  std::stable_sort(specs.begin(), specs.end(),
                   [](const EffectSpec& a, const EffectSpec& b) { return row_of(a) < row_of(b); });
  return specs;
}

}  // namespace ptm::golden
