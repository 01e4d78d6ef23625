#include "app/lab/wire/recorded_game.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "app/files/game_files.h"
#include "assets/library.h"
#include "net/protocol/message_reader.h"
#include "net/transport/client_endpoint.h"
#include "net/transport/loopback.h"
#include "server/server.h"

namespace temblor::app {
namespace {

using base::ErrorCode;
namespace wire = lab::wire;

constexpr std::uint16_t kServerPort = 26000;
constexpr double kBegin_s = 100, kMaxJoining_s = 10, kSettle_s = 1;
constexpr int kLastSignon = 4;
// In levels where the game's code has bots.
constexpr int kBots = 4;

platform::Address make_remote_address(std::uint16_t port) {
  return platform::ip4_address({10, 0, 0, 1}, port);
}

// A socket of this process that looks like one of another machine, so that the limits of a network hold.
class RemoteSocket : public platform::DatagramSocket {
 public:
  explicit RemoteSocket(std::unique_ptr<platform::DatagramSocket> socket) : socket_(std::move(socket)) {}

  void send(const platform::Address& to, base::Bytes bytes) override {
    socket_->send({.port = to.port}, bytes);
  }
  std::optional<platform::Datagram> receive() override {
    std::optional<platform::Datagram> datagram = socket_->receive();
    if (datagram) datagram->from = make_remote_address(datagram->from.port);
    return datagram;
  }
  platform::Address local_address() const override {
    return make_remote_address(socket_->local_address().port);
  }

 private:
  std::unique_ptr<platform::DatagramSocket> socket_;
};

// A stock client that joins, runs around, and shoots.
class Runner {
 public:
  Runner(std::unique_ptr<platform::DatagramSocket> socket, int number)
      : endpoint_(std::move(socket)), number_(number) {}

  void connect(double now_s) { endpoint_.connect(make_remote_address(kServerPort), now_s); }
  bool is_playing() const { return signon_ >= kLastSignon - 1; }
  // Empty: it is connected, or still trying.
  const std::string& problem() const { return problem_; }
  // How often it was sent a level.
  int levels() const { return levels_; }

  // `keep` receives the unreliable messages of this tick.
  void step(double now_s, std::size_t tick, const std::function<void(base::Bytes)>& keep) {
    endpoint_.update(now_s);
    while (const auto event = endpoint_.next_event(now_s)) {
      if (const auto* lost = std::get_if<net::ConnectionLost>(&*event)) problem_ = lost->reason;
      const auto* packet = std::get_if<net::FromServer>(&*event);
      if (packet == nullptr) continue;
      if (!packet->reliable) keep(packet->bytes);
      read(packet->bytes);
    }
    if (is_playing()) send(net::Move(choose_move(now_s, tick)), false);
  }

 private:
  // Turns all the time, a little differently each second, so that walls do not hold it for long.
  net::Move choose_move(double now_s, std::size_t tick) const {
    const double seconds = static_cast<double>(tick) / 72, own = 1 + 0.37 * number_;
    const double yaw_deg = 90 * number_ + 140 * std::sin(own * seconds) + 47 * std::floor(seconds * own);
    const bool shoots = (tick / 36 + static_cast<std::size_t>(number_)) % 3 == 0;
    const bool jumps = (tick / 24 + static_cast<std::size_t>(number_)) % 5 == 0;
    return {.time_s = static_cast<float>(now_s),
            .angles_deg = {0, static_cast<float>(std::remainder(yaw_deg, 360)), 0},
            .forward = 400,
            .buttons = static_cast<std::uint8_t>((shoots ? 1 : 0) | (jumps ? 2 : 0))};
  }

  void send(const net::ClientMessage& message, bool is_reliable) {
    base::ByteWriter writer;
    base::Status status = write_client_message(message, reader_.dialect().protocol, writer);
    if (status.ok())
      status =
          is_reliable ? endpoint_.send_reliable(writer.view()) : endpoint_.send_unreliable(writer.view());
    if (!status.ok() && problem_.empty()) problem_ = status.error().what;
  }

  void read(base::Bytes bytes) {
    constexpr std::string_view kAnswers[kLastSignon] = {"", "prespawn", "spawn", "begin"};
    reader_.begin(bytes);
    for (auto message = reader_.next(); message.ok() && *message; message = reader_.next()) {
      levels_ += std::holds_alternative<net::ServerInfo>(**message);
      const auto* number = std::get_if<net::SignonNumber>(&**message);
      if (number == nullptr || number->number <= signon_ || number->number >= kLastSignon) continue;
      signon_ = number->number;
      send(net::StringCommand{kAnswers[signon_]}, true);
    }
  }

  net::ClientEndpoint endpoint_;
  net::MessageReader reader_;
  int number_, signon_ = 0, levels_ = 0;
  std::string problem_;
};

// A server with its players.
class RecordedGame {
 public:
  RecordedGame(const assets::Library& library, const RecordingOptions& options)
      : options_(options), settings_(variables_) {
    net::ServerEndpoint::Sockets sockets;
    sockets.push_back(open(kServerPort));
    server_ = std::make_unique<server::Server>(
        server::ServerSetup{.library = library,
                            .settings = settings_,
                            .sockets = std::move(sockets),
                            .max_clients = static_cast<std::uint32_t>(options.players + kBots),
                            .print = [](std::string_view) {}});
  }

  base::Status join() {
    TRY_STATUS(variables_.set("deathmatch", "1"));
    TRY_STATUS(variables_.set("noexit", "1"));
    TRY_STATUS(variables_.set("bot_fill", fmt::format("{}", options_.players + kBots)));
    TRY_STATUS(server::start_map(*server_, options_.map));
    for (int player = 0; player < options_.players; ++player) {
      runners_.push_back(std::make_unique<Runner>(open(0), player));
      runners_.back()->connect(now_s_);
    }
    for (const double until_s = now_s_ + kMaxJoining_s; !is_everybody_playing();) {
      if (now_s_ > until_s) return base::error(ErrorCode::kIo, "{}: players cannot join", options_.map);
      TRY_STATUS(step([](base::Bytes) {}));
    }
    // Until all entities have dropped to the floor.
    for (const double until_s = now_s_ + kSettle_s; now_s_ < until_s;) TRY_STATUS(step([](base::Bytes) {}));
    return base::Ok{};
  }

  base::Result<wire::World> record() {
    wire::World world{.dialect = server_->game->setup().dialect, .tick_s = settings_.tick_s(), .ticks = {}};
    const auto count = static_cast<std::size_t>(std::ceil(options_.seconds / world.tick_s));
    base::Status status = base::Ok{};
    const auto keep = [&](base::Bytes datagram) {
      base::Result<wire::WorldTick> tick = wire::keep_state(datagram, world.dialect);
      if (!tick.ok())
        status = tick.error();
      else if (world.ticks.empty() || tick->time_s > world.ticks.back().time_s)
        world.ticks.push_back(std::move(*tick));
    };
    while (world.ticks.size() < count) {
      TRY_STATUS(step(keep));
      TRY_STATUS(status);
    }
    return world;
  }

 private:
  std::unique_ptr<platform::DatagramSocket> open(std::uint16_t port) {
    return std::make_unique<RemoteSocket>(network_.open(port));
  }
  bool is_everybody_playing() const {
    for (const auto& runner : runners_)
      if (!runner->is_playing()) return false;
    return true;
  }
  // `keep` receives what the first player is sent.
  base::Status step(const std::function<void(base::Bytes)>& keep) {
    now_s_ += settings_.tick_s();
    server::step_server(*server_, now_s_);
    for (std::size_t i = 0; i < runners_.size(); ++i) {
      runners_[i]->step(
          now_s_, tick_, i == 0 ? keep : [](base::Bytes) {});
      if (!runners_[i]->problem().empty())
        return base::error(ErrorCode::kIo, "{}: {}", options_.map, runners_[i]->problem());
      if (runners_[i]->levels() > 1)
        return base::error(ErrorCode::kUnsupported,
                           "{}: the level ends after {:.0f} s; choose fewer --seconds", options_.map,
                           static_cast<double>(tick_) * settings_.tick_s());
    }
    ++tick_;
    return base::Ok{};
  }

  RecordingOptions options_;
  command::Variables variables_;
  server::ServerVariables settings_;
  net::LoopbackNetwork network_;
  std::unique_ptr<server::Server> server_;
  std::vector<std::unique_ptr<Runner>> runners_;
  double now_s_ = kBegin_s;
  std::size_t tick_ = 0;
};

}  // namespace

base::Result<wire::World> record_game(const GameFolders& folders, const RecordingOptions& options) {
  if (options.map.empty()) return wire::make_built_in_world(options.seconds, options.players);
  TRY(vfs::FileSystem files, open_files(folders));
  const assets::Library library(std::move(files));
  RecordedGame game(library, options);
  TRY_STATUS(game.join());
  return game.record();
}

}  // namespace temblor::app
