#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace ptm::golden {

/// The name of a relightable picture that is not a .ptm, or of another file that stands where one
/// would be given: RTIViewer's .rti (harmonics), Relight's info.json, a Nexus mesh, an archive. By
/// its first bytes; `extension` (lower case, with its point) where a format has no mark. Empty for
/// anything else.
[[nodiscard]] std::optional<std::string> relightable_kind(std::string_view head,
                                                          std::string_view extension);

}  // namespace ptm::golden
