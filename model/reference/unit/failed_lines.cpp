#include "model/reference/unit/failed_lines.h"

#include "model/reference/unit/beats.h"

namespace ptm::reference {
namespace {

bool fetches_failed(const EvalConfig& config, const UnitState& state, const Draw& draw, int texture,
                    const Footprint& footprint) {
  if (!footprint.fetched) return false;
  const TextureLevels& levels = texture == 0 ? draw.map : draw.color_texture;
  const int planes = texture == 0 ? array_planes(draw, config) : 1;
  for (unsigned t = 0; t < kTaps; ++t) {
    if ((footprint.taps() >> t & 1U) == 0) continue;
    for (int plane = 0; plane < planes; ++plane) {
      const TexelPlace at = place_of(levels, planes, footprint.level, plane,
                                     (t & 1U) != 0 ? footprint.i1 : footprint.i0,
                                     (t & 2U) != 0 ? footprint.j1 : footprint.j0);
      if (state.failed.contains(at.line)) return true;
    }
  }
  return false;
}

}  // namespace

bool fetches_failed_line(const EvalConfig& config, const UnitState& state,
                         const UnitFragment& fragment) {
  if (state.failed.empty()) return false;
  const Draw& draw = state.draws[fragment.draw];
  for (int probe = 0; probe < 1 << fragment.probes_log2; ++probe) {
    for (int texture = 0; texture < 2; ++texture) {
      const Footprint first = make_footprint(draw, fragment, texture, probe, 0);
      if (!first.fetched) continue;
      if (fetches_failed(config, state, draw, texture, first)) return true;
      if (first.level_weight != 0 &&
          fetches_failed(config, state, draw, texture,
                         make_footprint(draw, fragment, texture, probe, 1))) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace ptm::reference
