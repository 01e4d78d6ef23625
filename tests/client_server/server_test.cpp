// A whole server with our clients, over a network that the test controls.
#include "server/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <map>

#include "client/demo/demo_player.h"
#include "client_server/served_game.h"
#include "formats/levels/bsp.h"
#include "support/programs/quakec.h"
#include "vfs/disk.h"

namespace temblor::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

net::Move forward(std::int16_t speed = 400) {
  return {.forward = speed};
}

TEST(Server, ClientJoinsAndSeesTheLevel) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me)) << served.client(me).disconnect_reason() << served.console();
  const client::Game& seen = served.client(me).state().game();
  EXPECT_EQ(seen.level_name, "Made in code");
  EXPECT_EQ(seen.models[1], "maps/small.bsp");
  EXPECT_EQ(seen.dialect.protocol, net::Protocol::kNetQuake);
  EXPECT_EQ(seen.players[0].name, "tester");
  EXPECT_EQ(seen.players[0].shirt, 4);
  EXPECT_EQ(seen.players[0].pants, 7);
  EXPECT_EQ(seen.view_entity, 1);
  EXPECT_EQ(seen.light_styles[1], "az");
  EXPECT_EQ(seen.data.health, 100);
  EXPECT_THAT(served.prints(me), HasSubstr("tester is here"));
  EXPECT_THAT(served.console(), HasSubstr("tester entered the game"));
}

TEST(Server, PlayerWalksWhereItLooks) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("walker");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(1);
  const math::Vec3 before = served.game().player(0)[server::field::kOrigin];
  served.run(0.5, forward());
  const math::Vec3 after = served.game().player(0)[server::field::kOrigin];
  // At most 320 units per second, reached within a few tenths of a second.
  EXPECT_GT(after.x - before.x, 80);
  EXPECT_LT(after.x - before.x, 165);
  EXPECT_NEAR(after.y, before.y, 1);
}

TEST(Server, ImpulsesArriveOnce) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(0.5);
  served.run(0.01, {.impulse = 7});
  served.run(0.5);
  const std::string& prints = served.prints(me);
  const std::size_t first = prints.find("7!");
  ASSERT_NE(first, std::string::npos) << prints;
  EXPECT_EQ(prints.find("7!", first + 1), std::string::npos) << prints;
}

TEST(Server, PlayersSeeAndHearOneAnother) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t a = served.add_client("ann"), b = served.add_client("bob");
  ASSERT_TRUE(served.run_until_playing(a));
  ASSERT_TRUE(served.run_until_playing(b));
  served.client(a).send_command("say hello there");
  served.run(1);
  EXPECT_THAT(served.prints(b), HasSubstr("ann: hello there"));
  const client::Game& seen = served.client(b).state().game();
  EXPECT_EQ(seen.players[0].name, "ann");
  EXPECT_EQ(seen.players[1].name, "bob");
  bool sees_other = false;
  for (const client::InterpolatedEntity& entity :
       served.client(b).state().interpolate_entities(served.client(b).state().time_s(), {}))
    sees_other |= entity.number == 1;
  EXPECT_TRUE(sees_other);
}

TEST(Server, LeavingIsAnnouncedToAll) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t a = served.add_client("ann"), b = served.add_client("bob");
  ASSERT_TRUE(served.run_until_playing(a));
  ASSERT_TRUE(served.run_until_playing(b));
  served.client(a).disconnect();
  served.run(1);
  EXPECT_THAT(served.prints(b), HasSubstr("ann has left"));
  EXPECT_EQ(served.client(b).state().game().players[0].name, "");
  EXPECT_EQ(served.server().clients.connected_count(), 1u);
}

TEST(Server, FullServersRefuseClients) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  ASSERT_TRUE(served.run_until_playing(served.add_client("first")));
  const std::size_t second = served.add_client("second");
  EXPECT_FALSE(served.run_until_playing(second));
  EXPECT_THAT(served.client(second).disconnect_reason(), HasSubstr("full"));
}

TEST(Server, LevelChangesKeepPlayersAndTheirItems) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("traveler");
  ASSERT_TRUE(served.run_until_playing(me));
  served.game().machine().set_global_float(server::global::kServerFlags, 3);
  served.command("changelevel small");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 101);  // SetChangeParms
  EXPECT_EQ(served.game().server_flags(), 3);
  served.command("restart");
  served.run(3);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 101);
  served.command("map small");
  served.run(3);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 100);
  EXPECT_EQ(served.game().server_flags(), 0);
}

// Moves of the old level are still in flight when the server already uses another protocol.
TEST(Server, LevelChangesToAnotherProtocolKeepPlayers) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.conditions = {.delay_s = 0.1, .jitter_s = 0.05}});
  const std::size_t me = served.add_client("traveler");
  ASSERT_TRUE(served.run_until_playing(me));
  for (const auto& [name, protocol] :
       {std::pair{"666", net::Protocol::kFitzQuake}, std::pair{"15", net::Protocol::kNetQuake},
        std::pair{"999", net::Protocol::kRmq}}) {
    ASSERT_TRUE(served.variables().set("sv_protocol", name).ok());
    served.run(1, forward());
    served.command("changelevel small");
    served.run(5, forward());
    ASSERT_TRUE(served.client(me).is_playing()) << name << ' ' << served.console();
    EXPECT_EQ(served.game().setup().dialect.protocol, protocol);
  }
}

TEST(Server, UnknownLevelsLeaveTheGameAsItIs) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("stayer");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("changelevel nowhere; map nowhere");
  served.run(1);
  EXPECT_TRUE(served.client(me).is_playing());
  EXPECT_THAT(served.console(), HasSubstr("nowhere"));
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 100);
}

TEST(Server, SavedGamesContinue) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  const std::size_t me = served.add_client("saver");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(1);
  served.game().player(0).set(server::field::kHealth, 42.0f);
  const math::Vec3 place = served.game().player(0)[server::field::kOrigin];
  const double time_s = served.game().time_s();
  served.command("save here");
  served.run(0.1);
  EXPECT_THAT(served.console(), HasSubstr("Game saved: "));
  served.run(1, forward());
  EXPECT_GT(glm::distance(place, served.game().player(0)[server::field::kOrigin]), 50);
  served.command("load here");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing());
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 42);
  EXPECT_LT(glm::distance(place, served.game().player(0)[server::field::kOrigin]), 1);
  EXPECT_GT(served.game().time_s(), time_s);
  EXPECT_FALSE(served.server().clock.is_paused);
}

// A game may have outgrown protocol 15 since the level started.
TEST(Server, ASavedGameChoosesTheProtocolThatItNeeds) {
  SKIP_WITHOUT_QUAKEC();
  std::string program = small_program();
  constexpr std::string_view kStill = "void() StartFrame = {};";
  program.replace(program.find(kStill), kStill.size(), R"(
    void() StartFrame = {
      local float left;
      local entity thing;
      left = cvar("temp1");
      cvar_set("temp1", "0");
      while (left > 0) { thing = spawn(); thing.classname = "thing"; left = left - 1; }
    };
  )");
  ServedGame served(program, {.max_clients = 1});
  const std::size_t me = served.add_client("saver");
  ASSERT_TRUE(served.run_until_playing(me));
  EXPECT_EQ(served.game().setup().dialect.protocol, net::Protocol::kNetQuake);
  served.command("temp1 650");
  served.run(0.5);
  served.command("save many");
  served.run(0.1);
  served.command("load many");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason() << served.console();
  EXPECT_GT(served.game().world().edicts.count(), 600u);
  EXPECT_EQ(served.game().setup().dialect.protocol, net::Protocol::kFitzQuake);
}

TEST(Server, HostFramerateSetsTheGameTimeOfATick) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const double before_s = served.game().time_s();
  ASSERT_TRUE(served.variables().set("host_framerate", "0.05").ok());
  served.run(1);
  EXPECT_NEAR(served.game().time_s() - before_s, 72 * 0.05, 0.11);
}

TEST(Server, DamagedSavesLeaveTheGameAsItIs) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  const std::size_t me = served.add_client("saver");
  ASSERT_TRUE(served.run_until_playing(me));
  served.folder().write("id1/bad.sav", "5\nnot much of a game\n");
  served.command("load bad; load missing; load ../../etc/passwd");
  served.run(1);
  EXPECT_TRUE(served.client(me).is_playing());
  EXPECT_THAT(served.console(), HasSubstr("bad.sav: line 3"));
  EXPECT_THAT(served.console(), HasSubstr("missing.sav"));
  EXPECT_THAT(served.console(), HasSubstr("is not a file name"));
}

TEST(Server, ChangedProgramsAreReloadedAndTheGameContinues) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(1, forward());
  served.run(1);
  served.game().player(0).set(server::field::kHealth, 42.0f);
  const math::Vec3 place = served.game().player(0)[server::field::kOrigin];
  served.replace_program(small_program(".float new_field; void() new_function = { bprint(\"new\\n\"); };"));
  served.command("reload");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.console();
  EXPECT_THAT(served.console(), HasSubstr("the game continues"));
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 42);
  EXPECT_LT(glm::distance(place, served.game().player(0)[server::field::kOrigin]), 5);
  EXPECT_NE(served.game().machine().program().find_function("new_function"), vm::kNoFunction);
}

// Changes the level that the server reads.
void change_level_file(ServedGame& io_served, const std::function<void(formats::Bsp&)>& change) {
  const std::filesystem::path file = io_served.folder().path() / "id1/maps/small.bsp";
  formats::Bsp bsp = formats::read_bsp(vfs::read_disk_file(file).value()).value();
  change(bsp);
  io_served.folder().write("id1/maps/small.bsp", formats::write_bsp(bsp, bsp.version).value());
}

TEST(Server, LevelWithNewLightIsReloadedAndTheGameContinues) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  served.game().player(0).set(server::field::kHealth, 42.0f);
  change_level_file(served, [](formats::Bsp& level) { level.lighting.assign(level.lighting.size() + 1, 9); });
  served.command("reload");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.console();
  EXPECT_THAT(served.console(), HasSubstr("the game continues"));
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 42);
}

TEST(Server, PlayersSpawnInADamagedLevel) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  const math::Vec3 start = served.game().player(0)[server::field::kOrigin];
  change_level_file(served, [](formats::Bsp& level) {
    constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
    level.models[0].head_nodes[3] = 99999;
    level.models[0].visible_leaves = 99999;
    level.models.back().mins.x = level.models.back().origin.y = kNoNumber;
    for (formats::BspPlane& plane : level.planes) plane.type = 99;
    for (formats::BspLeaf& leaf : level.leaves) leaf.visibility_offset = 1 << 28;
    level.faces[0].side = 7;
    level.faces[1].styles[0] = 200;
    level.texinfos[0].miptex = 5000;
    level.vertices[0].z = kNoNumber;
  });
  served.command("map small");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.console();
  EXPECT_THAT(served.console(), HasSubstr("repaired or left out"));
  EXPECT_LT(glm::distance(start, served.game().player(0)[server::field::kOrigin]), 5);
}

TEST(Server, PlayersStayWhereTheyAreWhenTheirLevelRestarts) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  const math::Vec3 start = served.game().player(0)[server::field::kOrigin];
  served.run(1, forward());
  served.run(1);
  const math::Vec3 place = served.game().player(0)[server::field::kOrigin];
  ASSERT_GT(glm::distance(place, start), 20);
  served.game().player(0).set(server::field::kHealth, 42.0f);
  served.game().player(0).set_flag(server::flag::kNoTarget);
  const auto add_entity = [](formats::Bsp& level) { level.entities += "{\n\"classname\" \"light\"\n}\n"; };
  change_level_file(served, add_entity);
  served.command("reload");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.console();
  EXPECT_THAT(served.console(), HasSubstr("the level restarts"));
  EXPECT_LT(glm::distance(place, served.game().player(0)[server::field::kOrigin]), 1);
  EXPECT_NE(served.game().player(0)[server::field::kHealth], 42) << "a new player";
  EXPECT_TRUE(served.game().player(0).has_flag(server::flag::kNoTarget));
  // Inside of a wall: only without clipping.
  for (const server::MoveType type : {server::MoveType::kNoClip, server::MoveType::kWalk}) {
    const math::Vec3 wall(4000, 0, 0);
    served.game().player(0).set(server::field::kMoveType, static_cast<float>(type));
    served.game().player(0).set(server::field::kOrigin, wall);
    change_level_file(served, add_entity);
    served.command("reload");
    served.run(3);
    ASSERT_TRUE(served.client(me).is_playing()) << served.console();
    const math::Vec3 now = served.game().player(0)[server::field::kOrigin];
    const bool flies = type == server::MoveType::kNoClip;
    EXPECT_LT(glm::distance(now, flies ? wall : start), 5) << now.x << " " << now.y << " " << now.z;
  }
  // Another level begins as usual.
  served.command("map small");
  served.run(3);
  EXPECT_LT(glm::distance(start, served.game().player(0)[server::field::kOrigin]), 5);
}

TEST(Server, UnusableProgramsLeaveTheOldOneRunning) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  served.folder().write("id1/progs.dat", "not a program");
  served.command("reload");
  served.run(1);
  EXPECT_TRUE(served.client(me).is_playing());
  EXPECT_THAT(served.console(), HasSubstr("progs.dat"));
}

TEST(Server, RunawayProgramsEndTheLevelButNotTheServer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(R"(
    void() forever = { while (1) { self.health = self.health + 1; } };
    void() use_forever = { forever(); };
  )"));
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  const vm::FunctionIndex runaway = served.game().machine().program().find_function("use_forever");
  served.game().player(0).set(server::field::kThink, runaway);
  served.game().player(0).set(server::field::kNextThink, static_cast<float>(served.game().time_s()) + 0.1f);
  served.run(4);
  EXPECT_THAT(served.console(), HasSubstr("forever"));
  EXPECT_THAT(served.console(), HasSubstr("use_forever"));
  EXPECT_THAT(served.prints(me), HasSubstr("Game code failed"));
  EXPECT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
}

// Missing files and unknown names are reported with the place in the code, errors with a stack trace; all
// with the file, and with the line if the compiler has written line numbers. The game continues.
TEST(Server, AModdersMistakesAreReportedAndTheGameContinues) {
  SKIP_WITHOUT_QUAKEC();
  std::string program = small_program(R"(
    void() careless = { self = world; self.health = 5; };
  )");
  const auto replace = [&](std::string_view what, std::string_view with) {
    ASSERT_NE(program.find(what), std::string::npos) << what;
    program.replace(program.find(what), what.size(), with);
  };
  replace("void() light = { remove(self); };",
          "void() light = {\nprecache_model(\"progs/none.mdl\");\nsetmodel(self, \"progs/none.mdl\");\n};");
  replace("void() func_door =", "void() func_gate =");
  ServedGame served(program);
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  EXPECT_THAT(served.console(),
              ContainsRegex("progs/none.mdl: there is no such model, in light \\(.*test.qc"));
  EXPECT_THAT(served.console(), ContainsRegex("maps/small.bsp: entity [0-9]+ at .*\"func_door\""));

  server::Edict player = served.game().player(0);
  player.set(server::field::kThink, served.game().machine().program().find_function("careless"));
  player.set(server::field::kNextThink, static_cast<float>(served.game().time_s()) + 0.1f);
  served.run(4);
  EXPECT_THAT(served.console(), ContainsRegex("careless \\(.*test.qc"));
  EXPECT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
}

TEST(Server, CheatsNeedPermissionInMultiplayer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("cheat");
  ASSERT_TRUE(served.run_until_playing(me));
  served.client(me).send_command("god");
  served.run(0.5);
  EXPECT_FALSE(served.game().player(0).has_flag(server::flag::kGodMode));
  EXPECT_THAT(served.prints(me), HasSubstr("sv_cheats"));
  served.command("sv_cheats 1");
  served.client(me).send_command("god");
  served.run(0.5);
  EXPECT_TRUE(served.game().player(0).has_flag(server::flag::kGodMode));
}

TEST(Server, RecordingsCanBePlayed) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("star");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("record film");
  served.run(1, forward());
  served.command("stop");
  served.run(0.1);
  EXPECT_THAT(served.console(), HasSubstr("Demo saved: "));
  const auto bytes = vfs::read_disk_file(served.folder().path() / "id1/film.dem");
  ASSERT_TRUE(bytes.ok());
  const auto length = client::DemoPlayer::scan(*bytes, "film");
  ASSERT_TRUE(length.ok()) << length.error().message();
  EXPECT_FALSE(length->damage.has_value());
  EXPECT_NEAR(length->last_time_s - length->first_time_s, 1, 0.1);
  EXPECT_EQ(length->levels, std::vector<std::string>{"maps/small.bsp"});
}

TEST(Server, TwoInOneProcessShareNothing) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame a, b;
  const std::size_t in_a = a.add_client("ann"), in_b = b.add_client("bob");
  ASSERT_TRUE(a.run_until_playing(in_a));
  ASSERT_TRUE(b.run_until_playing(in_b));
  a.command("sv_gravity 100");
  a.run(0.5, forward());
  EXPECT_EQ(a.game().world().settings.gravity, 100);
  EXPECT_EQ(b.game().world().settings.gravity, 800);
  EXPECT_THAT(b.prints(in_b), Not(HasSubstr("ann")));
}

TEST(Server, SameInputsGiveTheSameWorld) {
  SKIP_WITHOUT_QUAKEC();
  const auto play = [] {
    ServedGame served;
    const std::size_t me = served.add_client("tester");
    CHECK(served.run_until_playing(me));
    for (int i = 0; i < 100; ++i)
      served.run(1, {.angles_deg = {0, static_cast<float>(i * 37 % 360), 0},
                     .forward = 400,
                     .buttons = static_cast<std::uint8_t>(i % 4)});
    CHECK(served.server().clock.ticks > 7000);
    return served.game().state_hash();
  };
  EXPECT_EQ(play(), play());
}

TEST(Server, FastAndSlowHostsPlayTheSame) {
  SKIP_WITHOUT_QUAKEC();
  // Ticks have a fixed length, whatever the length of the host's frames.
  const auto play = [](int frames_per_second) {
    ServedGame served;
    std::map<std::uint64_t, std::uint64_t> hash_after_ticks;
    for (int i = 0; i < 10 * frames_per_second; ++i) {
      server::step_server(served.server(), 1000 + static_cast<double>(i) / frames_per_second);
      hash_after_ticks[served.server().clock.ticks] = served.game().state_hash();
    }
    return hash_after_ticks;
  };
  const auto often = play(250);
  EXPECT_GT(often.size(), 700u);
  for (const int rate : {10, 72}) {
    std::size_t compared = 0;
    for (const auto& [ticks, hash] : play(rate)) {
      const auto same = often.find(ticks);
      if (same == often.end()) continue;
      EXPECT_EQ(hash, same->second) << rate << " frames per second, " << ticks << " ticks";
      ++compared;
    }
    EXPECT_GT(compared, 90u) << rate;
  }
}

}  // namespace
}  // namespace temblor::test
