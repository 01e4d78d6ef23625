// Where the WADs that a map names may lie: pure functions on text, which touch no disk.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::compiler {

// The entries of worldspawn's `wad` key: between semicolons, without the white space and the quotes around
// them. Empty ones are left out.
std::vector<std::string> split_wad_key(std::string_view value);

// The paths to try for one entry, best first, each once:
//   1. where the entry says, seen from the map's folder, then from the current one (an absolute path: as it
//   is);
//   2. seen from each of `wad_folders`;
//   3. its file name alone in the map's folder and in each of `wad_folders`, also in small letters.
// Backslashes separate folders too. Paths from another system's root ("C:\quake\x.wad", "\quake\x.wad") have
// no place here, so only their file names are tried. A name without an extension gets ".wad".
std::vector<std::filesystem::path> wad_candidates(std::string_view entry,
                                                  const std::filesystem::path& map_folder,
                                                  std::span<const std::filesystem::path> wad_folders);

}  // namespace temblor::compiler
