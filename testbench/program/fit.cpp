// ptmsim fit: photographs under known lights become a map that the hardware holds as it stands.
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "golden/files/encoded_picture.h"
#include "golden/files/figure_text.h"
#include "golden/files/pending_file.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/expected_file.h"
#include "testbench/program/figures.h"
#include "testbench/program/fit_job.h"
#include "testbench/program/progress.h"
#include "testbench/program/region_option.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

struct FitArguments {
  FitJob job;
  std::string format = "lrgb", color = "least-squares", full_range, region, table;
  ConfigOptions config;
  std::size_t memory_mib = 256;
  bool json = false;
};

/// HP's recipe has luminance fill its range; what it truncates would miss 255 otherwise.
golden::FullRange full_range(const FitArguments& arguments) {
  const bool hp = arguments.job.quantizer == "hp";
  if (hp && arguments.full_range == "color") {
    throw ExitError(ExitCode::usage,
                    "--full-range color and --quantizer hp exclude each other: in HP's recipe it "
                    "is the luminance that fills its range");
  }
  return hp || arguments.full_range == "luminance" ? golden::FullRange::luminance
                                                   : golden::FullRange::color;
}

void check_names(const FitJob& job) {
  // A table of lights may be any text; a file of another kind in its place is named.
  expect_file(job.capture.source, golden::FileType::light_positions);
  expect_map_name(job.out);
  if (!job.residual.empty()) golden::check_picture_name(job.residual);
}

FitJob make_job(const FitArguments& arguments) {
  check_names(arguments.job);
  FitJob job = arguments.job;
  using golden::MapKind;
  job.fit.kind = arguments.format == "rgb"   ? MapKind::rgb
                 : arguments.format == "lum" ? MapKind::lum
                                             : MapKind::lrgb;
  job.fit.color =
      arguments.color == "average" ? golden::ColorRule::average : golden::ColorRule::least_squares;
  job.fit.truncate_color = job.quantizer == "hp";
  job.fit.full_range = full_range(arguments);
  job.config = file_config_of(arguments.config);
  job.memory = arguments.memory_mib << 20;
  if (!arguments.region.empty()) job.capture.region = parse_region("--region", arguments.region);
  return job;
}

Json describe(const golden::Residual& residual) {
  return {{"rmse", residual.rmse},
          {"psnr_db", residual.psnr_db},
          {"channel_rmse", residual.channel_rmse},
          {"channel_psnr_db", residual.channel_psnr_db}};
}

Json describe_lights(const FitJudgement& judgement) {
  Json lights = Json::array();
  for (std::size_t i = 0; i < judgement.names.size(); ++i) {
    Json light = {{"picture", judgement.names[i]}, {"light", judgement.directions[i]}};
    light.update(describe(judgement.lights[i]));
    light["contradicts"] = static_cast<bool>(judgement.contradicts[i]);
    lights.push_back(std::move(light));
  }
  return lights;
}

Json optional_number(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

void describe_quality(const FitOutcome& outcome, Json& out) {
  out["real_fit"] = describe(outcome.training.real);
  out["stored_fit"] = describe(outcome.training.stored);
  out["lights"] = describe_lights(outcome.training);
  for (std::size_t i = 0; i < outcome.leave_one_out.size(); ++i) {
    out["lights"][i]["leave_one_out_rmse"] = optional_number(outcome.leave_one_out[i]);
  }
  out["leave_one_out_rmse"] = optional_number(outcome.leave_one_out_rmse);
  if (!outcome.held_out) return;
  out["held_out"] = {{"real_fit", describe(outcome.held_out->real)},
                     {"stored_fit", describe(outcome.held_out->stored)},
                     {"lights", describe_lights(*outcome.held_out)}};
}

Json to_json(const FitArguments& arguments, const FitJob& job, const FitOutcome& outcome) {
  Json out;
  out["capture"] = job.capture.source.string();
  out["map"] = job.out.string();
  out["format"] = arguments.format;
  out["linear"] = job.capture.linear;
  if (job.capture.width_mm > 0) out["width_mm"] = job.capture.width_mm;
  out["width"] = outcome.width;
  out["height"] = outcome.height;
  out["photographs"] = outcome.training.names.size();
  out["bands"] = outcome.bands;
  out["notes"] = outcome.notes;
  out["rank"] = outcome.solver.rank;
  out["condition"] = outcome.solver.condition;
  const auto& values = outcome.solver.singular_values;
  out["singular_values"] = std::vector<double>(values.data(), values.data() + values.size());
  out["extrapolated"] = outcome.coverage.extrapolated;
  out["saturated_samples"] = outcome.saturated_samples;
  out["black_texels"] = outcome.black_texels;
  out["preset"] = name_of(job.config);
  out["method"] = job.quantizer;
  out["scale"] = outcome.scale;
  if (outcome.shift) out["shift"] = *outcome.shift;
  out["bias"] = outcome.bias;
  out["saturated"] = outcome.loss.saturated;
  out["quantization_rms"] = outcome.loss.rms();
  out["quantization_worst"] = outcome.loss.worst;
  out["luminance_exceeding"] = outcome.balance.exceeding;
  out["luminance_scaled"] = outcome.balance.scaled;
  out["luminance_remaining"] = outcome.balance.remaining;
  describe_quality(outcome, out);
  out["seconds"] = {{"read", outcome.read_seconds},
                    {"fit", outcome.fit_seconds},
                    {"quantize", outcome.quantize_seconds},
                    {"judge", outcome.judge_seconds}};
  return out;
}

void print_residual(const char* title, const Json& r) {
  std::cout << title << golden::count_of(figure(r["rmse"]), "level") << " RMSE, "
            << figure(r["psnr_db"]) << " dB, channels " << figure(r["channel_rmse"]) << '\n';
}

/// What the decibels of the stored map mean, for those who do not think in them. Six coefficients
/// are smooth in the light's direction; docs/tutorial.md says what that does to a capture.
void explain_decibels(const Json& stored, bool univariate) {
  if (stored["psnr_db"].is_null()) return;
  const double part = 100 * stored["rmse"].get<double>() / 255;
  std::cout << "what that means: " << figure(stored["psnr_db"]) << " dB is an RMS error of "
            << golden::four_digits(part) << " % of white\n";
  if (univariate) return;
  std::cout
      << "six coefficients a texel cannot follow highlights and the edges of shadows: captures "
         "with those usually give 18 to 25 dB, matt ones more than 30 dB\n";
}

void print_text(const Json& out, bool univariate) {
  for (const auto& note : out["notes"]) std::cout << "note: " << note.get<std::string>() << '\n';
  std::cout << golden::count_of(out["photographs"].get<int>(), "photograph") << " of "
            << out["width"] << " x " << out["height"] << " pixels, rank " << out["rank"]
            << ", condition " << figure(out["condition"]) << '\n'
            << golden::count_of(out["saturated_samples"].get<std::uint64_t>(), "saturated sample")
            << ", " << golden::count_of(out["black_texels"].get<std::uint64_t>(), "texel")
            << " black in every photograph\n";
  print_residual("against the photographs, real-valued: ", out["real_fit"]);
  print_residual("against the photographs, as stored:   ", out["stored_fit"]);
  explain_decibels(out["stored_fit"], univariate);
  if (out.contains("held_out")) {
    print_residual("held-out photographs, real-valued:    ", out["held_out"]["real_fit"]);
    print_residual("held-out photographs, as stored:      ", out["held_out"]["stored_fit"]);
  }
  if (!out["leave_one_out_rmse"].is_null()) {
    std::cout << "leave-one-out, of what is fitted:     "
              << golden::count_of(figure(out["leave_one_out_rmse"]), "level") << " RMSE\n";
  }
  std::cout << "stored by " << out["method"].get<std::string>() << " for "
            << out["preset"].get<std::string>() << ": scale " << figure(out["scale"]) << ", bias "
            << figure(out["bias"]) << ", saturated " << figure(out["saturated"]) << ", "
            << golden::count_of(figure(out["quantization_rms"]), "level") << " RMS, "
            << figure(out["quantization_worst"]) << " in the texel that lost most\n"
            << "map: " << out["map"].get<std::string>() << '\n';
}

void run(const FitArguments& arguments) {
  const FitJob job = make_job(arguments);
  std::optional<golden::PendingFile> table;
  if (!arguments.table.empty()) table.emplace(arguments.table);
  std::unique_ptr<Progress> progress;
  std::string text;
  Json out;
  (void)run_fit(
      job,
      [&](std::size_t, std::size_t total) {
        if (!progress) progress = std::make_unique<Progress>("fit", total);
        progress->step();
      },
      [&](const FitOutcome& outcome) {
        out = to_json(arguments, job, outcome);
        text = out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
        if (table) table->write(text);
      });
  if (table) table->commit();
  progress.reset();
  if (arguments.json) {
    std::cout << text;
  } else {
    print_text(out, arguments.job.capture.univariate);
  }
}

void add_input_options(CLI::App& command, FitArguments& a) {
  command
      .add_option("CAPTURE", a.job.capture.source,
                  "light positions (.lp) beside photographs; with --lights a folder of pictures")
      ->required();
  auto* lights = command.add_option("--lights", a.job.capture.lights,
                                    "table of light directions, N x 3 or 3 x N, one a picture of "
                                    "the folder in order of their names");
  auto* pictures =
      command
          .add_option("--pictures", a.job.capture.pictures.folder,
                      "folder of other photographs under the lights of the .lp: the n-th by name "
                      "belongs to the light of the list's n-th name")
          ->excludes(lights);
  command
      .add_flag("--skip-missing", a.job.capture.pictures.skip_missing,
                "leave out lights whose photographs are missing (default: an error)")
      ->excludes(lights)
      ->excludes(pictures);
  auto* width = command
                    .add_option("--width-mm", a.job.capture.width_mm,
                                "the picture's width in the unit of the lights' positions: fits "
                                "near lights, each pixel with its own light vectors and fall-off")
                    ->check(CLI::PositiveNumber);
  command
      .add_flag("--univariate", a.job.capture.univariate,
                "one parameter (focus, time): --lights holds one number a picture")
      ->needs(lights)
      ->excludes(width);
  command.add_option("--region", a.region, "X,Y,W,H: fit this part only, in pixels from top left");
  command.add_flag("--share-pictures", a.job.capture.share_pictures,
                   "let several lights have the same picture (default: an error, since a list "
                   "whose folders are missing looks like that)");
  command.add_flag("--as-stored", a.job.capture.as_stored,
                   "do not turn photographs as their tag Orientation (Exif, TIFF) says");
  command.add_flag("--linear", a.job.capture.linear,
                   "decode sRGB and fit linear light (default: values as they are stored)");
  auto* hold_out = command
                       .add_option("--hold-out", a.job.hold_out,
                                   "keep every N-th photograph for judging, do not fit it")
                       ->check(CLI::Range(2, 1000000));
  command.add_option("--test", a.job.test, "light positions (.lp) of photographs to judge by")
      ->excludes(hold_out);
}

void add_fit_options(CLI::App& command, FitArguments& a) {
  command.add_option("--format", a.format, "kind of map")
      ->check(CLI::IsMember({"lrgb", "rgb", "lum"}))
      ->capture_default_str();
  command.add_option("--color", a.color, "how an LRGB map's colour is found")
      ->check(CLI::IsMember({"least-squares", "average"}))
      ->capture_default_str();
  command
      .add_option("--full-range", a.full_range,
                  "what of an LRGB texel fills its byte: its colour's brightest channel (default), "
                  "or its brightest luminance (as HP's fitter did; default of --quantizer hp)")
      ->check(CLI::IsMember({"color", "luminance"}));
  command
      .add_option("--robust", a.job.fit.robust_passes,
                  "reweighted passes against highlights and shadows")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  add_config_options(command, a.config);
  command
      .add_option("--quantizer,--method", a.job.quantizer,
                  "how coefficients are rounded; hp: as HP's fitter did")
      ->check(CLI::IsMember({"nearest_plane", "plain", "hp"}))
      ->capture_default_str();
}

}  // namespace

void add_fit_command(CLI::App& app) {
  const auto arguments = std::make_shared<FitArguments>();
  CLI::App* command = app.add_subcommand("fit", "Photographs under known lights to a map");
  add_input_options(*command, *arguments);
  command->add_option("--out", arguments->job.out, "the map to write (.ptm)")->required();
  add_fit_options(*command, *arguments);
  command->add_option("--residual", arguments->job.residual,
                      "write a picture of each texel's RMS residual, times 4");
  command->add_option("--table", arguments->table, "write what --json prints to this file");
  command->add_option("--memory", arguments->memory_mib, "MiB of photographs held at once")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "print JSON");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace ptm::testbench
