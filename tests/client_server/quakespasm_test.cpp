// Interoperation with QuakeSpasm (Debian's package quakespasm), over UDP and in real time: its client plays
// on our server in all three protocols, and our client on its server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "client/session/connection.h"
#include "client_server/served_game.h"
#include "formats/game/sav.h"
#include "platform/posix/udp_socket.h"
#include "server/game/game_loader.h"
#include "server/save/save_game.h"
#include "server/server.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/programs/background_program.h"
#include "support/programs/quakec.h"
#include "support/programs/quakespasm_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

constexpr double kSignonLimit_s = 60;
constexpr int kPlayed_s = effort(60, 5);

double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::unique_ptr<platform::DatagramSocket> local_socket() {
  auto socket = platform::posix::open_udp_socket({.host = "127.0.0.1"});
  CHECK(socket.ok(), "{}", socket.error().message());
  return std::move(socket).value();
}

// Our server with the shipped game on a level of the data, and a stock client that walks there.
class StockClientPlays {
 public:
  StockClientPlays(const std::filesystem::path& data, std::string_view protocol)
      : files_(vfs::FileSystem::open(data).value()), settings_(variables_) {
    CHECK(variables_.set("sv_protocol", protocol).ok());
    net::ServerEndpoint::Sockets sockets;
    sockets.push_back(local_socket());
    port_ = sockets[0]->local_address().port;
    server_ = std::make_unique<server::Server>(
        server::ServerSetup{.library = library_,
                            .settings = settings_,
                            .sockets = std::move(sockets),
                            .program_file = TEMBLOR_GAME_PROGRAM,
                            .print = [this](std::string_view text) { console_ += text; }});
    const base::Status started = server::start_map(*server_, "lq_e0m1");
    CHECK(started.ok(), "{}", started.error().message());
    folder_ = *make_quakespasm_folder(home_, data, TEMBLOR_GAME_PROGRAM);
  }

  void start_client() {
    client_ = std::make_unique<BackgroundProgram>(
        std::vector<std::string>{TEMBLOR_SOURCE_DIR "/tests/support/on_display.sh", "320x240x24", "env",
                                 "SDL_NO_SIGNAL_HANDLERS=1", "quakespasm", "-basedir", folder_.string(),
                                 "-window", "-width", "320", "-height", "240", "-nosound", "+host_maxfps",
                                 "30", "+connect", "127.0.0.1:" + std::to_string(port_)},
        home_.path());
  }
  void ask_client_to_leave() { server_->clients.send(0, net::StuffText{"disconnect\n"}); }

  void step() {
    server::step_server(*server_, clock_s());
    if (!is_playing()) return;
    // From here on it walks and turns, as if its player held two keys.
    if (!has_place_) server_->clients.send(0, net::StuffText{"+forward\n+left\n"});
    const math::Vec3 place = server_->game->player(0)[server::field::kOrigin];
    if (has_place_) way_ += glm::distance(place, place_);
    place_ = place;
    has_place_ = true;
  }
  void change_level(const char* map) {
    const base::Status changed = server::change_level(*server_, map);
    CHECK(changed.ok(), "{}", changed.error().message());
  }
  bool is_playing() { return server_->clients[0].stage == server::ClientStage::kPlaying; }
  bool has_left() const {
    return server_->game != nullptr && console_.find("removed: left") != std::string::npos;
  }
  float way() const { return way_; }
  float ping_s() { return server_->clients[0].mean_ping_s(); }
  const std::string& console() const { return console_; }
  std::string client_output() const { return client_ ? client_->output() : ""; }

 private:
  TemporaryFolder home_;
  command::Variables variables_;
  vfs::FileSystem files_;
  assets::Library library_{std::move(files_)};
  server::ServerVariables settings_;
  std::uint16_t port_ = 0;
  std::string console_;
  std::unique_ptr<server::Server> server_;
  std::filesystem::path folder_;
  std::unique_ptr<BackgroundProgram> client_;
  math::Vec3 place_{0.0f};
  bool has_place_ = false;
  float way_ = 0;
};

#define SKIP_WITHOUT_QUAKESPASM()                                                    \
  if (!is_installed("quakespasm") || !is_installed("xvfb-run"))                      \
    GTEST_SKIP() << "quakespasm or a display for it (xvfb, xauth) is not installed"; \
  if (!std::filesystem::exists(TEMBLOR_GAME_PROGRAM))                                \
  GTEST_SKIP() << "the game's QuakeC is not compiled: fteqcc is not installed"

TEST(QuakeSpasmClient, PlaysInAllThreeProtocolsAndLeaves) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_QUAKESPASM();
  std::vector<std::unique_ptr<StockClientPlays>> games;
  for (const std::string_view protocol : {"15", "666", "999"}) {
    games.push_back(std::make_unique<StockClientPlays>(data, protocol));
    games.back()->start_client();
  }
  const auto step_all_until = [&](double limit_s, auto is_done) {
    const double until_s = clock_s() + limit_s;
    while (clock_s() < until_s) {
      bool all = true;
      for (auto& game : games) {
        game->step();
        all &= is_done(*game);
      }
      if (all) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  };
  step_all_until(kSignonLimit_s, [](StockClientPlays& game) { return game.is_playing(); });
  for (auto& game : games) ASSERT_TRUE(game->is_playing()) << game->console() << game->client_output();
  step_all_until(kPlayed_s, [](StockClientPlays&) { return false; });
  for (auto& game : games) {
    EXPECT_TRUE(game->is_playing()) << game->console();
    // In circles, at 160 to 320 units per second.
    EXPECT_GT(game->way(), 100.0f * kPlayed_s) << game->console();
    EXPECT_LT(game->ping_s(), 1) << game->console();
  }
  for (auto& game : games) game->change_level("lq_e1m2");
  step_all_until(kSignonLimit_s, [](StockClientPlays& game) { return game.is_playing(); });
  for (auto& game : games) EXPECT_TRUE(game->is_playing()) << game->console() << game->client_output();
  step_all_until(2, [](StockClientPlays&) { return false; });
  for (auto& game : games) game->ask_client_to_leave();
  step_all_until(10, [](StockClientPlays& game) { return game.has_left(); });
  for (auto& game : games) EXPECT_TRUE(game->has_left()) << game->console();
}

TEST(QuakeSpasmServer, OurClientPlaysOnIt) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_QUAKESPASM();
  const TemporaryFolder home;
  const auto folder = make_quakespasm_folder(home, data, TEMBLOR_GAME_PROGRAM);
  ASSERT_TRUE(folder.has_value());
  const std::uint16_t port = local_socket()->local_address().port;
  const BackgroundProgram server({"quakespasm", "-dedicated", "4", "-basedir", folder->string(), "-port",
                                  std::to_string(port), "-protocol", "666", "+map", "lq_e0m1"},
                                 home.path());
  const platform::Address address = platform::ip4_address({127, 0, 0, 1}, port);
  client::Connection player(local_socket(), {.name = "tester", .shirt = 3, .pants = 4});
  const auto run = [&](double limit_s, auto is_done) {
    const double until_s = clock_s() + limit_s;
    while (clock_s() < until_s && !is_done()) {
      const double now_s = clock_s();
      if (!player.is_connected() && !player.is_connecting() && player.updates() == 0)
        player.connect(address, now_s);
      player.update(now_s);
      player.send_move(
          {.angles_deg = {0, static_cast<float>(std::fmod(now_s * 90, 360)), 0}, .forward = 400});
      player.state().events().clear();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  };
  run(kSignonLimit_s, [&] { return player.is_playing(); });
  ASSERT_TRUE(player.is_playing()) << player.disconnect_reason() << server.output();
  EXPECT_EQ(player.state().game().players[0].name, "tester");
  const std::uint64_t before = player.updates();
  run(kPlayed_s, [] { return false; });
  EXPECT_TRUE(player.is_playing()) << player.disconnect_reason();
  // Its server sends twenty snapshots per second.
  EXPECT_GT(player.updates() - before, static_cast<std::uint64_t>(15 * kPlayed_s));
  EXPECT_GT(player.state().game().data.health, -100);
  player.disconnect();
  run(1, [] { return false; });
}

// With -hipnotic it sends the weapon in hand as an index, and items2 above the items.
TEST(QuakeSpasmServer, SendsTheItemsOfAMissionPack) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_QUAKESPASM();
  const TemporaryFolder home;
  const auto folder = make_quakespasm_folder(home, data, TEMBLOR_GAME_PROGRAM);
  ASSERT_TRUE(folder.has_value());
  // Before the first message, because QuakeSpasm leaves out the byte of a player without a weapon.
  constexpr std::string_view kBorn = "self.health = parm1;";
  std::string source = small_program(".float items2;\n");
  source.replace(source.find(kBorn), kBorn.size(),
                 "self.health = parm1; self.weapon = 65536; self.items = 65552; self.items2 = 3;");
  home.write("base/hipnotic/progs.dat", compile_quakec(source));
  home.write("base/hipnotic/maps/small.bsp", SmallGame().level_bytes(formats::BspVersion::k29));
  const std::uint16_t port = local_socket()->local_address().port;
  const BackgroundProgram server({"quakespasm", "-dedicated", "4", "-basedir", folder->string(), "-hipnotic",
                                  "-port", std::to_string(port), "+map", "small"},
                                 home.path());
  client::Connection player(local_socket(), {.name = "tester", .shirt = 3, .pants = 4});
  const net::ClientData& seen = player.state().game().data;
  const double until_s = clock_s() + kSignonLimit_s;
  while (clock_s() < until_s && seen.items == 0) {
    const double now_s = clock_s();
    if (!player.is_connected() && !player.is_connecting())
      player.connect(platform::ip4_address({127, 0, 0, 1}, port), now_s);
    player.update(now_s);
    player.send_move({});
    player.state().events().clear();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(seen.active_weapon, 16) << player.disconnect_reason() << server.output();
  EXPECT_EQ(seen.items, 3u << 23 | 65552u);
  player.disconnect();
}

// QuakeSpasm's server loads a game that ours has saved, without a word about its format.
TEST(QuakeSpasmServer, LoadsOurSavedGame) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_QUAKESPASM();
  const TemporaryFolder home;
  const auto folder = make_quakespasm_folder(home, data, TEMBLOR_GAME_PROGRAM);
  ASSERT_TRUE(folder.has_value());
  command::Variables variables;
  const server::ServerVariables settings(variables);
  const assets::Library library(vfs::FileSystem::open(data).value());
  auto loaded =
      server::load_game({.map = "lq_e0m1", .program_file = TEMBLOR_GAME_PROGRAM}, settings,
                        {.library = library, .io_variables = variables, .print = [](std::string_view) {}});
  ASSERT_TRUE(loaded.ok()) << loaded.error().message();
  ASSERT_TRUE(loaded->game->spawn_client(0, loaded->game->new_parameters().value(), "player", 0).ok());
  const auto text =
      formats::write_sav(server::make_save(*loaded->game, "Before the bridge      kills:  0/  0"));
  ASSERT_TRUE(text.ok());
  // It looks for saved games in the home folder of the system's user, whatever HOME says.
  const std::filesystem::path saves = home.path() / ".quakespasm/id1";
  std::filesystem::create_directories(saves);
  std::ofstream(saves / "ours.sav") << *text;
  constexpr const char* kWithHome =
      "mount --bind \"$0\" /root && PATH=$PATH:/usr/games exec quakespasm -dedicated 1 -basedir \"$1\" +load "
      "ours "
      "+edictcount +quit";
  const BackgroundProgram server({"unshare", "--map-root-user", "--mount", "sh", "-c", kWithHome,
                                  home.path().string(), folder->string()},
                                 home.path());
  const double until_s = clock_s() + kSignonLimit_s;
  while (clock_s() < until_s && server.output().find("num_edicts") == std::string::npos &&
         server.output().find("ERROR") == std::string::npos &&
         server.output().find("unshare") == std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  if (server.output().find("unshare") != std::string::npos ||
      server.output().find("mount:") != std::string::npos)
    GTEST_SKIP() << "no user namespaces: " << server.output();
  EXPECT_THAT(server.output(), HasSubstr("Loading game from"));
  EXPECT_THAT(server.output(), HasSubstr("num_edicts"));
  EXPECT_THAT(server.output(), ::testing::Not(HasSubstr("First token")));
  EXPECT_THAT(server.output(), ::testing::Not(HasSubstr("rror")));
}

}  // namespace
}  // namespace temblor::test
