// Plays a demo without a renderer: advances the client's state and its presentation (entities, particles,
// lights, sounds, status bar). It uses the client library's demo player, so a demo looks the same here as in
// the game.
//
//   .dem -> DemoPlayer -> ClientState -> Presentation -> Scene, DrawList, AudioScene
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/demo/demo_loading.h"
#include "base/result.h"
#include "client/demo/demo_player.h"
#include "client/view/presentation.h"

namespace temblor::app {

class DemoPlayback {
 public:
  // `demo` must outlive it. There is nothing to show before the first advance.
  static base::Result<DemoPlayback> open(const LoadedDemo& demo,
                                         const client::PresentationSettings& presentation);

  // Advances to `time_s` on the demo's clock. Every packet in between is played at its own time, so that
  // effects do not depend on the frame rate. Returns false if the demo has ended.
  base::Result<bool> advance_to(double time_s);
  // Advances by one packet, to its time.
  base::Result<bool> advance_by_packet();

  // Result of the last advance. Valid until the next one.
  client::Presentation& presentation() { return *presentation_; }
  const client::Presentation& presentation() const { return *presentation_; }
  const client::PresentationSettings& settings() const { return settings_; }
  client::PresentationSettings& settings() { return settings_; }
  const client::ClientState& state() const { return player_.state(); }

  // Sets a function that is called with the demo's time at every moment that is played, including the packets
  // between two advances.
  void set_moment_handler(std::function<void(double time_s)> call) { on_moment_ = std::move(call); }

 private:
  DemoPlayback(const LoadedDemo& demo, client::DemoPlayer player,
               const client::PresentationSettings& presentation);
  math::Vec3 view_angles_deg() const;
  // Updates the presentation for a moment that is drawn, or for one that is not.
  base::Status present(double time_s);
  base::Status present_unseen(double time_s);

  client::DemoPlayer player_;
  // Allocated separately, because its parts refer to each other and it must not move.
  std::unique_ptr<client::Presentation> presentation_;
  client::PresentationSettings settings_;
  std::function<void(double time_s)> on_moment_ = [](double) {};
};

}  // namespace temblor::app
