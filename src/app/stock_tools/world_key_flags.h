// Keys of worldspawn as flags of light: `-sunlight 200` for "_sunlight" "200".
#pragma once

#include <span>
#include <string_view>

namespace temblor::app {

struct WorldKeyFlag {
  std::string_view flag;
  std::string_view key;  // without the underscore
  bool is_triple;        // a color or angles: three numbers
};

// Sorted by flag. Add the keys of worldspawn here that light learns.
std::span<const WorldKeyFlag> list_world_key_flags();

}  // namespace temblor::app
