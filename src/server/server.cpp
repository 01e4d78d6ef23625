// Levels: how one begins, ends, and follows another; saved games.
#include "server/server.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "command/text.h"
#include "server/commands/host_commands.h"
#include "server/commands/player_commands.h"
#include "server/save/save_game.h"
#include "server/session/signon.h"

namespace temblor::server {
namespace {

// A program that fails again so soon after a level began will fail for ever.
constexpr double kSoon_s = 10;

std::string with_newline(std::string_view line) {
  return std::string(line) + "\n";
}

net::ServerEndpointSettings wire_settings(const ServerSetup& setup) {
  net::ServerEndpointSettings settings = setup.wire;
  settings.max_connections = setup.max_clients;
  settings.timeout_s = setup.settings.timeout_s();
  return settings;
}

}  // namespace

Server::Server(ServerSetup setup)
    : setup_(std::move(setup)),
      console_(setup_.settings.variables(), [this](std::string_view line) { print(with_newline(line)); }),
      endpoint_(std::move(setup_.sockets), wire_settings(setup_), [this] { return description(); }),
      clients_(endpoint_, setup_.max_clients),
      inputs_(setup_.max_clients) {
  add_host_commands(*this);
}

GameServices Server::services() {
  return {.library = setup_.library,
          .io_variables = setup_.settings.variables(),
          .print = setup_.print,
          .data_folder = setup_.write_folder.empty() ? "" : setup_.write_folder / "data",
          .has_client = [this](std::size_t slot) { return !clients_[slot].is_free(); }};
}

GameRequest Server::request_for(std::string_view map) const {
  return {.map = std::string(map),
          .kind = setup_.settings.kind(setup_.max_clients),
          .skill = setup_.settings.skill(),
          .program_file = setup_.program_file,
          .max_clients = setup_.max_clients,
          .seed = setup_.seed};
}

base::Status Server::replace_game(const GameRequest& request) {
  TRY(LoadedGame loaded, load_game(request, setup_.settings, services()));
  take_up(std::move(loaded));
  return base::Ok{};
}

// From here on it is the game; whoever is connected is told.
void Server::take_up(LoadedGame loaded) {
  game_ = std::move(loaded.game);
  const GameSetup& game = game_->setup();
  setup_.settings.set_kind(game.kind);
  for (const std::string& note : loaded.notes) print_event(fmt::format("{}: {}\n", game.map_name, note));
  for (const std::string& fault : game_->spawn_report().unknown_classes)
    print(fmt::format("maps/{}.bsp: {}\n", game.map_name, fault));
  if (recorder_) print_if_error(stop_recording());
  is_paused_ = false;
  resuming_.assign(clients_.size(), false);
  unplayed_s_ = 0;
  autosave_.begin_level();
  clients_.set_dialect(game.dialect, max_reliable_bytes(game.dialect));
  endpoint_.set_protocol(game.dialect.protocol);
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    Client& client = clients_[slot];
    if (client.is_bot()) client = Client{};  // the new game makes its own
    if (client.is_free()) continue;
    // One that still loads the level before is told of this one when it has.
    client.loads_old_level = clients_.is_loading(slot);
    // What was still to be said of the old level would be taken for the new one's.
    clients_.forget_waiting(slot);
    client.sent_frags = 0;
    client.sent_update = false;
    client.untold = {};
    if (!client.loads_old_level) tell_next_level(slot);
  }
}

base::Status Server::start_map(std::string_view map) {
  TRY(LoadedGame loaded, load_game(request_for(map), setup_.settings, services()));
  TRY(const SpawnParameters parameters, loaded.game->new_parameters());
  save_unasked();
  take_up(std::move(loaded));
  autosave_.begin_game();
  last_save_.clear();
  for (Client& client : clients_.all()) client.parameters = parameters;
  return base::Ok{};
}

base::Status Server::change_level(std::string_view map) {
  if (!game_) return start_map(map);
  GameRequest request = request_for(map);
  request.server_flags = game_->server_flags();
  TRY(LoadedGame loaded, load_game(request, setup_.settings, services()));
  // Nothing can fail any more but the program itself: only now it may take from players what they leave
  // behind.
  std::vector<SpawnParameters> carried(clients_.size());
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    carried[slot] = clients_[slot].parameters;
    if (!clients_[slot].is_in_game()) continue;
    TRY(carried[slot], game_->parameters_to_carry(slot));
  }
  take_up(std::move(loaded));
  last_save_.clear();
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) clients_[slot].parameters = carried[slot];
  return base::Ok{};
}

base::Status Server::restart() {
  if (!game_) return base::error(base::ErrorCode::kUsage, "no level is running");
  GameRequest request = request_for(game_->setup().map_name);
  request.server_flags = game_->setup().server_flags;
  return replace_game(request);
}

base::Result<std::filesystem::path> Server::file_to_write(std::string_view name,
                                                          std::string_view suffix) const {
  if (setup_.write_folder.empty() || !setup_.write_file)
    return base::error(base::ErrorCode::kUsage, "this server has no folder to write to");
  const bool is_plain = !name.empty() && name.size() < 64 && name.front() != '.' &&
                        std::all_of(name.begin(), name.end(), [](char c) {
                          return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                                 c == '_' || c == '-' || c == '.';
                        });
  if (!is_plain)
    return base::error(base::ErrorCode::kUsage,
                       "\"{}\" is no name for a file: letters, digits, '_', '-' and '.' are", name);
  std::string file(name);
  if (!file.ends_with(suffix)) file += suffix;
  return setup_.write_folder / file;
}

base::Status Server::save(std::string_view name) {
  if (!game_) return base::error(base::ErrorCode::kUsage, "no level is running");
  if (setup_.max_clients > 1)
    return base::error(base::ErrorCode::kUsage, "a game of several players cannot be saved");
  if (!clients_[0].is_in_game()) return base::error(base::ErrorCode::kUsage, "nobody is in the game");
  if (!(game_->player(0)[field::kHealth] > 0))
    return base::error(base::ErrorCode::kUsage, "a dead player's game cannot be saved");
  TRY(const std::filesystem::path file, file_to_write(name, ".sav"));
  const std::string_view level = game_->machine().text(game_->world().edicts.world()[field::kMessage]);
  const auto total = [&](vm::GlobalIndex i) { return sent_u16(game_->machine().global_float(i)); };
  const std::string comment = fmt::format("{:<22.22} kills:{:3}/{:3}", level, total(global::kKilledMonsters),
                                          total(global::kTotalMonsters));
  TRY(const std::string text, formats::write_sav(save_of(*game_, comment)));
  TRY_STATUS(setup_.write_file(file, base::as_bytes(text)));
  autosave_.note_save(now_s_);
  last_save_ = file.stem().string();
  // A player knows it by its name.
  print(fmt::format("saved {} {}\n", setup_.prints_events ? "to" : "as",
                    setup_.prints_events ? file.string() : file.stem().string()));
  return base::Ok{};
}

base::Status Server::load(std::string_view name) {
  base::Status loaded = go_on_from(name);
  // One that cannot be used is not offered to the dead again.
  if (!loaded.ok() && name == last_save_) last_save_.clear();
  return loaded;
}

base::Status Server::go_on_from(std::string_view name) {
  if (setup_.max_clients > 1)
    return base::error(base::ErrorCode::kUsage, "a saved game can be gone on with by one player alone");
  TRY(const std::filesystem::path file, file_to_write(name, ".sav"));
  TRY(const base::ByteVector bytes, vfs::read_disk_file(file));
  TRY(const formats::Sav sav, formats::read_sav(base::as_text(bytes)).with_file(file.string()));
  GameRequest request = request_for(sav.map);
  request.skill = sav.skill;
  request.kind = GameKind::kSingle;
  request.entities_to_come = entities_of(sav);
  TRY(LoadedGame loaded, load_game(request, setup_.settings, services()));
  TRY(const std::vector<std::string> notes, restore(sav, *loaded.game).with_file(file.string()));
  loaded.notes.insert(loaded.notes.end(), notes.begin(), notes.end());
  take_up(std::move(loaded));
  last_save_ = file.stem().string();
  autosave_.begin_loaded(last_save_);
  clients_[0].parameters = sav.spawn_parameters;
  print_if_error(setup_.settings.variables().set("skill", std::to_string(sav.skill)));
  resuming_[0] = true;
  set_paused(true);  // until the player is there
  return base::Ok{};
}

base::Status Server::reload() {
  if (!game_) return base::error(base::ErrorCode::kUsage, "no level is running");
  const GameSetup& old = game_->setup();
  GameRequest request = request_for(old.map_name);
  request.kind = old.kind;
  request.skill = old.skill;
  request.server_flags = old.server_flags;
  const formats::Sav going_on = save_of(*game_, "");
  request.entities_to_come = entities_of(going_on);
  TRY(LoadedGame loaded, load_game(request, setup_.settings, services()));

  // The game goes on where the level is the same and the new program knows all that the old one remembers.
  std::vector<bool> goes_on(clients_.size());
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    goes_on[slot] = clients_[slot].is_in_game() && !clients_[slot].is_bot();
  const bool is_same_level = loaded.game->setup().level_hash == old.level_hash;
  if (is_same_level) {
    const auto notes = restore(going_on, *loaded.game);
    if (notes.ok() && notes->empty()) {
      loaded.game->context().spawn_parameters = game_->context().spawn_parameters;
      loaded.game->take_over_bots(*game_);
      take_up(std::move(loaded));
      resuming_ = std::move(goes_on);
      if (clients_.size() == 1) set_paused(true);  // until the player is back
      print("reloaded: the game goes on\n");
      return base::Ok{};
    }
    const std::string reason = notes.ok() ? notes->front() : notes.error().message();
    print(fmt::format("the game cannot go on: {}\n", reason));
  }
  // What was loaded has taken in the old game's entities, or a protocol for so many.
  if (is_same_level || request.entities_to_come > kMaxEntitiesOfProtocol15) {
    request.entities_to_come = 0;
    TRY(loaded, load_game(request, setup_.settings, services()));
  }
  take_up(std::move(loaded));
  print("reloaded: the level starts anew\n");
  return base::Ok{};
}

void Server::print_if_error(const base::Status& status) {
  if (!status.ok()) print(status.error().message() + "\n");
}

void Server::print(std::string_view text) {
  setup_.print(text);
  if (captured_) *captured_ += text;
}

void Server::print_event(std::string_view text) {
  if (setup_.prints_events) print(text);
}

std::string Server::run_and_capture(std::string_view line) {
  std::optional<std::string> outer = std::exchange(captured_, std::string());
  console_.execute(line);
  return *std::exchange(captured_, std::move(outer));
}

void Server::set_paused(bool paused) {
  if (paused == is_paused_) return;
  is_paused_ = paused;
  clients_.tell_everyone(net::SetPause{paused});
}

// The game's code has failed: everyone is told, and the level begins anew, unless that has just been tried.
void Server::fail(const base::Error& error) {
  print(fmt::format("the game's code failed: {}\n{}", error.message(),
                    game_->machine().describe(game_->machine().failure_trace())));
  const std::string notice = fmt::format("The game's code failed: {}\n", error.message());
  const bool fails_again = now_s_ - failed_at_s_ < kSoon_s;
  failed_at_s_ = now_s_;
  const std::optional<std::size_t> blamed = game_->blamed_player();
  // Who makes it fail again and again goes, and the others play on.
  const bool is_one_to_drop = fails_again && blamed && !clients_[*blamed].is_free();
  if (is_one_to_drop) clients_.release(*blamed, notice);
  if (!fails_again || is_one_to_drop) {
    // What players are told before a level begins, they do not read.
    if (const base::Status again = restart(); again.ok()) return clients_.print_everyone(notice);
  }
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (!clients_[slot].is_free()) clients_.release(slot, notice);
  if (recorder_) print_if_error(stop_recording());
  game_.reset();
  print("no level is running; `map NAME` starts one\n");
}

bool Server::goes_on_from_save() const {
  return clients_.size() == 1 && !last_save_.empty() && setup_.settings.autoloads();
}

// Game code begins the level again for a dead player who presses a button, whichever.
bool Server::takes_last_save(std::string_view commands) const {
  constexpr std::uint8_t kJump = 2;
  while (commands.ends_with('\n')) commands.remove_suffix(1);
  return commands == "restart" && goes_on_from_save() && !(game_->player(0)[field::kHealth] > 0) &&
         (inputs_[0].buttons & kJump) == 0;
}

// What QuakeC asked for while it ran.
void Server::do_requests() {
  Requests requests = std::exchange(game_->requests(), {});
  for (const Requests::PlayerCommand& command : requests.player_commands) {
    const std::size_t slot = base::to_size(command.player) - 1;
    if (slot < clients_.size() && !clients_[slot].is_free()) run_player_command(*this, slot, command.line);
  }
  for (const std::size_t slot : requests.dropped_players)
    if (slot < clients_.size()) drop(slot, "dropped by the game");
  if (!requests.commands.empty())
    console_.append(takes_last_save(requests.commands) ? command::join_words({"load", last_save_})
                                                       : requests.commands);
  if (requests.change_level) console_.append("changelevel \"" + *requests.change_level + "\"\n");
}

void Server::shut_down(std::string_view reason) {
  if (recorder_) print_if_error(stop_recording());
  save_unasked();
  clients_.print_everyone(fmt::format("{}\n", reason));
  clients_.send_waiting();
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (!clients_[slot].is_free()) clients_.release(slot, reason);
  endpoint_.update(now_s_);
}

base::Status Server::record(std::size_t slot, std::string_view name) {
  if (!game_ || slot >= clients_.size() || !clients_[slot].is_in_game() || clients_[slot].is_bot())
    return base::error(base::ErrorCode::kUsage, "there is no player {} to record; `status` lists them",
                       static_cast<std::int64_t>(slot) + 1);
  if (recorder_) return base::error(base::ErrorCode::kUsage, "a recording is running already");
  TRY(std::filesystem::path file, file_to_write(name, ".dem"));
  TRY(recorder_, Recorder::begin(*game_, clients_.all(), slot, std::move(file)));
  clients_.listen_to(slot);
  print(fmt::format("recording what {} is told to {}; `stop` ends it\n", clients_[slot].name,
                    recorder_->file().string()));
  return base::Ok{};
}

base::Status Server::stop_recording() {
  if (!recorder_) return base::error(base::ErrorCode::kUsage, "no recording is running");
  const std::filesystem::path file = recorder_->file();
  if (recorder_->is_full()) print("the recording was full: its end is missing\n");
  const base::ByteVector bytes = std::move(*recorder_).finish();
  recorder_.reset();
  clients_.listen_to(std::nullopt);
  TRY_STATUS(setup_.write_file(file, bytes));
  print(fmt::format("recorded to {}\n", file.string()));
  return base::Ok{};
}

}  // namespace temblor::server
