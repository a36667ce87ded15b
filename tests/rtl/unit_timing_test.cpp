// Sentences of docs/spec/unit-timing.md, each held against the RTL unit.
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

using pipeline::Cycle;
using pipeline::FixedMemory;
using pipeline::MemoryFault;
using reference::UnitFragment;
using reference::UnitState;
using testbench::RtlUnitPins;

constexpr int kOne = 1 << 20;  // Q8.20

/// An LRGB map of that size and nothing else.
UnitState lrgb_state(int width, int height, reference::Wrap wrap = reference::Wrap::repeat,
                     bool bilinear = true) {
  reference::StoredTexture map{width, height, false, {}, {}, {}, {}};
  const auto texels = static_cast<std::size_t>(width * height);
  map.coef.assign(texels * 6, 100);
  map.color.assign(texels * 3, 50);
  UnitState state;
  reference::Draw draw;
  draw.map = append_map(reference::kBase, std::span(&map, 1), state.memory);
  draw.wrap_u = draw.wrap_v = wrap;
  draw.bilinear = bilinear;
  state.draws.push_back(draw);
  return state;
}

/// The fragment whose tap 00 is texel (i, j), a quarter of a texel off its centre.
UnitFragment at_texel(const UnitState& state, int i, int j) {
  const auto& map = state.draws[0].map;
  UnitFragment f;
  f.u = (4 * i + 3) * kOne / (4 * map.width);
  f.v = (4 * j + 3) * kOne / (4 * map.height);
  return f;
}

class RtlUnitTiming : public testing::Test {
 protected:
  /// A frame of these fragments with everything a hit: they are drawn twice, the second counts.
  pipeline::UnitFrameResult warm(testbench::RtlUnit& unit,
                                 const std::vector<UnitFragment>& fragments) {
    (void)unit.run({.fragments = fragments}, *memory_, {});
    return unit.run({.fragments = fragments, .keep_cache = true}, *memory_, {});
  }
  /// How many copies of that fragment the unit accepts with these pins.
  std::size_t accepted(testbench::RtlUnit& unit, const UnitFragment& fragment, bool pixel_ready) {
    std::size_t count = 0;
    RtlUnitPins pins{.valid = true, .fragment = fragment, .pixel_ready = pixel_ready};
    for (int cycle = 0; cycle < 1000; ++cycle) count += unit.cycle(pins).ready;
    return count;
  }

  std::unique_ptr<pipeline::MemoryTiming> memory_ = make_memory(FixedMemory{});
  std::unique_ptr<testbench::RtlUnit> unit_ = testbench::make_rtl_unit_base3();
  testbench::RtlUnitVariant small_ = testbench::rtl_unit_variants().back();
};

TEST_F(RtlUnitTiming, AFragmentOfOneBeatWithoutMissesIsAPixel25CyclesLater) {
  const UnitState state = lrgb_state(16, 16);
  unit_->load(state);
  const auto result = warm(*unit_, {at_texel(state, 5, 5)});
  ASSERT_EQ(result.taken.size(), 1U);
  EXPECT_EQ(result.taken[0], 25U);
  EXPECT_EQ(result.counters[UnitCounter::cycles], 26U);
}

TEST_F(RtlUnitTiming, AWarmLrgbMapGivesAPixelACycle) {
  const UnitState state = lrgb_state(32, 32);
  unit_->load(state);
  std::vector<UnitFragment> fragments;
  for (int n = 0; n < 1024; ++n) fragments.push_back(at_texel(state, n % 32, n / 32));
  const auto result = warm(*unit_, fragments);
  for (std::size_t n = 0; n < fragments.size(); ++n) EXPECT_EQ(result.taken[n], 25 + n);
  EXPECT_EQ(result.counters[UnitCounter::tag_misses], 0U);
  EXPECT_EQ(result.counters[UnitCounter::bank_conflicts], 0U);
}

TEST_F(RtlUnitTiming, ALineThatArrivesInACycleIsCommittedTwoLater) {
  const UnitState state = lrgb_state(16, 16, reference::Wrap::repeat, false);
  unit_->load(state);
  const std::vector<UnitFragment> fragments{at_texel(state, 5, 5)};
  const auto slow = make_memory(FixedMemory{.latency = 50, .interval = 7});
  const auto result = unit_->run({.fragments = fragments}, *slow, {});
  // In T in cycle 5, so the first of three requests leaves in 6; a rank waits for its last line.
  EXPECT_EQ(result.answered, (std::vector<Cycle>{56, 63, 70}));
  EXPECT_EQ(result.taken[0], 70U + 2 + 25 - 7);
}

TEST_F(RtlUnitTiming, BlockedItHoldsTheFragmentFifoAnd25BeatsBesides) {
  const UnitState state = lrgb_state(16, 16);
  for (const bool small : {false, true}) {
    const auto unit = small ? small_.make() : testbench::make_rtl_unit_base3();
    unit->load(state);
    (void)warm(*unit, {at_texel(state, 5, 5)});
    const std::size_t depth = small ? 8 : 192;
    EXPECT_EQ(accepted(*unit, at_texel(state, 5, 5), false), depth + 25);
  }
}

TEST_F(RtlUnitTiming, BehindALineThatNeverComesTheFifoFillsAndSixRegisters) {
  const UnitState state = lrgb_state(16, 16);
  const auto unit = small_.make();
  unit->load(state);
  EXPECT_EQ(accepted(*unit, at_texel(state, 5, 5), true), 8U + 6);  // A0 to A3, T, K
}

TEST_F(RtlUnitTiming, TheRingHoldsRanksWholeOrNotAtAll) {
  // Point sampling misses a line in each of three TMUs a beat: four ranks fill twelve slots.
  const UnitState state = lrgb_state(64, 64, reference::Wrap::repeat, false);
  const auto unit = small_.make();
  unit->load(state);
  unit->write(0x1000, 3);
  RtlUnitPins pins{.valid = true};
  std::size_t requests = 0, sent = 0;
  for (int cycle = 0; cycle < 300; ++cycle) {
    pins.fragment = at_texel(state, static_cast<int>(sent) * 4, 0);
    const auto seen = unit->cycle(pins);
    sent += seen.ready;
    requests += seen.request;
  }
  EXPECT_EQ(requests, 12U);
  EXPECT_EQ(unit->counters()[UnitCounter::tag_misses], 15U);  // the fifth beat has looked up
}

TEST_F(RtlUnitTiming, SeamsOfOddSizesSplitABeatInTwoAndCornersInFour) {
  struct Seam {
    int width, height, i, j;
    reference::Wrap wrap;
    std::uint64_t conflicts;
  };
  using reference::Wrap;
  const std::array<Seam, 9> seams{{{15, 16, 14, 3, Wrap::repeat, 1},
                                   {16, 15, 3, 14, Wrap::repeat, 1},
                                   {15, 15, 14, 14, Wrap::repeat, 3},
                                   {12, 16, 11, 3, Wrap::repeat, 1},  // three tiles across
                                   {12, 12, 11, 11, Wrap::repeat, 3},
                                   {16, 16, 15, 15, Wrap::repeat, 0},
                                   {15, 15, 13, 13, Wrap::repeat, 0},
                                   {15, 15, 14, 14, Wrap::clamp, 0},
                                   {1, 1, 0, 0, Wrap::repeat, 0}}};
  for (const Seam& seam : seams) {
    SCOPED_TRACE(std::to_string(seam.width) + " x " + std::to_string(seam.height) + " at " +
                 std::to_string(seam.i) + ", " + std::to_string(seam.j));
    const UnitState state = lrgb_state(seam.width, seam.height, seam.wrap);
    unit_->load(state);
    const auto result = warm(*unit_, {at_texel(state, seam.i, seam.j)});
    EXPECT_EQ(result.counters[UnitCounter::bank_conflicts], seam.conflicts);
    EXPECT_EQ(result.counters[UnitCounter::beats], 1 + seam.conflicts);
    EXPECT_EQ(result.counters[UnitCounter::taps], 12U);
    EXPECT_EQ(result.counters[UnitCounter::words], 3U);
    EXPECT_EQ(result.taken[0], 25 + seam.conflicts);
  }
}

TEST_F(RtlUnitTiming, ALineInTwoTmusCachesIsCountedAsADuplicate) {
  // One picture, the second word of a palettised draw (TMU 1) and the first of a plain one (TMU 0).
  UnitState state;
  const reference::StoredPicture picture{4, 4, std::vector<std::uint8_t>(64, 9)};
  const reference::StoredPaletteMap map{4, 4, false, std::vector<std::uint16_t>(16, 1),
                                        std::vector<std::uint8_t>(48, 2)};
  reference::Draw draw;
  draw.format = reference::TextureFormat::palette_lrgb;
  draw.combine = reference::Combine::modulate;
  draw.color = true;
  draw.map = append_palette_map(std::span(&map, 1), state.memory);
  draw.color_texture = append_picture(std::span(&picture, 1), state.memory);
  state.draws.push_back(draw);
  draw.format = reference::TextureFormat::none;
  draw.combine = reference::Combine::replace;
  state.draws.push_back(draw);
  unit_->load(state);
  UnitFragment first = at_texel(state, 1, 1), second = first;
  second.draw = 1;
  const std::vector<UnitFragment> fragments{first, second, second, first};
  const auto result = unit_->run({.fragments = fragments}, *memory_, {});
  EXPECT_EQ(result.counters[UnitCounter::duplicate_lines], 1U);
  EXPECT_EQ(result.counters[UnitCounter::tag_misses], 3U);
  reference::UnitCounters c = result.counters;
  EXPECT_EQ(c.misses(0, 0), 1U);
  EXPECT_EQ(c.misses(0, 1), 1U);
  EXPECT_EQ(c.misses(1, 1), 1U);
  EXPECT_EQ(c.hits(1, 1), 1U);
  EXPECT_EQ(c.hits(0, 0), 1U);
}

TEST_F(RtlUnitTiming, IdleCyclesBetweenTwoFragmentsCountAsInputEmpty) {
  const UnitState state = lrgb_state(16, 16);
  unit_->load(state);
  const std::vector<UnitFragment> fragments(2, at_texel(state, 5, 5));
  (void)warm(*unit_, fragments);
  const auto result =
      unit_->run({.fragments = fragments, .keep_cache = true}, *memory_, {.idle = 100});
  EXPECT_EQ(result.taken, (std::vector<Cycle>{125, 226}));
  EXPECT_EQ(result.counters[UnitCounter::cycles], 127U);
  EXPECT_EQ(result.counters[UnitCounter::cycles_input_empty], 125U);
}

TEST_F(RtlUnitTiming, AMemoryThatNeverAnswersIsReportedWithCycleFragmentAndLine) {
  const UnitState state = lrgb_state(16, 16, reference::Wrap::repeat, false);
  unit_->load(state);
  std::vector<UnitFragment> fragments(2, at_texel(state, 5, 5));
  fragments[0].x = 12;
  fragments[0].y = 34;
  const auto result =
      unit_->run({.fragments = fragments}, *memory_, {}, MemoryFault{MemoryFault::Kind::never, 1});
  ASSERT_TRUE(result.fault);
  // The third line is the last transfer: requests leave in 6, 7, 8, answers come from 106 on.
  EXPECT_EQ(result.fault->cycle, 114 + pipeline::kPatience);
  EXPECT_NE(result.fault->what.find("(12, 34)"), std::string::npos) << result.fault->what;
  EXPECT_NE(result.fault->what.find("line 15"), std::string::npos) << result.fault->what;
  const auto after = unit_->run({.fragments = fragments}, *memory_, {});
  EXPECT_FALSE(after.fault) << after.fault->what;
  EXPECT_EQ(after.taken.size(), 2U);
}

TEST_F(RtlUnitTiming, AResponseWithATagThatIsNotOutstandingIsReportedAtOnce) {
  const UnitState state = lrgb_state(16, 16);
  unit_->load(state);
  const std::vector<UnitFragment> fragments(2, at_texel(state, 5, 5));
  const auto result = unit_->run({.fragments = fragments}, *memory_, {},
                                 MemoryFault{MemoryFault::Kind::wrong_tag, 2});
  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->cycle, result.answered[2]);
  EXPECT_NE(result.fault->what.find("not outstanding"), std::string::npos) << result.fault->what;
  EXPECT_EQ(unit_->read(0x1003) & 2U, 2U);
  EXPECT_FALSE(unit_->run({.fragments = fragments}, *memory_, {}).fault);
}

TEST_F(RtlUnitTiming, ATagThatWasAnsweredAlreadyIsNotOutstandingEither) {
  const UnitState state = lrgb_state(16, 16, reference::Wrap::repeat, false);
  unit_->load(state);
  RtlUnitPins pins{.valid = true, .fragment = at_texel(state, 5, 5)};
  while (!unit_->cycle(pins).request) pins.valid = false;
  pins.response = true;  // to tag 0, whose request was just transferred
  (void)unit_->cycle(pins);
  EXPECT_EQ(unit_->read(0x1003) & 2U, 0U);
  (void)unit_->cycle(pins);
  EXPECT_EQ(unit_->read(0x1003) & 2U, 2U);
}

/// Thirteen slots have the numbers 0 to 15: the tags of requests go round all of them, while no
/// more than thirteen are in use.
TEST_F(RtlUnitTiming, SlotsAreNumberedModuloMissFifoRoundedUpToAMultipleOfFour) {
  const auto variants = testbench::rtl_unit_variants();
  const auto variant = std::find_if(variants.begin(), variants.end(),
                                    [](const auto& v) { return v.unit.miss_fifo % 4 != 0; });
  ASSERT_NE(variant, variants.end());
  ASSERT_EQ(variant->unit.miss_fifo, 13);
  ASSERT_EQ(variant->unit.tmus, 1);
  const auto unit = variant->make();
  const UnitState state = lrgb_state(128, 64);  // a beat at a tile's corner misses four lines
  unit->load(state);
  unit->write(0x1000, 3);
  std::vector<testbench::RtlUnitSeen> requests;
  std::size_t sent = 0, answered = 0, pixels = 0;
  const auto step = [&](bool answer) {
    RtlUnitPins pins{.valid = true};
    pins.fragment =
        at_texel(state, static_cast<int>(sent % 16) * 8 + 3, static_cast<int>(sent / 16) * 8 + 3);
    if (answer && answered < requests.size()) {
      pins.response = true;
      pins.tag = requests[answered].tag;
      pins.line = state.memory.at(requests[answered++].line);
    }
    const auto seen = unit->cycle(pins);
    sent += seen.ready;
    pixels += seen.pixel_valid;
    if (seen.request) requests.push_back(seen);
  };
  for (int cycle = 0; cycle < 200; ++cycle) step(false);
  EXPECT_EQ(requests.size(), 13U);  // and the ring is full
  for (int cycle = 0; cycle < 200; ++cycle) step(true);
  EXPECT_GT(requests.size(), 60U);
  for (std::size_t n = 0; n < requests.size(); ++n) EXPECT_EQ(requests[n].tag, n % 16) << n;
  EXPECT_GT(pixels, 10U);
  EXPECT_EQ(unit->read(0x1003) & 2U, 0U);
  RtlUnitPins beyond{.response = true, .tag = 16};
  (void)unit->cycle(beyond);
  EXPECT_EQ(unit->read(0x1003) & 0xff02U, 0x1002U);
}

/// Of a ring of which every number's bits have a meaning, all tags beyond are errors, and all below
/// that nobody waits for.
TEST_F(RtlUnitTiming, AnyTagThatNobodyWaitsForIsAnError) {
  const auto unit = small_.make();
  unit->load(lrgb_state(16, 16));
  for (unsigned tag = 0; tag < 256; ++tag) {
    unit->write(0x1000, 2);
    EXPECT_EQ(unit->read(0x1003), 0U);
    RtlUnitPins pins{.response = true, .tag = static_cast<std::uint8_t>(tag)};
    (void)unit->cycle(pins);
    EXPECT_EQ(unit->read(0x1003), tag << 8 | 2U);
  }
}

TEST_F(RtlUnitTiming, AnIllegalDrawIsRefusedAndNoFragmentAccepted) {
  UnitState state = lrgb_state(16, 16);
  state.draws[0].map.width = 0;
  try {
    unit_->load(state);
    FAIL() << "accepted";
  } catch (const testbench::RtlUnitRefusal& refusal) {
    EXPECT_EQ(refusal.status, reference::kBadSize);
  }
  EXPECT_EQ(accepted(*unit_, UnitFragment{}, true), 0U);
  unit_->load(lrgb_state(16, 16));
  EXPECT_GT(accepted(*unit_, UnitFragment{}, true), 0U);
}

}  // namespace
}  // namespace ptm::tests
