// The memory port of the whole unit (docs/spec/unit-timing.md, Tags): answers as early and as late
// as a memory may give them, with every other port stalling at random.
#include <random>

#include "tests/rtl/pin_frame.h"
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

using testbench::RtlUnitPins;
using testbench::RtlUnitSeen;

/// A memory that answers a request in the cycle in which it is taken, or up to `latest` later, at
/// most one a cycle.
class EagerMemory {
 public:
  EagerMemory(const reference::UnitState& state, double at_once, std::size_t latest,
              std::mt19937_64& random)
      : state_(state), at_once_(at_once), latest_(latest), random_(random) {}

  /// Drives the response of a cycle in which that is asked for, and taken if `taken`.
  void respond(RtlUnitPins& pins, const RtlUnitSeen& seen, bool taken) {
    std::optional<Asked> answer;
    if (taken && std::bernoulli_distribution(at_once_)(random_)) {
      answer = Asked{seen.tag, seen.line, 0};
      ++answered_at_once;
    } else {
      const auto due = std::ranges::find_if(asked_, [](const Asked& a) { return a.wait == 0; });
      if (due != asked_.end()) {
        answer = *due;
        asked_.erase(due);
      }
      if (taken) asked_.push_back({seen.tag, seen.line, 1 + random_() % latest_});
    }
    for (Asked& a : asked_) a.wait -= a.wait != 0;
    if (!answer) return;
    pins.response = true;
    pins.tag = answer->tag;
    pins.line = state_.memory.at(answer->line);
  }

  std::size_t answered_at_once = 0;

 private:
  struct Asked {
    std::uint8_t tag;
    std::uint32_t line;
    std::size_t wait;
  };
  const reference::UnitState& state_;
  double at_once_;
  std::size_t latest_;
  std::mt19937_64& random_;
  std::vector<Asked> asked_;
};

struct Mixture {
  const char* name;
  double at_once;
  double stall;
};

struct Case {
  testbench::RtlUnitVariant variant;
  Mixture mixture;
};

class RtlUnitMemory : public testing::TestWithParam<Case> {};

TEST_P(RtlUnitMemory, MayAnswerInTheCycleOfTheRequest) {
  const auto& [variant, mixture] = GetParam();
  UnitSceneMaker make(31);
  const UnitScene scene = make.scene(variant.config, variant.unit);
  const auto fragments = random_fragments(make, scene, 400);
  std::mt19937_64 random(5);
  std::bernoulli_distribution stall(mixture.stall);
  EagerMemory memory(scene.state, mixture.at_once, 40, random);
  const auto unit = variant.make();
  unit->load(scene.state);
  unit->write(0x1000, 3);
  std::vector<reference::UnitPixel> pixels;
  std::size_t sent = 0;
  for (int cycle = 0; cycle < 200'000 && pixels.size() < fragments.size(); ++cycle) {
    const RtlUnitSeen before = unit->seen();
    RtlUnitPins pins;
    pins.valid = sent < fragments.size() && !stall(random);
    if (pins.valid) pins.fragment = fragments[sent];
    pins.pixel_ready = !stall(random);
    pins.request_ready = !stall(random);
    memory.respond(pins, before, before.request && pins.request_ready);
    const RtlUnitSeen seen = unit->cycle(pins);
    EXPECT_EQ(seen.request, before.request);  // whatever the inputs are
    sent += pins.valid && seen.ready;
    if (seen.pixel_valid && pins.pixel_ready) pixels.push_back(seen.pixel);
  }
  ASSERT_EQ(pixels.size(), fragments.size()) << "the unit hangs";
  expect_pixels(scene, fragments, pixels);
  EXPECT_GT(memory.answered_at_once, 0U);
  EXPECT_EQ(unit->read(0x1003) & 0xffffU, 0U);
  EXPECT_EQ(unit->counters()[UnitCounter::tag_misses], unit->counters()[UnitCounter::lines_read]);
}

constexpr std::array<Mixture, 3> kMixtures{
    {{"Always", 1, 0}, {"OftenWithStalls", 0.5, 0.3}, {"SeldomWithStalls", 0.1, 0.6}}};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& variant : unit_variants()) {
    for (const Mixture& mixture : kMixtures) all.push_back({variant, mixture});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Units, RtlUnitMemory, testing::ValuesIn(cases()), [](const auto& tested) {
  return std::string(tested.param.variant.name) + tested.param.mixture.name;
});

class RtlUnitFailedLines : public testing::TestWithParam<testbench::RtlUnitVariant> {};

/// A tenth of the memory cannot be read: the pixels made of such a line say so, of the frame that
/// reads it and of the next, for which it stands in the caches; the others do not.
TEST_P(RtlUnitFailedLines, MarkThePixelsThatAreMadeOfThem) {
  UnitSceneMaker make(33);
  UnitScene scene = make.scene(GetParam().config, GetParam().unit);
  std::mt19937_64 random(7);
  for (std::uint32_t line = 0; line < scene.state.memory.size(); ++line) {
    if (random() % 10 == 0) scene.state.failed.insert(line);
  }
  const auto fragments = random_fragments(make, scene, 600);
  const auto unit = GetParam().make();
  const auto memory = make_memory(pipeline::RandomMemory{.seed = 2, .latency_max = 60});
  unit->load(scene.state);
  unit->write(0x1008, ~0U);
  for (const bool again : {false, true}) {
    const auto result = unit->run({.fragments = fragments, .keep_cache = again}, *memory,
                                  {.seed = 5, .input_gap = 0.2, .output_stall = 0.3});
    ASSERT_FALSE(result.fault) << result.fault->what;
    expect_pixels(scene, fragments, result.pixels);
    const auto marked = std::ranges::count_if(result.pixels, &reference::UnitPixel::memory_failed);
    EXPECT_GT(marked, 0);
    EXPECT_LT(marked, static_cast<long>(fragments.size()));
  }
  EXPECT_EQ(unit->read(0x1003), 0U);
  EXPECT_EQ(unit->read(0x1008) & 8U, 8U);
  unit->write(0x1008, 8);
  EXPECT_EQ(unit->read(0x1008) & 8U, 0U);
}

INSTANTIATE_TEST_SUITE_P(Units, RtlUnitFailedLines, testing::ValuesIn(unit_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// An LRGB map that fits the caches, drawn point by point.
struct SmallMap {
  SmallMap() {
    reference::StoredTexture map{16, 16, false, {}, {}, {}, {}};
    map.coef.assign(std::size_t{256} * 6, 100);
    map.color.assign(std::size_t{256} * 3, 50);
    reference::Draw draw;
    draw.map = append_map(reference::kBase, std::span(&map, 1), scene.state.memory);
    draw.bilinear = false;
    scene.config = reference::kBase;
    scene.state.draws.push_back(draw);
    for (int n = 0; n < 256; ++n) {
      reference::UnitFragment f;
      f.x = static_cast<std::uint16_t>(n);
      f.u = (n % 16) << 16;
      f.v = (n / 16) << 16;
      fragments.push_back(f);
    }
  }
  UnitScene scene;
  std::vector<reference::UnitFragment> fragments;
};

/// What is in the caches stays marked when the memory has recovered, until they are invalidated,
/// and what was read well stays so when the memory fails.
TEST(RtlUnitFailedLine, StaysOneUntilTheCachesAreInvalidated) {
  SmallMap bad, good;
  bad.scene.state.failed = {0, 7, 22, 40};
  const auto unit = testbench::make_rtl_unit_base3();
  const auto memory = make_memory(pipeline::FixedMemory{.latency = 5, .interval = 1});
  const auto frame = [&](const SmallMap& from) {
    return run_pins(*unit, from.scene.state, from.fragments, *memory, {}, 100'000).pixels;
  };
  unit->load(good.scene.state);
  for (const auto& [read, recovered] : {std::pair{&bad, &good}, std::pair{&good, &bad}}) {
    unit->write(0x1000, 1);
    expect_pixels(read->scene, read->fragments, frame(*read));
    expect_pixels(read->scene, read->fragments, frame(*recovered));
    unit->write(0x1000, 1);
    expect_pixels(recovered->scene, read->fragments, frame(*recovered));
  }
}

/// A line that comes in the cycle of its request is usable two cycles later, as any line.
TEST(RtlUnitMemoryTiming, AnAnswerInTheCycleOfItsRequestIsUsableTwoLater) {
  const auto unit = testbench::make_rtl_unit_base3();
  reference::StoredTexture map{16, 16, false, {}, {}, {}, {}};
  map.coef.assign(std::size_t{256} * 6, 100);
  map.color.assign(std::size_t{256} * 3, 50);
  reference::UnitState state;
  reference::Draw draw;
  draw.map = append_map(reference::kBase, std::span(&map, 1), state.memory);
  draw.bilinear = false;
  state.draws.push_back(draw);
  unit->load(state);
  unit->write(0x1000, 3);
  std::vector<std::size_t> asked, shown;
  for (std::size_t cycle = 0; cycle < 100; ++cycle) {
    const RtlUnitSeen before = unit->seen();
    RtlUnitPins pins{.valid = cycle == 0};
    if (before.request) {
      pins.response = true;
      pins.tag = before.tag;
      pins.line = state.memory.at(before.line);
      asked.push_back(cycle);
    }
    if (unit->cycle(pins).pixel_valid) shown.push_back(cycle);
  }
  EXPECT_EQ(asked, (std::vector<std::size_t>{6, 7, 8}));
  EXPECT_EQ(shown, std::vector<std::size_t>{8 + 2 + 25 - 7});
  EXPECT_EQ(unit->read(0x1003), 0U);
}

}  // namespace
}  // namespace ptm::tests
