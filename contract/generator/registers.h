#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The table of registers, read and checked: contract/registers.toml says what its keys mean.
namespace ptm::contract {

struct Constant {
  std::string name, meaning;
  std::int64_t value = 0;
};

/// An enumeration: names of codes 0 and on.
struct Codes {
  std::string name, meaning;
  std::vector<std::string> names{};
};

/// One place of a layout, which a field, or a repeated one's elements, are kept in.
struct Place {
  std::string name;
  std::string layout{};  ///< of which layout the place is; empty: a number
  unsigned low = 0, width = 0, count = 1;
  bool is_signed = false;
  [[nodiscard]] unsigned end() const { return low + width * count; }
};

/// A packed vector of the RTL.
struct Layout {
  std::string name, meaning;
  std::vector<Place> places{};  ///< the highest first
  unsigned width = 0;
};

struct Repeat {
  std::string index;
  unsigned count = 1, stride = 1;
};

/// Where a field is kept.
struct Held {
  std::string layout;              ///< the outermost
  std::vector<std::string> place;  ///< names from there on
  unsigned low = 0;                ///< of element 0, within the outermost layout
  unsigned stride = 0;             ///< from one element to the next
  unsigned count = 1;
};

/// A parameter that must be more than 0, or than a number or an index, for a field to be there.
struct Need {
  std::string parameter, index{};
  unsigned number = 0;  ///< without an index
};

/// What a field of the capabilities reads as.
struct Built {
  enum class Kind { number, constant, codes, parameter } kind = Kind::number;
  std::int64_t number = 0;  ///< of numbers and constants
  std::string name;
};

struct Field {
  std::string name, meaning{}, codes{};
  unsigned low = 0, width = 0;
  bool is_signed = false, shared = false;
  std::uint32_t reset = 0;
  std::optional<Repeat> repeat{};
  std::optional<Held> held{};
  std::optional<Need> need{};
  std::optional<Built> built{};
  [[nodiscard]] std::uint32_t mask() const {
    return (width == 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << width) - 1) << low;
  }
  [[nodiscard]] unsigned copies() const { return repeat ? repeat->count : 1; }
};

enum class Access { rw, ro, wo, w1c };

struct Register {
  std::string name, meaning, page{};
  std::string full_name{};  ///< with the block's
  unsigned offset = 0;
  Access access = Access::rw;
  bool shared = false, capability = false, bits = false;
  std::vector<Repeat> repeats{};  ///< within an instance of the block, the outermost first
  std::vector<Field> fields{};
  /// How many there are in an instance of the block.
  [[nodiscard]] unsigned copies() const;
  /// Offset of one of them in an instance, and its number by index.
  [[nodiscard]] unsigned offset_of(unsigned copy) const;
  [[nodiscard]] unsigned index_of(unsigned copy, std::string_view index) const;
  /// What a field's need asks its parameter to be more than, for one of them and one of its
  /// elements.
  [[nodiscard]] unsigned more_than(const Field& field, unsigned copy, unsigned element) const;
};

struct Block {
  std::string name, meaning;
  unsigned address = 0, size = 0;
  std::optional<Repeat> repeat{};
  bool shared = false;
  std::vector<Register> registers{};
  /// Addresses of one instance.
  [[nodiscard]] unsigned instance() const { return repeat ? repeat->stride : size; }
};

struct RegisterMap {
  std::string name, meaning;
  std::vector<Constant> constants;
  std::vector<Codes> codes;
  std::vector<Layout> layouts;
  std::vector<Block> blocks;

  [[nodiscard]] const Layout& layout(std::string_view wanted) const;
  [[nodiscard]] const Codes* codes_of(std::string_view wanted) const;
  [[nodiscard]] std::vector<const Register*> capabilities() const;  ///< in order of address
};

/// Numbers and names that other tables make: counters, codes of texel formats, parameters.
struct Others {
  std::vector<Constant> constants;
  std::vector<Codes> codes;
  std::vector<std::string> parameters;
};

/// Throws TableError for what is missing, unknown or does not fit: fields and registers that lie on
/// one another, places of another width than their field, places that no field fills.
[[nodiscard]] RegisterMap read_registers(const std::filesystem::path& file, const Others& others);

[[nodiscard]] std::string_view access_name(Access access);

}  // namespace ptm::contract
