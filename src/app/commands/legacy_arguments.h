// The command line as players and tools of such games write it: `-basedir quake -game mod +skill 2 +map
// start`.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace temblor::app {

// `words`, the program's name not among them, in our own terms: -basedir and -game with two dashes; each word
// that begins with + and a letter, with those behind it up to the next that begins with + or -, becomes
// `--exec "COMMAND"` at the end. For play and serve only; where no command of `commands` is named, play is
// meant.
std::vector<std::string> from_legacy_arguments(std::span<const char* const> words,
                                               std::span<const std::string> commands);

}  // namespace temblor::app
