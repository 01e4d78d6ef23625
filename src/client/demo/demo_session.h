// A recording that somebody watches: paused, slow, fast, and from any moment on.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "client/demo/demo_index.h"
#include "client/demo/demo_player.h"
#include "client/view/presentation.h"

namespace temblor::client {

// Times are the recording's (see DemoPlayer), from begin_s() to end_s(). What is to be seen at a time does
// not depend on how it was come to: after seeking, what happened in the seconds before is lived through
// unseen, and all of the level with marks on walls, which stay. Only the trail of what has flown for longer
// than these seconds may be dotted elsewhere.
//
// Where the recording is damaged it ends; that is told once, as an error of advance() or seek(), when its end
// is come to. What there is to see stays.
class DemoSession {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 8;

  // What happened, when it is to be heard: `events` of the moment, and the game that it happened in. After a
  // seek, one call has the level as if it had just begun: new_level, and its static sounds.
  using Listener = std::function<void(const Events& events, const Game& game, double server_time_s)>;

  // Reads all of it once. Nothing is to be seen before the first advance() or seek(). `io_presentation` must
  // outlive it.
  static base::Result<DemoSession> open(base::ByteVector bytes, std::string name,
                                        Presentation& io_presentation);
  void set_listener(Listener listener) { listener_ = std::move(listener); }

  const DemoLength& length() const { return index_.length(); }
  double begin_s() const { return length().first_time_s; }
  double end_s() const { return length().last_time_s; }
  double time_s() const { return time_s_; }
  bool has_ended() const { return has_ended_; }

  bool is_paused() const { return paused_; }
  void pause(bool paused) { paused_ = paused; }
  // Times as fast as it was recorded; kept from kSlowest to kFastest.
  double speed() const { return speed_; }
  void set_speed(double speed);

  // `passed_s` of real time go by: that times the speed, none while paused. False: the recording has ended.
  base::Result<bool> advance(double passed_s, const PresentationSettings& settings);
  // Times before the beginning and behind the end are these.
  base::Result<bool> seek(double time_s, const PresentationSettings& settings);
  // To the end of the packet that many after this one, or before it, whether or not it is paused. False past
  // the last one: the recording has ended.
  base::Result<bool> step(int packets, const PresentationSettings& settings);

  ClientState& state() { return player_->state(); }
  const ClientState& state() const { return player_->state(); }
  // Of what is shown, on the server's clock.
  double server_time_s() const { return player_->server_time_s(); }

 private:
  DemoSession(std::unique_ptr<DemoPlayer> player, DemoIndex index, Presentation& io_presentation)
      : player_(std::move(player)), index_(std::move(index)), presentation_(&io_presentation) {}

  base::Status go_before(double time_s, const PresentationSettings& settings);
  base::Result<bool> go_on_to(double time_s, const PresentationSettings& settings);
  base::Result<bool> live_through(double time_s, const PresentationSettings& settings);
  base::Status pass(const PresentationSettings& settings);
  base::Status present(const PresentationSettings& settings);
  void hear();
  void hear_level();
  math::Vec3 view_angles_deg(const PresentationSettings& settings) const;

  std::unique_ptr<DemoPlayer> player_;  // stays where it is: places of the index are in it
  DemoIndex index_;
  Presentation* presentation_;
  Listener listener_;
  std::vector<net::SpawnStaticSound> static_sounds_;  // of the level
  double time_s_ = 0, speed_ = 1;
  bool has_begun_ = false, has_ended_ = false, damage_told_ = false;
  bool paused_ = false, seeks_ = false;
};

}  // namespace temblor::client
