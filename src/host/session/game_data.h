// Everything that is loaded from the game folders. It is replaced as a whole when the player switches to
// another mod (change_games() in session/configure.h).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assets/library.h"
#include "client/view/presentation.h"
#include "host/game_folders.h"
#include "host/video/gl_view.h"
#include "render/renderer.h"

namespace temblor::host {

struct GameData {
  // Fails if the folders cannot be read or hold no palette.
  static base::Result<std::unique_ptr<GameData>> open(const GameFolders& folders);

  GameData(MountedGames games, assets::Look look);
  GameData(const GameData&) = delete;
  GameData& operator=(const GameData&) = delete;

  // A path for messages: "mod/a.png" if the file is in the last game folder. Paths of the player's own files,
  // which are elsewhere, stay whole.
  std::string shorten_path(const std::filesystem::path& path) const;

  // The members below refer to it.
  assets::Library library;
  // See MountedGames.
  std::vector<std::filesystem::path> write_folders;
  // The last of write_folders: settings, saved games, demos, and screenshots are written there.
  std::filesystem::path write_folder;
  assets::Look look;  // palette and color map
  client::Presentation presentation;
  render::Renderer renderer;
  // Draws the view while `vid_renderer` is gl; null: the CPU draws.
  std::unique_ptr<GlView> gl_view;
  GlWindowUse gl_window_use = GlWindowUse::kAuto;  // that it was made for
  // Set if OpenGL failed while a frame was drawn: why. The next frame reports it.
  std::optional<base::Error> gl_failure;
  // The technique whose stages the renderer has; see HostVariables::technique().
  std::size_t technique = 0;
  // The level that it was checked with (lab::Technique::check_level); null: none yet.
  std::shared_ptr<const world::LevelIdentity> technique_level;
};

}  // namespace temblor::host
