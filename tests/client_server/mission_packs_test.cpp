// The weapon and the items that a server sends, in stock games and in mission packs.
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "server/game/baselines.h"
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

// Sends `give` commands, and returns the player.
server::Edict give(ServedGame& io_game, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    io_game.client(0).send_command("give " + word);
    io_game.run(0.2);
  }
  return io_game.game().player(0);
}

TEST(MissionPacks, GiveTheWeaponsOfHipnotic) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(".float items2;\n"), {.max_clients = 1, .mod = "hipnotic"});
  served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(0));
  const server::Edict player = give(served, {"9", "0", "6a"});
  EXPECT_EQ(player.whole(server::field::kItems), 8388608 | 128 | 65536);
  player.set(server::field::kWeapon, kLaserCannon);
  give(served, {"c 33"});
  EXPECT_EQ(player[server::field::kCurrentAmmo], 33);
  give(served, {"all"});
  EXPECT_EQ(player.whole(server::field::kItems),
            8388608 | 128 | 65536 | 127 | 4096 | 32768 | 131072 | 262144);
  EXPECT_EQ(player[*served.game().items2_field()], 0);
}

TEST(MissionPacks, GiveTheAmmunitionOfRogue) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(".float items2, ammo_nails1, ammo_lava_nails;\n"),
                    {.max_clients = 1, .mod = "rogue"});
  served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(0));
  const vm::Program& program = served.game().machine().program();
  const auto nails = *server::float_field(program, "ammo_nails1");
  const auto lava_nails = *server::float_field(program, "ammo_lava_nails");
  const server::Edict player = served.game().player(0);
  player.set(server::field::kWeapon, 4.0f);  // the nailgun
  give(served, {"n 30", "l 40"});
  EXPECT_EQ(player[nails], 30);
  EXPECT_EQ(player[lava_nails], 40);
  EXPECT_EQ(player[server::field::kAmmoNails], 30);
  EXPECT_EQ(player[server::field::kCurrentAmmo], 30);
  player.set(server::field::kWeapon, 4096.0f);  // the same with lava nails
  give(served, {"n 50", "l 60", "a 120"});
  EXPECT_EQ(player[nails], 50);
  EXPECT_EQ(player[server::field::kAmmoNails], 60);
  EXPECT_EQ(player[server::field::kCurrentAmmo], 60);
  EXPECT_EQ(player.whole(server::field::kItems), 0);
  EXPECT_EQ(player[*served.game().items2_field()], 2) << "yellow armor";
  give(served, {"all"});
  EXPECT_EQ(player.whole(server::field::kItems), 127 | 2048 | 131072 | 262144);
  EXPECT_EQ(player[*served.game().items2_field()], 4) << "red armor";
}

}  // namespace
}  // namespace temblor::test
