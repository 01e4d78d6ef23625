// The weapon and the items that a server sends, in stock games and in mission packs.
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "server/game/entity_fields.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

constexpr float kLaserCannon = 1 << 23;

// Returns the data that a client has after the player got these items and this weapon.
net::ClientData play(ServedGame& io_game, float weapon, float items, float items2) {
  const server::Edict player = io_game.game().player(0);
  player.set(server::field::kWeapon, weapon);
  player.set(server::field::kItems, items);
  if (const auto field = io_game.game().items2_field()) player.set(*field, items2);
  io_game.run(0.2);
  return io_game.client(0).state().game().data;
}

TEST(MissionPacks, SendTheIndexOfTheWeaponInEveryProtocol) {
  SKIP_WITHOUT_QUAKEC();
  for (const char* mod : {"hipnotic", "quoth", "rogue"})
    for (const char* protocol : {"15", "666", "999"}) {
      SCOPED_TRACE(testing::Message() << mod << ", protocol " << protocol);
      ServedGame served(small_program(".float items2;\n"), {.mod = mod});
      ASSERT_TRUE(served.variables().set("sv_protocol", protocol).ok());
      ASSERT_TRUE(server::start_map(served.server(), "small").ok());
      served.add_client("player");
      ASSERT_TRUE(served.run_until_playing(0));
      EXPECT_EQ(play(served, 1, 1, 0).active_weapon, 0);
      EXPECT_EQ(play(served, 4096, 1, 0).active_weapon, 12);
      EXPECT_EQ(play(served, kLaserCannon, 1, 0).active_weapon, 23);
      EXPECT_EQ(play(served, 0, 1, 0).active_weapon, 31) << "a bit that no weapon has";
      EXPECT_EQ(play(served, 1, kLaserCannon + 3, 0b1'0000'0110).items, 0x80000000u | 7u << 23 | 3u);
    }
}

TEST(MissionPacks, StockGamesSendTheBitsOfTheWeapon) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.mod = "mymod"});
  served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(0));
  served.game().machine().set_global_float(server::global::kServerFlags, 5);
  const net::ClientData data = play(served, 64, 65, 0);
  EXPECT_EQ(data.active_weapon, 64);
  EXPECT_EQ(data.items, 5u << 28 | 65u) << "runes";
  EXPECT_EQ(play(served, 4096, 65, 0).active_weapon, 0) << "the lowest byte";
}

}  // namespace
}  // namespace temblor::test
