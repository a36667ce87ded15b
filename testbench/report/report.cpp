#include "testbench/report/report.h"

#include "golden/files/png_bytes.h"
#include "testbench/report/level_picture.h"
#include "testbench/report/report_html.h"
#include "testbench/report/report_json.h"
#include "testbench/report/staged_files.h"

namespace ptm::testbench {

ReportPaths write_report(const RunResult& result, const RunComparison& comparison,
                         const std::filesystem::path& directory) {
  StagedFiles files(directory);
  for (const ModelResult& model : result.models) {
    for (std::size_t f = 0; f < model.frames.size(); ++f) {
      files.write(picture_name(model.model, f, model.frames.size()),
                  golden::encode_png(level_picture(model.frames[f])));
    }
  }
  // A name that is not UTF-8 is shown with U+FFFD; it must not cost the user the report.
  files.write("report.json",
              report_json(result, comparison)
                      .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                  "\n");
  files.write("report.html", report_html(result, comparison));
  files.commit();
  return {directory / "report.json", directory / "report.html"};
}

}  // namespace ptm::testbench
