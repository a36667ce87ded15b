// Draws that are written while fragments are offered, and written again while they are checked:
// docs/spec/unit.md, Registers.
#include "tests/rtl/draw_check_drive.h"
#include "tests/rtl/small_scenes.h"
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

namespace registers = reference::registers;

/// A small unit and two states of the same memory whose draws differ in what makes a pixel.
class RtlUnitDrawCheck : public testing::TestWithParam<testbench::RtlUnitVariant> {
 protected:
  RtlUnitDrawCheck() {
    const SmallScene scene{.name = "Checked", .combine = reference::Combine::modulate, .draws = 4};
    world_ = make_small_world(scene, GetParam(), 12);
    unit_->load(world_.state);
    other_ = world_.state;
    for (reference::Draw& draw : other_.draws) {
      draw.combine = reference::Combine::add;
      draw.wrap_u = reference::Wrap::mirror;
      draw.bilinear = false;
      for (auto& b : draw.bias) b /= 3;
      draw.ka += 77;
    }
    EXPECT_NE(pixels_of(world_.state), pixels_of(other_));
  }

  std::vector<reference::UnitPixel> pixels_of(const reference::UnitState& state) const {
    std::vector<reference::UnitPixel> pixels(world_.fragments.size());
    shade_all(GetParam().config, state, world_.fragments, pixels);
    return pixels;
  }
  DrivenFrame offer(const reference::UnitState& state, std::uint64_t limit) {
    return drive_frame(*unit_, state, world_.fragments, slots(), {.limit = limit});
  }
  [[nodiscard]] unsigned slots() const {
    return static_cast<unsigned>((GetParam().unit.miss_fifo + 3) / 4 * 4);
  }
  void write(const reference::RegisterWrite& w) { unit_->write(w.address, w.data); }

  std::unique_ptr<testbench::RtlUnit> unit_ = GetParam().make();
  SmallWorld world_;
  reference::UnitState other_;
};

/// One draw, then two, three, four: written in cycles that follow each other, they are checked one
/// after the other, and the first fragment is accepted in the cycle after the last check's end.
TEST_P(RtlUnitDrawCheck, RefusesFragmentsUntilItEndsAndDrawsThemWithTheNewValues) {
  for (std::size_t count = 1; count <= other_.draws.size(); ++count) {
    reference::UnitState state = world_.state;
    std::copy_n(other_.draws.begin(), count, state.draws.begin());
    std::vector<reference::RegisterWrite> controls;
    unit_->load(world_.state);
    for (std::size_t d = 0; d < count; ++d) {
      const DrawWrites writes(state, static_cast<int>(d));
      for (const auto& w : writes.others) write(w);
      controls.push_back(writes.control);
    }
    for (const auto& w : controls) write(w);
    const DrivenFrame frame = offer(state, 100'000);
    ASSERT_FALSE(frame.accepted.empty());
    EXPECT_EQ(frame.accepted[0], count * kCheckCycles + 1 - count);
    EXPECT_EQ(frame.pixels, pixels_of(state));
    EXPECT_EQ(unit_->read(registers::kErrors), 0U);
  }
}

TEST_P(RtlUnitDrawCheck, RefusesFragmentsWhileADrawIsIllegalUntilItIsWrittenLegalAndChecked) {
  for (int number = 0; number < 4; ++number) {
    const DrawWrites writes(other_, number);
    for (const auto& w : writes.others) write(w);
    write({writes.control.address, 7});
    const DrivenFrame refused = offer(world_.state, 300);
    EXPECT_TRUE(refused.accepted.empty()) << refused.accepted[0];
    EXPECT_TRUE(refused.requests.empty());
    EXPECT_EQ(unit_->read(registers::kErrors), reference::kBadControl << 8 * number);
    write(writes.control);
    reference::UnitState state = world_.state;
    state.draws[static_cast<std::size_t>(number)] = other_.draws[static_cast<std::size_t>(number)];
    const DrivenFrame frame = offer(state, 100'000);
    ASSERT_FALSE(frame.accepted.empty());
    EXPECT_EQ(frame.accepted[0], kCheckCycles);
    EXPECT_EQ(frame.pixels, pixels_of(state));
    unit_->load(world_.state);
  }
}

/// The second write comes in every cycle of the first one's check, of what follows it, and in the
/// one in which it starts.
class RtlUnitRewrite : public RtlUnitDrawCheck {};

TEST_P(RtlUnitRewrite, ToLegalIsAcceptedWhenTheSecondCheckHasEnded) {
  const DrawWrites writes(other_, 2);
  reference::UnitState state = world_.state;
  state.draws[2] = other_.draws[2];
  for (std::uint64_t apart = 1; apart <= 60; ++apart) {
    SCOPED_TRACE(apart);
    for (const auto& w : writes.others) write(w);
    const Rewritten seen = drive_rewrite(
        *unit_, state, world_.fragments, slots(),
        {.apart = apart, .first = {writes.control.address, 7}, .second = writes.control}, 100'000);
    EXPECT_TRUE(seen.before.accepted.empty());
    ASSERT_FALSE(seen.after.accepted.empty());
    EXPECT_EQ(seen.after.accepted[0], accepted_after(apart));
    EXPECT_EQ(seen.after.pixels, pixels_of(state));
    EXPECT_EQ(unit_->read(registers::kErrors), 0U);
  }
}

TEST_P(RtlUnitRewrite, ToIllegalIsRefusedForGood) {
  const DrawWrites writes(world_.state, 1);
  const reference::RegisterWrite bad_size{registers::kDrawStride + 1, 0};
  for (std::uint64_t apart = 1; apart <= 60; ++apart) {
    SCOPED_TRACE(apart);
    for (const auto& w : writes.others) write(w);
    Rewrite rewrite{.apart = apart,
                    .first = writes.control,
                    .second = {writes.control.address, writes.control.data | 7U},
                    .offers = apart <= kCheckCycles};
    unsigned errors = reference::kBadControl;
    if (apart % 2 == 0) {  // the control stays legal, the map has no width
      rewrite.second = writes.control;
      rewrite.between = bad_size;
      errors = reference::kBadSize | reference::kBadLevels;
    }
    const Rewritten seen =
        drive_rewrite(*unit_, world_.state, world_.fragments, slots(), rewrite, 150);
    EXPECT_TRUE(seen.before.accepted.empty());
    EXPECT_TRUE(seen.after.accepted.empty()) << seen.after.accepted[0];
    EXPECT_EQ(unit_->read(registers::kErrors), errors << 8);
  }
}

std::vector<testbench::RtlUnitVariant> small_variants() {
  std::vector<testbench::RtlUnitVariant> out;
  for (const auto& variant : unit_variants()) {
    if (variant.unit.fragment_fifo == 8) out.push_back(variant);
  }
  return out;
}
const auto kName = [](const auto& tested) { return std::string(tested.param.name); };
INSTANTIATE_TEST_SUITE_P(Units, RtlUnitDrawCheck, testing::ValuesIn(small_variants()), kName);
INSTANTIATE_TEST_SUITE_P(Units, RtlUnitRewrite, testing::ValuesIn(small_variants()), kName);

}  // namespace
}  // namespace ptm::tests
