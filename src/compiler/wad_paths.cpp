// Maps are often made on Windows and compiled on Linux, so entries may have drives, backslashes and other
// case.
#include "compiler/wad_paths.h"

#include <algorithm>

#include "base/text.h"

namespace temblor::compiler {
namespace {

namespace fs = std::filesystem;

std::string_view trim(std::string_view text) {
  constexpr std::string_view kAround = " \t\r\n\"'";
  const std::size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kAround) - first + 1);
}

// Whether the entry begins with a drive, or with a root or server written with backslashes.
bool is_foreign(std::string_view entry) {
  const char first = entry.empty() ? '\0' : base::to_lower(entry[0]);
  return first == '\\' || (entry.size() >= 2 && entry[1] == ':' && first >= 'a' && first <= 'z');
}

fs::path to_path(std::string_view entry) {
  std::string text(entry);
  std::ranges::replace(text, '\\', '/');
  fs::path path(std::move(text));
  if (path.has_filename() && !path.has_extension()) path += ".wad";
  return path;
}

}  // namespace

std::vector<std::string> split_wad_key(std::string_view value) {
  std::vector<std::string> entries;
  while (!value.empty()) {
    const std::size_t end = std::min(value.find(';'), value.size());
    if (const std::string_view entry = trim(value.substr(0, end)); !entry.empty())
      entries.emplace_back(entry);
    value.remove_prefix(std::min(end + 1, value.size()));
  }
  return entries;
}

std::vector<fs::path> wad_candidates(std::string_view entry, const fs::path& map_folder,
                                     std::span<const fs::path> wad_folders) {
  const fs::path path = to_path(entry);
  std::vector<fs::path> candidates;
  if (!path.has_filename()) return candidates;
  const auto add = [&](const fs::path& candidate) {
    fs::path normal = candidate.lexically_normal();
    if (std::ranges::find(candidates, normal) == candidates.end()) candidates.push_back(std::move(normal));
  };
  if (!is_foreign(entry)) {
    add(map_folder / path);  // an absolute path replaces the folder
    add(path);
    for (const fs::path& folder : wad_folders) add(folder / path);
  }
  for (const fs::path& name : {path.filename(), fs::path(base::to_lower(path.filename().string()))}) {
    add(map_folder / name);
    for (const fs::path& folder : wad_folders) add(folder / name);
  }
  return candidates;
}

}  // namespace temblor::compiler
