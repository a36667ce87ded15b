#include "contract/generator/output.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace ptm::contract {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) {
  if (text_of(path) == text) return;
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

/// The page with the block in it; what it should say.
std::string with_block(const std::string& page, const Output& output) {
  std::string begin = "<!-- contract: " + output.block + " -->\n", end = "<!-- end -->";
  if (output.path.ends_with(".json")) {
    begin = "\"$comment\": \"contract: " + output.block + "\",\n";
    end = "\"description\": \"contract: end\"";
  }
  const std::size_t from = page.find(begin);
  std::size_t to = from == std::string::npos ? from : page.find(end, from);
  if (to == std::string::npos) {
    throw std::runtime_error(output.path + ": found no lines " + begin.substr(0, begin.size() - 1) +
                             " and " + end);
  }
  to = page.rfind('\n', to) + 1;  // the mark's line, from its indent on
  return page.substr(0, from + begin.size()) + output.text + page.substr(to);
}

/// What the file that holds an output should hold, its other parts as they are.
std::string wanted(const Output& output, const fs::path& repository) {
  if (output.kind != Output::Kind::block) return output.text;
  const auto page = text_of(repository / output.path);
  if (!page) throw std::runtime_error(output.path + ": cannot be read");
  return with_block(*page, output);
}

}  // namespace

void write_outputs(const Outputs& outputs, const fs::path& folder) {
  for (const Output& output : outputs) {
    fs::path path = folder;
    if (output.kind != Output::Kind::build) path /= "committed";
    path /= output.path;
    if (output.kind == Output::Kind::block) path /= output.block;
    write(path, output.text);
  }
}

void refresh_committed(const Outputs& outputs, const fs::path& repository) {
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::build) continue;
    write(repository / output.path, wanted(output, repository));
  }
}

std::vector<std::string> stale_committed(const Outputs& outputs, const fs::path& repository) {
  std::vector<std::string> stale;
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::build) continue;
    const std::string what = output.path + (output.block.empty() ? "" : " (" + output.block + ")");
    const auto found = text_of(repository / output.path);
    if (!found) {
      stale.push_back(what + " is missing");
    } else if (*found != wanted(output, repository)) {
      stale.push_back(what + " is not what the tables say");
    }
  }
  return stale;
}

}  // namespace ptm::contract
