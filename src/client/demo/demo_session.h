// A demo that somebody watches: with pause, speed and seeking.
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

// Times are on the demo's clock (see DemoPlayer), from begin_s() to end_s(). The picture at a time does not
// depend on how it was reached: after a seek, the seconds before it are replayed unseen, and the whole level
// if there are marks, as those stay. Only the trail of something that has flown for longer may have its
// particles elsewhere.
//
//   seek:  restore an entry of the index -> replay unseen with effects -> show
//
// A damaged demo ends at the damage. The error is returned once, by the advance() or seek() that reaches it;
// what came before stays visible.
class DemoSession {
 public:
  static constexpr double kMinSpeed = 0.1, kMaxSpeed = 8;

  // Receives the events at the time they should be heard, and the game they happened in. After a seek, one
  // call presents the level as newly begun: new_level, and its static sounds.
  using Listener = std::function<void(const Events& events, const Game& game, double server_time_s)>;

  // Reads the whole demo once. There is nothing to show before the first advance() or seek().
  // `io_presentation` must outlive the session. `texts`: see ClientState::set_texts().
  static base::Result<DemoSession> open(base::ByteVector bytes, std::string name,
                                        Presentation& io_presentation,
                                        std::shared_ptr<const formats::Localization> texts = nullptr);
  void set_listener(Listener listener) { listener_ = std::move(listener); }

  const DemoLength& length() const { return index_.length(); }
  double begin_s() const { return length().first_time_s; }
  double end_s() const { return length().last_time_s; }
  double time_s() const { return time_s_; }
  bool has_ended() const { return has_ended_; }

  bool is_paused() const { return paused_; }
  void pause(bool paused) { paused_ = paused; }
  // A factor, clamped to [kMinSpeed, kMaxSpeed].
  double speed() const { return speed_; }
  void set_speed(double speed);

  // Advances by `elapsed_s` of real time, times the speed; by nothing while paused. Returns false if the demo
  // has ended.
  base::Result<bool> advance(double elapsed_s, const PresentationSettings& settings);
  // Makes the scene of the same moment again, for other settings.
  base::Status show(const PresentationSettings& settings) { return present(settings); }
  // Clamps the time to the demo's.
  base::Result<bool> seek(double time_s, const PresentationSettings& settings);
  // Moves to the end of the packet that many after this one, or before it, paused or not. Returns false past
  // the last packet: the demo has ended.
  base::Result<bool> step(int packets, const PresentationSettings& settings);

  ClientState& state() { return player_->state(); }
  const ClientState& state() const { return player_->state(); }
  // The time shown, on the server's clock.
  double server_time_s() const { return player_->server_time_s(); }

 private:
  DemoSession(std::unique_ptr<DemoPlayer> player, DemoIndex index, Presentation& io_presentation)
      : player_(std::move(player)), index_(std::move(index)), presentation_(&io_presentation) {}

  base::Status restore_before(double time_s, const PresentationSettings& settings);
  base::Result<bool> play_to(double time_s, const PresentationSettings& settings);
  base::Result<bool> replay_unseen(double time_s, const PresentationSettings& settings);
  base::Status advance_unseen(const PresentationSettings& settings);
  base::Status present(const PresentationSettings& settings);
  void notify_listener();
  void notify_level_start();
  math::Vec3 view_angles_deg(const PresentationSettings& settings) const;

  std::unique_ptr<DemoPlayer> player_;  // a pointer, as the places of the index refer to it
  DemoIndex index_;
  Presentation* presentation_;
  Listener listener_;
  std::vector<net::SpawnStaticSound> static_sounds_;  // of the current level
  double time_s_ = 0, speed_ = 1;
  bool has_begun_ = false, has_ended_ = false, damage_reported_ = false;
  bool paused_ = false, seeks_ = false;
};

}  // namespace temblor::client
