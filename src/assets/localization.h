// Loads a game's localized texts (formats/game/localization.h) in the language of the player.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/game/localization.h"
#include "vfs/file_system.h"

namespace temblor::assets {

constexpr std::string_view kDefaultLanguage = "english";

// Loads localization/loc_english.txt, and over it loc_LANGUAGE.txt, so that a text that the language lacks is
// English. Games without such files have no texts. Adds a line to `io_notes` for each problem: it names the
// file and the line. A file that cannot be read counts as missing.
formats::Localization load_localization(const vfs::FileSystem& files, std::string_view language,
                                        std::vector<std::string>& io_notes);

}  // namespace temblor::assets
