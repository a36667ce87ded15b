#pragma once
#include "golden/scene/unit_scene.h"
#include "model/reference/unit/draw.h"

/// Enumerations of scenes, which golden has of its own since it knows nothing of models, as the
/// registers' codes (contract/registers.toml).
namespace ptm::testbench {

namespace codes {
template <class Own, class Code>
constexpr bool same(Own own, Code code) {
  return static_cast<int>(own) == static_cast<int>(code);
}
template <class Code>
constexpr int count(Code last) {
  return static_cast<int>(last) + 1;
}

using golden::CombineMode, golden::MipMode, golden::WrapMode;
using reference::Combine, reference::Mip, reference::Wrap;
static_assert(same(MipMode::none, Mip::none) && same(MipMode::nearest, Mip::nearest) &&
              same(MipMode::linear, Mip::linear) && count(contract::kLastMip) == 3);
static_assert(same(WrapMode::repeat, Wrap::repeat) && same(WrapMode::mirror, Wrap::mirror) &&
              same(WrapMode::clamp, Wrap::clamp) && count(contract::kLastWrap) == 3);
static_assert(same(CombineMode::none, Combine::none) &&
              same(CombineMode::modulate, Combine::modulate) &&
              same(CombineMode::decal, Combine::decal) &&
              same(CombineMode::blend, Combine::blend) && same(CombineMode::add, Combine::add) &&
              same(CombineMode::replace, Combine::replace) && count(contract::kLastCombine) == 6);
}  // namespace codes

[[nodiscard]] constexpr reference::Mip mip_of(golden::MipMode mode) {
  return static_cast<reference::Mip>(mode);
}
[[nodiscard]] constexpr reference::Wrap wrap_of(golden::WrapMode mode) {
  return static_cast<reference::Wrap>(mode);
}
[[nodiscard]] constexpr reference::Combine combine_of(golden::CombineMode mode) {
  return static_cast<reference::Combine>(mode);
}

}  // namespace ptm::testbench
