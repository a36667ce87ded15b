#include "testbench/compare/run_files.h"

#include <algorithm>

#include "golden/files/number_text.h"
#include "golden/files/whole_file.h"
#include "testbench/report/report_json.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;
using golden::InputError;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestReport = std::uintmax_t{256} << 20;
constexpr int kDeepest = 32;  ///< levels of nesting; a report has nine at most
constexpr const char* kWanted = "a folder that ptmsim run wrote, or its report.json";

/// "line 3, column 7" of a byte.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, byte == 0 ? 0 : std::min(byte - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1);
}

Json parse(const fs::path& report, const std::string& text) {
  const auto watch_depth = [&](int depth, Json::parse_event_t, Json&) {
    if (depth <= kDeepest) return true;
    throw InputError(report.string(), "the file",
                     "more than " + std::to_string(kDeepest) + " levels of nesting",
                     "a report.json of ptmsim run");
  };
  try {
    return Json::parse(text, watch_depth);
  } catch (const Json::parse_error& error) {
    throw InputError(report.string(), place_of(text, error.byte), "text that is no JSON",
                     "a report.json of ptmsim run");
  } catch (const Json::exception& error) {
    throw InputError(report.string(), "the file", error.what(), "a report.json of ptmsim run");
  }
}

[[noreturn]] void refuse(const RunFiles& run, const std::string& place, const std::string& found,
                         const std::string& expected) {
  throw InputError(run.report.string(), place, found, expected);
}

/// A member that must be there and of a type.
const Json& member(const RunFiles& run, const Json& object, const std::string& path,
                   const std::string& name, Json::value_t type, const char* expected) {
  const std::string place = path.empty() ? name : path + "." + name;
  const auto found = object.find(name);
  if (found == object.end()) refuse(run, place, "nothing", expected);
  if (found->type() != type) refuse(run, place, std::string("a ") + found->type_name(), expected);
  return *found;
}

void check_texts(const RunFiles& run, const Json& list, const std::string& place) {
  if (list.empty()) refuse(run, place, "an empty list", "one entry a light");
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].is_string()) continue;
    refuse(run, place + "[" + std::to_string(i) + "]", std::string("a ") + list[i].type_name(),
           "text");
  }
}

void check_model(const RunFiles& run, const std::string& name, const Json& model) {
  const std::string path = "models." + name;
  if (!model.is_object()) refuse(run, path, std::string("a ") + model.type_name(), "an object");
  using enum Json::value_t;
  const Json& pictures = member(run, model, path, "pictures", array, "a list of file names");
  const Json& digests = member(run, model, path, "digests", array, "a list of digests");
  check_texts(run, pictures, path + ".pictures");
  check_texts(run, digests, path + ".digests");
  if (pictures.size() != digests.size()) {
    refuse(run, path + ".digests", std::to_string(digests.size()),
           std::to_string(pictures.size()) + ", one a picture");
  }
  for (const Json& picture : pictures) {
    const std::string file = picture.get<std::string>();
    if (fs::path(file).filename() == file && file != "." && file != "..") continue;
    refuse(run, path + ".pictures", golden::quoted(file), "the name of a file beside the report");
  }
}

void check(const RunFiles& run) {
  using enum Json::value_t;
  if (!run.json.is_object()) {
    refuse(run, "the file", std::string("a JSON ") + run.json.type_name(), "an object");
  }
  member(run, run.json, "", "version", number_unsigned, "a number, the report's version");
}

void check_contents(const RunFiles& run) {
  using enum Json::value_t;
  const Json& scene = member(run, run.json, "", "scene", object, "an object");
  member(run, scene, "scene", "file", string, "text");
  const Json& models = member(run, run.json, "", "models", object, "an object");
  if (models.empty()) refuse(run, "models", "none", "one or more");
  for (const auto& [name, model] : models.items()) check_model(run, name, model);
}

}  // namespace

std::vector<std::string> RunFiles::pictures(const std::string& model) const {
  return json.at("models").at(model).at("pictures").get<std::vector<std::string>>();
}

std::vector<std::string> RunFiles::models() const {
  std::vector<std::string> names;
  for (const auto& [name, ignored] : json.at("models").items()) names.push_back(name);
  return names;
}

bool RunFiles::has_no_pictures() const {
  if (!named_alone) return false;
  for (const std::string& model : models()) {
    for (const std::string& picture : pictures(model)) {
      if (fs::exists(folder / picture)) return false;
    }
  }
  return true;
}

RunFiles read_run(const fs::path& path) {
  RunFiles run;
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InputError(path.string(), "the folder or file", "nothing there", kWanted);
  }
  run.named_alone = !fs::is_directory(path, error);
  run.report = run.named_alone ? path : path / "report.json";
  run.folder = run.report.parent_path();
  if (!fs::exists(run.report, error)) {
    throw InputError(path.string(), "report.json", "no such file", kWanted);
  }
  const std::string text = golden::read_text_file(run.report, "a report.json", kLargestReport);
  run.json = parse(run.report, text);
  check(run);
  if (run.json["version"] == kReportVersion) check_contents(run);
  return run;
}

void require_versions(const RunFiles& a, const RunFiles& b) {
  const auto version = [](const RunFiles& run) { return run.json["version"].dump(); };
  const std::string own = std::to_string(kReportVersion);
  const RunFiles* other = version(a) != own ? &a : version(b) != own ? &b : nullptr;
  if (other == nullptr) return;
  const RunFiles& beside = other == &a ? b : a;
  throw InputError(other->report.string(), "version", "a report of version " + version(*other),
                   "version " + own + ", the only one that this program compares (" +
                       beside.report.string() + " has version " + version(beside) + ")");
}

}  // namespace ptm::testbench
