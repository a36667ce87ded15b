#include "contract/generator/registers.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "contract/generator/names.h"
#include "contract/generator/table.h"

namespace ptm::contract {
namespace {

constexpr unsigned kWord = 32;
constexpr std::array<std::pair<std::string_view, Access>, 4> kAccess{
    {{"rw", Access::rw}, {"ro", Access::ro}, {"wo", Access::wo}, {"w1c", Access::w1c}}};

/// A name of the tables: small letters, digits, underscores between them, a letter first.
std::string name_of(const Row& row) {
  std::string name = row.text("name");
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  const bool legal = !name.empty() && name[0] >= 'a' && name[0] <= 'z' && name.back() != '_' &&
                     name.find("__") == std::string::npos &&
                     std::all_of(name.begin(), name.end(), fits);
  if (!legal) {
    row.fail("name", "found '" + name + "', expected small letters, digits and underscores");
  }
  return name;
}

template <class Item>
void require_new(const Row& row, const std::vector<Item>& all, const std::string& name) {
  for (const Item& item : all) {
    if (item.name == name) row.fail("name", "found '" + name + "' a second time");
  }
}

class Reader {
 public:
  Reader(const std::filesystem::path& path, const Others& others)
      : file_(path), others_(others), constants_(others.constants) {
    map_.codes = others.codes;
  }

  RegisterMap read() {
    file_.only({"map", "constant", "codes", "layout", "block"});
    for (const Row& row : file_.rows("map")) {
      row.only({"name", "meaning"});
      map_.name = name_of(row);
      map_.meaning = row.text("meaning");
    }
    for (const Row& row : file_.rows("constant")) read_constant(row);
    for (const Row& row : file_.rows("codes")) read_codes(row);
    for (const Row& row : file_.rows("layout")) read_layout(row);
    for (const Row& row : file_.rows("block")) read_block(row);
    require_filled();
    return map_;
  }

 private:
  /// A number, a constant's name, or that with a number added.
  std::int64_t number(const Row& row, std::string_view key) const {
    const std::string text = row.expression(key);
    const std::size_t plus = text.find(" + ");
    const std::string first = text.substr(0, plus);
    std::int64_t sum = plus == std::string::npos ? 0 : std::stoll(text.substr(plus + 3));
    if (first.find_first_not_of("0123456789-") == std::string::npos) return sum + std::stoll(first);
    for (const Constant& constant : constants_) {
      if (constant.name == first) return sum + constant.value;
    }
    row.fail(key, "found '" + text + "', expected a number or a constant, with a number added");
  }
  unsigned size(const Row& row, std::string_view key, std::int64_t least, std::int64_t most) const {
    const std::int64_t value = number(row, key);
    if (value < least || value > most) {
      row.fail(key, "found " + std::to_string(value) + ", expected " + std::to_string(least) +
                        " to " + std::to_string(most));
    }
    return static_cast<unsigned>(value);
  }

  void read_constant(const Row& row) {
    row.only({"name", "value", "meaning"});
    Constant constant{name_of(row), row.text("meaning"), number(row, "value")};
    require_new(row, constants_, constant.name);
    constants_.push_back(constant);
    map_.constants.push_back(constant);
  }

  void read_codes(const Row& row) {
    row.only({"name", "names", "meaning"});
    Codes codes{name_of(row), row.text("meaning"), row.texts("names")};
    require_new(row, map_.codes, codes.name);
    if (codes.names.empty()) row.fail("names", "found none, expected the code 0's at least");
    map_.codes.push_back(codes);
  }

  void read_layout(const Row& row) {
    row.only({"name", "meaning", "places"});
    Layout layout{.name = name_of(row), .meaning = row.text("meaning")};
    require_new(row, map_.layouts, layout.name);
    for (const Row& place : row.rows("places")) layout.places.push_back(read_place(place));
    for (auto place = layout.places.rbegin(); place != layout.places.rend(); ++place) {
      place->low = layout.width;
      layout.width = place->end();
    }
    map_.layouts.push_back(layout);
  }

  Place read_place(const Row& row) const {
    row.only({"name", "width", "count", "signed", "layout"});
    Place place{.name = name_of(row)};
    if (row.has("layout")) {
      place.layout = row.text("layout");
      for (const Layout& layout : map_.layouts) {
        if (layout.name == place.layout) place.width = layout.width;
      }
      if (place.width == 0) row.fail("layout", "found '" + place.layout + "', no layout before it");
    } else {
      place.width = size(row, "width", 1, 32);
    }
    if (row.has("count")) place.count = size(row, "count", 1, 4096);
    place.is_signed = row.flag_or("signed", false);
    return place;
  }

  Repeat read_repeat(const Row& row) const {
    row.only({"index", "count", "stride"});
    return {row.text("index"), size(row, "count", 1, 65536), size(row, "stride", 1, 65536)};
  }

  void read_block(const Row& row) {
    row.only({"name", "prefix", "address", "size", "repeat", "shared", "meaning", "register"});
    Block block{.name = name_of(row), .meaning = row.text("meaning")};
    require_new(row, map_.blocks, block.name);
    block.size = size(row, "size", 1, 65536);
    block.address = size(row, "address", 0, 65535);
    if (!is_power_of_two(block.size) || block.address % block.size != 0) {
      row.fail("address", "found " + hex(block.address, 4) + ", " + std::to_string(block.size) +
                              " long, expected a power of two, aligned to it");
    }
    for (const Block& other : map_.blocks) {
      if (block.address < other.address + other.size &&
          other.address < block.address + block.size) {
        row.fail("address", "lies on the block '" + other.name + "'");
      }
    }
    block.shared = row.flag_or("shared", false);
    if (row.has("repeat")) {
      block.repeat = read_repeat(row.table("repeat"));
      if (block.repeat->count * block.repeat->stride > block.size ||
          !is_power_of_two(block.repeat->stride)) {
        row.fail("repeat", "expected strides of a power of two, all within the block's size");
      }
    }
    std::set<unsigned> taken;
    for (const Row& r : row.rows("register")) {
      read_register(r, row.flag_or("prefix", true), block, taken);
    }
    map_.blocks.push_back(block);
  }

  void read_register(const Row& row, bool prefix, Block& block, std::set<unsigned>& taken) {
    row.only({"name", "offset", "access", "shared", "meaning", "page", "repeat", "fields",
              "capability", "bits"});
    Register r{.name = name_of(row), .meaning = row.text("meaning")};
    require_new(row, block.registers, r.name);
    r.full_name = prefix ? block.name + "_" + r.name : r.name;
    r.page = row.text_or("page", "unit.md");
    r.offset = size(row, "offset", 0, 65535);
    r.access = access_of(row);
    r.shared = block.shared || row.flag_or("shared", false);
    r.capability = row.flag_or("capability", false);
    r.bits = row.flag_or("bits", false);
    for (const Row& repeat : row.rows("repeat")) r.repeats.push_back(read_repeat(repeat));
    for (unsigned copy = 0; copy < r.copies(); ++copy) {
      if (r.offset_of(copy) >= block.instance()) {
        row.fail("offset", "copy " + std::to_string(copy) + " lies at " +
                               std::to_string(r.offset_of(copy)) + ", expected less than " +
                               std::to_string(block.instance()));
      }
      if (!taken.insert(r.offset_of(copy)).second) {
        row.fail("offset", "offset " + std::to_string(r.offset_of(copy)) + " is taken");
      }
    }
    std::uint32_t used = 0;
    for (const Row& field : row.rows("fields")) read_field(field, r, used);
    if (r.fields.empty()) row.fail("fields", "found none, expected at least one");
    block.registers.push_back(r);
  }

  static Access access_of(const Row& row) {
    const std::string text = row.text("access");
    for (const auto& [name, access] : kAccess) {
      if (name == text) return access;
    }
    row.fail("access", "found '" + text + "', expected rw, ro, wo or w1c");
  }

  void read_field(const Row& row, Register& r, std::uint32_t& used) {
    row.only({"name", "low", "width", "signed", "shared", "reset", "codes", "repeat", "in", "at",
              "needs", "value", "meaning"});
    Field field{.name = name_of(row)};
    require_new(row, r.fields, field.name);
    field.low = size(row, "low", 0, kWord - 1);
    field.width = size(row, "width", 1, kWord - field.low);
    field.is_signed = row.flag_or("signed", false);
    field.shared = row.flag_or("shared", false);
    field.reset = static_cast<std::uint32_t>(row.integer_or("reset", 0));
    if (row.has("repeat")) field.repeat = read_repeat(row.table("repeat"));
    for (unsigned copy = 0; copy < field.copies(); ++copy) {
      const unsigned low = field.low + (field.repeat ? copy * field.repeat->stride : 0);
      if (low + field.width > kWord)
        row.fail("repeat", "copy " + std::to_string(copy) + " lies beyond bit 31");
      Field at = field;
      at.low = low;
      if ((used & at.mask()) != 0)
        row.fail("low", "bits " + bit_range(low, field.width) + " are taken");
      used |= at.mask();
    }
    read_codes_of(row, field);
    if (row.has("value")) read_value(row, field);
    field.meaning = row.text_or("meaning", field.meaning);
    if (field.meaning.empty() && !field.built)
      row.fail("meaning", "found nothing, expected what the field says");
    if (row.has("needs")) field.need = read_need(row, r, field);
    if (row.has("in")) field.held = read_held(row, r, field);
    r.fields.push_back(field);
  }

  void read_codes_of(const Row& row, Field& field) const {
    field.codes = row.text_or("codes", "");
    if (field.codes.empty()) return;
    const Codes* codes = map_.codes_of(field.codes);
    if (codes == nullptr) row.fail("codes", "found '" + field.codes + "', no such enumeration");
    if (codes->names.size() > std::size_t{1} << field.width) {
      row.fail("width", "the codes of '" + field.codes + "' do not fit");
    }
  }

  void read_value(const Row& row, Field& field) const {
    const std::string text = row.expression("value");
    Built built{.name = text};
    const auto is = [&text](const auto& item) { return item.name == text; };
    const auto constant = std::find_if(constants_.begin(), constants_.end(), is);
    const bool parameter = std::find(others_.parameters.begin(), others_.parameters.end(), text) !=
                           others_.parameters.end();
    if (text.starts_with("codes ")) {
      built.kind = Built::Kind::codes;
      built.name = text.substr(6);
      const Codes* codes = map_.codes_of(built.name);
      if (codes == nullptr) row.fail("value", "found '" + text + "', no such enumeration");
      if (codes->names.size() > field.width) row.fail("width", "has no bit for each code");
      built.number = (std::int64_t{1} << codes->names.size()) - 1;
    } else if (constant != constants_.end()) {
      built.kind = Built::Kind::constant;
      built.number = constant->value;
      field.meaning = constant->meaning;
      if (built.number >> field.width != 0) row.fail("width", "does not hold the constant's value");
    } else if (parameter) {
      built.kind = Built::Kind::parameter;
    } else if (text.find_first_not_of("0123456789") == std::string::npos) {
      built.number = std::stoll(text);
    } else {
      row.fail("value", "found '" + text +
                            "', expected a parameter, a constant, \"codes NAME\" or a number");
    }
    field.built = built;
  }

  Need read_need(const Row& row, const Register& r, const Field& field) const {
    const std::string text = row.text("needs");
    const std::size_t more = text.find(" > ");
    Need need{text.substr(0, more), more == std::string::npos ? "" : text.substr(more + 3)};
    if (!need.index.empty() && need.index.find_first_not_of("0123456789") == std::string::npos) {
      need.number = static_cast<unsigned>(std::stoul(need.index));
      need.index.clear();
    }
    if (std::find(others_.parameters.begin(), others_.parameters.end(), need.parameter) ==
        others_.parameters.end()) {
      row.fail("needs", "found '" + need.parameter + "', no parameter");
    }
    bool known = need.index.empty() || (field.repeat && field.repeat->index == need.index);
    for (const Repeat& repeat : r.repeats) known = known || repeat.index == need.index;
    if (!known) row.fail("needs", "found '" + need.index + "', no index of the register or field");
    return need;
  }

  Held read_held(const Row& row, const Register& r, const Field& field) {
    const std::string path = row.text("in");
    Held held;
    std::size_t from = 0;
    const Layout* layout = nullptr;
    const Place* place = nullptr;
    while (from <= path.size()) {
      const std::size_t dot = std::min(path.find('.', from), path.size());
      const std::string part = path.substr(from, dot - from);
      from = dot + 1;
      if (held.layout.empty()) {
        held.layout = part;
        layout = find_layout(row, part);
        continue;
      }
      if (layout == nullptr) row.fail("in", "found '" + path + "', which goes on behind a number");
      place = nullptr;
      for (const Place& one : layout->places) {
        if (one.name == part) place = &one;
      }
      if (place == nullptr)
        row.fail("in", "found '" + part + "', no place of the layout '" + layout->name + "'");
      held.place.push_back(part);
      held.low += place->low;
      layout = place->layout.empty() ? nullptr : find_layout(row, place->layout);
    }
    if (place == nullptr || layout != nullptr)
      row.fail("in", "found '" + path + "', expected a place that holds a number");
    const unsigned at = row.has("at") ? size(row, "at", 0, 31) : 0;
    const unsigned copies = r.copies() * field.copies();
    if (copies != place->count) {
      row.fail("in", "the place has " + std::to_string(place->count) + " elements, the field " +
                         std::to_string(copies));
    }
    if (at + field.width > place->width)
      row.fail("in", "the place is " + std::to_string(place->width) + " bits wide");
    held.low += at;
    held.stride = place->width;
    held.count = place->count;
    fill(row, path, at, field.width, place->width);
    return held;
  }

  const Layout* find_layout(const Row& row, const std::string& name) const {
    for (const Layout& layout : map_.layouts) {
      if (layout.name == name) return &layout;
    }
    row.fail("in", "found '" + name + "', no layout");
  }

  void fill(const Row& row, const std::string& path, unsigned at, unsigned width, unsigned whole) {
    std::uint64_t& filled = filled_[path];
    const std::uint64_t bits = ((std::uint64_t{1} << width) - 1) << at;
    if ((filled & bits) != 0) row.fail("in", "the place '" + path + "' is taken");
    filled |= bits;
    if (filled == (std::uint64_t{1} << whole) - 1) whole_.insert(path);
  }

  void require_filled() const {
    for (const Layout& layout : map_.layouts) {
      if (!filled_outside(layout.name)) continue;
      require_filled(layout, layout.name);
    }
  }
  /// Whether a field names the layout as the outermost.
  bool filled_outside(const std::string& layout) const {
    return std::any_of(filled_.begin(), filled_.end(),
                       [&layout](const auto& one) { return one.first.starts_with(layout + "."); });
  }
  void require_filled(const Layout& layout, const std::string& path) const {
    for (const Place& place : layout.places) {
      const std::string here = path + "." + place.name;
      if (!place.layout.empty()) {
        require_filled(map_.layout(place.layout), here);
      } else if (!whole_.contains(here)) {
        throw TableError("registers.toml: " + here + ": no field of a register fills the place");
      }
    }
  }

  TableFile file_;
  const Others& others_;
  std::vector<Constant> constants_;
  RegisterMap map_;
  std::map<std::string, std::uint64_t> filled_;  ///< bits of a place that fields fill
  std::set<std::string> whole_;
};

}  // namespace

unsigned Register::copies() const {
  unsigned count = 1;
  for (const Repeat& repeat : repeats) count *= repeat.count;
  return count;
}

unsigned Register::offset_of(unsigned copy) const {
  unsigned at = offset;
  for (auto repeat = repeats.rbegin(); repeat != repeats.rend(); ++repeat) {
    at += copy % repeat->count * repeat->stride;
    copy /= repeat->count;
  }
  return at;
}

unsigned Register::index_of(unsigned copy, std::string_view index) const {
  for (auto repeat = repeats.rbegin(); repeat != repeats.rend(); ++repeat) {
    if (repeat->index == index) return copy % repeat->count;
    copy /= repeat->count;
  }
  return 0;
}

unsigned Register::more_than(const Field& field, unsigned copy, unsigned element) const {
  const Need& need = field.need.value();
  if (need.index.empty()) return need.number;
  const bool own = field.repeat && field.repeat->index == need.index;
  return own ? element : index_of(copy, need.index);
}

const Layout& RegisterMap::layout(std::string_view wanted) const {
  for (const Layout& one : layouts) {
    if (one.name == wanted) return one;
  }
  throw std::out_of_range("no layout " + std::string(wanted));
}

const Codes* RegisterMap::codes_of(std::string_view wanted) const {
  for (const Codes& one : codes) {
    if (one.name == wanted) return &one;
  }
  return nullptr;
}

std::vector<const Register*> RegisterMap::capabilities() const {
  std::vector<const Register*> all;
  for (const Block& block : blocks) {
    for (const Register& r : block.registers) {
      if (r.capability) all.push_back(&r);
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Register* a, const Register* b) { return a->offset < b->offset; });
  return all;
}

std::string_view access_name(Access access) {
  for (const auto& [name, value] : kAccess) {
    if (value == access) return name;
  }
  return "";
}

RegisterMap read_registers(const std::filesystem::path& file, const Others& others) {
  return Reader(file, others).read();
}

}  // namespace ptm::contract
