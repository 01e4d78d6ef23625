#include "host/host.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "command/text.h"
#include "host/commands/host_commands.h"

namespace temblor::host {
namespace {

constexpr double kUnknownRefreshRate_hz = 60;
constexpr double kHiddenRate_hz = 10;  // nobody looks
// A server tells of a turn several times, lest one is lost.
constexpr double kSameTurn_s = 0.1;

// "maps/start.bsp"; empty where the server has named none.
std::string level_of(const client::Game& game) {
  return game.models.size() > 1 ? game.models[1] : std::string();
}

// While recordings are shown to nobody a key is somebody who has come, unless he wants something of this.
bool runs_while_attracting(std::string_view commands) {
  return commands == "toggleconsole" || commands == "screenshot" || commands == "help_menu" ||
         commands.starts_with("menu_");
}

}  // namespace

Host::Host(Services services, const HostVariables& variables, HostOptions options)
    : services_(std::move(services)),
      variables_(variables),
      options_(std::move(options)),
      console_(variables.variables(), [this](std::string_view line) { print(line); }),
      console_ui_(
          {.complete = [this](std::string_view line) { return console_.complete_line(line); },
           .read_clipboard = [this] { return services_.window.clipboard(); },
           .write_clipboard = [this](std::string_view text) { services_.window.set_clipboard(text); }}),
      search_(services_) {}

Host::~Host() {
  worker_.wait();
}

base::Result<std::unique_ptr<Host>> Host::start(Services services, const HostVariables& variables,
                                                HostOptions options) {
  std::unique_ptr<Host> host(new Host(std::move(services), variables, std::move(options)));
  TRY_STATUS(host->open());
  return host;
}

base::Status Host::open() {
  now_s_ = services_.window.now_s();
  TRY(data_, GameData::open(options_.folders));
  take_up_data();
  client::add_binding_commands(console_, bindings_, [this](std::string_view line) { print(line); });
  client::add_input_commands(console_, input_, event_time_s_);
  add_host_commands(*this);
  if (services_.open_audio) sound_.emplace(services_.open_audio);
  TRY_STATUS(configure());
  return base::Ok{};
}

void Host::print(std::string_view line) {
  services_.print_line(line);
  console_ui_.print_utf8(fmt::format("{}\n", line), now_s_);
}

bool Host::frame() {
  const double rate_hz = variables_.frames_per_second();
  const double display_hz = services_.window.refresh_rate_hz();
  const double limit_hz = !services_.window.is_visible() ? kHiddenRate_hz
                          : rate_hz > 0                  ? rate_hz
                          : display_hz > 0               ? display_hz
                                                         : kUnknownRefreshRate_hz;
  // What is measured does not wait.
  has_time_to_spare_ = !timed_ && limiter_.wait(limit_hz, [this] { return services_.window.now_s(); });
  const double before_s = std::exchange(now_s_, services_.window.now_s());
  times_.frame_s = now_s_ - before_s;

  take_input();
  event_time_s_ = now_s_;
  console_.run();
  if (!std::exchange(has_begun_, true)) welcome();
  if (std::optional<std::vector<std::string>> games = std::exchange(wanted_games_, std::nullopt))
    if (const base::Status changed = change_games(std::move(*games)); !changed.ok())
      print(changed.error().message());
  follow_variables();
  read_server();
  look_and_move();
  if (const base::Status status = demo_ ? show_demo() : make_scene(); !status.ok()) {
    print(status.error().message());
    // What is shown to nobody may fail quietly.
    if (!is_attracting()) notices_.push_back(describe_failure(status.error()));
    disconnect();
  }
  show_notices();
  make_sound();
  draw();
  if (wants_to_quit_) leave();
  return !wants_to_quit_;
}

// Whoever has said nothing of what he wants to play is shown what there is.
void Host::welcome() {
  if (demo_ || session_->connection() != nullptr || wants_to_quit_) return;
  attract(demos_to_attract(*data_));
  menu_->open();
}

// A game that cannot be drawn ends; the player reads why, and what he can do about it.
client::Notice Host::describe_failure(const base::Error& error) const {
  if (demo_) return {"The recording has ended", error.message()};
  const client::Connection* const connection = session_->connection();
  const std::string level = connection == nullptr ? "" : level_of(connection->state().game());
  const vfs::FileSystem& files = data_->library.files();
  if (level.empty() || files.contains(level)) return {"The game has ended", error.message()};
  std::string text =
      fmt::format("The server plays the level {}, which is missing here.\n\nLooked for in:\n", level);
  for (const std::filesystem::path& folder : files.folders()) text += folder.string() + "\n";
  text +=
      "\nPut that file there, as the server has it, and join again; or play the game folder that it belongs "
      "to.";
  return {.title = "The level is missing",
          .text = std::move(text),
          .pages = {{"Game folders", client::MenuPage::kGameFolders},
                    {"Other servers", client::MenuPage::kJoin}}};
}

// Over the main menu, so that the player knows where he is.
void Host::show_notices() {
  for (client::Notice& notice : std::exchange(notices_, {})) {
    console_ui_.close();
    console_.append(held_.release_all());
    menu_->tell(std::move(notice));
  }
}

void Host::leave() {
  disconnect();
  if (const base::Status saved = save_configuration(); !saved.ok()) print(saved.error().message());
}

void Host::take_input() {
  events_.clear();
  services_.window.poll(events_);
  oldest_event_s_.reset();
  for (const platform::InputEvent& event : events_) take_event(event);
}

void Host::take_event(const platform::InputEvent& event) {
  event_time_s_ = event.time_s;
  if (!oldest_event_s_) oldest_event_s_ = event.time_s;
  const bool was_in_game = is_in_game();
  if (take_by_console_or_menu(event)) {
    // Whatever was held when it opened will not be heard of again.
    if (was_in_game) console_.append(held_.release_all());
    return;
  }
  if (const auto* key = std::get_if<platform::KeyChange>(&event.what)) {
    take_key(*key);
  } else if (const auto* mouse = std::get_if<platform::MouseMoved>(&event.what)) {
    input_.add_mouse(mouse->right, mouse->down);
  } else if (const auto* axis = std::get_if<platform::PadAxisMoved>(&event.what)) {
    input_.set_axis(axis->axis, axis->value);
  } else if (const auto* pad = std::get_if<platform::PadChanged>(&event.what)) {
    print(fmt::format("{} {}", pad->name, pad->connected ? "is connected" : "is gone"));
    if (!pad->connected) console_.append(held_.release_all());
  } else if (const auto* focus = std::get_if<platform::FocusChanged>(&event.what)) {
    has_focus_ = focus->focused;
    if (!has_focus_) console_.append(held_.release_all());
  } else if (const auto* changed = std::get_if<platform::WindowChanged>(&event.what)) {
    take_size(*changed);
  } else if (std::holds_alternative<platform::CloseRequested>(event.what)) {
    // The second time it is meant.
    if (unsaved().empty() || menu_->is_open())
      quit();
    else
      open_menu(client::MenuPage::kQuit);
  }
}

// The game begins with a menu, and a console that is spoken of everywhere must open from there, too.
bool Host::opens_console_over_menu(const platform::InputEvent& event) const {
  const auto* const key = std::get_if<platform::KeyChange>(&event.what);
  return key != nullptr && key->down && !key->repeated && menu_->is_open() && !menu_->is_waiting() &&
         bindings_.commands(key->key) == "toggleconsole";
}

bool Host::take_by_console_or_menu(const platform::InputEvent& event) {
  if (opens_console_over_menu(event)) {
    menu_->close();
    console_.append("toggleconsole");
    return true;
  }
  bool taken = console_ui_.handle(event);
  if (!taken) taken = menu_->handle(event);
  if (!taken && demo_ && !is_attracting()) taken = demo_controls_.handle(event);
  for (const std::string& line : console_ui_.take_commands()) console_.append(line);
  for (const std::string& line : menu_->take_commands()) console_.append(line);
  return taken;
}

// The player has pulled at the window: that is how large he wants it from now on.
void Host::take_size(const platform::WindowChanged& changed) {
  if (window_settings_.mode != platform::WindowMode::kWindowed) return;
  window_settings_.size = {std::max(1, changed.width), std::max(1, changed.height)};
  command::Variables& variables = variables_.variables();
  for (const auto& [name, value] : {std::pair{"vid_width", window_settings_.size.width},
                                    std::pair{"vid_height", window_settings_.size.height}})
    if (const base::Status set = variables.set(name, std::to_string(value)); !set.ok())
      print(set.error().message());
}

void Host::take_key(const platform::KeyChange& key) {
  if (key.repeated) return;
  const std::string& commands = bindings_.commands(key.key);
  const bool opens_menu = key.key == platform::Key::kEscape ||
                          (key.key == platform::Key::kPadStart && commands.empty()) ||
                          (is_attracting() && !runs_while_attracting(commands));
  if (key.down && opens_menu) return toggle_menu();
  if (!key.down)
    console_.append(held_.release(key.key));
  else
    console_.append(held_.press(key.key, commands));
  // At once, so that what happens in one frame keeps its order and its times.
  console_.run();
}

void Host::follow_variables() {
  const platform::WindowSettings wanted = variables_.window();
  if (wanted != window_settings_) {
    if (const base::Status applied = services_.window.apply(wanted); !applied.ok())
      print(applied.error().message());
    window_settings_ = wanted;
  }
  tell_player();
  services_.window.capture_mouse(has_focus_ && is_in_game() &&
                                 (session_->is_playing() || (demo_ && demo_controls_.is_flying())));
  const bool takes_text = console_ui_.takes_text() || menu_->wants_text();
  if (takes_text != takes_text_) services_.window.take_text(takes_text);
  takes_text_ = takes_text;
  if (search_.update(now_s_)) menu_->refresh();
}

// Who changes his name or colors does so in the game that runs.
void Host::tell_player() {
  client::PlayerSettings player = variables_.player();
  if (client::Connection* const connection = session_->connection(); connection != nullptr) {
    if (player.name != player_.name) connection->send_command(command::join_words({"name", player.name}));
    if (player.shirt != player_.shirt || player.pants != player_.pants)
      connection->send_command(fmt::format("color {} {}", player.shirt, player.pants));
  }
  player_ = std::move(player);
}

void Host::read_server() {
  const bool was_playing = session_->is_playing(), was_own = session_->server() != nullptr;
  if (const std::optional<std::string> lost = session_->read(now_s_)) {
    print(*lost);
    if (const base::Status kept = stop_recording_if_any(); !kept.ok()) print(kept.error().message());
    client::Notice notice{was_playing || was_own ? "The game has ended" : "No game was joined", *lost};
    if (!was_own) notice.pages = {{"Other servers", client::MenuPage::kJoin}};
    notices_.push_back(std::move(notice));
  }
  if (client::Connection* const connection = session_->connection()) {
    // Taken here: until the game has begun nobody else clears them.
    client::Events& events = connection->state().events();
    for (const std::string& text : std::exchange(events.prints, {})) print_part(text);
    if (session_->is_playing()) rumble(events);
    note_autosave();
    for (const std::string& line : connection->take_commands())
      if (session_->server() != nullptr || may_be_stuffed(line)) console_.append(line);
  }
  print_part(session_->take_server_output());
}

// What the server has saved by itself gets its picture as well.
void Host::note_autosave() {
  if (session_->server() == nullptr) return;
  std::string name = session_->server()->take_autosaved();
  if (name.empty()) return;
  picture_wanted_ = std::move(name);
  saved_s_ = now_s_;
}

// The harder the blow, the harder and longer.
void Host::rumble(const client::Events& events) {
  constexpr float kHardest = 50;
  float blow = 0;
  for (const net::Damage& damage : events.damages)
    blow += static_cast<float>(damage.armor) + static_cast<float>(damage.blood);
  const float strength = std::min(blow / kHardest, 1.0f) * variables_.rumble();
  if (strength > 0)
    services_.window.rumble(strength, strength / 2, 0.1 + 0.2 * static_cast<double>(strength));
}

// What the frame before has led to, and the menus' clicks.
void Host::make_sound() {
  client::AudioScene& scene = data_->presentation.audio_scene();
  const bool plays = demo_ || session_->is_playing();
  if (std::exchange(was_playing_, plays) && !plays) scene.end_level();
  for (const std::string& name : menu_->take_sounds()) scene.play_local(name);
  for (const std::string& note : scene.take_notes()) print(note);
  if (sound_) {
    sound_->advance(now_s_, scene.scene(), scene.events());
    const client::Game* const game = demo_                    ? &demo_->state().game()
                                     : session_->is_playing() ? &session_->connection()->state().game()
                                                              : nullptr;
    sound_->play_music(data_->library, game != nullptr ? game->music_track : 0);
    sound_->pause_music(is_halted() || (game != nullptr && game->paused));
    for (const std::string& note : sound_->take_notes()) print(note);
  }
  scene.events().clear();
}

// Text of the game, in its own letters.
void Host::print_part(std::string_view text) {
  console_ui_.print(text, now_s_);
  for (const char c : text) {
    if (c == '\n')
      services_.print_line(std::exchange(line_, {}));
    else
      line_ += c;
  }
}

void Host::look_and_move() {
  const ZoomSettings zoom = variables_.zoom();
  const bool zooms = input_.buttons()[client::Button::kZoom].is_down();
  const auto step = static_cast<float>(zoom.speed * times_.frame_s);
  zoom_ = std::clamp(zoom_ + (zooms ? step : -step), 0.0f, 1.0f);
  fov_deg_ = zoom.fov_deg + (zoom.zoom_fov_deg - zoom.fov_deg) * zoom_;

  const client::InputSettings settings = variables_.input();
  if (!session_->is_playing()) return;
  const client::Game& game = session_->connection()->state().game();
  const bool is_same_turn = game.set_angles_deg == turned_to_deg_ && now_s_ - turned_s_ < kSameTurn_s;
  if (game.turns != turns_ && !is_same_turn) {
    input_.set_view_angles(game.set_angles_deg);
    turned_to_deg_ = game.set_angles_deg;
    turned_s_ = now_s_;
  }
  turns_ = game.turns;
  const auto half_width = [](float fov_deg) { return std::tan(fov_deg * 0.00872665f); };
  input_.look({.time_s = now_s_,
               .zoom = half_width(zoom.fov_deg) / half_width(fov_deg_),
               .ideal_pitch_deg = game.data.ideal_pitch_deg,
               .may_drift = game.data.on_ground},
              settings);
  send_moves(settings);
}

// A move of a slow frame is one of several ticks.
void Host::send_moves(const client::InputSettings& settings) {
  if (is_halted()) return;
  int due = session_->moves_due(now_s_);
  net::Move move = due > 0 ? input_.take_move(now_s_, settings) : input_.peek_move(now_s_, settings);
  for (; due > 0; --due) {
    session_->send_move(move, now_s_);
    move.impulse = 0;
  }
  prediction_.begin_frame(*session_->connection(), move, session_->move_clock_s(now_s_));
}

}  // namespace temblor::host
