// The register port of the whole unit as a driver sees it: docs/spec/unit.md, Registers. What was
// written and can be read, what the unit says of itself, writes that come while fragments are
// inside, events and the interrupt.
#include <deque>
#include <map>

#include "model/reference/unit/register_map.h"
#include "testbench/rtl/unit_probe.h"
#include "testbench/rtl/variant_cache.h"
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

namespace registers = reference::registers;
namespace events = reference::events;
using testbench::RtlUnitPins;
using testbench::RtlUnitSeen;

constexpr unsigned kAddresses = 0x10000;

/// What the unit says of itself at an address, if it is one of those.
std::optional<std::uint32_t> identity(unsigned address, const testbench::RtlUnitVariant& variant) {
  if (address == registers::kMagic) return reference::kRegisterMagic;
  if (address == registers::kVersion) return reference::kRegisterMapVersion;
  const unsigned n = address - registers::kCapabilities;
  if (n >= reference::kCapabilityWords) return std::nullopt;
  return capability_words(variant.config, variant.unit)[n];
}

/// Every address that does not read as expected; the first few are told.
template <class Expected>
void expect_reads(testbench::RtlUnit& unit, Expected expected) {
  unsigned wrong = 0;
  for (unsigned address = 0; address < kAddresses; ++address) {
    const std::uint32_t value = unit.read(static_cast<std::uint16_t>(address));
    const std::optional<std::uint32_t> right = expected(address);
    if (!right || value == *right || ++wrong > 5) continue;
    ADD_FAILURE() << std::hex << "0x" << address << " reads 0x" << value << ", expected 0x"
                  << *right;
  }
  EXPECT_EQ(wrong, 0U);
}

class RtlUnitPort : public testing::TestWithParam<testbench::RtlUnitVariant> {
 protected:
  std::unique_ptr<testbench::RtlUnit> unit_ = GetParam().make();
};

TEST_P(RtlUnitPort, IsBuiltWithTheParametersOfItsConfiguration) {
  std::uint8_t number = testbench::unit_probe::kParameters;
  for (const std::string& parameter :
       testbench::rtl_parameters(GetParam().config, GetParam().unit)) {
    const int value = static_cast<int>(unit_->probe(number++));
    const std::size_t at = parameter.find('=');
    EXPECT_EQ(value, std::stoi(parameter.substr(at + 1))) << parameter;
  }
  EXPECT_EQ(number - testbench::unit_probe::kParameters, 26);
}

TEST_P(RtlUnitPort, ReadsAsZeroAfterResetButForWhatTheUnitSaysOfItself) {
  for (int round = 0; round < 2; ++round) {
    unit_->reset(true);
    (void)unit_->cycle({});  // by then it knows that the memory owes nothing
    expect_reads(*unit_,
                 [](unsigned address) { return identity(address, GetParam()).value_or(0); });
    for (unsigned address = 0; address < kAddresses; ++address) {
      unit_->write(static_cast<std::uint16_t>(address), 0xffffffff);
    }
  }
}

TEST_P(RtlUnitPort, ReadsBackWhatWasWrittenWhereSomethingIsStoredAndZeroElsewhere) {
  std::mt19937 rng(9);
  for (int round = 0; round < 2; ++round) {
    unit_->reset(true);
    std::vector<std::uint32_t> data(kAddresses);
    for (unsigned address = kAddresses; address-- > 0;) {
      data[address] = static_cast<std::uint32_t>(rng());
      unit_->write(static_cast<std::uint16_t>(address), data[address]);
    }
    for (int cycle = 0; cycle < 4 * 27; ++cycle) (void)unit_->cycle({});
    EXPECT_EQ(unit_->read(registers::kErrors) & ~0x0f0f0f0fU, 0U);
    EXPECT_EQ(unit_->read(registers::kEvents) & ~events::kDrawError, 0U);
    expect_reads(*unit_, [&](unsigned address) -> std::optional<std::uint32_t> {
      if (address == registers::kErrors || address == registers::kEvents) return std::nullopt;
      if (const auto said = identity(address, GetParam())) return said;
      return data[address] &
             stored_bits(static_cast<std::uint16_t>(address), GetParam().unit, GetParam().config);
    });
  }
}

/// A frame by its pins: fragments with gaps, pixels with stalls, answers in order.
class PortFrame {
 public:
  PortFrame(testbench::RtlUnit& unit, const reference::UnitState& state,
            const std::vector<reference::UnitFragment>& fragments, std::uint64_t seed)
      : unit_(unit), state_(state), fragments_(fragments), rng_(seed) {}

  [[nodiscard]] bool over() const { return pixels_.size() == fragments_.size(); }
  [[nodiscard]] std::size_t inside() const { return accepted_ - pixels_.size(); }
  [[nodiscard]] const std::vector<reference::UnitPixel>& pixels() const { return pixels_; }
  bool one_in(unsigned n) { return rng_() % n == 0; }

  struct Moved {
    bool accepted = false, taken = false;
    bool interrupt = false;  ///< as seen before the edge
  };
  /// A cycle with that write, if there is one. A response with a tag that nobody waits for can only
  /// come in a cycle without another one.
  Moved cycle(const std::optional<reference::RegisterWrite>& write,
              std::optional<std::uint8_t> stray = std::nullopt) {
    RtlUnitPins pins;
    pins.write = write;
    // Now and then the next fragment comes only when all the others are out.
    if (!offered_ && inside() == 0) pauses_ = false;
    if (!offered_ && !pauses_) {
      offered_ = accepted_ < fragments_.size() && (accepted_ == 0 || !one_in(3));
      pauses_ = offered_ && one_in(4);
    }
    pins.valid = offered_;
    if (pins.valid) pins.fragment = fragments_[accepted_];
    pins.pixel_ready = !one_in(3);
    pins.response = stray || (!due_.empty() && due_.front().first <= cycle_);
    if (stray) {
      pins.tag = *stray;
    } else if (pins.response) {
      pins.tag = due_.front().second.tag;
      pins.line = state_.memory.at(due_.front().second.line);
      due_.pop_front();
    }
    const RtlUnitSeen seen = unit_.cycle(pins);
    Moved moved{pins.valid && seen.ready, pins.pixel_ready && seen.pixel_valid, seen.interrupt};
    if (moved.accepted) {
      ++accepted_;
      offered_ = false;
    }
    if (moved.taken) pixels_.push_back(seen.pixel);
    if (seen.request) due_.push_back({cycle_ + 20, seen});
    ++cycle_;
    return moved;
  }

 private:
  testbench::RtlUnit& unit_;
  const reference::UnitState& state_;
  const std::vector<reference::UnitFragment>& fragments_;
  std::mt19937_64 rng_;
  std::vector<reference::UnitPixel> pixels_;
  std::deque<std::pair<std::uint64_t, RtlUnitSeen>> due_;
  std::uint64_t cycle_ = 0;
  std::size_t accepted_ = 0;
  bool offered_ = false, pauses_ = false;
};

/// An address that fragments read, and random data.
reference::RegisterWrite spoiling_write(PortFrame& frame, std::mt19937& rng) {
  const auto data = static_cast<std::uint32_t>(rng());
  const auto at = [&](unsigned first, unsigned count) {
    return reference::RegisterWrite{static_cast<std::uint16_t>(first + rng() % count), data};
  };
  if (frame.one_in(2)) return at(0, 256);
  switch (rng() % 6) {
    case 0:
      return at(registers::kSets, 128);
    case 1:
      return at(registers::kTables, 1024);
    case 2:
      return at(registers::kLrgbPalettes, 2048);
    case 3:
      return at(registers::kRgbPalette, 32768);
    case 4:
      return {registers::kMemoryLines, data};
    default:
      return {registers::kCommand, registers::kInvalidate};
  }
}

TEST_P(RtlUnitPort, IgnoresWritesOfWhatFragmentsReadWhileTheyAreInsideAndSaysSo) {
  UnitSceneMaker make(31);
  const UnitScene scene = make.scene(GetParam().config, GetParam().unit);
  const auto fragments = random_fragments(make, scene, 40);
  std::mt19937 rng(4);
  unit_->load(scene.state);
  const auto read_all = [this] {
    std::vector<std::uint32_t> values;
    for (unsigned address = 0; address < registers::kTables; ++address) {
      if (stored_bits(static_cast<std::uint16_t>(address), GetParam().unit, GetParam().config) == 0)
        continue;
      values.push_back(unit_->read(static_cast<std::uint16_t>(address)));
    }
    return values;
  };
  const auto before = read_all();
  for (const bool spoil : {false, true}) {
    unit_->write(registers::kCommand, registers::kInvalidate | registers::kClear);
    PortFrame frame(*unit_, scene.state, fragments, 8);
    unsigned writes = 0;
    for (bool first = true; !frame.over(); first = false) {
      // The first fragment is accepted in the first cycle, in which nothing is inside yet.
      const bool writes_now = spoil && (first || (frame.inside() > 0 && frame.one_in(2)));
      writes += writes_now;
      const auto moved =
          frame.cycle(writes_now ? std::optional(spoiling_write(frame, rng)) : std::nullopt);
      if (!first) continue;
      EXPECT_TRUE(moved.accepted);
      EXPECT_EQ(unit_->read(registers::kEvents), spoil ? events::kIdle | events::kRefused : 0U);
    }
    expect_pixels(scene, fragments, frame.pixels());
    EXPECT_EQ(unit_->read(registers::kEvents), events::kIdle | (spoil ? events::kRefused : 0U));
    EXPECT_EQ(read_all(), before);
    EXPECT_GE(writes, spoil ? 40U : 0U);
  }
  // Idle again, the unit takes them.
  unit_->write(registers::kEvents, events::kAll);
  unit_->write(5, 0x00150123);
  EXPECT_EQ(unit_->read(5), 0x00150123U);
  EXPECT_EQ(unit_->read(registers::kEvents), 0U);
}

TEST_P(RtlUnitPort, HasNoUpperBitsOfPalettesWhereThreeCoefficientsFitAWrite) {
  UnitSceneMaker make(32);
  const UnitScene scene = make.scene(GetParam().config, GetParam().unit);
  ASSERT_LE(GetParam().config.coef_bits, 10);
  unit_->load(scene.state);
  RtlUnitPins pins{.valid = true, .fragment = make.fragment(scene)};
  pins.write = reference::RegisterWrite{registers::kPaletteUpper, 9};
  ASSERT_TRUE(unit_->cycle(pins).ready);
  EXPECT_EQ(unit_->read(registers::kPaletteUpper), 0U);
  EXPECT_EQ(unit_->read(registers::kEvents), 0U) << "an address that holds nothing refuses nothing";
}

/// The event and the enable register as the page describes them, stepped beside the unit.
struct SteppedEvents {
  std::uint32_t bits = 0, enable = 0;
  [[nodiscard]] bool interrupt() const { return (bits & enable) != 0; }
  void edge(std::uint32_t causes, const std::optional<reference::RegisterWrite>& write) {
    if (write && write->address == registers::kEvents) bits &= ~write->data;
    if (write && write->address == registers::kEnable) enable = write->data & events::kAll;
    bits |= causes;
  }
};

TEST_P(RtlUnitPort, RaisesEventsAndTheInterruptInTheCycleAfterTheirCause) {
  UnitSceneMaker make(33);
  const UnitScene scene = make.scene(GetParam().config, GetParam().unit);
  const auto fragments = random_fragments(make, scene, 60);
  std::mt19937 rng(6);
  unit_->load(scene.state);
  SteppedEvents stepped;
  PortFrame frame(*unit_, scene.state, fragments, 2);
  std::map<std::uint32_t, unsigned> raised, kept;  // by cause; kept: cleared in the same cycle
  const auto step = [&](const std::optional<reference::RegisterWrite>& write,
                        std::optional<std::uint8_t> stray) {
    const std::size_t inside = frame.inside();
    const PortFrame::Moved moved = frame.cycle(write, stray);
    EXPECT_EQ(moved.interrupt, stepped.interrupt());
    std::uint32_t causes = 0;
    if (moved.taken && inside == 1 && !moved.accepted) causes |= events::kIdle;
    if (stray) causes |= events::kWrongTag;
    if (write && write->address < 0x100 && (inside > 0 || moved.accepted)) {
      causes |= events::kRefused;
    }
    for (std::uint32_t cause = 1; cause <= events::kAll; cause *= 2) {
      raised[cause] += (causes & cause) != 0;
      kept[cause] += (causes & cause) != 0 && write && write->address == registers::kEvents &&
                     (write->data & cause) != 0;
    }
    stepped.edge(causes, write);
    EXPECT_EQ(unit_->read(registers::kEvents), stepped.bits);
    EXPECT_EQ(unit_->read(registers::kEnable), stepped.enable);
  };
  while (!frame.over()) {
    std::optional<reference::RegisterWrite> write;
    const auto data = static_cast<std::uint32_t>(rng());
    if (frame.one_in(2)) write = {registers::kEvents, data};
    if (frame.one_in(8)) write = {registers::kEnable, data};
    if (frame.inside() > 0 && frame.one_in(8)) write = {7, data};
    std::optional<std::uint8_t> stray;
    if (frame.one_in(9)) stray = static_cast<std::uint8_t>(255);  // above any slot's number
    step(write, stray);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
  expect_pixels(scene, fragments, frame.pixels());
  for (const std::uint32_t cause : {events::kIdle, events::kWrongTag, events::kRefused}) {
    EXPECT_GT(raised[cause], 2U) << cause;
  }
  EXPECT_GT(kept[events::kIdle], 0U);
  EXPECT_GT(kept[events::kWrongTag], 0U);
  // Nothing else raises one: an idle unit stays silent.
  stepped.edge(0, std::nullopt);
  for (int cycle = 0; cycle < 40; ++cycle) {
    EXPECT_EQ(unit_->cycle({}).interrupt, stepped.interrupt());
  }
  unit_->write(registers::kEnable, events::kAll);
  unit_->reset(true);
  EXPECT_FALSE(unit_->cycle({}).interrupt);
  EXPECT_EQ(unit_->read(registers::kEvents), 0U);
  EXPECT_EQ(unit_->read(registers::kEnable), 0U);
}

TEST_P(RtlUnitPort, RaisesTheDrawErrorWhenTheCheckHasEnded) {
  unit_->reset(true);
  unit_->write(registers::kEnable, events::kDrawError);
  unit_->write(0, 7);  // a format of no meaning
  int cycle = 1;
  while (cycle < 100 && !unit_->cycle({}).interrupt) ++cycle;
  EXPECT_EQ(cycle, 1 + 26 + 1);  // it waits, is looked at, and the result stands
  const std::uint32_t errors = reference::kBadSize | reference::kBadLevels | reference::kBadControl;
  EXPECT_EQ(unit_->read(registers::kErrors), errors);
  EXPECT_EQ(unit_->read(registers::kState), 0U);
  unit_->write(registers::kEvents, events::kDrawError);
  EXPECT_FALSE(unit_->cycle({}).interrupt);
  EXPECT_EQ(unit_->read(registers::kErrors), errors)
      << "the errors are the draw's, not the event's";
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlUnitPort, testing::ValuesIn(unit_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
