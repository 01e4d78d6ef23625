#include "app/installs/store_files.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Longer texts are no paths.
constexpr std::size_t kMaxPathChars = 4096;

void add_path(std::string_view text, std::vector<fs::path>& io_paths) {
  const bool is_absolute =
      text.starts_with('/') && text.size() <= kMaxPathChars && text.find('\0') == std::string_view::npos;
  if (is_absolute && io_paths.size() < kMaxStorePaths) io_paths.emplace_back(text);
}

// Takes the next text in quotes off the front. A backslash makes the next character part of the text: enough
// for paths, in which other escapes do not occur. Returns nullopt at the end.
std::optional<std::string> take_quoted(std::string_view& io_text) {
  const std::size_t open = io_text.find('"');
  if (open == std::string_view::npos) return std::nullopt;
  std::string quoted;
  for (std::size_t i = open + 1; i < io_text.size(); ++i) {
    if (io_text[i] == '"') {
      io_text.remove_prefix(i + 1);
      return quoted;
    }
    if (io_text[i] == '\\' && i + 1 < io_text.size()) ++i;
    quoted += io_text[i];
  }
  return std::nullopt;
}

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Adds each text that follows a key for which `is_wanted` holds.
template <typename IsWanted>
std::vector<fs::path> read_values(std::string_view text, IsWanted is_wanted) {
  std::vector<fs::path> paths;
  std::string key;
  while (std::optional<std::string> next = take_quoted(text)) {
    if (is_wanted(key)) add_path(*next, paths);
    key = *std::move(next);
  }
  return paths;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r'\"";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

}  // namespace

std::vector<fs::path> read_steam_libraries(std::string_view vdf) {
  return read_values(vdf, [](std::string_view key) { return key == "path" || is_number(key); });
}

std::vector<fs::path> read_heroic_folders(std::string_view json) {
  return read_values(json, [](std::string_view key) { return key == "install_path"; });
}

std::vector<fs::path> read_lutris_paths(std::string_view yml) {
  constexpr std::array<std::string_view, 4> kKeys = {"exe", "main_file", "working_dir", "prefix"};
  std::vector<fs::path> paths;
  while (!yml.empty()) {
    const std::string_view line = yml.substr(0, yml.find('\n'));
    yml.remove_prefix(std::min(line.size() + 1, yml.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    if (std::find(kKeys.begin(), kKeys.end(), trim(line.substr(0, colon))) != kKeys.end())
      add_path(trim(line.substr(colon + 1)), paths);
  }
  return paths;
}

}  // namespace temblor::app
