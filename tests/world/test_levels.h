// Levels for the tests of the world: the file's structs beside the level made from them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "artgen/small_level.h"
#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

struct TestLevel {
  std::string name;
  formats::Bsp bsp;
  std::shared_ptr<const Level> level;
};

// Every .bsp of the game folder's maps; under a sanitizer a small, a middling and a lit one.
std::vector<TestLevel> stock_levels(const std::filesystem::path& base_folder);

// The level that `bsp` makes. CHECKs that it makes one.
TestLevel test_level(std::string name, formats::Bsp bsp);
TestLevel small_test_level(const artgen::SmallLevelOptions& options = {});

}  // namespace temblor::world
