// Small levels compiled from map text, in a base directory with the shipped game code.
#pragma once

#include <string>
#include <string_view>

#include "compiler/compile_options.h"
#include "scripted_player/session/run.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

class MadeRooms {
 public:
  // Compiles the level as "rooms". CHECKs that it compiles and does not leak.
  explicit MadeRooms(const std::string& map_text,
                     compiler::StagePolicy visibility = compiler::StagePolicy::kSkip);

  // Skill 1, one player.
  player::RunSetup setup() const;
  player::RunReport play() const { return player::play_level(setup()).value(); }

 private:
  TemporaryFolder folder_;
};

// Returns the map text of a trigger_changelevel that fills that box.
std::string exit_text(const math::Vec3& mins, const math::Vec3& maxs);

}  // namespace temblor::test
