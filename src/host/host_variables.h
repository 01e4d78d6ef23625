// All console variables of a game: the renderer's, the client's, the server's and the host's own.
#pragma once

#include "client/console/console_variables.h"
#include "client/input/input_variables.h"
#include "client/session/connection.h"
#include "client/view/client_variables.h"
#include "command/variables.h"
#include "host/session/overrides.h"
#include "host/video/render_settings.h"
#include "host/video/screen.h"
#include "platform/window.h"
#include "server/server_variables.h"

namespace temblor::host {

struct ZoomSettings {
  float fov_deg = 90, zoom_fov_deg = 30;
  float speed = 8;  // of the way a second
};

class HostVariables {
 public:
  // Registers them all; `variables` must outlive it.
  explicit HostVariables(command::Variables& variables);

  command::Variables& variables() const { return *variables_; }
  const server::ServerVariables& server() const { return server_; }

  render::Settings render() const { return render_.read(*variables_); }
  client::PresentationSettings presentation() const { return client_.read(*variables_); }
  client::InputSettings input() const { return input_.read(*variables_); }
  platform::WindowSettings window() const;
  ScreenSettings screen() const;
  ZoomSettings zoom() const;
  client::PlayerSettings player() const;
  client::ConsoleSettings console() const { return console_.read(*variables_); }
  float rumble() const { return static_cast<float>(variables_->float_value(rumble_)); }
  double frames_per_second() const;  // 0: as the display
  std::uint32_t max_players() const {
    return static_cast<std::uint32_t>(variables_->int_value(max_players_));
  }
  std::uint16_t port() const { return static_cast<std::uint16_t>(variables_->int_value(port_)); }
  bool is_parallel() const { return variables_->bool_value(parallel_); }
  bool shows_speed() const { return variables_->bool_value(show_speed_); }
  bool shows_latency() const { return variables_->bool_value(show_latency_); }

  // Everything as it was registered.
  void reset() const;
  // Text that sets what is not at its default and belongs to the player, not to a server's rules.
  std::string to_text(const Overrides& overrides) const;

 private:
  command::Variables* variables_;
  RenderSettings render_;
  client::ClientVariables client_;
  client::InputVariables input_;
  client::ConsoleVariables console_;
  server::ServerVariables server_;
  command::VariableIndex width_, height_, mode_, display_, vsync_, color_, scale_, automatic_scale_,
      target_fps_, max_fps_, gamma_, contrast_, brightness_, fov_, zoom_fov_, zoom_speed_, name_, shirt_,
      pants_, rumble_, parallel_, show_speed_, show_latency_, max_players_, port_;
  std::vector<std::string> kept_;  // names of the player's own
};

}  // namespace temblor::host
