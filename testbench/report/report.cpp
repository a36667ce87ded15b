#include "testbench/report/report.h"

#include <string>
#include <vector>

#include "golden/files/whole_file.h"
#include "testbench/report/level_picture.h"
#include "testbench/report/report_html.h"
#include "testbench/report/report_json.h"
#include "testbench/report/staged_files.h"

namespace ptm::testbench {
namespace {

/// Pictures that the report in the directory lists. Of a report that cannot be read, none.
std::vector<std::string> listed_pictures(const std::filesystem::path& report) {
  std::string text;
  try {
    text = golden::read_text_file(report, "a report");
  } catch (const golden::InputError&) {
    return {};
  }
  const auto json = nlohmann::json::parse(text, nullptr, false);
  std::vector<std::string> names;
  if (!json.is_object() || !json.contains("models") || !json["models"].is_object()) return names;
  for (const auto& [model, entry] : json["models"].items()) {
    if (!entry.is_object() || !entry.contains("pictures")) continue;
    const auto& pictures = entry["pictures"];
    for (std::size_t f = 0; f < pictures.size() && pictures.is_array(); ++f) {
      // Only a name that this program would have given: the file may have been edited.
      const std::string name = picture_name(model, f, pictures.size());
      const bool plain = std::filesystem::path(name).filename() == name;
      if (plain && pictures[f] == name) names.push_back(name);
    }
  }
  return names;
}

}  // namespace

ReportPaths write_report(const RunResult& result, const RunComparison& comparison,
                         const std::filesystem::path& directory) {
  PngCache pngs;
  const std::string page = report_html(result, comparison, pngs);
  StagedFiles files(directory);
  std::vector<std::string> stale = listed_pictures(directory / "report.json");
  for (std::size_t f = 0; f < result.lights.size(); ++f) {
    for (const ModelResult& model : result.models) {
      const std::string name = picture_name(model.model, f, model.frames.size());
      files.write(name, *pngs.encode(level_picture(model.frames[f])));
      std::erase(stale, name);
    }
  }
  // Before the report that no longer lists them: a run that is killed in between leaves one that
  // does, and the next run removes the rest.
  for (const std::string& name : stale) files.remove(name);
  // A name that is not UTF-8 is shown with U+FFFD; it must not cost the user the report.
  files.write("report.json",
              report_json(result, comparison)
                      .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                  "\n");
  files.write("report.html", page);
  files.commit();
  return {directory / "report.json", directory / "report.html"};
}

}  // namespace ptm::testbench
