// Prediction of the player's own motion: replays the moves that the server has not acknowledged yet, as the
// server will play them. Needs a server that takes numbered moves (net/protocol/numbered_moves.h).
//
//   acknowledged state --replay sent moves--> latest --pending part of a move--> shown (+ error, which fades)
//
// Each acknowledgment restarts the prediction. If the new result differs from the old one for the same
// moment, the difference becomes an error that fades within about a tenth of a second, so the view does not
// jump. On a lift the player is shown relative to the lift as it is drawn, which lags behind, so that the
// ride is as smooth as the lift.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/prediction/predicted_player.h"
#include "client/session/client_state.h"
#include "client/session/connection.h"
#include "client/view/view.h"

namespace temblor::client {

// Statistics of corrections, for tests and diagnostics. Distances in units.
struct PredictionReport {
  // Corrections of more than a hundredth of a unit, and the largest of them.
  std::uint64_t corrections = 0;
  float largest_units = 0;
  // The largest part of an error that faded in one frame, lifts included: how far the view jumped.
  float largest_jump_units = 0;
  // Frames without a prediction, because it would have taken too long.
  std::uint64_t abandoned_frames = 0;
  // The largest difference that was taken for a teleport; those are not counted above.
  float teleport_units = 0;
};

// Owns its copies of moves and entities. One object per connection.
class Prediction {
 public:
  // Bounds on the work of a frame, whatever the server sends: the number of brush models, and the effort of
  // step() (a frame may exceed it by its last step).
  static constexpr std::size_t kMaxSolids = 512, kMaxEffort = 1 << 15;

  // Call once a frame, after Connection::update() and the frame's moves. `pending`: what the player has done
  // since the last move (buttons and impulse included) and has not sent yet.
  void begin_frame(const Connection& connection, const net::Move& pending, double now_s);
  // The player's motion for this frame. Returns nothing if the server does not take numbered moves, the view
  // is in another entity, or it would take too long. `drawn`: the entities as this frame draws them. Call
  // once a frame.
  std::optional<PredictedMotion> advance(const ClientState& state, const world::Level& level,
                                         std::span<const InterpolatedEntity> drawn);

  const PredictionReport& report() const { return report_; }
  void reset_report() { report_ = {}; }
  // The difference between shown and predicted place; it fades.
  const math::Vec3& error() const { return error_; }

 private:
  struct ShownPlayer {
    PredictedPlayer predicted;
    bool on_ground = false;
    // The mover below; 0: the level, or nothing.
    std::uint32_t ground = 0;
    // The place to show, without error_.
    math::Vec3 origin{0.0f};
  };
  // The world that solids_ describe.
  PredictionWorld make_world(const world::Level& level) const;
  ShownPlayer restart(const ClientState& state, const world::Level& level,
                      std::span<const InterpolatedEntity> drawn);
  ShownPlayer continue_prediction(const ClientState& state, const world::Level& level,
                                  std::span<const InterpolatedEntity> drawn);
  ShownPlayer predict_shown(const PredictedPlayer& latest, const PredictionWorld& world,
                            std::span<const InterpolatedEntity> drawn);
  math::Vec3 compute_ride_lag(std::uint32_t ground, const PredictedPlayer& predicted,
                              std::span<const InterpolatedEntity> drawn) const;
  void play_sent_moves(std::uint32_t after, const PredictionWorld& world, PredictedPlayer& io_player);
  void update_solids(const ClientState& state, const world::Level& level);
  void correct(const math::Vec3& before, const math::Vec3& now);

  // Inputs of this frame.
  std::optional<net::MoveParameters> parameters_;
  std::optional<net::MoveAcknowledgment> acknowledged_;
  std::uint64_t acknowledgment_count_ = 0;
  std::vector<NumberedMove> moves_;
  net::Move pending_;
  double pending_s_ = 0;
  double now_s_ = 0;
  std::size_t effort_ = 0;

  // State that lasts from frame to frame.
  std::vector<EntityPlace> places_;
  std::vector<SolidModel> solids_;
  std::vector<world::PlacedLiquid> liquids_;
  // The player after all sent moves; nothing without a prediction.
  std::optional<PredictedPlayer> latest_;
  // The number of the last move in latest_.
  std::uint32_t last_played_ = 0;
  // The acknowledgment that latest_ is based on.
  std::uint64_t latest_base_ = 0;
  // The mover on which the last frame showed the player.
  std::uint32_t ground_ = 0;
  double shown_at_s_ = 0;
  // Added to the predicted place; fades to 0.
  math::Vec3 error_{0.0f};
  PredictionReport report_;
};

}  // namespace temblor::client
