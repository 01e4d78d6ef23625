// The player's settings between runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "client/input/bindings.h"
#include "host/game_data.h"
#include "host/host_variables.h"

namespace temblor::host {

// Ours, in GameData::write_folder. A game folder that has none yet takes the settings of those before it, id1
// at last; where there is none at all another engine's config.cfg is read, and never written.
constexpr std::string_view kConfigurationFile = "temblor.cfg";
// Lines typed into the console.
constexpr std::string_view kHistoryFile = "temblor.history";
// Of the last game folder that has some; empty where there is none.
std::string read_history(const GameData& data);

// Text of a file of commands. Of all game folders the last one that has it counts: where it is written to, as
// that is now, before what it came with. kMalformed for what is no text.
base::Result<std::string> read_commands(const GameData& data, std::string_view name);
// Whether any of them has it.
bool has_commands(const GameData& data, std::string_view name);
// kConfigurationFile or config.cfg; nothing where there is neither.
std::optional<std::string> configuration_to_run(const GameData& data);
// kConfigurationFile as far as it is text: a line that is none is empty.
struct ReadConfiguration {
  std::string text;
  std::size_t unreadable_lines = 0;
};
base::Result<ReadConfiguration> read_configuration(const GameData& data);
// A copy of kConfigurationFile, which is written over when the program ends; its place. Nothing where it is
// in no folder that is written to.
base::Result<std::optional<std::filesystem::path>> keep_configuration_aside(const GameData& data);
std::string configuration_text(const client::Bindings& bindings, const HostVariables& variables,
                               const Overrides& overrides);

}  // namespace temblor::host
