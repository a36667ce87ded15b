#include "testbench/report/report_json.h"

#include <algorithm>
#include <cmath>

#include "testbench/report/config_json.h"
#include "testbench/rtl/digest.h"

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
  Json pictures = Json::array(), digests = Json::array();
  for (std::size_t f = 0; f < model.frames.size(); ++f) {
    pictures.push_back(picture_name(model.model, f, model.frames.size()));
    digests.push_back(picture_digest(model.frames[f]));
  }
  Json counters = Json::object();
  for (const Counter& counter : model.counters) counters[counter.name] = counter.value;
  return {{"picture", pictures.front()},
          {"pictures", pictures},
          {"digests", digests},
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

Json made_by_json(const MadeBy& made) {
  const Invocation& program = made.invocation;
  return {{"version", program.version},
          {"commit", program.commit},
          {"sources_changed", program.changed ? Json(*program.changed) : Json(nullptr)},
          {"command", program.command},
          {"date", made.date},
          {"tools",
           {{"compiler", made.compiler}, {"verilator", made.verilator}, {"systemc", made.systemc}}},
          {"machine",
           {{"cpu", made.cpu},
            {"cores", made.cores},
            {"system", made.system},
            {"kernel", made.kernel}}}};
}

/// All wall times of a report, in seconds.
Json timing_json(const RunResult& result) {
  Json json = {{"models", Json::object()}};
  for (const ModelResult& model : result.models) json["models"][model.model] = model.seconds;
  if (result.unit) {
    json["unit"] = Json::object();
    for (const UnitTiming& timing : result.unit->timings) {
      json["unit"][timing.model] = timing.seconds;
    }
  }
  if (result.costs) json["effects"] = effect_times_json(*result.costs);
  return json;
}

}  // namespace

std::string picture_digest(const golden::ImageReal& image) {
  std::string levels;
  levels.reserve(image.samples.size());
  for (const double sample : image.samples) levels.push_back(static_cast<char>(level8(sample)));
  Digest digest;
  digest.add(std::to_string(image.width) + " " + std::to_string(image.height));
  digest.add(levels);
  return digest.text();
}

std::string picture_name(const std::string& model, std::size_t frame, std::size_t frames) {
  if (frames < 2) return model + ".png";
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(frames - 1).size());
  const std::string number = std::to_string(frame);
  return model + "_" + std::string(digits - number.size(), '0') + number + ".png";
}

Json report_json(const RunResult& result, const RunComparison& comparison) {
  Json json = {{"version", kReportVersion},
               {"scene", scene_json(result)},
               {"config", config_json(result.config)},
               {"models", Json::object()}};
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
  json["made_by"] = made_by_json(result.made_by);
  json["timing"] = timing_json(result);
  return json;
}

}  // namespace ptm::testbench
