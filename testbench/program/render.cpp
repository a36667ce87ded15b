// ptmsim render: one map under one light, by one model.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "golden/files/encoded_picture.h"
#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "golden/files/ptm_header.h"
#include "golden/render/light_map.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/expected_file.h"
#include "testbench/run/light_advice.h"
#include "testbench/run/picture_models.h"
#include "testbench/run/prepare_rtl.h"
#include "testbench/run/timed_models.h"

namespace ptm::testbench {
namespace {

/// What the widest preset can express: from there on a light is a mistake, not an extrapolation.
constexpr double kFarthestLight = 2;

struct RenderOptions {
  std::string map, out;
  std::vector<double> light;
  std::vector<int> size;
  std::string model = "golden", rounding = "nearest";
  ConfigOptions config;
};

/// Refuses a light far outside of the unit disc, and says so of one just outside.
void check_light(const std::vector<double>& light) {
  const std::string advice = light_advice(light[0], light[1]);
  if (advice.empty()) return;
  if (std::max(std::abs(light[0]), std::abs(light[1])) > kFarthestLight) {
    std::ostringstream found;
    found << light[0] << "," << light[1];
    throw golden::InputError("--light", "the light", found.str(),
                             "U,V within the unit disc. " + advice);
  }
  std::cerr << "ptmsim: note: --light lies outside of the unit disc, where the map is "
               "extrapolated. "
            << advice << '\n';
}

/// The pipeline holds a map in the unit's memory.
Configuration configuration_of(const RenderOptions& options) {
  golden::Settings hardware, memory;
  overlay(options.config, hardware, memory);
  const SettingsOf settings{"the command line", hardware, memory};
  return options.model == "pipeline" ? make_unit_configuration(settings)
                                     : make_configuration(settings);
}

FlatJob make_job(const RenderOptions& options, const Configuration& configuration) {
  FlatJob job;
  job.name = "--light";
  job.map_file = options.map;
  if (options.model != "golden") {
    const golden::PtmMap header = golden::read_ptm_header(options.map).map;
    check_hardware_size(options.map, header.width, header.height);  // before the rest is read
  }
  job.map = golden::read_ptm(options.map).map;
  job.width = options.size.empty() ? job.map.width : options.size[0];
  job.height = options.size.empty() ? job.map.height : options.size[1];
  job.lights = {{options.light[0], options.light[1], "the light"}};
  job.tmus = configuration.unit.tmus;
  if (options.model != "golden") choose_config(job, configuration.eval);
  return job;
}

golden::ImageReal draw(const FlatJob& job, const std::string& model) {
  if (model == "golden") return std::move(render_golden(job).frames.front());
  if (model == "reference") return std::move(render_reference(job).frames.front());
  if (model == "rtl") prepare_rtl_evaluator(job.config);
  ChildProcess child = model == "pipeline" ? start_pipeline(job) : start_rtl(job);
  return std::move(take_result(child, model, job).model.frames.front());
}

void render(const RenderOptions& options) {
  for (const double coordinate : options.light) {
    if (!std::isfinite(coordinate)) {
      throw golden::InputError("--light", "the light", "a coordinate that is no finite number",
                               "U,V, two finite numbers");
    }
  }
  golden::check_picture_name(options.out);
  expect_file(options.map, golden::FileType::map);
  check_light(options.light);
  const Configuration configuration = configuration_of(options);
  const golden::ImageReal picture = draw(make_job(options, configuration), options.model);
  const auto rounding =
      options.rounding == "truncate" ? golden::Rounding8::truncate : golden::Rounding8::nearest;
  golden::write_picture(options.out, golden::to_8_bit(picture, rounding));
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render one map under one light");
  command->add_option("map", options->map, "A .ptm file")->required();
  command
      ->add_option("--light", options->light,
                   "U,V: the first two coordinates of the unit vector toward the light")
      ->delimiter(',')
      ->expected(2)
      ->required();
  command->add_option("--out", options->out, "Picture to write; its ending chooses the format")
      ->required();
  command->add_option("--model", options->model, "Who renders")
      ->check(CLI::IsMember({"golden", "reference", "pipeline", "rtl"}))
      ->capture_default_str();
  add_config_options(*command, options->config);
  command
      ->add_option("--rounding", options->rounding,
                   "How golden's real values become 8 bits (the hardware's are integers)")
      ->check(CLI::IsMember({"nearest", "truncate"}))
      ->capture_default_str();
  command->add_option("--size", options->size, "WxH of the picture (default: the map's)")
      ->delimiter('x')
      ->expected(2)
      ->check(CLI::Range(1, golden::kLargestPicture));
  command->callback([options] { render(*options); });
}

}  // namespace ptm::testbench
