#include "testbench/report/run_comparison.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>

#include "golden/files/figure_text.h"
#include "testbench/report/html_text.h"

namespace ptm::testbench {
namespace {

constexpr std::size_t kWorst = 10;
const std::string kGolden = "golden";

void check_frames(const RunResult& result, const std::string& whose,
                  const std::vector<golden::ImageReal>& frames) {
  if (frames.empty() || frames.size() != result.lights.size()) {
    throw std::invalid_argument("report: " + whose + " has " + golden::count_of(frames.size(), "frame") +
                                ", expected one for each of " +
                                golden::count_of(result.lights.size(), "light"));
  }
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const golden::ImageReal& image = frames[f];
    if (image.width == result.width && image.height == result.height && image.channels == 3) {
      continue;
    }
    throw std::invalid_argument("report: " + whose + ", frame " + std::to_string(f) + ": found " +
                                std::to_string(image.width) + " x " + std::to_string(image.height) +
                                " x " + std::to_string(image.channels) + " samples, expected " +
                                std::to_string(result.width) + " x " +
                                std::to_string(result.height) + " x 3");
  }
}

/// Names become file names and keys.
void check_name(const std::string& name, std::set<std::string>& seen) {
  const bool plain = !name.empty() && name.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyz"
                                          "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-") == std::string::npos;
  if (!plain || !seen.insert(name).second) {
    throw std::invalid_argument("report: model name '" + name +
                                "', expected letters, digits, _ and -, each name once");
  }
}

const ModelResult* find_model(const RunResult& result, const std::string& name) {
  for (const ModelResult& model : result.models) {
    if (model.model == name) return &model;
  }
  return nullptr;
}

bool equal_frames(const ModelResult& p, const ModelResult& q) {
  return std::equal(p.frames.begin(), p.frames.end(), q.frames.begin(), q.frames.end(),
                    [](const auto& x, const auto& y) { return x.samples == y.samples; });
}

/// The first model with the same pictures. Reference, pipeline and RTL agree as a rule, so most
/// pairs need no comparing of their own.
std::vector<std::size_t> first_with_equal_frames(const RunResult& result) {
  std::vector<std::size_t> first(result.models.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    first[i] = i;
    for (std::size_t j = 0; j < i && first[i] == i; ++j) {
      if (equal_frames(result.models[j], result.models[i])) first[i] = j;
    }
  }
  return first;
}

std::optional<PartDifference> off_edges(const RunResult& result,
                                        const std::vector<golden::ImageReal>& a,
                                        const std::vector<golden::ImageReal>& b) {
  if (result.edge_pixels.empty()) return std::nullopt;
  return compare_without(a, b, result.edge_pixels);
}

std::vector<PairDifference> compare_pairs(const RunResult& result) {
  const std::vector<std::size_t> first = first_with_equal_frames(result);
  std::vector<PairDifference> pairs;
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> done;  // first, first, pair
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = i + 1; j < first.size(); ++j) {
      const ModelResult &a = result.models[i], &b = result.models[j];
      const auto same = std::find_if(done.begin(), done.end(), [&](const auto& entry) {
        return std::get<0>(entry) == first[i] && std::get<1>(entry) == first[j];
      });
      PictureDifference difference = same != done.end() ? pairs[std::get<2>(*same)].difference
                                                        : compare_frames(a.frames, b.frames);
      if (same == done.end()) done.emplace_back(first[i], first[j], pairs.size());
      pairs.push_back({a.model, b.model, std::move(difference),
                       a.model != kGolden && b.model != kGolden, std::nullopt});
      if (a.model == kGolden) pairs.back().off_edges = off_edges(result, a.frames, b.frames);
    }
  }
  return pairs;
}

std::vector<PresetDifference> compare_presets(const RunResult& result) {
  std::vector<PresetDifference> presets;
  const ModelResult* golden = find_model(result, kGolden);
  if (!golden) return presets;
  for (const PresetFrames& preset : result.presets) {
    check_frames(result, "preset " + preset.preset, preset.frames);
    presets.push_back({preset.preset, compare_frames(golden->frames, preset.frames),
                       off_edges(result, golden->frames, preset.frames)});
  }
  return presets;
}

std::vector<ProbedPixel> worst_pixels(const std::vector<PairDifference>& pairs) {
  struct Candidate {
    const PairDifference* pair;
    WorstPixel where;
  };
  std::vector<Candidate> candidates;
  for (const PairDifference& pair : pairs) {
    for (const WorstPixel& where : pair.difference.worst) candidates.push_back({&pair, where});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& p, const auto& q) {
    const auto rank = [](const Candidate& c) {
      return std::tuple(!c.pair->must_agree, -c.where.error, c.where.frame, c.where.y, c.where.x);
    };
    return rank(p) < rank(q);
  });
  std::vector<ProbedPixel> worst;
  std::set<std::tuple<int, int, int>> seen;
  for (const Candidate& candidate : candidates) {
    const WorstPixel& where = candidate.where;
    if (worst.size() == kWorst) break;
    if (!seen.insert({where.frame, where.y, where.x}).second) continue;
    worst.push_back({candidate.pair->a, candidate.pair->b, where, {}});
  }
  return worst;
}

void probe_pixel(const RunResult& result, ProbedPixel& pixel) {
  const WorstPixel& where = pixel.where;
  for (const ModelResult& model : result.models) {
    PixelValues values{model.model, {}, {}};
    const golden::ImageReal& frame = model.frames[static_cast<std::size_t>(where.frame)];
    for (int c = 0; c < 3; ++c) {
      values.rgb[static_cast<std::size_t>(c)] = frame.at(where.x, where.y, c);
    }
    if (result.probe) values.values = result.probe(model.model, where.frame, where.x, where.y);
    pixel.models.push_back(std::move(values));
  }
}

}  // namespace

bool RunComparison::models_agree() const {
  return std::none_of(pairs.begin(), pairs.end(), [](const PairDifference& pair) {
    return pair.must_agree && pair.difference.max > 0;
  });
}

std::string edge_sentence(const RunComparison& comparison, const PairDifference& pair) {
  if (comparison.edge_samples == 0) return {};
  const std::string text =
      grouped(comparison.edge_samples) + " of " + grouped(pair.difference.samples) +
      " samples lie on an edge between texels: the hardware rounds their coordinates to 2^-20 and "
      "may read the texel on the other side of the edge than golden. ";
  if (!pair.off_edges) return text + "No other sample is left to compare.";
  return text + "Without these samples, the PSNR of " + pair.b + " against golden is " +
         decibels(pair.off_edges->psnr_db) + " and the largest error " +
         golden::count_of(levels(pair.off_edges->max), "level") + ".";
}

RunComparison compare_run(const RunResult& result) {
  if (result.models.empty()) throw std::invalid_argument("report: no model");
  std::set<std::string> names;
  for (const ModelResult& model : result.models) {
    check_name(model.model, names);
    check_frames(result, model.model, model.frames);
  }
  RunComparison comparison;
  comparison.pairs = compare_pairs(result);
  comparison.presets = compare_presets(result);
  const auto on_edge = std::count(result.edge_pixels.begin(), result.edge_pixels.end(), 1);
  comparison.edge_samples = static_cast<std::uint64_t>(on_edge) * 3 * result.lights.size();
  comparison.worst = worst_pixels(comparison.pairs);
  for (ProbedPixel& pixel : comparison.worst) probe_pixel(result, pixel);
  return comparison;
}

}  // namespace ptm::testbench
