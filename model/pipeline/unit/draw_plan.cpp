#include "model/pipeline/unit/draw_plan.h"

#include "model/reference/effects/stages.h"
#include "model/reference/unit/texel_fields.h"

namespace ptm::pipeline {
namespace {

using reference::Combine;
using reference::Draw;
using reference::TextureFormat;
using reference::TextureLevels;

TexturePlan plan_texture(const TextureLevels& levels, int texture, int planes) {
  TexturePlan plan{.texture = texture, .planes = planes, .levels = levels.levels};
  for (int l = 0; l < levels.levels; ++l) {
    const auto at = static_cast<std::size_t>(l);
    const int width = levels.level_width(l);
    plan.level[at] = {width, levels.level_height(l), static_cast<std::uint32_t>((width + 3) >> 2),
                      levels.base[at]};
  }
  return plan;
}

void plan_beats(DrawPlan& plan, const reference::EvalConfig& eval, unsigned tmus) {
  const auto words = static_cast<unsigned>(reference::draw_words(plan.draw, eval));
  plan.beats = (words + tmus - 1) / tmus;
  for (unsigned w = 0; w < words; ++w) {
    BeatPlan& beat = plan.beat[w / tmus];
    const reference::WordUse use = reference::word_use(plan.draw, eval, static_cast<int>(w));
    const WordPlan word{static_cast<std::uint32_t>(use.texture),
                        static_cast<std::uint32_t>(use.plane)};
    beat.word[beat.words++] = word;
    plan.readers[word.texture][plan.words_of[word.texture]++] = {w % tmus, word.plane};
    ++beat.words_of[word.texture];
    beat.filter_fields[word.texture] += use.fields;
  }
  for (unsigned b = 0; b < plan.beats; ++b) {
    BeatPlan& beat = plan.beat[b];
    beat.address_multiplies = (beat.words_of[0] != 0 ? 4U : 0U) + (beat.words_of[1] != 0 ? 4U : 0U);
    plan.address_multiplies += beat.address_multiplies;
    for (std::size_t t = 0; t < 2; ++t) {
      plan.filter_fields[t] += beat.filter_fields[t];
    }
  }
}

}  // namespace

DrawPlan plan_draw(const Draw& draw, const reference::UnitConfig& unit,
                   const reference::EvalConfig& eval) {
  DrawPlan plan;
  plan.draw = draw;
  if (draw.format != TextureFormat::none) {
    plan.texture[plan.texture_count++] =
        plan_texture(draw.map, 0, reference::array_planes(draw, eval));
  }
  if (draw.color) plan.texture[plan.texture_count++] = plan_texture(draw.color_texture, 1, 1);
  plan_beats(plan, eval, static_cast<unsigned>(unit.tmus));
  const auto lanes = static_cast<unsigned>(unit.eval_lanes);
  const auto passes = static_cast<unsigned>(reference::draw_passes(draw));
  plan.passes = (passes + lanes - 1) / lanes;
  plan.palette_ports = static_cast<unsigned>(reference::palette_ports(draw.format, unit));
  plan.beat[0].palette_ports = plan.palette_ports;  // the map's only own word is word 0
  plan.extra_passes = static_cast<unsigned>(draw.effects.passes);
  plan.effects = plan.extra_passes != 0 || unit.stages != 0;
  plan.beats_alone = plan.passes == 1 && plan.palette_ports == 0 && !plan.effects;
  plan.eval_multiplies = reference::format_row(draw.format).multiplies + 8 * plan.extra_passes;
  plan.effect_multiplies = reference::effects::stage_multiplies(eval, draw);
  constexpr std::array<unsigned, 6> kCombine{0, 3, 6, 6, 0, 0};
  plan.combine_multiplies = kCombine[static_cast<std::size_t>(draw.combine)];
  return plan;
}

std::vector<DrawPlan> plan_draws(const std::vector<Draw>& draws, const reference::UnitConfig& unit,
                                 const reference::EvalConfig& eval) {
  std::vector<DrawPlan> plans;
  plans.reserve(draws.size());
  for (const Draw& draw : draws) plans.push_back(plan_draw(draw, unit, eval));
  return plans;
}

}  // namespace ptm::pipeline
