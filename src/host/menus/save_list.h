// Describes saved games for the menus.
#pragma once

#include <filesystem>
#include <string>

#include "client/menu/menu_content.h"
#include "formats/game/sav.h"

namespace temblor::host {

// Everything but the file's name and date. The stock game's comment has 22 columns for the level's title and
// then the kills: "The Slipgate Complex   kills:  3/ 21". Other text than the title there is the name that
// the player has given. `level_title`: of the level's file, or empty if there is none; the comment cuts it
// off.
client::MenuSave describe_save(const formats::Sav& sav, const std::string& level_title);

// The time of the last change of a file, in the local time zone: "2026-11-26 07:02". Empty if it is unknown.
std::string format_date(const std::filesystem::path& file);

}  // namespace temblor::host
