// The scripted player recovers when no place that it knows is near.
#include <gtest/gtest.h>

#include <vector>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/made_rooms.h"
#include "scripted_player/navigation/level_map.h"
#include "scripted_player/session/session.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

namespace field = server::field;

// A hall with a gallery that cannot be reached. Its parapet ends 80 units before the gallery does.
std::string hall_with_gallery(const std::string& brushes) {
  return entity_text("worldspawn", "",
                     walls_text({0, 0, 0}, {1024, 256, 256}, "wall") +
                         box_text({300, 0, 142}, {600, 48, 150}, "gallery") +
                         box_text({300, 40, 150}, {520, 48, 256}, "parapet") + brushes) +
         entity_text("info_player_start", "\"origin\" \"64 128 32\"\n\"angle\" \"0\"") +
         exit_text({960, 0, 0}, {1024, 256, 96});
}

struct Outcome {
  bool wanted_to_restart = false;
  math::Vec3 at{0.0f};
};

// Puts the player at `origin` and plays for 30 seconds, or until it comes near the exit.
Outcome play_from(const std::string& map_text, const math::Vec3& origin) {
  const MadeRooms rooms(map_text);
  const auto session = player::Session::start(rooms.setup().session).value();
  std::vector<net::Move> moves(1);
  for (int i = 0; i < 72; ++i) session->step(moves);
  const std::size_t slot = session->slot(0);
  const auto map = player::LevelMap::make(session->game());
  player::Brain brain(*map, session->game(), player::BrainSetup{.slot = slot});
  session->game().player(slot).set(field::kOrigin, origin);
  Outcome outcome;
  for (int i = 0; i < 30 * 72; ++i) {
    moves[0] = brain.think(session->game(), {}, session->now_s());
    outcome.wanted_to_restart |= brain.wants_restart();
    session->step(moves);
    outcome.at = session->game().player(slot)[field::kOrigin];
    if (outcome.at.x > 940) break;
  }
  return outcome;
}

TEST(Recovery, ReturnsFromAGalleryThatCannotBeReached) {
  for (const float x : {330.0f, 420.0f, 510.0f}) {
    const Outcome outcome = play_from(hall_with_gallery(""), {x, 20, 174.1f});
    EXPECT_GT(outcome.at.x, 940) << x;
    EXPECT_FALSE(outcome.wanted_to_restart) << x;
  }
}

TEST(Recovery, RestartsTheLevelWhenTrapped) {
  const std::string closed = box_text({520, 40, 150}, {600, 48, 256}, "parapet") +
                             box_text({600, 0, 142}, {608, 48, 256}, "parapet") +
                             box_text({292, 0, 142}, {300, 48, 256}, "parapet");
  const Outcome outcome = play_from(hall_with_gallery(closed), {420, 20, 174.1f});
  EXPECT_TRUE(outcome.wanted_to_restart);
  EXPECT_LT(outcome.at.x, 600);
}

// The lift rises with the player, who is then put on the edge of the floor below it, and has to ride it
// again.
TEST(Recovery, StepsAsideForALiftThatIsAbove) {
  const std::string floor =
      box_text({0, 0, 0}, {472, 256, 32}, "floor") + box_text({472, 0, 0}, {600, 64, 32}, "floor") +
      box_text({472, 192, 0}, {600, 256, 32}, "floor") + box_text({600, 0, 0}, {1024, 256, 160}, "floor");
  const Outcome outcome = play_from(
      entity_text("worldspawn", "", walls_text({0, 0, 0}, {1024, 256, 256}, "wall") + floor) +
          entity_text("info_player_start", "\"origin\" \"536 128 64\"\n\"angle\" \"0\"") +
          entity_text("func_plat", "\"height\" \"128\"", box_text({472, 64, 144}, {600, 192, 160}, "lift")) +
          exit_text({960, 0, 160}, {1024, 256, 256}),
      {536, 72, 56.1f});
  EXPECT_GT(outcome.at.x, 940);
}

}  // namespace
}  // namespace temblor::test
