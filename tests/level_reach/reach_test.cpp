// The shipped levels, as the build compiled them: a player can reach every item, monster, and exit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "formats/levels/bsp.h"
#include "level_reach/explorer.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

std::vector<std::filesystem::path> shipped_levels() {
  const char* elsewhere = std::getenv("TEMBLOR_SHIPPED_LEVELS");
  const std::filesystem::path folder = elsewhere != nullptr ? elsewhere : TEMBLOR_GAME "/maps";
  std::vector<std::filesystem::path> levels;
  if (std::filesystem::is_directory(folder))
    for (const auto& file : std::filesystem::directory_iterator(folder))
      if (file.path().extension() == ".bsp" && !file.path().filename().string().starts_with("b_"))
        levels.push_back(file.path());
  std::sort(levels.begin(), levels.end());
  return levels;
}

std::shared_ptr<const world::Level> load(const std::filesystem::path& path) {
  base::Result<formats::Bsp> bsp = formats::read_bsp(read_file(path));
  EXPECT_TRUE(bsp.ok()) << path;
  if (!bsp.ok()) return nullptr;
  auto level = world::make_level(std::move(bsp).value(), path.stem().string());
  EXPECT_TRUE(level.ok()) << path;
  return level.ok() ? *level : nullptr;
}

bool boxes_overlap(const math::Bounds& a, const math::Bounds& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.mins[axis] > b.maxs[axis] || b.mins[axis] > a.maxs[axis]) return false;
  return true;
}

// Monsters that a trigger teleports into the level wait behind walls.
bool is_waiting(const world::Level& level, const math::Bounds& box) {
  return std::any_of(level.entities.begin(), level.entities.end(), [&](const formats::Entity& entity) {
    return entity.classname() == "trigger_teleport" && entity.find("targetname") &&
           boxes_overlap(entity_box(level, entity), box);
  });
}

bool is_for_players(std::string_view classname) {
  for (const std::string_view kind :
       {"item_", "weapon_", "monster_", "info_player_", "trigger_secret", "trigger_changelevel",
        "func_button", "trigger_setskill", "trigger_once"})
    if (classname.starts_with(kind)) return true;
  return false;
}

TEST(ShippedLevels, EverythingInThemCanBeReached) {
  if (shipped_levels().empty()) GTEST_SKIP() << "no levels were built";
  for (const std::filesystem::path& path : shipped_levels()) {
    const auto level = load(path);
    if (level == nullptr) continue;
    std::vector<math::Vec3> starts;
    for (const formats::Entity& entity : level->entities)
      if (entity.classname() == "info_player_start")
        starts.push_back(entity.find_vec3("origin").value_or(math::Vec3(0.0f)));
    EXPECT_EQ(starts.size(), 1u) << path << ": info_player_start";
    Explorer explorer(*level);
    explorer.explore(starts);
    for (const formats::Entity& entity : level->entities) {
      if (!is_for_players(entity.classname())) continue;
      math::Bounds box = entity_box(*level, entity);
      if (is_waiting(*level, box)) continue;
      // Flying and swimming monsters come to the player.
      if (entity.classname() == "monster_wizard" || entity.classname() == "monster_fish") continue;
      box.mins -= 8.0f;
      box.maxs += 8.0f;
      EXPECT_TRUE(explorer.touches(box)) << path.stem() << ": " << entity.classname() << " at "
                                         << fmt::format("{} {} {}", box.mins.x, box.mins.y, box.mins.z);
    }
  }
}

}  // namespace
}  // namespace temblor::test
