#include "testbench/run/measure_effects.h"

#include <algorithm>
#include <bit>

#include "testbench/compare/picture_difference.h"
#include "testbench/plan/effect_rows.h"
#include "testbench/rtl/variant_cache.h"
#include "testbench/run/run_unit_scene.h"
#include "testbench/run/unit_job.h"

namespace ptm::testbench {
namespace {

using golden::DrawSpec;
using golden::EffectSpec;
using golden::UnitScene;

/// The number of the first stage that an effect's pixels pass; 32 without any.
int first_stage(const std::string& effect) { return std::countr_zero(effect_row(effect).stages); }
int first_stage(const std::vector<EffectSpec>& effects) {
  int first = 32;
  for (const EffectSpec& spec : effects) first = std::min(first, first_stage(spec.effect));
  return first;
}

bool brings_color(const DrawSpec& draw) {
  return std::any_of(draw.effects.begin(), draw.effects.end(), [](const EffectSpec& spec) {
    const golden::Effect* effect = golden::find_effect(spec.effect);
    return effect && effect->brings_color;
  });
}

/// Takes an effect from a draw. A stage behind the first only changes what the first made: an
/// effect of such stages goes too if nothing is left that begins the chain.
void take_effect(const std::string& effect, DrawSpec& draw, std::vector<std::string>& together) {
  const int began = first_stage(draw.effects);
  const bool brought = draw.color < 0 && brings_color(draw);
  std::erase_if(draw.effects, [&](const EffectSpec& spec) { return spec.effect == effect; });
  if (first_stage(draw.effects) > began) {
    std::erase_if(draw.effects, [&](const EffectSpec& spec) {
      if (effect_row(spec.effect).stages == 0) return false;
      if (std::find(together.begin(), together.end(), spec.effect) == together.end()) {
        together.push_back(spec.effect);
      }
      return true;
    });
  }
  // What was combined may be gone.
  if (brought && !brings_color(draw)) draw.combine = golden::CombineMode::none;
}

/// Draws that agree become one.
void merge_draws(UnitScene& scene) {
  std::vector<DrawSpec> draws;
  std::vector<int> number;
  for (const DrawSpec& draw : scene.draws) {
    const auto found = std::find(draws.begin(), draws.end(), draw);
    number.push_back(static_cast<int>(found - draws.begin()));
    if (found == draws.end()) draws.push_back(draw);
  }
  for (golden::ObjectSpec& object : scene.objects) {
    object.draw = number[static_cast<std::size_t>(object.draw)];
  }
  scene.draws = std::move(draws);
}

std::vector<std::string> effects_of(const UnitScene& scene) {
  std::vector<std::string> names;
  for (const EffectRow& row : effect_rows()) {
    const bool named = std::any_of(scene.draws.begin(), scene.draws.end(), [&](const auto& draw) {
      return std::any_of(draw.effects.begin(), draw.effects.end(),
                         [&](const EffectSpec& spec) { return spec.effect == row.name; });
    });
    if (named) names.emplace_back(row.name);
  }
  return names;
}

EffectRun effect_run(const SceneRun& drawn) {
  const RunResult& result = drawn.result;
  EffectRun run;
  run.unit = drawn.unit;
  for (const ModelResult& model : result.models) {
    run.seconds.emplace_back(model.model, model.seconds);
  }
  if (!result.unit) return run;
  for (const UnitTiming& timing : result.unit->timings) {
    if (timing.estimate) {
      run.seconds.emplace_back("loose", timing.seconds);
    } else if (result.unit->config.counters) {
      run.counters = timing.counters;  // rtl comes last
    }
  }
  return run;
}

void add_cells(const reference::EvalConfig& config, EffectRun& run,
               std::vector<std::string>& notes) {
  try {
    run.cells = count_unit_cells(config, run.unit);
  } catch (const std::exception& error) {  // what was drawn is not to be lost for a count
    const std::string note = std::string("cells are not counted: ") + error.what();
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
}

/// Over all frames, of the first model that both runs have: golden's, else the reference's.
void compare_pictures(const RunResult& with, const RunResult& without, EffectCost& cost) {
  if (with.models.empty() || without.models.empty()) return;
  const PictureDifference difference =
      compare_frames(with.models.front().frames, without.models.front().frames);
  cost.rmse = difference.rmse;
  cost.largest = difference.max;
  cost.psnr_db = difference.psnr_db;
  cost.changed = difference.samples > 0 ? static_cast<double>(difference.differing) /
                                              static_cast<double>(difference.samples)
                                        : 0;
}

}  // namespace

ReducedScene without_effect(const UnitScene& scene, const std::string& effect) {
  ReducedScene reduced{scene, {}};
  for (DrawSpec& draw : reduced.scene.draws) {
    const bool has = std::any_of(draw.effects.begin(), draw.effects.end(),
                                 [&](const EffectSpec& spec) { return spec.effect == effect; });
    if (has) take_effect(effect, draw, reduced.together);
  }
  merge_draws(reduced.scene);
  return reduced;
}

EffectCosts measure_effects(const UnitScene& scene, const SceneRun& whole,
                            const std::function<void(const std::string&)>& say) {
  const reference::EvalConfig config = scene_eval_config(scene);
  EffectCosts costs;
  costs.with = effect_run(whole);
  add_cells(config, costs.with, costs.notes);
  for (const std::string& effect : effects_of(scene)) {
    if (say) say("drawing the scene without " + effect);
    ReducedScene reduced = without_effect(scene, effect);
    try {
      const SceneRun run = run_unit_scene(reduced.scene);
      EffectCost cost{effect, std::move(reduced.together), effect_run(run)};
      add_cells(config, cost.without, costs.notes);
      compare_pictures(whole.result, run.result, cost);
      costs.costs.push_back(std::move(cost));
    } catch (const golden::InputError& error) {  // legal only with the effect: a light, a palette
      costs.notes.push_back("the scene cannot be drawn without " + effect + ", at " +
                            error.place() + ": found " + error.found() + ", expected " +
                            error.expected());
    }
  }
  return costs;
}

}  // namespace ptm::testbench
