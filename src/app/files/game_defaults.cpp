#include "app/files/game_defaults.h"

#include <algorithm>
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
  for (std::string_view rest = base::as_text(*file); !rest.empty();) {
    const std::size_t length = command::command_length(rest);
    const std::vector<std::string> words = command::split_words(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
    // A wrong value changes nothing; `play` reports it.
    if (words.size() == 2) static_cast<void>(io_variables.set(words[0], words[1]));
  }
}

}  // namespace temblor::app
