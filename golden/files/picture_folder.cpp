#include "golden/files/picture_folder.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>

#include "golden/files/figure_text.h"
#include "golden/files/number_text.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lower(std::string text) {
  for (char& c : text) c = lower(c);
  return text;
}

/// OpenImageIO's list is "tiff:tif,tiff;jpeg:jpg,...". Films are no photographs, and some of its
/// writers have no file.
std::set<std::string> picture_extensions() {
  const std::string known = OIIO::get_string_attribute("extension_list");
  std::set<std::string> extensions;
  for (std::size_t at = 0; at < known.size();) {
    const std::size_t end = std::min(known.find(';', at), known.size());
    const std::string_view format = std::string_view(known).substr(at, end - at);
    at = end + 1;
    const std::size_t colon = std::min(format.find(':'), format.size());
    const std::string_view name = format.substr(0, colon);
    if (name == "ffmpeg" || name == "null" || name == "term" || name == "socket") continue;
    for (std::size_t k = colon + 1; k < format.size();) {
      const std::size_t comma = std::min(format.find(',', k), format.size());
      std::string extension(1, '.');
      extension += lower(std::string(format.substr(k, comma - k)));
      extensions.insert(std::move(extension));
      k = comma + 1;
    }
  }
  return extensions;
}

bool is_picture_name(const fs::path& path) {
  static const std::set<std::string> known = picture_extensions();
  return path.filename().string().front() != '.' &&
         known.count(lower(path.extension().string())) > 0;
}

/// " (3 .jpg, 3 .tif)"; nothing for one kind alone.
std::string kinds_of(const std::vector<fs::path>& pictures) {
  std::map<std::string, int> kinds;
  for (const fs::path& picture : pictures) ++kinds[lower(picture.extension().string())];
  if (kinds.size() < 2) return {};
  std::string text;
  for (const auto& [extension, count] : kinds) {
    text += (text.empty() ? " (" : ", ") + std::to_string(count) + " " + extension;
  }
  return text + ")";
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::vector<fs::path> all_pictures(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> pictures;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_picture_name(entry->path()) && is_file(entry->path())) pictures.push_back(entry->path());
  }
  if (error) {
    throw InputError(folder.string(), "folder", error.message(), "a folder of pictures");
  }
  return pictures;
}

int compare_natural(const std::string& a, const std::string& b, bool any_case) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[k])) {
      const char c = any_case ? lower(a[i]) : a[i], d = any_case ? lower(b[k]) : b[k];
      if (c != d) return c < d ? -1 : 1;
      ++i, ++k;
      continue;
    }
    while (i < a.size() && a[i] == '0') ++i;
    while (k < b.size() && b[k] == '0') ++k;
    std::size_t m = i, n = k;
    while (m < a.size() && is_digit(a[m])) ++m;
    while (n < b.size() && is_digit(b[n])) ++n;
    if (m - i != n - k) return m - i < n - k ? -1 : 1;
    const int order = a.compare(i, m - i, b, k, n - k);
    if (order != 0) return order;
    i = m, k = n;
  }
  if ((i < a.size()) != (k < b.size())) return k < b.size() ? -1 : 1;
  return 0;
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  int order = compare_natural(a, b, true);
  if (order == 0) order = compare_natural(a, b, false);
  return order != 0 ? order < 0 : a < b;
}

std::size_t count_pictures(const fs::path& folder) { return all_pictures(folder).size(); }

std::vector<fs::path> pictures_of(const fs::path& folder, std::size_t lights,
                                  const std::string& of_what) {
  std::vector<fs::path> pictures = all_pictures(folder);
  if (pictures.size() != lights) {
    const std::string kinds = kinds_of(pictures);
    throw InputError(folder.string(), "folder", count_of(pictures.size(), "picture") + kinds,
                     std::to_string(lights) + ", one for each light of " + of_what);
  }
  std::sort(pictures.begin(), pictures.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return pictures;
}

ListedPictures::ListedPictures(fs::path list)
    : list_(std::move(list)),
      folder_(list_.has_parent_path() ? list_.parent_path() : fs::path(".")) {}

void ListedPictures::Told::add(const std::string& listed, const fs::path& picture) {
  if (times++ > 0) return;
  name = listed;
  found = picture.string();
}

std::vector<fs::path> ListedPictures::candidates(const fs::path& name) const {
  std::vector<fs::path> parts;
  for (const fs::path& part : name.relative_path()) {
    const std::string text = part.string();
    const bool drive = parts.empty() && text.size() == 2 && text[1] == ':';
    if (!text.empty() && text != "." && !drive) parts.push_back(part);
  }
  std::vector<fs::path> all{folder_ / name};
  if (parts.empty()) return all;
  const fs::path above = folder_ / "..";
  for (std::size_t first = 0; first < parts.size(); ++first) {
    fs::path rest;
    for (std::size_t k = first; k < parts.size(); ++k) rest /= parts[k];
    all.push_back(folder_ / rest);
    if (first + 1 < parts.size()) all.push_back(above / rest);
  }
  for (const char* exports : {"jpeg-exports", "cropped-files"}) {
    all.push_back(above / exports / parts.back());
  }
  return all;
}

const ListedPictures::Names& ListedPictures::names_in(const fs::path& folder) {
  const auto [at, fresh] = listings_.try_emplace(folder);
  std::error_code error;
  if (!fresh) return at->second;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    at->second.emplace(lower(name), name);
  }
  return at->second;
}

std::optional<fs::path> ListedPictures::in_any_case(const fs::path& candidate,
                                                    const std::string& place) {
  fs::path found = candidate.is_absolute() ? candidate.root_path() : fs::path(".");
  for (const fs::path& part : candidate.relative_path()) {
    std::error_code ignored;
    if (part == "." || part == ".." || fs::exists(found / part, ignored)) {
      found /= part;
      continue;
    }
    const auto [first, last] = names_in(found).equal_range(lower(part.string()));
    if (first == last) return std::nullopt;
    if (std::next(first) != last) {
      throw InputError(list_.string(), place,
                       golden::quoted(part.string()) + ", which is " + first->second + " or " +
                           std::next(first)->second + " in " + found.string(),
                       "a name that tells them apart");
    }
    found /= first->second;
  }
  if (!is_file(found)) return std::nullopt;
  return found.lexically_proximate(fs::path("."));
}

std::optional<fs::path> ListedPictures::find(const std::string& name, const std::string& place) {
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const std::vector<fs::path> all = candidates(slashed);
  std::optional<fs::path> found;
  for (std::size_t i = 0; i < all.size() && !found; ++i) {
    if (is_file(all[i])) found = all[i];
  }
  for (std::size_t i = 0; i < all.size() && !found; ++i) {
    found = in_any_case(all[i], place);
    if (found) other_case_.add(name, found->filename());
  }
  if (!found) return std::nullopt;
  // What lies in the list's own folder or as the list says needs no word.
  const fs::path expected = (folder_ / fs::path(slashed)).lexically_normal();
  const bool beside =
      found->lexically_normal().parent_path() == (folder_ / "any").lexically_normal().parent_path();
  if (!beside && lower(found->lexically_normal().string()) != lower(expected.string())) {
    other_folder_.add(name, found->parent_path().lexically_normal());
  }
  return found;
}

void ListedPictures::finish(std::vector<std::string>& notes) const {
  if (other_case_.times > 0) {
    notes.push_back(
        std::to_string(other_case_.times) +
        " names of the list have letters of another case than the files; the first is '" +
        other_case_.name + "', taken for " + other_case_.found);
  }
  if (other_folder_.times > 0) {
    notes.push_back(std::to_string(other_folder_.times) +
                    " pictures were not where the list says; the first, '" + other_folder_.name +
                    "', was found in " + other_folder_.found);
  }
}

}  // namespace ptm::golden
