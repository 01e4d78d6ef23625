#include "assets/mission_pack.h"

#include <algorithm>
#include <ranges>

#include "base/text.h"

namespace temblor::assets {
namespace {

struct PackFolder {
  std::string_view name, option;
  MissionPack pack;
};
constexpr PackFolder kPackFolders[] = {{"hipnotic", "-hipnotic", MissionPack::kHipnotic},
                                       {"quoth", "-quoth", MissionPack::kHipnotic},
                                       {"rogue", "-rogue", MissionPack::kRogue}};

}  // namespace

MissionPack find_mission_pack(const vfs::FileSystem& files) {
  for (const std::filesystem::path& folder : files.folders() | std::views::reverse) {
    const std::string name = folder.filename().string();
    for (const PackFolder& known : kPackFolders)
      if (base::equal_ignoring_case(name, known.name)) return known.pack;
  }
  return MissionPack::kNone;
}

std::optional<std::string_view> find_pack_folder(std::string_view option) {
  const auto found = std::ranges::find(kPackFolders, option, &PackFolder::option);
  if (found == std::end(kPackFolders)) return std::nullopt;
  return found->name;
}

}  // namespace temblor::assets
