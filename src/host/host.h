// The game in a window: owns everything, and does it in a fixed order, frame by frame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/bindings.h"
#include "client/player_input.h"
#include "client/presentation.h"
#include "command/console.h"
#include "host/frame_limiter.h"
#include "host/game_data.h"
#include "host/host_variables.h"
#include "host/screen.h"
#include "host/services.h"
#include "host/session.h"
#include "host/worker.h"

namespace temblor::host {

struct HostOptions {
  GameFolders folders;
  std::filesystem::path program_file{};  // the game's code; empty: the game folders' progs.dat
  std::vector<std::string> commands{};   // run once the configuration is
  // Set again after the configuration: what the command line says.
  std::function<base::Status()> apply_overrides{};
};

// Of the last frame.
struct FrameTimes {
  double frame_s = 0;    // from the frame before to this one
  double drawing_s = 0;  // scene to finished picture
  double present_s = 0;  // handing it to the window
  double latency_s = 0;  // from the oldest event in it to its being handed over; 0: there was none
};

class Host {
 public:
  // Fails where the game folders or the window cannot be used.
  static base::Result<std::unique_ptr<Host>> start(Services services, const HostVariables& variables,
                                                   HostOptions options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  // One frame. False: it is over; the configuration is saved then.
  bool frame();
  const FrameTimes& times() const { return times_; }

  // --- For commands (host_commands.h adds them).
  command::Console& console() { return console_; }
  void print(std::string_view line);
  base::Status start_map(std::string_view map);
  base::Status load_game(std::string_view name);
  base::Status save_game(std::string_view name);
  base::Status connect(std::string_view address);
  void disconnect();
  void quit() { wants_to_quit_ = true; }
  base::Status screenshot(std::string_view file);
  base::Status save_configuration();
  Session& session() { return *session_; }
  const client::PlayerInput& input() const { return input_; }
  const GameData& data() const { return *data_; }
  const HostVariables& variables() const { return variables_; }
  // Another set of game folders, without a restart; the game that is running ends.
  base::Status change_games(std::vector<std::string> games);

 private:
  Host(Services services, const HostVariables& variables, HostOptions options);
  base::Status open();
  base::Status configure();
  base::Status open_own_server(std::uint32_t max_clients);
  base::Status take_up(base::Status started);

  // A frame's parts, in order.
  void take_input();
  void take_event(const platform::InputEvent& event);
  void take_key(const platform::KeyChange& key);
  void take_size(const platform::WindowChanged& changed);
  void follow_variables();
  void read_server();
  void look_and_move();
  base::Status make_scene();
  void draw();
  void note_latency();
  void print_part(std::string_view text);
  // Time stands still for a single player who looks at something else.
  bool is_halted() const;

  Services services_;
  const HostVariables& variables_;
  HostOptions options_;
  command::Console console_;
  client::Bindings bindings_;
  client::HeldKeys held_;
  client::PlayerInput input_;
  std::unique_ptr<GameData> data_;
  std::unique_ptr<Session> session_;
  Screen screen_;
  Worker worker_;
  FrameLimiter limiter_;
  FrameTimes times_;
  std::vector<platform::InputEvent> events_;
  double now_s_ = 0;
  double event_time_s_ = 0;  // of what is being taken
  std::optional<double> oldest_event_s_;
  platform::WindowSettings window_settings_;
  render::DrawList overlay_;
  client::PresentationSettings presentation_settings_;  // of this frame
  float zoom_ = 0;                                      // 0: not at all, 1: all the way
  float fov_deg_ = 90;
  std::uint32_t turns_ = 0;  // by the server, as far as followed
  math::Vec3 turned_to_deg_{0.0f};
  double turned_s_ = 0;
  std::string line_;  // printed in part
  bool has_focus_ = true;
  bool wants_to_quit_ = false;
};

}  // namespace temblor::host
