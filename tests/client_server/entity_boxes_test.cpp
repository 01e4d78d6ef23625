#include "server/entity_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "client_server/served_game.h"
#include "server/game/entity_fields.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

bool contains(const std::vector<math::Bounds>& boxes, const math::Vec3& mins, const math::Vec3& maxs) {
  return std::ranges::any_of(boxes,
                             [&](const math::Bounds& box) { return box.mins == mins && box.maxs == maxs; });
}

TEST(EntityBoxes, AreWhereEntitiesCollide) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(0));
  server::Game& game = served.game();
  const std::size_t before = server::list_entity_boxes(game, 0).size();
  server::Edicts& edicts = game.world().edicts;
  const vm::EntityIndex monster = edicts.spawn(10).value(), turned = edicts.spawn(10).value();
  edicts[monster].set(server::field::kOrigin, {100, 200, 300});
  edicts[monster].set(server::field::kMins, {-16, -16, -24});
  edicts[monster].set(server::field::kMaxs, {16, 16, 32});
  edicts[turned].set(server::field::kSolid, 4);
  edicts[turned].set(server::field::kAngles, {0, 45, 0});
  edicts[turned].set(server::field::kAbsMin, {-50, -50, 0});
  edicts[turned].set(server::field::kAbsMax, {50, 50, 9});
  const std::vector<math::Bounds> boxes = server::list_entity_boxes(game, 0);
  EXPECT_EQ(boxes.size(), before + 2);
  EXPECT_TRUE(contains(boxes, {84, 184, 276}, {116, 216, 332}));
  EXPECT_TRUE(contains(boxes, {-50, -50, 0}, {50, 50, 9}));
  const math::Vec3 player = game.player(0)[server::field::kOrigin];
  EXPECT_FALSE(contains(boxes, player + math::Vec3(-16, -16, -24), player + math::Vec3(16, 16, 32)));
  EXPECT_TRUE(contains(server::list_entity_boxes(game, 1), player + math::Vec3(-16, -16, -24),
                       player + math::Vec3(16, 16, 32)));
  edicts.free(monster, 10);
  EXPECT_EQ(server::list_entity_boxes(game, 0).size(), before + 1);
}

}  // namespace
}  // namespace temblor::test
