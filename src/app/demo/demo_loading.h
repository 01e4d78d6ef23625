// Loads the demo that --demo names, with the game data to play it.
#pragma once

#include <string>

#include "app/commands/options.h"
#include "assets/library.h"
#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// A demo and the game data that its models, sounds, and pictures come from.
struct LoadedDemo {
  // For messages: where it was found.
  std::string name;
  // The whole file. Players of the demo refer to it.
  base::ByteVector bytes;
  assets::Library library;
  assets::Look look;
};

// `demo` is a name in the game directories ("demo1", "demo1.dem") or the path of a file. The error for an
// unknown name lists similar names.
base::Result<LoadedDemo> load_demo(const GameFolders& folders, const std::string& demo);

}  // namespace temblor::app
