// A server with the shipped game on a level of the data, and a client that predicts, on a network
// and a clock that the test controls.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assets/library.h"
#include "client/prediction/prediction.h"
#include "client/session/connection.h"
#include "command/variables.h"
#include "server/server.h"
#include "server/server_variables.h"
#include "support/programs/bad_network.h"

namespace temblor::test {

class PredictedGame {
 public:
  // A single-player game, without monsters from join() on.
  PredictedGame(const std::filesystem::path& data, const std::string& map,
                const NetworkConditions& conditions, std::uint64_t seed = 1);

  // Runs until the client plays and its moves are acknowledged; false: that takes too long.
  bool join();
  // Runs one frame with this input; `forward` and so on of the move are the player's keys.
  void frame(const net::Move& doing);
  void run(double seconds, const net::Move& doing = {});
  // Puts the player somewhere, and waits until client and server agree on it.
  void put_player(const math::Vec3& origin);

  server::Edict player() { return server_->game->player(0); }
  server::Game& game() { return *server_->game; }
  server::Server& server() { return *server_; }
  client::Connection& client() { return client_; }
  client::Prediction& prediction() { return prediction_; }
  const world::Level& level() const { return *level_; }
  // The result of the last frame.
  const std::optional<client::PredictedMotion>& shown() const { return shown_; }
  std::span<const client::InterpolatedEntity> drawn() const { return drawn_; }
  double now_s() const { return now_s_; }
  double frame_s = 1.0 / 60;
  std::uint64_t moves_sent() const { return moves_sent_; }

 private:
  void remove_monsters();

  command::Variables variables_;
  std::unique_ptr<assets::Library> library_;
  std::unique_ptr<server::ServerVariables> settings_;
  BadNetwork network_;
  std::unique_ptr<server::Server> server_;
  client::Connection client_;
  client::Prediction prediction_;
  std::shared_ptr<const world::Level> level_;
  std::optional<client::PredictedMotion> shown_;
  std::vector<client::InterpolatedEntity> drawn_;
  std::string console_;
  double now_s_ = 50, drawn_time_s_ = 0;
  std::uint64_t moves_sent_ = 0;
};

}  // namespace temblor::test
