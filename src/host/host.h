// The game in a window: owns everything, and does it in a fixed order, frame by frame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/console/console_ui.h"
#include "client/demo/demo_controls.h"
#include "client/demo/demo_session.h"
#include "client/input/bindings.h"
#include "client/input/player_input.h"
#include "client/menu/menu.h"
#include "client/prediction/prediction.h"
#include "client/view/presentation.h"
#include "client/view/sound_output.h"
#include "command/console.h"
#include "host/game_data.h"
#include "host/host_variables.h"
#include "host/menus/menu_lists.h"
#include "host/services.h"
#include "host/session/server_search.h"
#include "host/session/session.h"
#include "host/session/worker.h"
#include "host/video/frame_limiter.h"
#include "host/video/screen.h"

namespace temblor::host {

struct HostOptions {
  GameFolders folders;
  std::filesystem::path program_file{};  // the game's code; empty: the game folders' progs.dat
  std::vector<std::string> commands{};   // run once the configuration is
  std::string version{};                 // "Temblor 1.0", for the console
  // Sets variables after the configuration, as the command line says: for this run, unless the player changes
  // them himself.
  std::function<base::Status()> apply_overrides{};
};

// Of the last frame.
struct FrameTimes {
  double frame_s = 0;    // from the frame before to this one
  double drawing_s = 0;  // scene to finished picture
  double present_s = 0;  // handing it to the window
  double latency_s = 0;  // from the oldest event in it to its being handed over; 0: there was none
};

// A recording that is being measured.
struct TimedDemo {
  std::string name;
  double began_s = 0;
  int frames = 0;
};

// What a game shows while nobody plays: `startdemos` of its quake.rc, or else its demo1 to demo3.
std::vector<std::string> demos_to_attract(const GameData& data);

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
  client::ConsoleUi& console_ui() { return console_ui_; }
  void print(std::string_view line);
  void play_sound(const std::string& name) { data_->presentation.audio_scene().play_local(name); }
  void open_menu(client::MenuPage page);
  void toggle_menu();
  base::Status start_map(std::string_view map);
  base::Status load_game(std::string_view name);
  base::Status save_game(std::string_view name);
  base::Status connect(std::string_view address);
  void disconnect();
  void quit() { wants_to_quit_ = true; }
  base::Status screenshot(std::string_view file);
  // Recordings: watched, and measured by drawing every update as fast as can be.
  base::Status play_demo(std::string_view name);
  base::Status time_demo(std::string_view name);
  // Shows them behind the menus, one after another, until something else begins; any key opens the menu.
  void attract(std::vector<std::string> demos);
  void stop_demo();
  client::DemoSession* demo() { return demo_ ? &*demo_ : nullptr; }
  base::Status seek_demo(double time_s);
  base::Status record(std::string_view name);
  base::Status stop_recording();
  base::Status save_configuration();
  base::Status dump_console(std::string_view file);
  Session& session() { return *session_; }
  const client::PlayerInput& input() const { return input_; }
  const GameData& data() const { return *data_; }
  const HostVariables& variables() const { return variables_; }
  client::Bindings& bindings() { return bindings_; }
  // Where the last frame was seen from; nothing where there is no game to be seen.
  std::optional<render::Camera> view() const;

  // --- For the menus (menu_lists.h).
  const GameFolders& folders() const { return options_.folders; }
  const platform::Window& window() const { return services_.window; }
  bool can_save();
  // What leaving now would lose, for the player; empty: nothing.
  std::string unsaved();
  void search_servers();
  const std::vector<client::MenuServer>& found_servers() const { return search_.found(); }
  // Another set of game folders, without a restart, after this frame's commands; the game that is running
  // ends.
  void ask_for_games(std::vector<std::string> games);

 private:
  Host(Services services, const HostVariables& variables, HostOptions options);
  base::Status open();
  void take_up_data();
  base::Status configure();
  void check_configuration(std::size_t wrong_lines);
  base::Status change_games(std::vector<std::string> games);
  void welcome();
  void leave();
  base::Status stop_recording_if_any();
  void keep_picture(const render::FrameBuffer& frame);
  base::Status open_own_server(std::uint32_t max_clients);
  base::Status take_up(base::Status started);

  // A frame's parts, in order.
  void take_input();
  void take_event(const platform::InputEvent& event);
  bool opens_console_over_menu(const platform::InputEvent& event) const;
  bool take_by_console_or_menu(const platform::InputEvent& event);
  void take_key(const platform::KeyChange& key);
  void take_size(const platform::WindowChanged& changed);
  void follow_variables();
  void tell_player();
  void read_server();
  void note_autosave();
  client::Notice describe_failure(const base::Error& error) const;
  void show_notices();
  void look_and_move();
  void send_moves(const client::InputSettings& settings);
  void read_presentation_settings();
  std::string_view death_hint();
  base::Status make_scene();
  base::Status open_demo(std::string_view name);
  base::Status show_demo();
  void attract_next();
  bool is_attracting() const { return !attracting_.empty(); }
  base::Status play_neighbor(int recordings);
  void make_sound();
  void rumble(const client::Events& events);
  void draw();
  struct DrawSettings {
    render::Settings render;
    client::ConsoleSettings console;
    bool shows_speed, shows_latency;
  };
  void draw_view(const DrawSettings& settings, render::FrameBuffer& io_frame);
  void draw_over(const DrawSettings& settings, const render::FrameBuffer& frame);
  bool is_in_game() const { return !console_ui_.takes_text() && !(menu_ && menu_->is_open()); }
  bool has_view() const;
  void print_part(std::string_view text);
  bool is_halted() const;

  Services services_;
  const HostVariables& variables_;
  HostOptions options_;
  command::Console console_;
  client::ConsoleUi console_ui_;
  Overrides overrides_;
  client::Bindings bindings_;
  client::HeldKeys held_;
  client::PlayerInput input_;
  client::Prediction prediction_;
  std::unique_ptr<GameData> data_;
  std::unique_ptr<MenuLists> menu_lists_;
  std::optional<client::Menu> menu_;
  std::unique_ptr<Session> session_;
  std::optional<client::SoundOutput> sound_;  // nothing: silence is wanted
  std::optional<client::DemoSession> demo_;
  std::string demo_name_;
  client::DemoControls demo_controls_;
  std::optional<TimedDemo> timed_;
  std::vector<std::string> attracting_;  // the next one first; empty: no such thing is going on
  std::optional<std::vector<std::string>> wanted_games_;
  std::string recording_name_;           // empty: none is being made
  std::vector<client::Notice> notices_;  // still to be shown
  std::string picture_wanted_;           // of the saved game of this name; empty: none
  ServerSearch search_;
  Screen screen_;
  Worker worker_;
  FrameLimiter limiter_;
  FrameTimes times_;
  std::vector<platform::InputEvent> events_;
  double now_s_ = 0;
  double event_time_s_ = 0;  // of what is being taken
  std::optional<double> oldest_event_s_;
  platform::WindowSettings window_settings_;
  client::PlayerSettings player_;  // as the server knows him
  render::DrawList overlay_;
  client::PresentationSettings presentation_settings_;  // of this frame
  float zoom_ = 0;                                      // 0: not at all, 1: all the way
  float fov_deg_ = 90;
  std::uint32_t turns_ = 0;  // by the server, as far as followed
  math::Vec3 turned_to_deg_{0.0f};
  double turned_s_ = 0;
  std::string line_;  // printed in part
  struct {
    int frames = 0;
    double seconds = 0, worst_latency_s = 0;
  } speed_;
  std::string speed_text_, latency_text_;
  bool has_focus_ = true, takes_text_ = false, was_playing_ = false;
  bool is_shown_ = true;            // what was drawn last
  bool has_time_to_spare_ = false;  // the frame waited for its time
  double saved_s_ = 0;              // when the game was last saved, or begun
  bool has_begun_ = false;          // the first commands were run
  bool wants_to_quit_ = false;
};

}  // namespace temblor::host
