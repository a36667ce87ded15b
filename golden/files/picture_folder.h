#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// Order of names, runs of digits compared as numbers and letters by no case: "a2" before "A10".
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

/// The pictures of a folder in natural order of their names: plain files whose extension belongs to
/// a picture format that OpenImageIO knows (films are none), hidden ones left out.
/// Throws InputError if there are not `lights` of them; it says which kinds were counted and what
/// has the lights: "one for each light of the table".
[[nodiscard]] std::vector<std::filesystem::path> pictures_of(const std::filesystem::path& folder,
                                                             std::size_t lights,
                                                             const std::string& of_what);

/// How many pictures a folder has, counted alike.
[[nodiscard]] std::size_t count_pictures(const std::filesystem::path& folder);

/// Finds the pictures that a list names, as lists move from one machine to another.
///
/// With the list in folder F, a name is sought, the first that exists being taken:
///  1. as it is written, beside the list;
///  2. without the drive and the first folders of its path, one after the other, in F and in the
///     folder above: "C:\\dome\\jpeg-exports\\a.jpg" is F/jpeg-exports/a.jpg, ../jpeg-exports/a.jpg
///     or F/a.jpg;
///  3. by its bare name in ../jpeg-exports and ../cropped-files, where RTIBuilder keeps the
///  pictures
///     of the lists that it writes to assembly-files;
///  4. all of this again with letters of either case, where that leaves one file only.
/// Backslashes part folders as well as slashes.
class ListedPictures {
 public:
  explicit ListedPictures(std::filesystem::path list);

  /// None if there is no such file. Throws InputError (`place`) if two files differ from the name
  /// in the case of letters only.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name,
                                                          const std::string& place);
  /// One note for all names of another case, one for all pictures of other folders.
  void finish(std::vector<std::string>& notes) const;

 private:
  /// What happened to some of the names, told by the first of them.
  struct Told {
    std::size_t times = 0;
    std::string name, found;
    void add(const std::string& listed, const std::filesystem::path& picture);
  };
  using Names = std::multimap<std::string, std::string>;  ///< of a folder's files, by lower case

  [[nodiscard]] std::vector<std::filesystem::path> candidates(
      const std::filesystem::path& name) const;
  const Names& names_in(const std::filesystem::path& folder);
  std::optional<std::filesystem::path> in_any_case(const std::filesystem::path& candidate,
                                                   const std::string& place);

  std::filesystem::path list_, folder_;
  std::map<std::filesystem::path, Names> listings_;
  Told other_case_, other_folder_;
};

}  // namespace ptm::golden
