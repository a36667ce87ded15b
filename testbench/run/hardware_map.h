#pragma once
#include <array>
#include <string>
#include <vector>

#include "golden/files/ptm_map.h"
#include "model/quantize/balance.h"
#include "model/quantize/import.h"
#include "model/quantize/quantize.h"
#include "model/reference/texture_words.h"

namespace ptm::testbench {

/// A map as the hardware holds it, and how it got there.
struct HardwareMap {
  reference::StoredTexture texture;
  quantize::Origin origin = quantize::Origin::verbatim;
  std::string how;  ///< one sentence for the user
};

/// Real coefficients [texel][polynomials][6] of a map, in levels. A lum map becomes three
/// polynomials: a0..a4 times the matrix' Y column, the chroma and the offset added to a5
/// (HPL-98-131, section 3).
struct RealCoefficients {
  std::size_t polynomials = 1;
  std::vector<double> coef;
};
[[nodiscard]] RealCoefficients real_polynomials(const golden::PtmMap& map);
[[nodiscard]] RealCoefficients real_polynomials(const golden::PtmMap& map, std::size_t texel);
/// The same with an lrgb map's colour multiplied in: three polynomials whatever the kind.
[[nodiscard]] RealCoefficients rgb_polynomials(const golden::PtmMap& map);

/// The file's integers unchanged, or why this hardware cannot hold them.
[[nodiscard]] quantize::Import import_map(const golden::PtmMap& map,
                                          const reference::EvalConfig& config);

/// What is quantised where a map cannot be taken verbatim: an lrgb map's colours have taken up
/// luminance that the hardware could not hold under lights anywhere on the hemisphere
/// (model/quantize/balance.h).
struct QuantizerInput {
  RealCoefficients real;
  std::vector<std::uint8_t> color;  ///< [texel][3], lrgb only
  quantize::Balance balance;
};
[[nodiscard]] QuantizerInput quantizer_input(const golden::PtmMap& map,
                                             const reference::EvalConfig& config);

/// What to say if storing a map changed the luminance by more than a picture's 255 levels, as root
/// mean square; empty if not.
[[nodiscard]] std::string beyond_hardware(double rms_error);

/// Throws InputError (`file`) if storing a map changed the luminance by more than all of a
/// picture's levels, as root mean square: then its coefficients are outside of what the hardware
/// can hold, and its picture would have nothing to do with the map's.
void require_held(double rms_error, const std::string& file);

/// Lights to balance luminance for: 256 directions down to the horizon, (lu, lv).
[[nodiscard]] std::vector<std::array<double, 2>> hemisphere_lights();

/// Stores a map for a configuration: verbatim where the file allows it, otherwise quantised by
/// `method` over lights spread evenly on the hemisphere. Throws InputError (`file`) as
/// require_held() does.
[[nodiscard]] HardwareMap store_map(const golden::PtmMap& map, const reference::EvalConfig& config,
                                    quantize::Method method = quantize::Method::nearest_plane,
                                    const std::string& file = "the map");

/// A stored map as a file's map, scale 2^-shift, so that store_map() takes it verbatim.
/// Requires coefficients of at most 8 bits (std::invalid_argument); the colour as PtmMap wants it.
[[nodiscard]] golden::PtmMap to_ptm(const quantize::StoredMap& stored, golden::MapKind kind,
                                    std::vector<std::uint8_t> color);

}  // namespace ptm::testbench
