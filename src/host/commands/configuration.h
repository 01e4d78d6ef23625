// The player's settings between runs: files of console commands in the game folders.
//
//   file              read                                  written
//   default.cfg       at the start, a game's own bindings   never
//   temblor.cfg       at the start                          at the end and by `writeconfig`
//   config.cfg        at the start, without temblor.cfg     never: it belongs to another engine
//   autoexec.cfg      at the start                          never: it belongs to the player
//   temblor.history   at the start                          with temblor.cfg
//
// run_configuration() in session/configure.h runs them in this order.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "host/session/game_data.h"

namespace temblor::host {

// Our own settings, in GameData::write_folder. A game folder that has none yet starts with the settings of
// the folders before it, down to id1. If there is none at all, another engine's config.cfg is read; it is
// never written.
constexpr std::string_view kConfigurationFile = "temblor.cfg";
// The lines that the player has typed into the console, in GameData::write_folder.
constexpr std::string_view kHistoryFile = "temblor.history";
// The history of the last game folder that has one; empty if none has.
std::string read_history(const GameData& data);

// Reads a file of console commands. The last game folder that has it wins. In each folder, a file in the
// write folder (as it is on disk now) wins over one that came with the game. Fails with kUsage if the name
// leads out of the game folders, with kMalformed if the file is not text. A file larger than 1 MiB is an
// error.
base::Result<std::string> read_commands(const GameData& data, std::string_view name);
// Whether a game folder has such a file.
bool has_commands(const GameData& data, std::string_view name);
// Returns kConfigurationFile or config.cfg, whichever exists, in this order. None if neither does.
std::optional<std::string> configuration_to_run(const GameData& data);
// The text of kConfigurationFile. A damaged file (after a crash of the machine, for example) should cost only
// the damaged lines: lines with bytes that are not text are left empty, so that line numbers stay right, and
// counted.
struct ReadConfiguration {
  std::string text;
  std::size_t unreadable_lines = 0;
};
base::Result<ReadConfiguration> read_configuration(const GameData& data);
// Copies kConfigurationFile to "temblor.cfg.damaged" next to it, because it is overwritten when the program
// ends. Replaces an older copy. Returns the path of the copy; none if the write folder holds no such file.
base::Result<std::optional<std::filesystem::path>> copy_damaged_configuration(const GameData& data);
// Returns the text of kConfigurationFile from those of Bindings::to_text() and HostVariables::to_text().
std::string configuration_text(std::string_view bindings, std::string_view variables);

}  // namespace temblor::host
