// Small levels made of map text, in a base folder with the game's program.
#pragma once

#include <string>
#include <string_view>

#include "scripted_player/run.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

class MadeRooms {
 public:
  // The level's name is "rooms". CHECKs that it compiles, and that nothing leaks.
  explicit MadeRooms(const std::string& map_text);

  // Skill 1, one player.
  player::RunSetup setup() const;
  player::RunReport play() const { return player::play_level(setup()).value(); }

 private:
  TemporaryFolder folder_;
};

// A trigger_changelevel over that box.
std::string exit_text(const math::Vec3& mins, const math::Vec3& maxs);

}  // namespace temblor::test
