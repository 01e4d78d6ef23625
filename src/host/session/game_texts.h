// The localized texts (formats/game/localization.h) in which this client reads what other servers and demos
// send. Our own server sends texts, not keys.
#pragma once

#include <memory>
#include <string>

#include "formats/game/localization.h"

namespace temblor::host {

struct Host;

struct GameTexts {
  std::string language;
  std::shared_ptr<const formats::Localization> texts;  // null: not loaded yet
};

// Returns the texts in the player's language; loads them when the language or the game folders have changed.
// After the player has chosen another language, prints why it cannot be read.
const std::shared_ptr<const formats::Localization>& load_game_texts(Host& io_host);

}  // namespace temblor::host
