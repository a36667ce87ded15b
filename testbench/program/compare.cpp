// ptmsim compare: what differs between two runs, for people and as a regression gate.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "golden/files/figure_text.h"
#include "testbench/compare/run_verdict.h"
#include "testbench/program/commands.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/figures.h"
#include "testbench/report/html_text.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
  std::string a, b, tolerance;
  bool json = false;
};

constexpr std::size_t kLongestValue = 60;  ///< characters of a value in a line of text

std::string plain_number(double value) {
  std::ostringstream text;
  text << std::setprecision(6) << value;
  return text.str();
}

std::string value_text(const Json& value) {
  if (value.is_number_unsigned()) return grouped(value.get<std::uint64_t>());
  if (value.is_number_float()) return plain_number(value.get<double>());
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kLongestValue ? text : text.substr(0, kLongestValue - 3) + "...";
}

std::string pixel_text(const ModelPixels& pixels) {
  const FilePixels& worst = pixels.files.front();
  std::string text = grouped(pixels.differing) + " of " + grouped(pixels.samples) +
                     " samples differ, at most " +
                     golden::count_of(golden::four_digits(pixels.max), "level");
  if (pixels.pictures > 1) {
    text += ", in " + std::to_string(pixels.files.size()) + " of " +
            std::to_string(pixels.pictures) + " pictures";
  }
  return text + "; worst in " + worst.picture + " at x " + std::to_string(worst.x) + ", y " +
         std::to_string(worst.y);
}

std::string change_text(const RunDifference& difference) {
  std::string text = value_text(difference.a) + " -> " + value_text(difference.b);
  const std::optional<double> part = difference.relative();
  const bool setting = difference.kind == DifferenceKind::configuration;
  if (part && std::isfinite(*part) && !setting) {
    text += " (" + std::string(*part < 0 ? "" : "+") + figure(100 * *part) + " %)";
  }
  return text;
}

std::string difference_text(const RunDifference& difference) {
  if (difference.pixels) return pixel_text(*difference.pixels);
  if (!difference.what.empty()) {
    const bool values = !difference.a.is_null() || !difference.b.is_null();
    return (values ? change_text(difference) + " " : "") + difference.what;
  }
  if (!difference.only.empty()) return "in " + difference.only + " only";
  if (difference.kind == DifferenceKind::lists) return "other entries";
  return change_text(difference);
}

std::string places_text(const RunDifference& difference) {
  std::string text = difference.path;
  for (const std::string& path : difference.also) text += ", " + path;
  return text;
}

std::string verdict_word(const RunVerdict& verdict) {
  if (verdict.refused() != 0) return "different";
  return verdict.differences.empty() ? "same" : "allowed";
}

std::string verdict_text(const RunVerdict& verdict, const Tolerance& tolerance) {
  if (verdict.differences.empty()) return "same: nothing differs but what made the runs and when";
  const std::string allowed = plural(verdict.allowed(), "difference");
  if (verdict.refused() == 0) {
    return "same within " + tolerance.file + ": " + allowed +
           (verdict.allowed() == 1 ? ", allowed" : ", all allowed");
  }
  std::string text = "different: " + plural(verdict.refused(), "difference") +
                     (verdict.refused() == 1 ? " that is" : " that are") + " not allowed";
  if (verdict.allowed() != 0) text += ", " + std::to_string(verdict.allowed()) + " allowed";
  return text;
}

/// Text of a report's member that any program may have written there.
std::string text_at(const RunFiles& run, const Json::json_pointer& place) {
  if (!run.json.contains(place)) return "unknown";
  const Json& value = run.json.at(place);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void print_run(const char* name, const RunFiles& run) {
  const auto text = [&](const char* place) { return text_at(run, Json::json_pointer(place)); };
  std::cout << name << ": " << run.report.string() << ", scene " << text("/scene/file")
            << "; ptmsim " << text("/made_by/version") << ", commit " << text("/made_by/commit")
            << (text("/made_by/sources_changed") == "true" ? " and changes" : "") << ", "
            << text("/made_by/date") << '\n';
}

void print_text(const RunFiles& a, const RunFiles& b, const RunVerdict& verdict,
                const Tolerance& tolerance) {
  std::cout << verdict_text(verdict, tolerance) << '\n';
  print_run("A", a);
  print_run("B", b);
  if (verdict.by_digests) {
    std::cout << "pictures are compared by the reports' digests: there are none beside "
              << (a.has_no_pictures() ? a : b).report.string() << '\n';
  }
  for (const RunDifference& difference : verdict.differences) {
    std::cout << (difference.allowed ? "allowed  " : "") << kind_name(difference.kind) << "  "
              << places_text(difference) << "  " << difference_text(difference) << '\n';
  }
}

Json run_json(const RunFiles& run) {
  const auto member = [&](const char* place) {
    const Json::json_pointer pointer(place);
    return run.json.contains(pointer) ? run.json.at(pointer) : Json(nullptr);
  };
  return {{"report", run.report.string()},
          {"scene", member("/scene/file")},
          {"version", member("/made_by/version")},
          {"commit", member("/made_by/commit")},
          {"sources_changed", member("/made_by/sources_changed")},
          {"date", member("/made_by/date")}};
}

Json pixels_json(const ModelPixels& pixels) {
  Json files = Json::array();
  for (const FilePixels& file : pixels.files) {
    files.push_back({{"picture", file.picture},
                     {"samples", file.samples},
                     {"differing", file.differing},
                     {"max", file.max},
                     {"x", file.x},
                     {"y", file.y}});
  }
  return {{"pictures", pixels.pictures},
          {"samples", pixels.samples},
          {"differing", pixels.differing},
          {"max", pixels.max},
          {"files", std::move(files)}};
}

Json difference_json(const RunDifference& difference) {
  Json json = {{"kind", kind_name(difference.kind)},
               {"allowed", difference.allowed},
               {"path", difference.path},
               {"also", difference.also},
               {"says", difference_text(difference)}};
  if (!difference.only.empty()) json["only"] = difference.only;
  if (difference.pixels) json["pixels"] = pixels_json(*difference.pixels);
  const bool values = !difference.a.is_null() || !difference.b.is_null();
  if (!values || difference.pixels) return json;
  json["a"] = difference.a;
  json["b"] = difference.b;
  if (const auto amount = difference.amount()) json["difference"] = *amount;
  if (const auto part = difference.relative()) {
    json["relative"] = std::isfinite(*part) ? Json(*part) : Json(nullptr);
  }
  return json;
}

void print_json(const RunFiles& a, const RunFiles& b, const RunVerdict& verdict,
                const Tolerance& tolerance) {
  Json json = {{"version", 1},
               {"verdict", verdict_word(verdict)},
               {"a", run_json(a)},
               {"b", run_json(b)},
               {"tolerance", tolerance.file.empty() ? Json(nullptr) : Json(tolerance.file)},
               {"pictures_by", verdict.by_digests ? "digests" : "samples"},
               {"not_allowed", verdict.refused()},
               {"allowed", verdict.allowed()},
               {"differences", Json::array()}};
  for (const RunDifference& difference : verdict.differences) {
    json["differences"].push_back(difference_json(difference));
  }
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void compare(const CompareOptions& options) {
  Tolerance tolerance;
  if (!options.tolerance.empty()) tolerance = read_tolerance(options.tolerance);
  const RunFiles a = read_run(options.a), b = read_run(options.b);
  const RunVerdict verdict = compare_runs(a, b, tolerance);
  (options.json ? print_json : print_text)(a, b, verdict, tolerance);
  if (verdict.refused() == 0) return;
  throw ExitError(ExitCode::disagree, b.report.string() + " differs from " + a.report.string() +
                                          " in " + plural(verdict.refused(), "thing") +
                                          " that the comparison does not allow");
}

}  // namespace

void add_compare_command(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "Say what differs between two runs: pictures, cycles, counters, configuration, "
      "figures. Exit code 1 if more than is allowed (docs/spec/compare.md)");
  command->add_option("A", options->a, "The earlier run: what run --out wrote, or its report.json")
      ->required();
  command->add_option("B", options->b, "The later run")->required();
  command->add_option("--tolerance", options->tolerance,
                      "What may differ, TOML; without it nothing but what made the runs and when");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { compare(*options); });
}

}  // namespace ptm::testbench
