// Real peers over UDP: DarkPlaces (Debian packages darkplaces and darkplaces-server), set to NetQuake's
// protocol 15. QuakeSpasm would need gfx/pop.lmp of the registered game to play levels outside of the
// shareware archive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"
#include "net/transport/client_endpoint.h"
#include "net/transport/endpoint_bench.h"
#include "net/transport/server_endpoint.h"
#include "platform/posix/udp_socket.h"
#include "support/game_data.h"
#include "support/programs/background_program.h"
#include "support/programs/temporary_folder.h"

namespace temblor::net {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kLevel = "lqdm1";

// Seconds since the start of the test.
class Clock {
 public:
  double now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  // Calls `step` with the time until it returns true. Returns false if that takes longer than `limit_s`.
  bool run(double limit_s, const std::function<bool(double)>& step) const {
    while (now_s() < limit_s) {
      if (step(now_s())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// A minimal server for one player in an empty world.
class BareServer {
 public:
  explicit BareServer(const ServerEndpointSettings& settings)
      : endpoint_(sockets(), settings, test::described) {}

  std::uint16_t port() const { return endpoint_.local_address().port; }
  void tick(double now_s) {
    endpoint_.update(now_s);
    while (const auto event = endpoint_.next_event(now_s)) {
      if (const auto* peer = std::get_if<PeerConnected>(&*event)) {
        player_ = peer->connection;
        const std::string model = std::string("maps/") + kLevel + ".bsp";
        const std::string_view models[] = {model};
        say({ServerInfo{.max_clients = 8, .game_type = 1, .level_name = "a level", .models = models},
             SetView{1}, SignonNumber{1}});
      }
      if (const auto* message = std::get_if<PeerMessage>(&*event)) hear(message->bytes);
    }
  }
  void kick(std::string_view reason) { endpoint_.disconnect(player_, reason); }
  const std::vector<std::string>& commands() const { return commands_; }
  bool heard(std::string_view command) const {
    return std::find(commands_.begin(), commands_.end(), command) != commands_.end();
  }

 private:
  static ServerEndpoint::Sockets sockets() {
    ServerEndpoint::Sockets one;
    one.push_back(platform::posix::open_udp_socket({.host = "127.0.0.1"}).value());
    return one;
  }
  void say(const std::vector<ServerMessage>& messages) {
    base::ByteWriter writer;
    for (const ServerMessage& message : messages) ASSERT_TRUE(write_message(message, {}, writer).ok());
    ASSERT_TRUE(endpoint_.send_reliable(player_, writer.view()).ok());
  }
  void hear(base::Bytes bytes) {
    ClientMessageReader reader(bytes, Protocol::kNetQuake);
    while (true) {
      const auto message = reader.next();
      ASSERT_TRUE(message.ok()) << message.error().message();
      if (!message->has_value()) return;
      const auto* command = std::get_if<StringCommand>(&**message);
      if (command == nullptr) continue;
      commands_.emplace_back(command->text);
      if (command->text == "prespawn") say({SignonNumber{2}});
      if (command->text.starts_with("spawn")) say({Print{std::string(3000, '.') + "\n"}, SignonNumber{3}});
    }
  }

  ServerEndpoint endpoint_;
  ConnectionId player_{};
  std::vector<std::string> commands_;
};

void expect_that_it_signs_on(const ServerEndpointSettings& settings) {
  DATA_FOLDER_OR_SKIP(data);
  if (!test::is_installed("darkplaces") || !test::is_installed("xvfb-run"))
    GTEST_SKIP() << "no stock client or no display for it (darkplaces, xvfb, xauth)";
  BareServer server(settings);
  const test::TemporaryFolder home;
  const test::BackgroundProgram client(
      {TEMBLOR_SOURCE_DIR "/tests/support/on_display.sh", "640x480x24", "darkplaces", "-basedir",
       data.string(), "-nosound", "-window", "-width", "320", "-height", "240", "+cl_protocol", "QUAKE",
       "+connect", "127.0.0.1:" + std::to_string(server.port())},
      home.path());
  const Clock clock;
  const bool begun = clock.run(60, [&](double now_s) {
    server.tick(now_s);
    return server.heard("begin");
  });
  EXPECT_TRUE(begun) << client.output();
  EXPECT_THAT(server.commands(), Contains("prespawn"));
  server.kick("enough played");
  const bool got_reason = clock.run(90, [&](double now_s) {
    server.tick(now_s);
    return client.output().find("enough played") != std::string::npos;
  });
  EXPECT_TRUE(got_reason) << client.output();
}

TEST(StockClient, SignsOnAndGetsDisconnectReason) {
  expect_that_it_signs_on({});
}

TEST(StockClient, ReturnsChallengeCookie) {
  expect_that_it_signs_on({.challenge = true, .secret = {1, 2}});
}

// A minimal client: signs on, and runs in circles.
class BarePlayer {
 public:
  explicit BarePlayer(std::uint16_t port)
      : endpoint_(platform::posix::open_udp_socket({}).value()),
        server_(platform::ip4_address({127, 0, 0, 1}, port)) {}

  void tick(double now_s) {
    if (endpoint_.state() == ClientEndpoint::State::kIdle) endpoint_.connect(server_, now_s);
    endpoint_.update(now_s);
    while (const auto event = endpoint_.next_event(now_s))
      if (const auto* message = std::get_if<FromServer>(&*event)) hear(message->bytes);
    if (signon_ < 3) return;
    Move move{.time_s = time_s_, .forward = 400};
    move.angles_deg[1] = static_cast<float>(now_s * 90);
    base::ByteWriter writer;
    ASSERT_TRUE(write_client_message(move, Protocol::kNetQuake, writer).ok());
    ASSERT_TRUE(endpoint_.send_unreliable(writer.view()).ok());
  }
  void leave() { endpoint_.disconnect(); }
  int count(const char* message) const {
    const auto found = counts_.find(message);
    return found == counts_.end() ? 0 : found->second;
  }

 private:
  void hear(base::Bytes bytes) {
    reader_.begin(bytes);
    while (true) {
      const auto message = reader_.next();
      ASSERT_TRUE(message.ok()) << message.error().message();
      if (!message->has_value()) return;
      ++counts_[message_name(**message)];
      if (const auto* time = std::get_if<Time>(&**message)) time_s_ = time->time_s;
      if (const auto* signon = std::get_if<SignonNumber>(&**message)) answer(signon->number);
    }
  }
  void answer(int signon) {
    if (signon <= signon_) return;
    signon_ = signon;
    const std::vector<std::string> said[] = {
        {"prespawn"}, {"name \"tester\"", "color 3 4", "spawn "}, {"begin"}};
    base::ByteWriter writer;
    for (const std::string& text : said[std::min(signon, 3) - 1])
      ASSERT_TRUE(write_client_message(StringCommand{text}, Protocol::kNetQuake, writer).ok());
    ASSERT_TRUE(endpoint_.send_reliable(writer.view()).ok());
  }

  ClientEndpoint endpoint_;
  platform::Address server_;
  MessageReader reader_;
  std::map<std::string, int> counts_;
  int signon_ = 0;
  float time_s_ = 0;
};

TEST(StockServer, AcceptsOurClient) {
  DATA_FOLDER_OR_SKIP(data);
  const std::filesystem::path program = TEMBLOR_GAME_PROGRAM;
  if (!test::is_installed("darkplaces-server") || !std::filesystem::exists(program))
    GTEST_SKIP() << "no stock server (darkplaces-server) or no QuakeC compiler (fteqcc)";
  const test::TemporaryFolder home;
  home.write("base/id1/progs.dat", test::read_file(program));
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1"))
    std::filesystem::create_symlink(entry.path(), home.path() / "base/id1" / entry.path().filename());
  // A free port.
  const std::uint16_t port = platform::posix::open_udp_socket({}).value()->local_address().port;
  const test::BackgroundProgram server(
      {"darkplaces-server", "-basedir", (home.path() / "base").string(), "-port", std::to_string(port),
       "+sv_protocolname", "QUAKE", "+sv_public", "0", "+maxplayers", "4", "+deathmatch", "1", "+map",
       kLevel},
      home.path());
  BarePlayer player(port);
  const Clock clock;
  const bool played = clock.run(60, [&](double now_s) {
    player.tick(now_s);
    return player.count("svc_time") > 300;
  });
  EXPECT_TRUE(played) << server.output();
  EXPECT_GE(player.count("svc_clientdata"), 300);
  EXPECT_GT(player.count("fast update"), 300);
  player.leave();
  const bool gone = clock.run(90, [&](double) {
    return server.output().find("tester leaves") != std::string::npos ||
           server.output().find("dropped") != std::string::npos;
  });
  EXPECT_TRUE(gone) << server.output();
}

}  // namespace
}  // namespace temblor::net
