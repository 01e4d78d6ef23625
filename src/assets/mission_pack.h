// The mission packs, whose items, weapons, and status bars differ from stock Quake's.
//
// No message and no file names the pack of a game: server and client find it by the game folders, each for
// itself, like other engines. A mod on top of a pack ("hipnotic", then "mymod") keeps the pack's rules.
#pragma once

#include <optional>
#include <string_view>

#include "vfs/file_system.h"

namespace temblor::assets {

enum class MissionPack {
  kNone,
  kHipnotic,  // Scourge of Armagon; also Quoth, a mod with the same weapons and status bar
  kRogue      // Dissolution of Eternity
};

// Returns the pack of the last mounted game folder named "hipnotic", "quoth", or "rogue", in upper or lower
// case.
MissionPack find_mission_pack(const vfs::FileSystem& files);

// Returns the folder of an option with which other engines select a pack: "-hipnotic", "-quoth", "-rogue".
std::optional<std::string_view> find_pack_folder(std::string_view option);

}  // namespace temblor::assets
