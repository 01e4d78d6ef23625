// A game and a recording in it, both made in code, with all that stock recordings do not show: a script of 17
// seconds in which every effect happens by itself.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "math/vec.h"
#include "net/protocol/protocol.h"
#include "support/programs/small_game.h"

namespace temblor::test {

// id1 with the level "small", models and sprites in progs/, and all 2-D art.
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
// 0-4      a walker crosses the hall from left to right, 50 units a second, swinging its legs; a ball stands
//          to the right; the door is where it belongs; a text for two seconds
// 1.0      the player fires: the weapon kicks back, lit by its flash as the floor below it is; two shots hit
//          the floor, one the walker, who bleeds
// 2.0-3.0  a rocket flies to the right with smoke and light
// 3.0      it explodes: sparks, and light that fades within half a second
// 4.0-4.6  spike, big spike, wizard's and knight's spikes hit the floor before the player
// 5.0      a spawn bursts: purple and dark red drops, no light
// 6.0      an explosion in eight blues, with light
// 7.0      the walker is gone; where it comes out, in the middle of the hall, a teleport's column of sparks
// 8.0      lava splashes up from the middle of the hall, for two seconds
// 10.2     a sprite stands in a cloud of sparks (bright field), then in bright light (10.6), in dim light
// (11) 11.5     lightning of three kinds and a beam, half a second each; the first from the player's hand
// 13.5     the player is hurt: red flash, the face in pain, 42 health
// 14.0     he takes armor, a key and quad damage: a golden flash, then all is blue; 150 armor
// 14.5     the light goes out but for style 1's
// 15.0     intermission, from above the court: 0:16 on the clock, 1 of 2 secrets, 3 of 4 monsters
namespace made_recording {

constexpr double kLength_s = 17;
constexpr double kFirstTime_s = 1;  // the server's, at second 0
constexpr double kPacket_s = 0.05;

constexpr math::Vec3 kPlayer{48, 256, 24};
constexpr math::Vec3 kRocketFrom{70, 240, 40}, kRocketTo{370, 150, 50};  // at seconds 2 and 3
constexpr math::Vec3 kMiddle{220, 256, 40};                              // of most explosions
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

// In any dialect. Protocols 666 and 999 have a walker that is half clear until second 1 besides.
MadeRecording make_recording(const net::Dialect& dialect);

}  // namespace temblor::test
