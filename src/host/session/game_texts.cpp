#include "host/session/game_texts.h"

#include <utility>
#include <vector>

#include "assets/localization.h"
#include "host/frame/host_parts.h"

namespace temblor::host {

const std::shared_ptr<const formats::Localization>& load_game_texts(Host& io_host) {
  GameTexts& loaded = io_host.game.texts;
  const std::string& language = io_host.variables.server().language();
  if (loaded.texts != nullptr && loaded.language == language) return loaded.texts;
  std::vector<std::string> notes;
  loaded.language = language;
  loaded.texts = std::make_shared<const formats::Localization>(
      assets::load_localization(io_host.game.data->library.files(), language, notes));
  for (const std::string& note : notes) print_line(io_host, note);
  return loaded.texts;
}

}  // namespace temblor::host
