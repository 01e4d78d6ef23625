// Translates the traditional Quake command line, which launchers and level editors use, to Temblor's own:
//
//   -basedir quake -game mod -hipnotic -window -width 800 +skill 2 +map start
//   --game hipnotic --basedir quake --game mod --set vid_mode=window --set vid_width=800
//     play --exec "skill 2" --exec "map start"
//
//   -basedir quake -dedicated 8 -port 26001 +map dm1
//   --basedir quake serve --maxclients 8 --port 26001 --map dm1
#pragma once

#include <span>
#include <string>
#include <vector>

namespace temblor::app {

// Returns the translated words. `words` does not include the program's name; `commands` are the names of all
// commands. -basedir and -game get two dashes, -hipnotic, -quoth, and -rogue become `--game FOLDER`, and
// other options become settings, options of the command, or nothing, like -heapsize. Each word that starts
// with + and a letter, together with the words after it up to the next + or -, becomes `--exec "COMMAND"` at
// the end. Only play and serve have --exec; for other commands the words stay. Without a command, `play` is
// added, or `serve` with -dedicated.
std::vector<std::string> convert_legacy_arguments(std::span<const char* const> words,
                                                  std::span<const std::string> commands);

}  // namespace temblor::app
