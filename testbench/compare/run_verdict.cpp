#include "testbench/compare/run_verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "testbench/compare/report_difference.h"
#include "testbench/compare/run_pictures.h"

namespace ptm::testbench {
namespace {

std::string last_name(const std::string& path) { return path.substr(path.find_last_of(".]") + 1); }

bool same_pixels(const std::optional<ModelPixels>& x, const std::optional<ModelPixels>& y) {
  if (x.has_value() != y.has_value()) return false;
  if (!x) return true;
  return std::tie(x->pictures, x->samples, x->differing, x->max) ==
         std::tie(y->pictures, y->samples, y->differing, y->max);
}

/// One more place of what `first` says: models that agree differ from their earlier selves alike.
bool repeats(const RunDifference& first, const RunDifference& next) {
  using enum DifferenceKind;
  if (first.kind == configuration || first.kind == notes) return false;
  return std::tie(first.kind, first.allowed, first.a, first.b, first.only, first.what) ==
             std::tie(next.kind, next.allowed, next.a, next.b, next.only, next.what) &&
         (first.kind == structure || first.kind == lists ||
          last_name(first.path) == last_name(next.path)) &&
         same_pixels(first.pixels, next.pixels);
}

double size_of(const RunDifference& difference) {
  if (difference.pixels) return difference.pixels->max;
  // Settings stay in the order of the report, which groups them.
  if (difference.kind == DifferenceKind::pixels ||
      difference.kind == DifferenceKind::configuration) {
    return std::numeric_limits<double>::infinity();
  }
  const std::optional<double> part = difference.relative();
  return part ? std::abs(*part) : std::numeric_limits<double>::infinity();
}

bool weighs_more(const RunDifference& x, const RunDifference& y) {
  if (x.allowed != y.allowed) return y.allowed;
  if (x.kind != y.kind) return x.kind < y.kind;
  return size_of(x) > size_of(y);
}

}  // namespace

std::size_t RunVerdict::allowed() const {
  return static_cast<std::size_t>(std::count_if(differences.begin(), differences.end(),
                                                [](const RunDifference& d) { return d.allowed; }));
}

RunVerdict compare_runs(const RunFiles& a, const RunFiles& b, const Tolerance& tolerance) {
  require_versions(a, b);
  RunVerdict verdict;
  verdict.by_digests = a.has_no_pictures() || b.has_no_pictures();
  std::vector<RunDifference> found = compare_run_pictures(a, b);
  std::vector<RunDifference> figures = compare_reports(a.json, b.json);
  std::move(figures.begin(), figures.end(), std::back_inserter(found));
  for (RunDifference& one : found) {
    one.allowed = tolerance.allows(one);
    const auto earlier = std::find_if(verdict.differences.begin(), verdict.differences.end(),
                                      [&](const RunDifference& d) { return repeats(d, one); });
    if (earlier != verdict.differences.end()) {
      earlier->also.push_back(one.path);
    } else {
      verdict.differences.push_back(std::move(one));
    }
  }
  std::stable_sort(verdict.differences.begin(), verdict.differences.end(), weighs_more);
  return verdict;
}

}  // namespace ptm::testbench
