#include "golden/files/light_positions.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>

#include "golden/files/figure_text.h"
#include "golden/files/light_directions.h"
#include "golden/files/light_line.h"
#include "golden/files/number_text.h"
#include "golden/files/pending_file.h"
#include "golden/files/picture_folder.h"
#include "golden/files/text_lines.h"
#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCoefficients = 6;
constexpr std::size_t kNamesTold = 8;  ///< of missing pictures, in a note

std::string line_place(int line) { return "line " + std::to_string(line); }

struct ListedLight {
  LightLine light;
  int line = 0;
};

class Reader {
 public:
  Reader(const fs::path& path, const PictureSource& source) : path_(path), source_(source) {}

  LightPositions read() {
    read_list();
    if (source_.folder.empty()) {
      find_pictures();
    } else {
      take_folder();
    }
    for (ListedLight& listed : lights_) take_light(listed);
    finish();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& found, const std::string& expected) const {
    throw InputError(path_.string(), line_place(line), found, expected);
  }

  void read_list() {
    int number = 0;
    for (const std::string& line : read_text_lines(path_, "a light position file (.lp)")) {
      ++number;
      const std::string_view text = without_separators(line);
      if (text.empty()) continue;
      auto light = read_light_line(text);
      if (!light && (text.front() == '#' || take_count(text) || take_column_names(text, number))) {
        continue;
      }
      if (count_ && lights_.size() >= *count_) {
        ++beyond_;
        continue;
      }
      if (!light) complain(text, number);
      if (light->decimal_commas && comma_line_ == 0) comma_line_ = number;
      lights_.push_back({std::move(*light), number});
    }
    tell_about_list();
  }

  /// A lone whole number before the first light.
  bool take_count(std::string_view text) {
    if (count_ || !lights_.empty()) return false;
    const auto count = parse_integer(text, 0, std::numeric_limits<std::int64_t>::max());
    if (count) count_ = static_cast<std::size_t>(*count);
    return count.has_value();
  }

  /// "name,x,y,z" before the first light.
  bool take_column_names(std::string_view text, int line) {
    const auto fields = last_fields(text);
    const bool words = std::all_of(fields.begin(), fields.end(), is_column_name) ||
                       (text.find(',') != std::string_view::npos && is_column_name(text) &&
                        text.find_first_of("0123456789") == std::string_view::npos);
    if (!lights_.empty() || !words) return false;
    result_.notes.push_back(line_place(line) + " holds the names of columns, passed over");
    return true;
  }

  [[noreturn]] void complain(std::string_view text, int line) const {
    const auto fields = last_fields(text);
    const bool enough = !fields[0].empty() && fields[0].data() != text.data();
    if (!enough) fail(line, "'" + std::string(text) + "'", "a picture's name and three numbers");
    const auto bad = std::find_if(fields.begin(), fields.end(), [](std::string_view field) {
      return !parse_real(field) && !parse_decimal_comma(field);
    });
    const std::string_view field = bad == fields.end() ? fields[0] : *bad;
    fail(line, "coordinate '" + std::string(field) + "'", "a finite number");
  }

  void tell_about_list() {
    if (comma_line_ > 0) {
      result_.notes.push_back("numbers with a decimal comma, the first in " +
                              line_place(comma_line_));
    }
    if (!count_ || (beyond_ == 0 && *count_ == lights_.size())) return;
    std::string note = "the first line says " + count_of(*count_, "light") + ", the file has " +
                       std::to_string(lights_.size() + beyond_);
    if (beyond_ > 0) note += "; what is beyond the count is not read";
    result_.notes.push_back(note);
  }

  void find_pictures() {
    ListedPictures pictures(path_);
    for (const ListedLight& listed : lights_) {
      auto found = pictures.find(listed.light.name, line_place(listed.line));
      if (!found && !source_.skip_missing) {
        fail(listed.line, "no picture '" + listed.light.name + "'",
             "an existing file beside the light positions, or --skip-missing");
      }
      if (!found) missing_.push_back(listed.light.name);
      pictures_.push_back(std::move(found));
    }
    pictures.finish(result_.notes);
    if (!missing_.empty()) tell_missing();
  }

  void tell_missing() {
    const std::size_t listed = lights_.size(), left = listed - missing_.size();
    std::string names;
    for (std::size_t i = 0; i < std::min(kNamesTold, missing_.size()); ++i) {
      names += (i == 0 ? "" : ", ") + missing_[i];
    }
    if (missing_.size() > kNamesTold) names += ", ...";
    const std::size_t least = listed < kCoefficients ? 2 : kCoefficients;
    if (left < least) {
      throw InputError(
          path_.string(), "pictures",
          std::to_string(left) + " of " + std::to_string(listed) + " (missing: " + names + ")",
          std::to_string(least) + " or more");
    }
    result_.notes.push_back(std::to_string(missing_.size()) + " of " + std::to_string(listed) +
                            " lights are left out, as their photographs are missing: " + names);
  }

  /// The n-th name of the list stands for the n-th name of the folder, whatever both are called.
  void take_folder() {
    const auto all = pictures_of(source_.folder, lights_.size(), path_.filename().string());
    std::vector<std::size_t> order(lights_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return natural_less(lights_[a].light.name, lights_[b].light.name);
    });
    pictures_.resize(all.size());
    for (std::size_t n = 0; n < order.size(); ++n) pictures_[order[n]] = all[n];
    if (std::is_sorted(order.begin(), order.end())) return;
    result_.notes.push_back(
        "the list is not in order of its names: the light of its n-th name, not "
        "of its n-th line, was given to the n-th picture of " +
        source_.folder.string());
  }

  void take_light(const ListedLight& listed) {
    const auto at = static_cast<std::size_t>(&listed - lights_.data());
    LitPicture lit;
    lit.direction = lit.position = listed.light.numbers;
    lit.line = listed.line;
    // A light that stands wrong is worth a word whether its picture is there or not.
    const bool above =
        directions_.take(lit.direction, path_.string(), line_place(listed.line), result_.notes);
    if (!above || !pictures_[at]) return;
    lit.picture = *pictures_[at];
    result_.pictures.push_back(std::move(lit));
  }

  void finish() {
    if (!source_.positions) directions_.finish(result_.notes);
    if (result_.pictures.empty()) {
      throw InputError(path_.string(), "file",
                       count_ == 0 && beyond_ > 0 ? "a count of 0 lights in the first line"
                                                  : "no light above the horizon",
                       "lines of a picture's name and three numbers");
    }
  }

  fs::path path_;
  PictureSource source_;
  LightPositions result_;
  std::vector<ListedLight> lights_;
  std::vector<std::optional<fs::path>> pictures_;  ///< one a light
  std::vector<std::string> missing_;
  int comma_line_ = 0;
  std::optional<std::size_t> count_;
  std::size_t beyond_ = 0;
  LightDirections directions_;
};

}  // namespace

LightPositions read_light_positions(const fs::path& path, const PictureSource& source) {
  return Reader(path, source).read();
}

std::string format_light_positions(const fs::path& path, const std::vector<LitPicture>& pictures) {
  std::ostringstream out;
  out << pictures.size() << '\n' << std::setprecision(17);
  for (const LitPicture& lit : pictures) {
    out << lit.picture.lexically_proximate(path.parent_path()).generic_string();
    for (const double c : lit.direction) out << ' ' << c;
    out << '\n';
  }
  return std::move(out).str();
}

void write_light_positions(const fs::path& path, const std::vector<LitPicture>& pictures) {
  PendingFile file(path);
  file.write(format_light_positions(path, pictures));
  file.commit();
}

}  // namespace ptm::golden
