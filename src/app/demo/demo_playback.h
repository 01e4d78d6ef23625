// A recording being played, moment by moment: state and presentation, without a renderer.
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
  // `demo` must outlive it. Nothing is shown before the first advance.
  static base::Result<DemoPlayback> open(const LoadedDemo& demo,
                                         const client::PresentationSettings& presentation);

  // Plays on to `time_s` of the recording's clock. False: the recording has ended. What happens on the way
  // does so at its own time, however long the way is.
  base::Result<bool> advance_to(double time_s);
  // Plays on by one packet, to its time.
  base::Result<bool> advance_by_packet();

  // What the last advance led to. Valid until the next one.
  client::Presentation& presentation() { return *presentation_; }
  const client::Presentation& presentation() const { return *presentation_; }
  const client::PresentationSettings& settings() const { return settings_; }
  client::PresentationSettings& settings() { return settings_; }
  const client::ClientState& state() const { return player_.state(); }

  // Called with the recording's time at every moment that is lived through, also those on the way.
  void on_moment(std::function<void(double time_s)> call) { on_moment_ = std::move(call); }

 private:
  DemoPlayback(const LoadedDemo& demo, client::DemoPlayer player,
               const client::PresentationSettings& presentation);
  math::Vec3 view_angles_deg() const;
  base::Status present(double time_s);
  base::Status pass(double time_s);

  client::DemoPlayer player_;
  std::unique_ptr<client::Presentation> presentation_;  // parts of it refer to one another
  client::PresentationSettings settings_;
  std::function<void(double time_s)> on_moment_ = [](double) {};
};

}  // namespace temblor::app
