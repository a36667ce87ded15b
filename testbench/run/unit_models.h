#pragma once
#include <string>
#include <vector>

#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/run/child_process.h"
#include "testbench/run/run_result.h"
#include "testbench/run/unit_job.h"

/// The models of the whole unit. Those that know time run in processes of their own.
namespace ptm::testbench {

/// Golden's picture: light per pixel, lit texels filtered, nothing rounded.
[[nodiscard]] ModelResult render_unit_golden(const UnitJob& job);
/// The yardstick: golden's texels averaged exactly over what each pixel covers.
[[nodiscard]] std::vector<golden::ImageReal> unit_area_averages(const UnitJob& job);

/// The reference's pixels, in fragment order, one list a frame.
[[nodiscard]] std::vector<std::vector<reference::UnitPixel>> unit_pixels(const UnitJob& job);
/// A picture of pixels over the scene's background.
[[nodiscard]] golden::ImageReal unit_image(const golden::UnitScene& scene,
                                           const std::vector<reference::UnitPixel>& pixels);

/// What a timed model said; frames that were drawn only to warm the caches are left out. A fault is
/// the last frame's, and frames after it are missing.
struct UnitTimed {
  std::string model;
  double seconds = 0;  ///< of the model alone
  std::vector<pipeline::UnitFrameResult> frames;
};

/// Starts "pipeline" (the timing exact), "loose" or "rtl"; the job must stay as it is until
/// take_unit_model(). "rtl" builds the unit before anything starts if it does not come with the
/// build.
[[nodiscard]] ChildProcess start_unit_model(const UnitJob& job, const std::string& model);
[[nodiscard]] UnitTimed take_unit_model(ChildProcess& child, const std::string& model);

/// What a timed model is given, but for its frames.
[[nodiscard]] pipeline::UnitSimulation unit_simulation(const UnitJob& job);

}  // namespace ptm::testbench
