#include "app/files/game_defaults.h"

#include <string>
#include <string_view>
#include <vector>

#include "app/files/game_files.h"
#include "base/bytes.h"
#include "command/text.h"

namespace temblor::app {

void apply_game_defaults(const GameFolders& folders, command::Variables& io_variables) {
  if (has_no_game_data(folders)) return;
  const base::Result<vfs::FileSystem> files = open_files(folders);
  if (!files.ok()) return;
  const base::Result<base::ByteVector> file = files->read("default.cfg");
  if (!file.ok()) return;
  for (const std::string_view command : command::split_commands(base::as_text(*file))) {
    const std::vector<std::string> words = command::split_words(command);
    // A wrong value changes nothing; `play` reports it.
    if (words.size() == 2) static_cast<void>(io_variables.set(words[0], words[1]));
  }
}

}  // namespace temblor::app
