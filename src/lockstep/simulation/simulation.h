// A server whose game depends on nothing but its start and its players' inputs, so that every peer of a
// lockstep game, and every replay, can play it and get the same state.
//
//   inputs of all players --> one pretended client each <-- loopback --> server::Server
//                                      |
//                                      +--> messages for that player's real client, or for a demo
//
// The server's clock is virtual: it advances by one tick in play_tick(). The pretended clients acknowledge
// everything at once, so that real clients, and how fast they load, do not influence the server.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "command/variables.h"
#include "lockstep/game_start.h"
#include "lockstep/peers/client_input.h"
#include "net/transport/client_endpoint.h"
#include "net/transport/loopback.h"
#include "server/server.h"

namespace temblor::lockstep {

// A message of the server to one client.
struct MessageForClient {
  base::ByteVector bytes;
  bool is_reliable = false;
};

struct SimulationSetup {
  const assets::Library& library;  // must outlive the simulation
  std::filesystem::path program_file{};
  std::function<void(std::string_view text)> print{};
};

class Simulation {
 public:
  // Loads the level, and lets all clients connect. Fails if the level or its game code cannot be used.
  static base::Result<std::unique_ptr<Simulation>> begin(const SimulationSetup& setup,
                                                         const GameStart& start);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  // Plays one tick. `inputs`: one per player. Fails if no game is left, after an error in game code.
  base::Status play_tick(std::span<const ClientInput> inputs);
  // Ticks since begin().
  std::uint32_t ticks() const { return ticks_; }
  double tick_s() const { return settings_.tick_s(); }

  // The messages for this player's client since the last call, in order.
  std::vector<MessageForClient> take_messages(std::size_t player);
  net::Protocol protocol() const { return server_->clients.dialect().protocol; }
  // CHECKs that a level is running.
  server::Game& game() { return *server_->game; }
  server::Server& server() { return *server_; }

 private:
  struct PretendedClient {
    net::ClientEndpoint endpoint;
    std::vector<MessageForClient> messages{};
    bool has_left = false;
  };

  Simulation(const SimulationSetup& setup, const GameStart& start);
  base::Status connect_clients(std::size_t count);
  void send_input(PretendedClient& io_client, const ClientInput& input);
  void send_moves(PretendedClient& io_client, const ClientInput& input);
  void step();
  void receive_messages();

  command::Variables variables_;
  server::ServerVariables settings_;
  net::LoopbackNetwork network_;
  std::unique_ptr<server::Server> server_;
  std::vector<PretendedClient> clients_;
  double now_s_ = 0;
  float input_age_s_ = 0;  // how long inputs have traveled when they are played
  std::uint32_t ticks_ = 0;
};

}  // namespace temblor::lockstep
