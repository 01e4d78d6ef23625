// A single player's games on disk: saved on request and automatically, and loaded.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "server/game/game_loader.h"
#include "server/save/save_game.h"
#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

// Whether a name needs no quotes, and can neither leave the folder nor be a hidden file.
bool is_plain_file_name(std::string_view name) {
  return !name.empty() && name.size() < 64 && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                  c == '-' || c == '.';
         });
}

// Explains to the player why the game cannot be saved now.
base::Status check_can_save(const Server& server) {
  const auto refuse = [](const char* why) { return base::error(base::ErrorCode::kUsage, "{}", why); };
  if (!server.game) return refuse("no level is running");
  if (server.setup.max_clients > 1) return refuse("only single-player games can be saved");
  if (!server.clients[0].is_in_game()) return refuse("nobody is in the game");
  if (!(server.game->player(0)[field::kHealth] > 0))
    return refuse("the game cannot be saved while you are dead");
  return base::Ok{};
}

// "The Copperworks        kills: 12/ 30", as stock menus show it. A title replaces the level's.
std::string make_comment(Game& io_game, std::string_view title) {
  const std::string shown =
      title.empty()
          ? io_game.localize(io_game.machine().text(io_game.world().edicts.world()[field::kMessage]))
          : std::string(title);
  const auto total = [&](vm::GlobalIndex i) { return sent_u16(io_game.machine().global_float(i)); };
  return fmt::format("{:<22.22} kills:{:3}/{:3}", shown, total(global::kKilledMonsters),
                     total(global::kTotalMonsters));
}

// The order matters: the running game continues until the save is known to be good.
base::Status load_from(Server& io_server, std::string_view name) {
  if (io_server.setup.max_clients > 1)
    return base::error(base::ErrorCode::kUsage, "saved games can only be loaded in single player");
  TRY(const std::filesystem::path file, make_write_path(io_server, name, ".sav"));
  TRY(const base::ByteVector bytes, vfs::read_disk_file(file));
  TRY(const formats::Sav sav, formats::read_sav(base::as_text(bytes)).with_file(file.string()));
  GameRequest request = make_request(io_server, sav.map);
  request.skill = sav.skill;
  request.kind = GameKind::kSingle;
  request.min_entities = count_used_entities(sav);
  TRY(LoadedGame loaded, load_level(io_server, request));
  TRY(const std::vector<std::string> notes, restore(sav, *loaded.game).with_file(file.string()));
  loaded.notes.insert(loaded.notes.end(), notes.begin(), notes.end());
  set_game(io_server, std::move(loaded));
  io_server.saves.last_save = file.stem().string();
  io_server.saves.autosave.begin_loaded(io_server.saves.last_save);
  io_server.clients[0].parameters = sav.spawn_parameters;
  print_if_error(io_server, io_server.settings().variables().set("skill", std::to_string(sav.skill)));
  io_server.resuming_players[0] = true;
  set_paused(io_server, true);  // until the player has joined
  return base::Ok{};
}

// Games of several players belong to nobody, and one that is over or that nobody sees is not worth saving.
bool can_autosave(const Server& server) {
  const ServerSetup& setup = server.setup;
  if (setup.settings.autosave_s() <= 0 || !setup.write_file || setup.write_folder.empty() || !server.game ||
      server.clients.size() > 1 || server.clients[0].stage != ClientStage::kPlaying)
    return false;
  const Edict player = server.game->player(0);
  return player[field::kHealth] > 0 && player.move_type() != MoveType::kNone;
}

// A failed autosave is tried again when the next one is due.
void write_autosave(Server& io_server) {
  const std::string name = io_server.saves.autosave.choose_name(io_server.setup.write_folder);
  if (const base::Status saved = save_game(io_server, name); saved.ok())
    io_server.saves.new_autosave = name;
  else
    print_if_error(io_server, saved);
  io_server.saves.autosave.note_save(io_server.clock.now_s);
}

// The text for the player after a save of this name and title.
std::string make_player_notice(std::string_view name, std::string_view title) {
  constexpr std::string_view kQuickSave = "quick";  // as the client binds it to a key
  const bool is_autosave =
      std::find(kAutosaveNames.begin(), kAutosaveNames.end(), name) != kAutosaveNames.end();
  if (is_autosave) return "Autosaved.\n";
  if (name == kQuickSave) return "Quicksaved.\n";
  return fmt::format("Game saved: {}\n", title.empty() ? name : title);
}

}  // namespace

base::Result<std::filesystem::path> make_write_path(const Server& server, std::string_view name,
                                                    std::string_view suffix) {
  if (server.setup.write_folder.empty() || !server.setup.write_file)
    return base::error(base::ErrorCode::kUsage, "this server has no folder to write to");
  if (!is_plain_file_name(name))
    return base::error(base::ErrorCode::kUsage,
                       "\"{}\" is not a file name: use letters, digits, '_', '-' and '.'", name);
  std::string file(name);
  if (!file.ends_with(suffix)) file += suffix;
  return server.setup.write_folder / file;
}

base::Status save_game(Server& io_server, std::string_view name, std::string_view title) {
  TRY_STATUS(check_can_save(io_server));
  TRY(const std::filesystem::path file, make_write_path(io_server, name, ".sav"));
  const ServerSetup& setup = io_server.setup;
  TRY(const std::string text,
      formats::write_sav(make_save(*io_server.game, make_comment(*io_server.game, title))));
  TRY_STATUS(setup.write_file(file, base::as_bytes(text)));
  io_server.saves.autosave.note_save(io_server.clock.now_s);
  io_server.saves.last_save = file.stem().string();
  // A player knows the save by its name, a host by its file.
  print(io_server, setup.prints_events ? fmt::format("Game saved: {}\n", file.string())
                                       : make_player_notice(io_server.saves.last_save, title));
  return base::Ok{};
}

base::Status load_saved_game(Server& io_server, std::string_view name) {
  base::Status loaded = load_from(io_server, name);
  // A file that cannot be loaded is not offered to dead players again.
  if (!loaded.ok() && name == io_server.saves.last_save) io_server.saves.last_save.clear();
  return loaded;
}

bool can_resume_from_save(const Server& server) {
  return server.clients.size() == 1 && !server.saves.last_save.empty() && server.settings().autoloads();
}

bool autosaves_on_leave(const Server& server) {
  return server.saves.autosave.is_worth_saving(server.clock.now_s) && can_autosave(server);
}

std::string take_autosave_name(Server& io_server) {
  return std::exchange(io_server.saves.new_autosave, {});
}

void autosave_if_due(Server& io_server) {
  if (io_server.clock.is_paused || !can_autosave(io_server)) return;
  const Edict player = io_server.game->player(0);
  Autosave& autosave = io_server.saves.autosave;
  const double now_s = io_server.clock.now_s;
  autosave.watch({.health = player[field::kHealth],
                  .stands = player.move_type() != MoveType::kWalk || player.has_flag(flag::kOnGround) ||
                            player[field::kWaterLevel] > 0},
                 now_s);
  if (autosave.is_due(io_server.settings().autosave_s(), now_s)) write_autosave(io_server);
}

void autosave_on_leave(Server& io_server) {
  if (autosaves_on_leave(io_server)) write_autosave(io_server);
}

}  // namespace temblor::server
