#include "testbench/report/report_json.h"

#include <algorithm>
#include <cmath>

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: the PSNR of identical pictures is null.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// [lu, lv], or what the world's light is with its three numbers.
Json light_json(const FrameLight& light) {
  if (light.kind == FrameLight::Kind::local) return {light.x, light.y};
  const bool direction = light.kind == FrameLight::Kind::direction;
  return {{direction ? "direction" : "position", {light.x, light.y, light.z}}};
}

Json scene_json(const RunResult& result) {
  Json lights = Json::array();
  for (const FrameLight& light : result.lights) lights.push_back(light_json(light));
  return {{"file", result.scene_file},  {"map", result.map_file}, {"map_format", result.map_format},
          {"preset", result.preset},    {"width", result.width},  {"height", result.height},
          {"lights", std::move(lights)}};
}

Json model_json(const ModelResult& model) {
  Json pictures = Json::array();
  for (std::size_t f = 0; f < model.frames.size(); ++f) {
    pictures.push_back(picture_name(model.model, f, model.frames.size()));
  }
  Json counters = Json::object();
  for (const Counter& counter : model.counters) counters[counter.name] = counter.value;
  return {{"picture", pictures.front()},
          {"pictures", pictures},
          {"seconds", model.seconds},
          {"cycles", model.cycles ? Json(*model.cycles) : Json(nullptr)},
          {"counters", std::move(counters)}};
}

Json difference_json(const PictureDifference& d) {
  return {{"samples", d.samples},
          {"differing", d.differing},
          {"share", d.share},
          {"max", d.max},
          {"mean", d.mean},
          {"rmse", d.rmse},
          {"psnr_db", finite_or_null(d.psnr_db)},
          {"ssim", d.ssim}};
}

Json histogram_json(const ErrorHistogram& histogram) {
  return {{"bin_width", histogram.bin_width},
          {"first_center", histogram.center(0)},
          {"counts", histogram.counts}};
}

/// Null where no sample is left, or none was left out.
Json part_json(const std::optional<PartDifference>& part) {
  if (!part) return nullptr;
  return {{"samples", part->samples}, {"differing", part->differing},
          {"max", part->max},         {"mean", part->mean},
          {"rmse", part->rmse},       {"psnr_db", finite_or_null(part->psnr_db)}};
}

Json pair_json(const PairDifference& pair) {
  Json json = {{"a", pair.a}, {"b", pair.b}};
  json.update(difference_json(pair.difference));
  json["off_edges"] = part_json(pair.off_edges);
  json["histogram"] = histogram_json(pair.difference.histogram);
  return json;
}

Json preset_json(const PresetDifference& preset) {
  Json json = {{"preset", preset.preset}, {"against", "golden"}};
  json.update(difference_json(preset.difference));
  json["off_edges"] = part_json(preset.off_edges);
  return json;
}

Json pixel_json(const ProbedPixel& pixel) {
  Json models = Json::object();
  for (const PixelValues& model : pixel.models) {
    Json values = Json::object();
    for (const NamedValue& value : model.values) values[value.name] = value.value;
    models[model.model] = {{"rgb", model.rgb}, {"values", std::move(values)}};
  }
  return {{"frame", pixel.where.frame}, {"x", pixel.where.x},
          {"y", pixel.where.y},         {"pair", Json::array({pixel.a, pixel.b})},
          {"error", pixel.where.error}, {"models", std::move(models)}};
}

}  // namespace

std::string picture_name(const std::string& model, std::size_t frame, std::size_t frames) {
  if (frames < 2) return model + ".png";
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(frames - 1).size());
  const std::string number = std::to_string(frame);
  return model + "_" + std::string(digits - number.size(), '0') + number + ".png";
}

Json report_json(const RunResult& result, const RunComparison& comparison) {
  Json json = {{"version", 1}, {"scene", scene_json(result)}, {"models", Json::object()}};
  for (const ModelResult& model : result.models) json["models"][model.model] = model_json(model);
  json["agree"] = comparison.models_agree();
  json["edge_samples"] = comparison.edge_samples;
  for (const char* list : {"differences", "presets", "worst"}) json[list] = Json::array();
  for (const PairDifference& pair : comparison.pairs) {
    json["differences"].push_back(pair_json(pair));
  }
  for (const PresetDifference& preset : comparison.presets) {
    json["presets"].push_back(preset_json(preset));
  }
  for (const ProbedPixel& pixel : comparison.worst) json["worst"].push_back(pixel_json(pixel));
  if (result.unit) json["unit"] = unit_json(*result.unit);
  if (result.costs) json["effects"] = effect_costs_json(*result.costs);
  json["notes"] = result.notes;
  return json;
}

}  // namespace ptm::testbench
