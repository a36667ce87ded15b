#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "golden/files/ptm_file.h"
#include "golden/scene/scene.h"
#include "model/reference/fragment.h"
#include "testbench/run/hardware_map.h"

namespace ptm::testbench {

/// Everything that the four models need to draw one flat map: one frame a light.
struct FlatJob {
  std::string name;  ///< the scene or command, for errors
  std::filesystem::path map_file;
  golden::PtmMap map;
  reference::EvalConfig config;
  HardwareMap hardware;
  int width = 0, height = 0;
  std::vector<golden::Light> lights;
  int tmus = 3;
};

/// Throws golden::InputError if a map has more texels a side than the unit addresses.
void check_hardware_size(const std::filesystem::path& map_file, int width, int height);

/// Checks that the unit can draw the map under the job's lights with a configuration; throws
/// golden::InputError naming the light, or the map's size.
void check_hardware_limits(const FlatJob& job, const reference::EvalConfig& config);

/// Fills `config` and `hardware`. Throws as check_hardware_limits() and store_map() do.
void choose_config(FlatJob& job, const reference::EvalConfig& config);

/// The fragment of one pixel: golden's sample, quantised.
[[nodiscard]] reference::Fragment make_fragment(const FlatJob& job,
                                                const reference::EvalConfig& config,
                                                const golden::Light& light, int x, int y);

/// One frame's fragments in scan-line order: golden's samples, quantised. The unit's models and
/// the reference all draw these.
[[nodiscard]] std::vector<reference::Fragment> make_fragments(const FlatJob& job,
                                                              const reference::EvalConfig& config,
                                                              const golden::Light& light);

/// The texel that a fragment reads by point sampling.
[[nodiscard]] inline std::size_t texel_of(const reference::Fragment& fragment, int width,
                                          int height) {
  return static_cast<std::size_t>(reference::nearest_index(fragment.v, height) * width +
                                  reference::nearest_index(fragment.u, width));
}

}  // namespace ptm::testbench
