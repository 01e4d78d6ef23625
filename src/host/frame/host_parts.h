// The parts of a running game, private to src/host.
//
// Host is a plain struct. The stages of a frame (frame_stages.h), the actions of the player (session/,
// menus/) and the console commands (commands/) are free functions that read and change the parts:
//
//   part      holds                                             written mainly by
//   timing    clock, frame limiter, measured times              wait_for_frame, draw_and_show
//   console   command interpreter, console on the screen        print_line, print_game_text
//   input     key bindings, held keys, the player's view        read_input, look_and_move
//   game      data, menus and session of the game folders       load_game_folders
//   demos     the current demo, the loop behind the menu        session/demos.h
//   saves     time of the last save, pending save picture       session/games.h
//   video     window settings, frame buffer, overlay            apply_variables, draw_and_show
//   sound     mixer and audio device                            play_sound
//
// Everything runs on the thread of the frames, except for the worker's job: a server tick while a frame is
// drawn. The job calls only Session::step_server(). Drawing must neither read the server nor set variables
// meanwhile.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/console/console_ui.h"
#include "client/demo/demo_controls.h"
#include "client/demo/demo_session.h"
#include "client/hud_program/hud_program.h"
#include "client/input/bindings.h"
#include "client/input/player_input.h"
#include "client/menu/menu.h"
#include "client/prediction/prediction.h"
#include "client/view/presentation.h"
#include "client/view/sound_output.h"
#include "command/console.h"
#include "host/commands/foreign_names.h"
#include "host/host.h"
#include "host/host_variables.h"
#include "host/menus/menu_lists.h"
#include "host/services.h"
#include "host/session/game_data.h"
#include "host/session/game_texts.h"
#include "host/session/overrides.h"
#include "host/session/server_search.h"
#include "host/session/session.h"
#include "host/session/stuffed_text.h"
#include "host/session/worker.h"
#include "host/video/frame_limiter.h"
#include "host/video/screen.h"

namespace temblor::host {

struct FrameTiming {
  FrameLimiter limiter;
  FrameTimes measured;
  double now_s = 0;       // the window's clock at the start of this frame
  double time_scale = 1;  // game time per real time in this frame
  // The console has said why host_timescale is ignored.
  bool has_explained_time_scale = false;
  // The limiter had to wait for this frame: the machine is faster than the frame rate limit.
  bool has_time_to_spare = false;
};

struct HostConsole {
  command::Console commands;
  client::ConsoleUi ui;
  ForeignNames foreign_names;
  // Game text for the terminal that has no newline yet. The console shows such text at once; the terminal
  // gets whole lines only.
  std::string unfinished_line;
};

struct HostInput {
  std::vector<platform::InputEvent> events;  // of this frame
  // From when the key or command that is being handled counts.
  double event_time_s = 0;
  std::optional<double> oldest_event_s;  // of this frame
  client::Bindings bindings;
  client::HeldKeys held;
  client::PlayerInput player;
  client::Prediction prediction;
  bool has_focus = true;
  bool is_alt_down = false;
  bool takes_text = false;  // the window sends TextTyped events (a prompt or the console is open)

  // The zoom of the view moves between 0 (off) and 1 (full) over several frames.
  float zoom = 0;
  float fov_deg = 90;

  // The last turn of the view by the server, after a teleport for example. The server repeats the message in
  // case a packet is lost: `count` is that of the messages so far, `time_s` the host's clock.
  struct {
    std::uint32_t count = 0;
    math::Vec3 angles_deg{0.0f};
    double time_s = 0;
  } server_turn;
};

// The state of quake.rc; see session/configure.h.
struct StartupScript {
  bool is_running = false;
  bool has_configured = false;     // temblor.cfg or config.cfg has run
  bool has_stuffed = false;        // `stuffcmds` has run in this frame
  std::vector<std::string> demos;  // named by `startdemos`
};

// Everything that depends on the game folders. Members refer to those above them, so a switch to other game
// folders destroys them from the bottom up (session/configure.h).
struct LoadedGame {
  std::unique_ptr<GameData> data;
  std::unique_ptr<client::HudProgram> hud_program;
  std::unique_ptr<MenuLists> menu_lists;
  std::optional<client::Menu> menu;
  std::unique_ptr<Session> session;
  GameTexts texts;
  double pings_asked_s = -1e9;  // the host's clock: when a HUD program's pings were last asked for
  std::string last_server{};    // that the player has joined, for `reconnect`
  // Game folders to switch to after this frame's commands. An empty list is id1 alone; none: no switch.
  std::optional<std::vector<std::string>> requested_games;
  // Game data to switch to, in the same way.
  std::optional<GameSource> requested_source;
  // The first frame's commands have run, including those of the command line. Until then it is not known
  // whether a game or a demo starts.
  bool has_begun = false;
  StartupScript startup;
};

// A benchmark: a demo that is played as fast as possible, one packet per frame.
struct TimedDemo {
  std::string name;
  double start_s = 0;  // the window's clock
  int frames = 0;      // drawn so far
};

struct DemoPlayback {
  std::optional<client::DemoSession> session;  // none: no demo is playing
  std::string file;                            // of `session`, "demo1.dem"
  client::DemoControls controls;
  std::optional<TimedDemo> timed;
  // Attract mode: demos that play behind the menu in a loop, until something else starts. The next one comes
  // first, and the current one last. Empty: no attract mode.
  std::vector<std::string> attract_loop;
  std::string recording_file;  // the demo that is being recorded; empty: none

  bool is_attracting() const { return !attract_loop.empty(); }
};

struct SaveStatus {
  double saved_s = 0;           // when the game was last saved or started
  std::string picture_request;  // the saved game that gets the next frame as its picture; empty: none
};

// "60 fps" and "12.3 ms" in a corner of the screen. Both sum up a short interval, so that they can be read:
// the mean frame rate, and the worst latency.
struct SpeedMeter {
  int frames = 0;
  double seconds = 0, worst_latency_s = 0;
  std::string speed_text, latency_text;
};

struct HostVideo {
  platform::WindowSettings window_settings;            // as last applied to the window
  std::string full_screen_mode = "borderless";         // `vid_mode` that Alt+Enter turns on
  client::PresentationSettings presentation_settings;  // of this frame
  Screen screen;
  render::DrawList overlay;
  render::Tint server_tint;  // v_cshift
  SpeedMeter meter;
  bool was_shown = true;  // the last frame reached the window
  // The console has said why r_showbboxes shows nothing.
  bool has_explained_boxes = false;
};

struct HostSound {
  std::optional<client::SoundOutput> output;  // none: sound is off
  bool was_playing = false;                   // a game or demo was playing in the last frame
  bool is_music_paused = false;               // by the player or the server
};

struct Host {
  Host(Services own_services, const HostVariables& own_variables, HostOptions own_options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  Services services;
  const HostVariables& variables;
  HostOptions options;
  HostConsole console;
  Overrides overrides;
  StuffedText stuffed_text;
  HostInput input;
  LoadedGame game;
  HostSound sound;
  DemoPlayback demos;
  SaveStatus saves;
  client::PlayerSettings sent_player;   // name and colors that were last sent to the server
  std::vector<client::Notice> notices;  // pending; show_notices() shows them
  ServerSearch search;
  std::optional<std::size_t> listed_servers;  // printed since "slist"; empty: nobody waits for more
  HostVideo video;
  FrameTiming timing;
  bool wants_to_quit = false;
  // Runs server ticks while a frame is drawn. It is the last member, so that it ends before the parts it
  // uses.
  Worker worker;
};

// --- State that several stages need.

// The keys control the game: neither the console nor a menu is open.
bool is_in_game(const Host& host);
// There is a level to draw, of a game or a demo.
bool has_view(const Host& host);
// The game is halted because the player of a single-player game has opened the console or a menu, or uses
// another window.
bool is_halted(const Host& host);
// The camera of the last frame; none if there is no view.
std::optional<render::Camera> current_camera(const Host& host);

// --- Output.

// Prints a line (UTF-8) to the console and the terminal.
void print_line(Host& io_host, std::string_view line);
// Prints one line about the unknown names in the config files that ran since the last call, if there were
// any.
void report_unknown_names(Host& io_host);
void print_if_error(Host& io_host, const base::Status& status);
// Prints text of the game to the console and the terminal, in the game's character set (bytes from 128 on are
// the bronze letters). It may hold several lines, or part of one.
void print_game_text(Host& io_host, std::string_view text);

}  // namespace temblor::host
