// Tests the effect of each message, except for the movement of entities.
#include "client/session/client_state.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "client/session/messages.h"

namespace temblor::test {
namespace {

using client::ClientState;
using client::Stat;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void expect_error(ClientState& io_state, const net::ServerMessage& message, const char* what) {
  const base::Status status = io_state.apply(message);
  ASSERT_FALSE(status.ok()) << net::message_name(message);
  EXPECT_THAT(status.error().message(), HasSubstr(what));
}

TEST(ClientState, ServerInfoBeginsALevelWithItsListsFromOne) {
  ClientState state;
  apply(state, {net::Print{"VERSION 1\n"}, net::Sound{}, server_info()});
  EXPECT_EQ(state.game().level_name, "Entrance");
  EXPECT_THAT(state.game().models,
              ElementsAre("", "maps/start.bsp", "progs/player.mdl", "progs/ogre.mdl", "progs/flame.mdl"));
  EXPECT_THAT(state.game().sounds, ElementsAre("", "weapons/guncock.wav", "misc/menu1.wav"));
  EXPECT_EQ(state.game().players.size(), 4u);
  EXPECT_FALSE(state.game().deathmatch);
  EXPECT_TRUE(state.events().new_level);
  EXPECT_THAT(state.events().prints, ElementsAre("VERSION 1\n"));
  EXPECT_THAT(state.events().sounds, IsEmpty()) << "a sound of the last level";
}

TEST(ClientState, AnotherServerInfoForgetsTheLastLevel) {
  ClientState state = state_in_level();
  packet(
      state, 50,
      {net::UpdateStat{12, 30}, net::LightStyle{3, "az"}, net::Skybox{"dusk"}, net::SetPause{true},
       net::Intermission{}, net::SpawnStatic{{.model = kFlameModel}}, update_at(7, kOgreModel, {1, 2, 3})});
  ASSERT_EQ(state.interpolate_entities(50, {}).size(), 2u);
  apply(state, {server_info()});
  state.end_packet();
  EXPECT_TRUE(state.interpolate_entities(50, {}).empty());
  EXPECT_EQ(state.game().stat(Stat::kTotalMonsters), 0);
  EXPECT_EQ(state.game().light_styles[3], "");
  EXPECT_FALSE(state.game().skybox);
  EXPECT_FALSE(state.game().paused);
  EXPECT_EQ(state.game().ending, client::Ending::kNone);
  EXPECT_EQ(state.time_s(), 0);
}

TEST(ClientState, SignonEndsWithTheFirstUpdateAfterItsThirdStage) {
  ClientState state = state_in_level();
  apply(state, {net::SignonNumber{1}, net::SignonNumber{2}, net::SignonNumber{3}});
  EXPECT_EQ(state.game().signon, 3);
  apply(state, {update_at(1, kPlayerModel, {})});
  EXPECT_EQ(state.game().signon, client::kPlaying);
}

TEST(ClientState, ClientDataSetsTheStats) {
  ClientState state = state_in_level();
  net::ClientData data;
  data.health = -12;
  data.armor = 150;
  data.weapon_model = 300;
  data.weapon_frame = 6;
  data.ammo = 25;
  data.shells = 26;
  data.nails = 27;
  data.rockets = 28;
  data.cells = 29;
  data.active_weapon = 64;
  data.items = 0xf0000001u;
  apply(state, {data});
  const client::Game& game = state.game();
  // In the order of the protocol's numbers 0 to 10; frags are not part of it.
  const std::array<std::int32_t, 11> expected = {-12, 0, 300, 25, 150, 6, 26, 27, 28, 29, 64};
  for (std::size_t stat = 0; stat < expected.size(); ++stat)
    EXPECT_EQ(game.stats[stat], expected[stat]) << stat;
  EXPECT_EQ(game.data.items, 0xf0000001u);
}

TEST(ClientState, MonstersAndSecretsAreCounted) {
  ClientState state = state_in_level();
  apply(state, {net::UpdateStat{14, 4}, net::KilledMonster{}, net::KilledMonster{}, net::FoundSecret{}});
  EXPECT_EQ(state.game().stat(Stat::kMonsters), 6);
  EXPECT_EQ(state.game().stat(Stat::kSecrets), 1);
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  apply(state, {net::UpdateStat{14, kMost}, net::KilledMonster{}});
  EXPECT_EQ(state.game().stat(Stat::kMonsters), kMost);
}

TEST(ClientState, GamesHaveStatsOfTheirOwn) {
  ClientState state = state_in_level();
  apply(state, {net::UpdateStat{255, -7}, net::StuffText{"//temblor stat 40 f 1.5\n//temblor stat 41 i 9\n"},
                net::StuffText{"//temblor stat 42 s aGk\n//temblor stat 3 i 1\n"}});
  EXPECT_EQ(state.game().stats[255], -7);
  EXPECT_EQ(state.game().game_stats.at(40), net::StatValue(1.5f));
  EXPECT_EQ(state.game().stats[41], 9);
  EXPECT_EQ(state.game().game_stats.at(42), net::StatValue(std::string("hi")));
  ASSERT_EQ(state.events().prints.size(), 1u) << "stat 3 belongs to the engine";
  EXPECT_TRUE(state.events().commands.empty());
  apply(state, {net::UpdateStat{40, 2}});
  EXPECT_FALSE(state.game().game_stats.contains(40)) << "it is a whole number now";
}

TEST(ClientState, PowerupsEndWhenTheServerSays) {
  ClientState state = state_in_level();
  apply(state, {net::StuffText{"//temblor powerup 22 45.5\n//temblor powerup 32 1\n"}});
  EXPECT_EQ(state.game().powerup_ends_s[22], 45.5f);
  EXPECT_EQ(state.game().powerup_ends_s[21], 0);
  EXPECT_EQ(state.events().prints.size(), 1u) << "there is no bit 32";
  EXPECT_TRUE(state.events().commands.empty());
}

TEST(ClientState, KnowsTheCapturesOfTeams) {
  ClientState state = state_in_level();
  apply(state, {net::StuffText{"//temblor captures 4 2\n//temblor captures 16 1\n"}});
  EXPECT_EQ(state.game().captures[4], 2);
  EXPECT_EQ(state.game().captures[8], std::nullopt);
  EXPECT_EQ(state.events().prints.size(), 1u) << "there is no color 16";
  EXPECT_TRUE(state.events().commands.empty());
  apply(state, {server_info()});
  EXPECT_EQ(state.game().captures[4], std::nullopt) << "a new level";
}

TEST(ClientState, KnowsWhetherThePlayerFights) {
  ClientState state = state_in_level();
  packet(state, 50, {});
  EXPECT_FALSE(client::is_in_combat(state.game(), 50));
  apply(state, {net::StuffText{"//temblor combat 1\n"}});
  EXPECT_TRUE(client::is_in_combat(state.game(), 50));
  apply(state, {net::StuffText{"//temblor combat 0\n"}});
  EXPECT_FALSE(client::is_in_combat(state.game(), 50));
  EXPECT_TRUE(state.events().prints.empty());
  apply(state, {net::StuffText{"//temblor combat 7\n"}});
  EXPECT_EQ(state.events().prints.size(), 1u);
  packet(state, 60, {net::Damage{}});
  EXPECT_TRUE(client::is_in_combat(state.game(), 64));
  EXPECT_FALSE(client::is_in_combat(state.game(), 66));
  apply(state, {net::StuffText{"//temblor combat 1\n"}, server_info()});
  EXPECT_FALSE(client::is_in_combat(state.game(), 61)) << "a new level";
}

TEST(ClientState, PlayersHaveNamesFragsAndColors) {
  ClientState state = state_in_level();
  apply(state, {net::UpdateName{2, "Ranger"}, net::UpdateFrags{2, -3}, net::UpdateColors{2, 0xd4}});
  const client::Player& player = state.game().players[2];
  EXPECT_EQ(player.name, "Ranger");
  EXPECT_EQ(player.frags, -3);
  EXPECT_EQ(player.shirt, 13);
  EXPECT_EQ(player.pants, 4);
}

TEST(ClientState, StuffedLinesAreJoinedAndFlashesExtracted) {
  ClientState state = state_in_level();
  apply(state, {net::StuffText{"bf\n"}});
  EXPECT_EQ(state.events().bonus_flashes, 1);
  EXPECT_THAT(state.events().commands, IsEmpty());
  apply(state, {net::StuffText{"v_cshift 1 2 3"}, net::StuffText{" 4\nbf\nco"}, net::StuffText{"lor 4\nb"}});
  EXPECT_EQ(state.events().bonus_flashes, 2);
  EXPECT_THAT(state.events().commands, ElementsAre("v_cshift 1 2 3 4", "color 4"));
  apply(state, {net::StuffText{"f\n"}, net::BonusFlash{}});
  EXPECT_EQ(state.events().bonus_flashes, 4);
}

TEST(ClientState, CollectsRequestsForMarks) {
  ClientState state = state_in_level();
  apply(state, {net::StuffText{"//temblor mark smile 1 2 "}, net::StuffText{"3 4\n//temblor other\n"},
                net::StuffText{"//temblor mark ../smile 1 2 3 4\n"}});
  EXPECT_THAT(state.events().marks, ElementsAre(net::MarkRequest{"smile", {1, 2, 3}, 4}));
  EXPECT_THAT(state.events().commands, IsEmpty());
  ASSERT_EQ(state.events().prints.size(), 1u);
  EXPECT_NE(state.events().prints[0].find("bad picture name \"../smile\""), std::string::npos);
  apply(state, {server_info()});
  EXPECT_THAT(state.events().marks, IsEmpty()) << "the level with the mark is over";
  apply(state, {net::StuffText{"//temblor mark smile 1 2 3 4\n"}});
  EXPECT_EQ(state.events().marks.size(), 1u);
  state.events().clear();
  EXPECT_THAT(state.events().marks, IsEmpty());
}

TEST(ClientState, EventsAreKeptUntilCleared) {
  ClientState state = state_in_level();
  net::TempEntity explosion;
  explosion.kind = net::TempEntityKind::kExplosion;
  apply(state, {explosion, net::Particles{.count = 1024}, net::Damage{.blood = 5}, net::Sound{.sound = 9999},
                net::StopSound{3, 1}, net::SpawnStaticSound{}, net::Print{"You got the axe\n"}});
  const client::Events& events = state.events();
  EXPECT_EQ(events.temp_entities.size(), 1u);
  EXPECT_EQ(events.particles.at(0).count, 1024);
  EXPECT_EQ(events.damages.at(0).blood, 5);
  EXPECT_EQ(events.sounds.at(0).sound, 9999) << "numbers past the list's end are kept";
  EXPECT_EQ(events.stopped_sounds.at(0).entity, 3);
  EXPECT_EQ(events.static_sounds.size(), 1u);
  EXPECT_THAT(events.prints, ElementsAre("You got the axe\n"));
  state.events().clear();
  EXPECT_TRUE(events.temp_entities.empty() && events.particles.empty() && events.damages.empty() &&
              events.sounds.empty() && events.stopped_sounds.empty() && events.static_sounds.empty() &&
              events.prints.empty() && events.commands.empty());
  EXPECT_FALSE(events.new_level);
}

TEST(ClientState, EndingsSayWhenTheyBegan) {
  ClientState state = state_in_level();
  packet(state, 61.5f, {net::Intermission{}});
  EXPECT_EQ(state.game().ending, client::Ending::kIntermission);
  EXPECT_EQ(state.game().ending_since_s, 61.5);
  packet(state, 70, {net::Finale{"The end"}});
  EXPECT_EQ(state.game().ending, client::Ending::kFinale);
  EXPECT_EQ(state.game().ending_since_s, 70);
  EXPECT_EQ(state.game().ending_text, "The end");
  packet(state, 80, {net::CutScene{"Later"}, net::CenterPrint{"..."}, net::SellScreen{}});
  EXPECT_EQ(state.game().ending, client::Ending::kCutScene);
  EXPECT_EQ(state.game().center_text, "...");
  EXPECT_EQ(state.game().center_text_since_s, 80);
  EXPECT_THAT(state.events().commands, ElementsAre("help"));
}

TEST(ClientState, OtherMessagesAreStoredUnchanged) {
  ClientState state = state_in_level();
  apply(state,
        {net::SetAngle{{-10, 90, 0}}, net::CdTrack{6, 6}, net::LightStyle{63, "a"}, net::Nop{},
         net::Version{15}, net::Ignored{45}, net::Skybox{"dusk"}, net::SetPause{true}, net::Disconnect{}});
  EXPECT_EQ(state.game().set_angles_deg, math::Vec3(-10, 90, 0));
  EXPECT_EQ(state.game().music_track, 6);
  EXPECT_EQ(state.game().light_styles[63], "a");
  EXPECT_EQ(state.game().skybox, "dusk");
  EXPECT_TRUE(state.game().paused);
}

net::Fog fog(float density, float fade_s) {
  return {.density = density, .color = {density, 0, 1 - density}, .fade_s = fade_s};
}

TEST(ClientFog, FadesInOverTheLevelsOwn) {
  ClientState state = state_in_level();
  const net::Fog of_level = fog(0.5f, 0);
  EXPECT_EQ(client::compute_fog(state.game(), of_level, 3).density, 0.5f);
  packet(state, 10, {fog(0.25f, 2)});
  packet(state, 10.5f, {});
  EXPECT_EQ(client::compute_fog(state.game(), of_level, 10).density, 0.5f);
  const net::Fog half = client::compute_fog(state.game(), of_level, 11);
  EXPECT_EQ(half.density, 0.375f);
  EXPECT_EQ(half.color, math::Vec3(0.375f, 0, 0.625f));
  EXPECT_EQ(half.fade_s, 0);
  EXPECT_EQ(client::compute_fog(state.game(), of_level, 13).density, 0.25f);
}

TEST(ClientFog, AnInterruptedFadeContinuesFromItsMixture) {
  ClientState state = state_in_level();
  const net::Fog of_level = fog(0.5f, 0);
  packet(state, 20, {fog(1, 4)});
  packet(state, 22, {fog(0, 3)});
  EXPECT_EQ(client::compute_fog(state.game(), of_level, 22).density, 0.75f);
  EXPECT_FLOAT_EQ(client::compute_fog(state.game(), of_level, 23).density, 0.5f);
  packet(state, 23.5f, {fog(0.875f, 1)});
  EXPECT_FLOAT_EQ(client::compute_fog(state.game(), of_level, 23.5f).density, 0.375f);
  EXPECT_FLOAT_EQ(client::compute_fog(state.game(), of_level, 24).density, 0.625f);
  EXPECT_EQ(client::compute_fog(state.game(), of_level, 30).density, 0.875f);
}

TEST(ClientState, RemembersWhereThePlayerDied) {
  ClientState state = state_in_level();
  const auto at = [&](float time_s, std::int16_t health, float x) {
    packet(state, time_s, {net::ClientData{.health = health}, update_at(1, kPlayerModel, {x, 0, 24})});
  };
  at(1, 100, 10);
  EXPECT_FALSE(state.game().death_place);
  at(2, -5, 20);
  at(3, -5, 30);  // the corpse slides
  ASSERT_TRUE(state.game().death_place);
  EXPECT_EQ(*state.game().death_place, math::Vec3(20, 0, 24));
  at(4, 100, 500);
  EXPECT_EQ(state.game().death_place->x, 20);
  at(5, 0, 510);
  EXPECT_EQ(state.game().death_place->x, 510);
  apply(state, {server_info()});
  EXPECT_FALSE(state.game().death_place);
}

TEST(ClientState, PassesOverUnknownMessagesOnceTheGameRuns) {
  ClientState state = state_in_level();
  const base::Error error = base::error(base::ErrorCode::kUnsupported, "message 99: unknown message");
  ASSERT_FALSE(state.pass_over_unknown(error).ok());
  EXPECT_EQ(state.pass_over_unknown(error).error().message(), error.message());
  apply(state, {net::SignonNumber{3}});
  packet(state, 1, {update_at(1, kPlayerModel, {})});
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(state.pass_over_unknown(error).ok());
  EXPECT_THAT(state.events().notes, ElementsAre(HasSubstr("message 99: unknown message")));
}

TEST(ClientState, MessagesBeforeServerInfoAreErrors) {
  ClientState state;
  expect_error(state, update_at(1, kPlayerModel, {}), "serverinfo");
  expect_error(state, net::SpawnBaseline{}, "serverinfo");
  expect_error(state, net::SpawnStatic{}, "serverinfo");
  expect_error(state, net::ClientData{}, "serverinfo");
  expect_error(state, net::UpdateName{0, "x"}, "player slot 0");
  state.end_packet();
  EXPECT_TRUE(state.interpolate_entities(0, {}).empty());
}

TEST(ClientState, NumbersOutOfRangeAreErrorsWithoutEffect) {
  ClientState state = state_in_level();
  constexpr auto kPast = static_cast<std::uint16_t>(net::kMaxEntities);
  expect_error(state, update_at(kPast, kOgreModel, {}), "entity 32000, expected 0 to 31999");
  expect_error(state, net::SpawnBaseline{kPast, {}}, "entity 32000");
  expect_error(state, net::SetView{kPast}, "entity 32000");
  expect_error(state, net::UpdateName{4, "x"}, "player slot 4, but the server has 4");
  expect_error(state, net::UpdateFrags{4, 1}, "player slot 4");
  expect_error(state, net::UpdateColors{255, 1}, "player slot 255");
  expect_error(state, net::LightStyle{64, "a"}, "light style 64, expected 0 to 63");
  expect_error(state, net::SignonNumber{5}, "signon 5");
  expect_error(state, net::Time{-1}, "-1 s, expected 0 to");
  expect_error(state, net::Time{1e30f}, "1e+30 s");
  expect_error(state, net::Time{std::numeric_limits<float>::quiet_NaN()}, "nan s");
  net::ServerInfo nowhere = server_info();
  nowhere.models = {};
  expect_error(state, nowhere, "no level");
  net::ServerInfo nobody = server_info();
  nobody.max_clients = 0;
  expect_error(state, nobody, "0 players");
  EXPECT_EQ(state.game().level_name, "Entrance");
  EXPECT_EQ(state.game().view_entity, 1);
  state.end_packet();
  EXPECT_TRUE(state.interpolate_entities(0, {}).empty());
}

// Keys are for the texts of the game, not for what players write.
TEST(ClientState, ReplacesKeysOfOtherServers) {
  ClientState state;
  state.set_texts(std::make_shared<const formats::Localization>(formats::Localization::Texts{
      {"m", "The Entrance"}, {"got", "You got {0}\n"}, {"item", "a key"}, {"hi", "{0} says hi"}}));
  net::ServerInfo info = server_info();
  info.level_name = "$m";
  apply(state, {info, net::UpdateName{0, "$item"}, net::UpdateName{1, "Bot"}});
  EXPECT_EQ(state.game().level_name, "The Entrance");
  apply(state, {net::Print{"$got$item"}, net::Print{"$item entered the game\n"},
                net::Print{"\x01$item: $m\n"}, net::Print{"$none\n"}});
  EXPECT_THAT(state.events().prints,
              ElementsAre("You got a key\n", "$item entered the game\n", "\x01$item: $m\n", "$none\n"));
  apply(state, {net::CenterPrint{"$m"}});
  EXPECT_EQ(state.game().center_text, "The Entrance");
  apply(state, {net::Finale{"$m!"}});
  EXPECT_EQ(state.game().ending_text, "The Entrance!");
  state.events().clear();
  const std::array<std::string_view, 2> texts = {"$hi", "$item"};
  apply(state, {net::BotChat{1, texts}, net::BotChat{1, {}}});
  EXPECT_THAT(state.events().prints, ElementsAre("\x01"
                                                 "Bot: a key says hi\n"));
  expect_error(state, net::BotChat{4, texts}, "slot 4");
  state.set_texts(nullptr);
  apply(state, {net::CenterPrint{"$m"}});
  EXPECT_EQ(state.game().center_text, "$m");
}

TEST(ClientState, ReadsPingsAndHidesTheListThatItAskedFor) {
  ClientState state;
  apply(state, {server_info(), net::UpdateName{0, "Ann"}, net::UpdateName{2, "Bob B"}});
  const auto list = [&](int ann, int bob) {
    state.events().clear();
    const std::string first = fmt::format("{:4} Ann\n", ann), second = fmt::format("{:4} Bob B\n", bob);
    apply(state, {net::Print{"Client ping times:\n"}, net::Print{first}, net::Print{second},
                  net::Print{"   7 apples\n"}, net::Print{"Ann rocks\n"}, net::Print{" 999 Ann\n"}});
    return state.events().prints.size();
  };
  EXPECT_EQ(list(20, 12345), 6u) << "the player has asked";
  EXPECT_EQ(state.game().players[0].ping_ms, 20);
  EXPECT_EQ(state.game().players[2].ping_ms, 12345);
  state.expect_pings();
  EXPECT_EQ(list(30, 40), 2u) << "from the first line on that is not of the list";
  EXPECT_EQ(state.game().players[0].ping_ms, 30);
  EXPECT_EQ(list(50, 60), 6u) << "only one list was expected";
}

}  // namespace
}  // namespace temblor::test
