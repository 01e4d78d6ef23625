// The host's commands: remote console, kicks and bans, recordings, cheats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(HostCommands, RemoteConsoleNeedsItsPassword) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("host");
  ASSERT_TRUE(served.run_until_playing(me));
  served.client(me).send_command("rcon anything status");
  served.run(1);
  EXPECT_THAT(served.prints(me), HasSubstr("Wrong rcon password"));
  served.command("rcon_password secret");
  served.run(0.1);
  served.client(me).send_command("rcon secret status");
  served.run(1);
  EXPECT_THAT(served.prints(me), HasSubstr("map:     small"));
}

TEST(HostCommands, RemotePasswordsMayHaveBlanks) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("host");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("rcon_password \"a long sentence\"");
  served.run(0.1);
  served.client(me).send_command("rcon \"a long sentence\" say it works");
  served.run(1);
  EXPECT_THAT(served.prints(me), HasSubstr("it works"));
  EXPECT_THAT(served.console(), Not(HasSubstr("sentence")));
}

TEST(HostCommands, ABannedPlayersAddressCanBeUnbanned) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t rogue = served.add_client("rogue");
  ASSERT_TRUE(served.run_until_playing(rogue));
  served.command("ban #1");
  served.run(1);
  ASSERT_EQ(served.server().endpoint.bans().size(), 1u);
  served.client(rogue).connect(kServedAddress, served.now_s());
  EXPECT_FALSE(served.run_until_playing(rogue));
  served.command("unban 10.0.0.2");
  served.run(1);
  EXPECT_TRUE(served.server().endpoint.bans().empty()) << served.console();
  served.client(rogue).connect(kServedAddress, served.now_s());
  EXPECT_TRUE(served.run_until_playing(rogue));
}

// The server's output for one line of its console.
std::string answer(ServedGame& io_served, std::string_view line) {
  const std::size_t before = io_served.console().size();
  io_served.command(line);
  io_served.run(0.1);
  return io_served.console().substr(before);
}

TEST(HostCommands, LettersAreNotNumbers) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
  EXPECT_EQ(answer(served, "edict abc"), "edict: \"abc\" is not a number\n");
  EXPECT_EQ(answer(served, "edict 1x"), "edict: \"1x\" is not a number\n");
  EXPECT_THAT(answer(served, "edict 99999"), HasSubstr("there is no entity 99999; the last one is "));
  EXPECT_THAT(answer(served, "edict -1"), HasSubstr("there is no entity -1"));
  EXPECT_THAT(answer(served, "edict 1"), HasSubstr("progs/player.mdl"));
  EXPECT_THAT(answer(served, "kick #one"), HasSubstr("\"#one\" is not a player number"));
  EXPECT_THAT(answer(served, "ban #"), HasSubstr("\"#\" is not a player number"));
  EXPECT_THAT(answer(served, "record film two"), HasSubstr("\"two\" is not a number"));
  EXPECT_THAT(answer(served, "record film 0"), HasSubstr("no player 0"));
  EXPECT_THAT(answer(served, "sv_gravity high"), HasSubstr("cannot be \"high\""));
  EXPECT_EQ(served.server().clients.connected_count(), 1u);
}

TEST(HostCommands, WithoutArgumentsTheyPrintTheirUsage) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  for (const std::string name :
       {"map", "changelevel", "save", "load", "kick", "unban", "say", "record", "edict"})
    EXPECT_THAT(answer(served, name), ::testing::StartsWith(name + " ")) << name;
}

TEST(HostCommands, HelpListsThem) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::string list = answer(served, "help");
  for (const char* line : {"kick NAME or #NUMBER", "status: Shows the level", "exec FILE", "quit: "})
    EXPECT_THAT(list, HasSubstr(std::string("\n") + line));
}

TEST(HostCommands, SuccessIsPrinted) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("star");
  ASSERT_TRUE(served.run_until_playing(me));
  EXPECT_THAT(answer(served, "record film"), HasSubstr("Recording demo of star to "));
  EXPECT_THAT(answer(served, "stop"), HasSubstr("film.dem"));
  EXPECT_EQ(answer(served, "pause"), "Paused. Type pause to continue.\n");
  EXPECT_EQ(answer(served, "pause"), "Unpaused.\n");
  EXPECT_EQ(answer(served, "ban 198.51.100.7/24"),
            "198.51.100.0/24 is banned until the server shuts down; `unban 198.51.100.0/24` lifts the ban\n");
  EXPECT_EQ(answer(served, "unban 198.51.100.0/24"), "198.51.100.0/24 is no longer banned\n");
  EXPECT_THAT(answer(served, "unban 198.51.100.0/24"), HasSubstr("is not banned"));
  EXPECT_THAT(answer(served, "ban nobody"),
              HasSubstr("there is no such player, and 'nobody' is not a numeric IP address"));
  EXPECT_THAT(answer(served, "changelevel small"), HasSubstr("level small, protocol 15\n"));
  EXPECT_THAT(answer(served, "kick star enough is enough"), HasSubstr("removed: kicked: enough is enough"));
  EXPECT_EQ(served.client(me).disconnect_reason(), "kicked: enough is enough");
}

TEST(HostCommands, PlayersSeeChangedRules) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("sv_gravity 100; hostname Moon; sv_gravity 100");
  served.run(0.5);
  const std::string& prints = served.prints(me);
  const std::size_t first = prints.find("\"sv_gravity\" changed to \"100\"");
  ASSERT_NE(first, std::string::npos) << prints;
  EXPECT_EQ(prints.find("changed to", first + 30), std::string::npos) << prints;
}

TEST(HostCommands, ErrorsInFilesNameTheLine) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  served.server().console.set_loader([](std::string_view) -> base::Result<std::string> {
    return std::string("ban 198.51.100.0/24\nedict 5000\nkick nobody\nsv_maxrate 1\nsave here");
  });
  const std::string output = answer(served, "exec server.cfg");
  EXPECT_THAT(output, HasSubstr("server.cfg:2: there is no entity 5000"));
  EXPECT_THAT(output, HasSubstr("server.cfg:3: there is no player \"nobody\""));
  EXPECT_THAT(output,
              HasSubstr("server.cfg:4: sv_maxrate cannot be \"1\": it takes 0 or a whole number from 2500"));
  EXPECT_THAT(output, HasSubstr("server.cfg:5: only single-player games can be saved"));
  EXPECT_THAT(output, Not(HasSubstr("is banned"))) << "a file may hold many";
}

TEST(HostCommands, PlayersGiveThemselvesNumbersOnly) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  for (const char* line : {"give h many", "give x 1", "give"}) {
    served.client(me).send_command(line);
    served.run(0.2);
    EXPECT_EQ(served.game().player(0)[server::field::kHealth], 100) << line;
  }
  EXPECT_THAT(served.prints(me), HasSubstr("give h NUMBER: \"many\" is not a whole number"));
  EXPECT_THAT(served.prints(me), HasSubstr("Cannot give \"x\""));
  served.client(me).send_command("give h 250");
  served.run(0.2);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 250);
  served.client(me).send_command("give health 0");
  served.run(0.2);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 1) << "give never kills";
}

TEST(HostCommands, PlayersGiveThemselvesEverything) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  const server::Edict player = served.game().player(0);
  const auto answer_to = [&](const char* line) {
    const std::size_t before = served.prints(me).size();
    served.client(me).send_command(line);
    served.run(0.2);
    return served.prints(me).substr(before);
  };
  player.set(server::field::kWeapon, 8.0f);  // the super nailgun
  EXPECT_EQ(answer_to("give 4"), "You have the nailgun\n");
  EXPECT_EQ(player.whole(server::field::kItems), 4);
  EXPECT_EQ(answer_to("give n 30"), "You have 30 nails\n");
  EXPECT_EQ(player[server::field::kCurrentAmmo], 30) << "ammunition of the weapon in hand is shown";
  EXPECT_EQ(answer_to("give shells"), "You have 100 shells\n");
  EXPECT_EQ(player[server::field::kCurrentAmmo], 30);
  EXPECT_EQ(answer_to("give armor 120"), "You have 120 armor\n");
  EXPECT_FLOAT_EQ(player[server::field::kArmorType], 0.6f) << "yellow";
  player.set(server::field::kHealth, 7.0f);
  EXPECT_EQ(answer_to("give all"), "You have everything\n");
  // The seven weapons and the axe, the best armor, both keys; not the eighth weapon, which this program does
  // not have.
  EXPECT_EQ(player.whole(server::field::kItems), 127 | 4096 | 32768 | 131072 | 262144);
  EXPECT_EQ(player[server::field::kHealth], 100);
  EXPECT_EQ(player[server::field::kArmorValue], 200);
  EXPECT_EQ(player[server::field::kAmmoNails], 200);
  EXPECT_EQ(player[server::field::kAmmoCells], 100);
  player.set(server::field::kHealth, -7.0f);
  EXPECT_THAT(answer_to("give h 100"), HasSubstr("dead"));
  EXPECT_EQ(player[server::field::kHealth], -7);
}

TEST(HostCommands, PlayersWithTheSameNameGetNumbers) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  for (const char* name : {"player", "Player", "player"}) {
    const std::size_t client = served.add_client(name);
    ASSERT_TRUE(served.run_until_playing(client)) << client;
  }
  const auto& players = served.client(0).state().game().players;
  EXPECT_EQ(players[0].name, "player");
  EXPECT_EQ(players[1].name, "Player (2)");
  EXPECT_EQ(players[2].name, "player (3)");
  // A name of maximum length is cut, to make room for the number.
  served.client(0).send_command("name 123456789012345");
  served.client(1).send_command("name 123456789012345");
  served.run(0.5);
  EXPECT_EQ(players[0].name, "123456789012345");
  EXPECT_EQ(players[1].name, "12345678901 (2)");
  served.client(2).send_command("name \"\"");
  served.run(0.5);
  EXPECT_EQ(players[2].name, "player") << "a person is never \"unconnected\"";
  // A player who repeats its own name keeps it.
  served.client(0).send_command("name 123456789012345");
  served.run(0.5);
  EXPECT_EQ(players[0].name, "123456789012345");
  EXPECT_THAT(answer(served, "kick player"), HasSubstr("removed"));
}

}  // namespace
}  // namespace temblor::test
