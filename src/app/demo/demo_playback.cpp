#include "app/demo/demo_playback.h"

#include <utility>

namespace temblor::app {

DemoPlayback::DemoPlayback(const LoadedDemo& demo, client::DemoPlayer player,
                           const client::PresentationSettings& presentation)
    : player_(std::move(player)),
      presentation_(std::make_unique<client::Presentation>(demo.library)),
      settings_(presentation) {}

base::Result<DemoPlayback> DemoPlayback::open(const LoadedDemo& demo,
                                              const client::PresentationSettings& presentation) {
  TRY(client::DemoPlayer player, client::DemoPlayer::open(demo.bytes, demo.name));
  return DemoPlayback(demo, std::move(player), presentation);
}

// The recorded view angles, interpolated between packets if the settings say so.
math::Vec3 DemoPlayback::view_angles_deg() const {
  return player_.view_angles_at(player_.server_time_s(),
                                {.interpolate = settings_.interpolate, .no_lerp_models = {}});
}

// The handler runs after the presentation has been updated, so it sees the sounds of this moment.
base::Status DemoPlayback::present(double time_s) {
  TRY_STATUS(presentation_->advance(player_.state(), player_.server_time_s(), view_angles_deg(), settings_));
  on_moment_(time_s);
  return base::Ok{};
}

base::Status DemoPlayback::present_unseen(double time_s) {
  TRY_STATUS(
      presentation_->advance_unseen(player_.state(), player_.server_time_s(), view_angles_deg(), settings_));
  on_moment_(time_s);
  return base::Ok{};
}

// Plays every packet up to `time_s`: first everything to the packet's time, then the packet's messages. Only
// the state at `time_s` is prepared for drawing.
base::Result<bool> DemoPlayback::advance_to(double time_s) {
  while (player_.packet_time_s() < time_s) {
    const double packet_time_s = player_.packet_time_s();
    TRY_STATUS(player_.advance_to(packet_time_s));
    TRY_STATUS(present_unseen(packet_time_s));
    TRY(const bool has_more, player_.begin_packet());
    if (!has_more) break;
    TRY_STATUS(present_unseen(packet_time_s));
  }
  TRY(const bool has_more, player_.advance_to(time_s));
  TRY_STATUS(present(time_s));
  return has_more;
}

base::Result<bool> DemoPlayback::advance_by_packet() {
  TRY(const bool has_more, player_.read_packet());
  TRY_STATUS(present(player_.packet_time_s()));
  return has_more;
}

}  // namespace temblor::app
