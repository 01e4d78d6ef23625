// From --demo and the game folders to a recording and all that it is played with.
#pragma once

#include <string>

#include "app/commands/options.h"
#include "assets/library.h"
#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

struct LoadedDemo {
  std::string name;  // for messages: where it was found
  base::ByteVector bytes;
  assets::Library library;
  assets::Look look;
};

// `demo`: a name in the game folders ("demo1", "demo1.dem"), or a path to a file on disk. An unknown name
// gets an error that lists the recordings that are there.
base::Result<LoadedDemo> load_demo(const GameFolders& folders, const std::string& demo);

}  // namespace temblor::app
