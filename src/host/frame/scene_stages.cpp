// The scene of the game or the demo, notices, and sound.
#include <fmt/format.h>

#include "host/frame/frame_stages.h"
#include "host/frame/host_parts.h"
#include "host/frame/presentation_settings.h"
#include "host/menus/menus.h"
#include "host/session/demos.h"
#include "host/session/games.h"

namespace temblor::host {
namespace {

// The file of the level, "maps/start.bsp". Empty if the server has not named one. Model 0 is unused, and
// model 1 is the level, as in the stock game.
std::string level_file(const client::Game& game) {
  return game.models.size() > 1 ? game.models[1] : std::string();
}

// Describes why a game cannot be shown and how the player can fix it. Usually the level of a server is
// missing on this machine.
client::Notice describe_failure(const Host& host, const base::Error& error) {
  if (host.demos.session) return {"Demo stopped", error.message()};
  const client::Connection* const connection = host.game.session->connection();
  const std::string level = connection == nullptr ? "" : level_file(connection->state().game());
  const vfs::FileSystem& files = host.game.data->library.files();
  if (level.empty() || files.contains(level)) return {"Disconnected", error.message()};
  std::string text =
      fmt::format("The server is running the level {}, which is not installed.\n\nSearched in:\n", level);
  for (const std::filesystem::path& folder : files.folders()) text += folder.string() + "\n";
  text += "\nCopy the server's file there and join again, or switch to the mod that it belongs to.";
  return {.title = "Missing level",
          .text = std::move(text),
          .pages = {{"Mods", client::MenuPage::kGameFolders}, {"Find servers", client::MenuPage::kJoin}}};
}

base::Status make_game_scene(Host& io_host) {
  Session& session = *io_host.game.session;
  if (!session.is_playing()) return base::Ok{};
  update_presentation_settings(io_host);
  client::ClientState& state = session.connection()->state();
  client::Presentation& presentation = io_host.game.data->presentation;
  presentation.set_prediction(&io_host.input.prediction);
  TRY_STATUS(presentation.advance(state, session.time_s(), io_host.input.player.view_angles_deg(),
                                  io_host.video.presentation_settings));
  for (const std::string& note : presentation.take_notes()) print_line(io_host, note);
  return base::Ok{};
}

}  // namespace

void make_scene(Host& io_host) {
  const base::Status status = io_host.demos.session ? advance_demo(io_host) : make_game_scene(io_host);
  if (status.ok()) return;
  print_line(io_host, status.error().message());
  // Nobody asked for a demo in attract mode, so the console's message is enough.
  if (!io_host.demos.is_attracting()) io_host.notices.push_back(describe_failure(io_host, status.error()));
  disconnect(io_host);
}

void show_notices(Host& io_host) {
  for (client::Notice& notice : std::exchange(io_host.notices, {})) {
    io_host.console.ui.close();
    release_held_keys(io_host);
    io_host.game.menu->show_notice(std::move(notice));
  }
}

// The scene's sound events are discarded at the end even if sound is off, or they would pile up.
void play_sound(Host& io_host) {
  Session& session = *io_host.game.session;
  const std::optional<client::DemoSession>& demo = io_host.demos.session;
  client::AudioScene& scene = io_host.game.data->presentation.audio_scene();
  const bool plays = demo || session.is_playing();
  if (std::exchange(io_host.sound.was_playing, plays) && !plays) scene.end_level();
  for (const std::string& name : io_host.game.menu->take_sounds()) scene.play_local(name);
  for (const std::string& note : scene.take_notes()) print_line(io_host, note);
  if (std::optional<client::SoundOutput>& output = io_host.sound.output) {
    audio::Scene heard = scene.scene();
    if (!io_host.input.has_focus && io_host.variables.mutes_unfocused())
      heard.volumes = {.sounds = 0, .ambient = 0, .music = 0};
    output->advance(io_host.timing.now_s, heard, scene.events());
    const client::Game* const game = demo                   ? &demo->state().game()
                                     : session.is_playing() ? &session.connection()->state().game()
                                                            : nullptr;
    const double time_s = demo                   ? demo->state().time_s()
                          : session.is_playing() ? session.connection()->state().time_s()
                                                 : 0;
    output->play_music(io_host.game.data->library, game != nullptr ? game->music_track : 0);
    output->set_combat(game != nullptr && is_in_combat(*game, time_s) && scene.scene().volumes.music_layers);
    output->pause_music(is_halted(io_host) || io_host.sound.is_music_paused ||
                        (game != nullptr && game->paused));
    for (const std::string& note : output->take_notes()) print_line(io_host, note);
  }
  scene.events().clear();
}

}  // namespace temblor::host
