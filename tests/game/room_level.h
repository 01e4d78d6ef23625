// Levels of a few brushes, made for a test, with a file for every model that the game names, so that they
// need no data.
#pragma once

#include <filesystem>
#include <string>

#include "game/played_level.h"
#include "support/levels/room_map.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

// Whether the data contains the Tremor's models, which stock data lacks.
enum class HasTremor { kNo, kYes };
// The format of the level, and the boxes of its hulls.
enum class LevelFor { kQuake, kHalfLife };

class RoomData {
 public:
  // `map_text` describes a closed level, which becomes maps/room.bsp.
  explicit RoomData(const std::string& map_text, HasTremor has_tremor = HasTremor::kYes,
                    LevelFor level_for = LevelFor::kQuake);
  const std::filesystem::path& path() const { return folder_.path(); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

// A closed hall of this size, with additional brushes and entities. Starts are at its two ends in x, under
// the ceiling: players fall to the floor.
std::string hall_text(const math::Vec3d& mins, const math::Vec3d& maxs, const std::string& brushes = {},
                      const std::string& entities = {});

}  // namespace temblor::test
