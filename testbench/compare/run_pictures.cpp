#include "testbench/compare/run_pictures.h"

#include <algorithm>
#include <cmath>

#include "golden/files/picture_file.h"

namespace ptm::testbench {
namespace {

using golden::ImageReal;

std::string size_text(const ImageReal& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels, " +
         std::to_string(image.channels) + (image.channels == 1 ? " channel" : " channels");
}

FilePixels compare_samples(const std::string& name, const ImageReal& a, const ImageReal& b) {
  FilePixels found{name, a.samples.size(), 0, 0, 0, 0};
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const double error = std::abs(b.samples[i] - a.samples[i]);
    if (error == 0) continue;
    ++found.differing;
    if (error <= found.max) continue;
    found.max = error;
    const std::size_t pixel = i / static_cast<std::size_t>(a.channels);
    found.x = static_cast<int>(pixel % static_cast<std::size_t>(a.width));
    found.y = static_cast<int>(pixel / static_cast<std::size_t>(a.width));
  }
  return found;
}

class ModelComparison {
 public:
  ModelComparison(const RunFiles& a, const RunFiles& b, const std::string& model)
      : a_(a), b_(b), path_("models." + model + ".pictures"), model_(model) {}

  std::vector<RunDifference> run(bool digests) {
    const auto x = a_.pictures(model_), y = b_.pictures(model_);
    if (x.size() != y.size()) {
      RunDifference& found = add(DifferenceKind::structure, path_);
      found.a = x.size();
      found.b = y.size();
      found.what = "pictures, one a light";
    }
    const std::size_t both = std::min(x.size(), y.size());
    if (digests) {
      compare_digests(both);
    } else {
      for (std::size_t n = 0; n < both; ++n) compare_files(x[n], y[n]);
      add_pixels();
    }
    return std::move(found_);
  }

 private:
  RunDifference& add(DifferenceKind kind, const std::string& path) {
    RunDifference& found = found_.emplace_back();
    found.kind = kind;
    found.path = path;
    return found;
  }

  void compare_digests(std::size_t pictures) {
    std::size_t differing = 0;
    for (std::size_t n = 0; n < pictures; ++n) {
      const auto digest = [&](const RunFiles& run) {
        return run.json.at("models").at(model_).at("digests").at(n);
      };
      if (digest(a_) != digest(b_)) ++differing;
    }
    if (differing == 0) return;
    add(DifferenceKind::pixels, path_).what = std::to_string(differing) + " of " +
                                              std::to_string(pictures) +
                                              " differ by their digests; by how much is not known";
  }

  void compare_files(const std::string& x, const std::string& y) {
    const auto there = [](const RunFiles& run, const std::string& name) {
      return std::filesystem::exists(run.folder / name);
    };
    const bool in_a = there(a_, x), in_b = there(b_, y);
    if (!in_a || !in_b) {
      RunDifference& found = add(DifferenceKind::structure, path_ + "[" + (in_a ? y : x) + "]");
      found.only = in_a ? "A" : in_b ? "B" : "";
      found.what = in_a || in_b ? "the file is missing in " + std::string(in_a ? "B" : "A")
                                : "the file is missing in both";
      return;
    }
    const ImageReal first = golden::read_picture(a_.folder / x);
    const ImageReal second = golden::read_picture(b_.folder / y);
    if (first.width != second.width || first.height != second.height ||
        first.channels != second.channels) {
      RunDifference& found = add(DifferenceKind::pixels, path_ + "[" + y + "]");
      found.a = size_text(first);
      found.b = size_text(second);
      return;
    }
    take(compare_samples(y, first, second));
  }

  void take(const FilePixels& file) {
    ++pixels_.pictures;
    pixels_.samples += file.samples;
    pixels_.differing += file.differing;
    pixels_.max = std::max(pixels_.max, file.max);
    if (file.differing != 0) pixels_.files.push_back(file);
  }

  void add_pixels() {
    if (pixels_.differing == 0) return;
    std::stable_sort(pixels_.files.begin(), pixels_.files.end(),
                     [](const FilePixels& x, const FilePixels& y) { return x.max > y.max; });
    add(DifferenceKind::pixels, path_).pixels = pixels_;
  }

  const RunFiles &a_, &b_;
  std::string path_, model_;
  ModelPixels pixels_;
  std::vector<RunDifference> found_;
};

}  // namespace

std::vector<RunDifference> compare_run_pictures(const RunFiles& a, const RunFiles& b) {
  const bool digests = a.has_no_pictures() || b.has_no_pictures();
  std::vector<RunDifference> all;
  const std::vector<std::string> others = b.models();
  for (const std::string& model : a.models()) {
    if (std::find(others.begin(), others.end(), model) == others.end()) continue;
    for (RunDifference& one : ModelComparison(a, b, model).run(digests)) {
      all.push_back(std::move(one));
    }
  }
  return all;
}

}  // namespace ptm::testbench
