// The player's own place ahead of the server's word: what he has done since then, played as the server will
// play it. Only with servers that take numbered moves and say what came of them
// (net/protocol/numbered_moves.h).
//
// The server's word starts each prediction; where that shows him somewhere else than the one before did for
// the same moment, the difference fades within about a tenth of a second. On a lift he is shown where he is
// to it, beside the lift as it is drawn, which is some time behind: so he rides as smoothly as it does.
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

// What has been made up for, for tests and for who wants to see it.
struct PredictionReport {
  std::uint64_t corrections = 0;  // by more than a hundredth of a unit
  float largest_units = 0;        // of them
  float largest_jump_units = 0;   // that one frame has shown of them, and of steps on and off lifts
  std::uint64_t given_up = 0;     // frames that would have taken too long: none was made in them
  float unpredicted_units = 0;    // those too large to be a mistake, which are not counted above: teleports
};

class Prediction {
 public:
  // However many brush models a server shows, and however it moves the player about: the nearest so many
  // count, and a frame takes this much of step()'s effort, but for the last step's, before it gives up.
  static constexpr std::size_t kMaxSolids = 512, kMaxEffort = 1 << 15;

  // Once a frame, after Connection::update() and the frame's moves. `doing`: what the player does since the
  // last move (its buttons and impulse included), which has not been sent yet.
  void begin_frame(const Connection& connection, const net::Move& doing, double now_s);
  // Where the player is to be shown; nothing where the server does not take numbered moves, somebody
  // else's eyes are looked through, or it would take too long. `drawn`: the entities as this frame draws
  // them. Once a frame.
  std::optional<OwnMotion> advance(const ClientState& state, const world::Level& level,
                                   std::span<const SeenEntity> drawn);

  const PredictionReport& report() const { return report_; }
  void reset_report() { report_ = {}; }
  // Of what is shown, from what is predicted: it fades.
  const math::Vec3& error() const { return error_; }

 private:
  struct Shown {
    PredictedPlayer predicted;
    bool on_ground = false;
    std::uint32_t ground = 0;  // 0: the level, or nothing
    math::Vec3 origin{0.0f};   // without the error
  };
  PredictionWorld world_around(const ClientState& state, const world::Level& level) const;
  Shown begin(const ClientState& state, const world::Level& level, std::span<const SeenEntity> drawn);
  Shown go_on(const ClientState& state, const world::Level& level, std::span<const SeenEntity> drawn);
  Shown shown(const PredictedPlayer& whole, const PredictionWorld& world, std::span<const SeenEntity> drawn);
  math::Vec3 lag_of(std::uint32_t ground, const PredictedPlayer& predicted,
                    std::span<const SeenEntity> drawn) const;
  void play_sent_moves(std::uint32_t after, const PredictionWorld& world, PredictedPlayer& io_whole);
  void take_up_solids(const ClientState& state, const world::Level& level);
  void correct(const math::Vec3& before, const math::Vec3& now);

  // Of this frame.
  std::optional<net::MoveParameters> terms_;
  std::optional<net::MoveAcknowledgement> told_;
  std::uint64_t told_count_ = 0;
  std::vector<NumberedMove> moves_;
  net::Move doing_;
  double doing_for_s_ = 0;
  double now_s_ = 0;
  std::size_t effort_ = 0;

  // From frame to frame.
  std::vector<EntityPlace> places_;
  std::vector<SolidModel> solids_;
  std::optional<PredictedPlayer> whole_;  // after all moves that were sent
  std::uint32_t played_ = 0;              // the last of them
  std::uint64_t whole_from_ = 0;          // the acknowledgement that it starts from
  std::uint32_t ground_ = 0;              // that the last frame showed him on
  double shown_at_s_ = 0;
  math::Vec3 error_{0.0f};
  PredictionReport report_;
};

}  // namespace temblor::client
