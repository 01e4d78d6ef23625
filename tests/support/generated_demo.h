// A game and a demo, both made in code. The demo shows what stock demos do not: in 17 seconds, every effect
// appears separately.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "math/vec.h"
#include "net/protocol/protocol.h"
#include "support/programs/small_game.h"

namespace temblor::test {

// Writes id1 with the level "small", models and sprites in progs/, and all 2D art.
class MadeGame {
 public:
  MadeGame();
  const TemporaryFolder& folder() const { return game_.folder(); }
  const std::filesystem::path& path() const { return game_.path(); }

 private:
  SmallGame game_;
};

// The script. Seconds from the recording's first packet with a time on; packets come 20 times a second.
//
// 0-15     the player stands at the hall's west end and looks east, weapon in hand; health 100, 25 shells
// 0-4      a walker crosses the hall from left to right, 50 units per second, swinging its legs; a ball
//          stands to the right; the door is closed; a message for two seconds
// 1.0      the player fires: the weapon kicks back; its flash lights it and the floor below; two shots hit
//          the floor, one the walker, which bleeds
// 2.0-3.0  a rocket flies to the right with smoke and light
// 3.0      it explodes: sparks, and light that fades within half a second
// 4.0-4.6  spike, big spike, wizard's and knight's spikes hit the floor in front of the player
// 5.0      a spawn bursts: purple and dark red drops, without light
// 6.0      an explosion in eight blues, with light
// 7.0      the walker teleports: a column of sparks at its destination, in the middle of the hall
// 8.0      lava splashes up from the middle of the hall, for two seconds
// 10.2     a sprite stands in a cloud of sparks (bright field), in bright light (10.6), in dim light (11)
// 11.5     lightning of three kinds and a beam, half a second each; the first from the player's hand
// 13.5     the player is hurt: red flash, the face in pain, 42 health
// 14.0     it picks up armor, a key, and Quad Damage: a golden flash, then a blue tint; 150 armor
// 14.5     the lights go out, except for those of style 1
// 15.0     intermission, from above the court: 0:16 on the clock, 1 of 2 secrets, 3 of 4 monsters
namespace made_recording {

constexpr double kLength_s = 17;
constexpr double kFirstTime_s = 1;  // server time at second 0
constexpr double kPacket_s = 0.05;

constexpr math::Vec3 kPlayer{48, 256, 24};
constexpr math::Vec3 kRocketFrom{70, 240, 40}, kRocketTo{370, 150, 50};  // at seconds 2 and 3
constexpr math::Vec3 kMiddle{220, 256, 40};                              // the place of most explosions
constexpr math::Vec3 kAboveTheCourt{800, 32, 200};
constexpr std::uint8_t kFirstBlue = 244, kBlues = 8;

constexpr math::Vec3 walker_at(double second) {
  return {180, 400 - 50 * static_cast<float>(second), 24};
}

}  // namespace made_recording

struct MadeRecording {
  base::ByteVector bytes;
  std::size_t records = 0, messages = 0;
};

// Makes the demo in any dialect. In protocols 666 and 999, the walker is also half transparent until second
// 1.
MadeRecording make_recording(const net::Dialect& dialect);

}  // namespace temblor::test
