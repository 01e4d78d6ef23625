// The player's settings between runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "client/bindings.h"
#include "host/game_data.h"
#include "host/host_variables.h"

namespace temblor::host {

// Ours, in GameData::write_folder; another engine's config.cfg is read where there is none, and never
// written.
constexpr std::string_view kConfigurationFile = "temblor.cfg";
// Lines typed into the console.
constexpr std::string_view kHistoryFile = "temblor.history";
// Empty where there is none.
std::string read_history(const std::filesystem::path& folder);

// Text of a file of commands: from the folder that is written to, as it is now, or from the game's files.
// kMalformed for what is no text.
base::Result<std::string> read_commands(const GameData& data, std::string_view name);
// kConfigurationFile or config.cfg; nothing where there is neither.
std::optional<std::string> configuration_to_run(const GameData& data);
// What could not be read is not written over: it gets another name. Nothing where it can be read.
base::Status keep_damaged(const GameData& data, std::string_view name);
std::string configuration_text(const client::Bindings& bindings, const HostVariables& variables,
                               const Overrides& overrides);

}  // namespace temblor::host
