// Loads a game's localized texts (formats/game/localization.h) in the language of the player.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/game/localization.h"
#include "vfs/file_system.h"

namespace temblor::assets {

constexpr std::string_view kDefaultLanguage = "english";

// The languages that the game folders have texts for, sorted.
std::vector<std::string> list_languages(const vfs::FileSystem& files);

// Loads localization/loc_english.txt, and over it loc_LANGUAGE.txt, so that a text that the language lacks is
// English. The files of a mod add to those of the games below it, and win. Games without such files have no
// texts. Adds a line to `io_notes` for each problem: it names the file and the line. A file that cannot be
// read counts as missing, and so does one in whose language most texts have letters that the game's
// characters cannot write, such as Japanese.
formats::Localization load_localization(const vfs::FileSystem& files, std::string_view language,
                                        std::vector<std::string>& io_notes);

}  // namespace temblor::assets
