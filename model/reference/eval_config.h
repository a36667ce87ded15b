#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace ptm::reference {

enum class Rounding : std::uint8_t { nearest, truncate };

/// Parameters of one evaluator, docs/spec/datapath.md; the same names in rtl/ptm_evaluator.sv.
/// The defaults are the preset `base`.
struct EvalConfig {
  int coef_bits = 8;   ///< stored coefficient, unsigned; 4..12
  int delta_bits = 9;  ///< coefficient less its bias, signed; 5..13
  int light_int = 2;   ///< integer bits of a light coordinate, sign included; 1..3
  int light_frac = 8;  ///< its fraction bits; 4..14
  int basis_frac = 8;  ///< fraction bits kept of lu*lu, lv*lv, lu*lv; 4..2*light_frac
  int guard = 4;       ///< fraction bits in the accumulator; 0..12
  Rounding rounding = Rounding::nearest;
  int lum_bits = 10;     ///< integer bits of luminance after the clamp, unsigned; 8..12
  int lum_frac = 0;      ///< its fraction bits; 0..4
  int shift_min = -4;    ///< lowest shift built for, it bounds the sum's width; -8..0
  int shift_groups = 6;  ///< six shifts, or three: a0 a1 a2, a3 a4, a5
  int filter_frac = 0;   ///< fraction bits that filtering leaves on coefficients; 0..4

  bool operator==(const EvalConfig&) const = default;
};

inline constexpr int kShiftMax = 15;

inline constexpr EvalConfig kPaper8{.coef_bits = 8,
                                    .delta_bits = 8,
                                    .light_int = 1,
                                    .light_frac = 7,
                                    .basis_frac = 6,
                                    .guard = 0,
                                    .rounding = Rounding::truncate,
                                    .lum_bits = 8,
                                    .lum_frac = 0,
                                    .shift_min = -2,
                                    .shift_groups = 6,
                                    .filter_frac = 0};
inline constexpr EvalConfig kBase{};
inline constexpr EvalConfig kWide{.coef_bits = 8,
                                  .delta_bits = 9,
                                  .light_int = 2,
                                  .light_frac = 12,
                                  .basis_frac = 16,
                                  .guard = 10,
                                  .rounding = Rounding::nearest,
                                  .lum_bits = 10,
                                  .lum_frac = 4,
                                  .shift_min = -4,
                                  .shift_groups = 6,
                                  .filter_frac = 0};

struct Preset {
  std::string_view name;
  EvalConfig config;
};
inline constexpr std::array<Preset, 3> kPresets{
    {{"paper8", kPaper8}, {"base", kBase}, {"wide", kWide}}};

/// The preset of that name; throws std::invalid_argument that lists the names there are.
[[nodiscard]] const Preset& find_preset(std::string_view name);

/// Throws std::invalid_argument naming the first field outside its range, its value and the range.
void validate(const EvalConfig& config);

/// The parameter as the RTL takes it, for build files and tests: "CoefBits" and so on.
struct NamedParameter {
  std::string_view name;
  int value;
};
[[nodiscard]] std::array<NamedParameter, 12> rtl_parameters(const EvalConfig& config);

}  // namespace ptm::reference
