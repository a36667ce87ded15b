#include "testbench/plan/scene_plan.h"

#include <algorithm>
#include <bit>
#include <functional>

#include "golden/files/figure_text.h"
#include "model/reference/unit/unit_beats.h"
#include "testbench/plan/effect_rows.h"
#include "testbench/plan/golden_codes.h"

namespace ptm::testbench {
namespace {

using reference::Draw;
using reference::TextureFormat;
using reference::UnitConfig;
using reference::UnitCounter;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// A descriptor that lacks addresses and grids: what a fragment counts does not depend on them.
Draw outline(const golden::DrawSpec& spec, const golden::UnitScene& scene,
             const golden::LoadedTextures& textures, const golden::DrawExtras& extras) {
  constexpr int side = 64, levels = 7;  // any size of which no seam splits a beat
  Draw draw;
  draw.format = TextureFormat::none;
  if (spec.map >= 0) {
    draw.format = reference::map_format(textures[index(spec.map)].polynomials == 3,
                                        scene.textures[index(spec.map)].palette != 0);
  }
  draw.color = spec.color >= 0;
  draw.bilinear = spec.filter.bilinear;
  draw.mip = mip_of(spec.filter.mip);
  draw.combine = combine_of(spec.combine);
  draw.map = {.width = side, .height = side, .levels = levels};
  draw.color_texture = draw.map;
  draw.effects = planned_effects(spec, extras);
  return draw;
}

/// Between texels in both directions, so that all four taps are fetched.
reference::UnitFragment off_centre(bool levels_apart, int probes_log2) {
  constexpr std::int32_t place = (20 << 14) + (5 << 11);
  reference::UnitFragment fragment;
  fragment.u = fragment.v = place;
  fragment.probes_log2 = static_cast<std::uint8_t>(probes_log2);
  if (levels_apart) fragment.lod = 256 + 100;
  return fragment;
}

/// Cycles that a footprint's first beat stays for its palette's look-ups, beyond the first.
int look_ups_more(const Draw& draw, const UnitConfig& unit, const reference::Footprint& footprint) {
  const int ports = reference::palette_ports(draw.format, unit);
  if (ports == 0 || !footprint.fetched) return 0;
  return (std::popcount(footprint.taps()) + ports - 1) / ports - 1;
}

PixelCost pixel_cost(const reference::EvalConfig& config, const Draw& draw, const UnitConfig& unit,
                     const reference::UnitFragment& fragment) {
  reference::UnitCounters counters;
  count_fragment(draw, fragment, unit, counters, config);
  PixelCost cost;
  cost.footprints = reference::footprint_count(draw, fragment);
  cost.probes = 1 << fragment.probes_log2;
  cost.words = counters[UnitCounter::words];
  cost.taps = counters[UnitCounter::taps];
  cost.address = counters[UnitCounter::multiplies_address];
  cost.filter = counters[UnitCounter::multiplies_filter];
  cost.eval = counters[UnitCounter::multiplies_eval];
  cost.combine = counters[UnitCounter::multiplies_combine];
  cost.effects = counters[UnitCounter::multiplies_effects];
  cost.cycles = warm_cycles(draw, unit, fragment, config);
  return cost;
}

std::vector<std::string> stage_names(unsigned mask) {
  std::vector<std::string> names;
  for (const StageRow& stage : stage_rows()) {
    if ((mask >> stage.number & 1U) != 0) names.emplace_back(stage.id);
  }
  return names;
}

PlannedDraw plan_draw(const golden::DrawSpec& spec, const Draw& draw,
                      const golden::LoadedTextures& textures, const reference::EvalConfig& config,
                      const UnitConfig& unit) {
  PlannedDraw planned;
  if (spec.map >= 0) planned.map = textures[index(spec.map)].name;
  if (spec.color >= 0) planned.color = textures[index(spec.color)].name;
  for (const golden::EffectSpec& effect : spec.effects) planned.effects.push_back(effect.effect);
  planned.words = draw_words(draw, config);
  planned.passes = draw_passes(draw);
  planned.extra_passes = draw.effects.passes;
  planned.stages = stage_names(draw.effects.stages);
  int probes_log2 = 0;
  while (1 << probes_log2 < spec.probes) ++probes_log2;
  planned.least = pixel_cost(config, draw, unit, off_centre(false, 0));
  planned.most =
      pixel_cost(config, draw, unit, off_centre(draw.mip == reference::Mip::linear, probes_log2));
  return planned;
}

/// Names of the scene's effects of which a draw has one that `asks`.
std::vector<std::string> asking(const golden::UnitScene& scene,
                                const std::function<bool(const EffectRow&)>& asks) {
  std::vector<std::string> names;
  for (const EffectRow& row : effect_rows()) {
    const bool named =
        std::any_of(scene.draws.begin(), scene.draws.end(), [&](const golden::DrawSpec& draw) {
          return std::any_of(draw.effects.begin(), draw.effects.end(),
                             [&](const golden::EffectSpec& e) { return e.effect == row.name; });
        });
    if (named && asks(row)) names.emplace_back(row.name);
  }
  return names;
}

std::string counted(int n, const std::string& one) { return golden::count_of(n, one); }

std::vector<PlannedBlock> plan_blocks(const golden::UnitScene& scene, const UnitConfig& unit) {
  std::vector<PlannedBlock> blocks;
  if (unit.half_vector) {
    blocks.push_back({"half_vector", "a half-vector beside every fragment",
                      asking(scene, [](const EffectRow& row) { return row.half; })});
  }
  if (unit.extra_sets > 0) {
    blocks.push_back({"extra_sets", counted(unit.extra_sets, "coefficient set"),
                      asking(scene, [](const EffectRow& row) { return row.sets > 0; })});
  }
  if (unit.extra_passes > 0) {
    blocks.push_back({"extra_passes", counted(unit.extra_passes, "evaluator pass"),
                      asking(scene, [](const EffectRow& row) { return row.passes > 0; })});
  }
  for (const StageRow& stage : stage_rows()) {
    if ((unit.stages >> stage.number & 1U) == 0) continue;
    blocks.push_back(
        {stage.id, "a stage behind the combine stage", asking(scene, [&](const EffectRow& row) {
           return (row.stages >> stage.number & 1U) != 0;
         })});
  }
  return blocks;
}

}  // namespace

reference::DrawEffects planned_effects(const golden::DrawSpec& spec,
                                       const golden::DrawExtras& extras) {
  reference::DrawEffects effects;
  effects.sets = static_cast<int>(extras.sets.size());
  effects.passes = static_cast<int>(extras.passes.size());
  if (effects.sets > reference::kExtraSets || effects.passes > reference::kExtraPasses) {
    throw std::length_error("a draw's effects ask for more than the unit can be built with");
  }
  for (std::size_t k = 0; k < extras.passes.size(); ++k) {
    effects.pass[k] = {extras.passes[k].set, extras.passes[k].half};
  }
  for (const golden::EffectSpec& effect : spec.effects) {
    effects.stages |= effect_row(effect.effect).stages;
  }
  effects.argument = extras.argument;
  return effects;
}

int warm_cycles(const Draw& draw, const UnitConfig& unit, const reference::UnitFragment& fragment,
                const reference::EvalConfig& config) {
  const int groups = (draw_words(draw, config) + unit.tmus - 1) / unit.tmus;
  const int probes = 1 << fragment.probes_log2;
  int beats = 0;
  for (int probe = 0; probe < probes; ++probe) {
    for (int f = 0; f < reference::footprint_count(draw, fragment); ++f) {
      beats += groups + look_ups_more(draw, unit, make_footprint(draw, fragment, 0, probe, f));
    }
  }
  const int own = (draw_passes(draw) + unit.eval_lanes - 1) / unit.eval_lanes;
  return std::max(beats, own + draw.effects.passes);
}

ScenePlan plan_scene(const golden::UnitScene& scene, const golden::LoadedTextures& textures,
                     const std::vector<golden::DrawExtras>& extras,
                     const reference::EvalConfig& config, const UnitConfig& unit) {
  ScenePlan plan;
  plan.unit = unit;
  std::vector<Draw> draws;
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    draws.push_back(outline(scene.draws[d], scene, textures, extras[d]));
    const reference::DrawEffects& effects = draws.back().effects;
    plan.unit.extra_sets = std::max(plan.unit.extra_sets, effects.sets);
    plan.unit.extra_passes = std::max(plan.unit.extra_passes, effects.passes);
    plan.unit.stages |= effects.stages;
    for (int k = 0; k < effects.passes; ++k) plan.unit.half_vector |= effects.pass[index(k)].half;
  }
  for (std::size_t d = 0; d < draws.size(); ++d) {
    plan.draws.push_back(plan_draw(scene.draws[d], draws[d], textures, config, plan.unit));
  }
  plan.blocks = plan_blocks(scene, plan.unit);
  return plan;
}

}  // namespace ptm::testbench
