#pragma once
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

/// As much of SystemRDL 2.0 as contract/driver/ptm_unit.rdl uses: enumerations, register files,
/// registers with fields, an address map, properties. Refuses what the standard does not allow.
namespace ptm::tests {

struct RdlField {
  std::string name, software, on_write, encode;
  unsigned low = 0, width = 0;
  std::uint32_t reset = 0;
  [[nodiscard]] std::uint32_t mask() const {
    return (width == 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << width) - 1) << low;
  }
};

struct RdlRegister {
  std::string name;
  std::uint64_t address = 0;  ///< of bytes
  std::vector<RdlField> fields;
};

/// All registers of the address map, each instance of its own.
using RdlMap = std::vector<RdlRegister>;

class RdlReader {
 public:
  explicit RdlReader(const std::string& text) { split(text); }

  /// Throws std::runtime_error for what is not SystemRDL or does not fit.
  RdlMap read() {
    RdlMap map;
    while (at_ < tokens_.size()) {
      if (peek() == "enum") {
        enumeration();
      } else if (peek() == "regfile") {
        take("regfile");
        const std::string name = identifier();
        files_[name] = body("regfile");
        take(";");
      } else {
        take("addrmap");
        identifier();
        map = body("addrmap");
        take(";");
      }
    }
    if (map.empty()) fail("no address map");
    return map;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    std::string near;
    for (std::size_t n = at_ > 4 ? at_ - 4 : 0; n < at_ + 4 && n < tokens_.size(); ++n) {
      near += tokens_[n] + " ";
    }
    throw std::runtime_error("SystemRDL: " + what + " near: " + near);
  }

  void split(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      std::size_t end = i + 1;
      if (std::isspace(static_cast<unsigned char>(c)) != 0) {
        ++i;
        continue;
      }
      if (text.compare(i, 2, "//") == 0) {
        i = text.find('\n', i);
        continue;
      }
      const auto word = [&text](std::size_t n) {
        return n < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[n])) != 0 || text[n] == '_');
      };
      if (c == '"') {
        while (text.at(end) != '"') end += text[end] == '\\' ? 2U : 1U;
        ++end;
      } else if (text.compare(i, 2, "+=") == 0) {
        end = i + 2;
      } else if (word(i) || c == '\\') {
        while (word(end)) ++end;
      }
      tokens_.push_back(text.substr(i, end - i));
      i = end;
    }
  }

  const std::string& peek() const {
    if (at_ >= tokens_.size()) fail("the end of the file");
    return tokens_[at_];
  }
  std::string next() {
    std::string token = peek();
    ++at_;
    return token;
  }
  void take(const std::string& expected) {
    if (peek() != expected) fail("found " + peek() + ", expected " + expected);
    ++at_;
  }
  bool skip(const std::string& token) {
    if (peek() != token) return false;
    ++at_;
    return true;
  }
  std::string identifier() {
    static const std::set<std::string> reserved{
        "reg",      "regfile", "addrmap",  "field",    "enum", "mem", "signal",
        "property", "default", "external", "internal", "sw",   "hw",  "rw",
        "r",        "w",       "na",       "name",     "desc", "set", "alias"};
    std::string name = next();
    if (name.starts_with("\\")) return name.substr(1);
    // `name` and `desc` are properties, which a component may be named like; `set` is nothing.
    if (reserved.contains(name) && name != "name" && name != "desc" && name != "set") {
      fail(name + " is a word of the language");
    }
    if (std::isdigit(static_cast<unsigned char>(name[0])) != 0 || name[0] == '"') {
      fail("found " + name + ", expected a name");
    }
    return name;
  }
  std::uint64_t number() {
    const std::string token = next();
    std::size_t used = 0;
    const std::uint64_t value = std::stoull(token, &used, 0);
    if (used != token.size()) fail("found " + token + ", expected a number");
    return value;
  }

  void enumeration() {
    take("enum");
    const std::string name = identifier();
    take("{");
    while (!skip("}")) {
      identifier();
      take("=");
      enums_[name].insert(number());
      take("{");
      while (!skip("}")) property("enumerator");
      take(";");
    }
    take(";");
  }

  /// Its name and value.
  std::pair<std::string, std::string> property(const std::string& component) {
    static const std::map<std::string, std::set<std::string>> known{
        {"enumerator", {"name", "desc"}},
        {"field", {"name", "desc", "sw", "hw", "onwrite", "encode"}},
        {"reg", {"name", "desc", "regwidth", "accesswidth"}},
        {"regfile", {"name", "desc", "regwidth"}},
        {"addrmap", {"name", "desc", "regwidth", "addressing", "littleendian"}}};
    skip("default");
    const std::string name = next();
    if (!known.at(component).contains(name)) fail(name + " is no property of a " + component);
    std::string value;
    if (skip("=")) value = next();
    take(";");
    return {name, value};
  }

  /// What stands between braces of a register file or address map.
  RdlMap body(const std::string& component) {
    RdlMap map;
    take("{");
    while (!skip("}")) {
      if (peek() == "reg") {
        registers(map);
      } else if (files_.contains(peek())) {
        const RdlMap file = files_.at(next());
        instances(file, map);
      } else {
        property(component);
      }
    }
    std::set<std::uint64_t> taken;
    for (const RdlRegister& r : map) {
      if (r.address % 4 != 0) fail(r.name + " is not aligned");
      if (!taken.insert(r.address).second) fail(r.name + " lies on another register");
    }
    return map;
  }

  void registers(RdlMap& map) {
    take("reg");
    take("{");
    RdlRegister made;
    std::uint32_t used = 0;
    while (!skip("}")) {
      if (peek() != "field") {
        const auto [name, value] = property("reg");
        if (name.ends_with("width") && value != "32") fail(name + " = " + value);
        continue;
      }
      made.fields.push_back(field());
      if ((used & made.fields.back().mask()) != 0) fail(made.fields.back().name + " overlaps");
      used |= made.fields.back().mask();
    }
    if (made.fields.empty()) fail("a register without a field");
    instances({made}, map);
  }

  RdlField field() {
    RdlField made;
    take("field");
    take("{");
    while (!skip("}")) {
      const auto [name, value] = property("field");
      if (name == "sw") made.software = value;
      if (name == "onwrite") made.on_write = value;
      if (name == "encode") made.encode = value;
    }
    made.name = identifier();
    take("[");
    const std::uint64_t high = number();
    take(":");
    made.low = static_cast<unsigned>(number());
    take("]");
    if (high < made.low || high > 31) fail("bits of " + made.name);
    made.width = static_cast<unsigned>(high) - made.low + 1;
    if (skip("=")) made.reset = static_cast<std::uint32_t>(number());
    if (made.width < 32 && made.reset >> made.width != 0) fail("reset of " + made.name);
    take(";");
    if (!made.encode.empty()) {
      if (!enums_.contains(made.encode)) fail("no enumeration " + made.encode);
      if (*enums_[made.encode].rbegin() >> made.width != 0) fail("codes of " + made.name);
    }
    return made;
  }

  void instances(const RdlMap& one, RdlMap& map) {
    std::uint64_t size = 0;
    for (const RdlRegister& r : one) size = std::max(size, r.address + 4);
    do {
      const std::string name = identifier();
      std::uint64_t count = 1, stride = 0;
      if (skip("[")) {
        count = number();
        take("]");
      }
      take("@");
      const std::uint64_t base = number();
      if (skip("+=")) stride = number();
      if (count > 1 && stride < size) fail("instances of " + name + " overlap");
      for (std::uint64_t n = 0; n < count; ++n) {
        for (RdlRegister r : one) {
          r.name = r.name.empty() ? name : name + "." + r.name;
          r.address += base + n * stride;
          map.push_back(r);
        }
      }
    } while (skip(","));
    take(";");
  }

  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::map<std::string, std::set<std::uint64_t>> enums_;
  std::map<std::string, RdlMap> files_;
};

}  // namespace ptm::tests
