#include "testbench/report/report.h"

#include "testbench/report/level_picture.h"
#include "testbench/report/report_html.h"
#include "testbench/report/report_json.h"
#include "testbench/report/staged_files.h"

namespace ptm::testbench {

ReportPaths write_report(const RunResult& result, const RunComparison& comparison,
                         const std::filesystem::path& directory) {
  PngCache pngs;
  const std::string page = report_html(result, comparison, pngs);
  StagedFiles files(directory);
  for (std::size_t f = 0; f < result.lights.size(); ++f) {
    for (const ModelResult& model : result.models) {
      files.write(picture_name(model.model, f, model.frames.size()),
                  *pngs.encode(level_picture(model.frames[f])));
    }
  }
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
