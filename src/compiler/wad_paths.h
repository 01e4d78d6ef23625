// Where to look for the WADs that a map names: pure functions of text that never touch the disk.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::compiler {

// Splits worldspawn's `wad` key at its semicolons, and removes white space and quotes around each entry.
// Empty entries are left out.
std::vector<std::string> split_wad_key(std::string_view value);

// The paths to try for one entry, best first, without duplicates:
//   1. as written, relative to the map's folder, then to the current folder (an absolute path as it is);
//   2. relative to each of `wad_folders`;
//   3. only the file name, in the map's folder and in each of `wad_folders`, also in lower case.
// A backslash separates folders, too. For paths from another system's root ("C:\quake\x.wad", "\quake\x.wad")
// only the file name is tried. A name without extension gets ".wad".
std::vector<std::filesystem::path> wad_candidates(std::string_view entry,
                                                  const std::filesystem::path& map_folder,
                                                  std::span<const std::filesystem::path> wad_folders);

}  // namespace temblor::compiler
