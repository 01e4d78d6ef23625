// Levels for the tests of src/world: the structs of the file, and the level that was made from them.
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

// Every .bsp of the game folder; in sanitizer builds only a small, a medium, and a lit one.
std::vector<TestLevel> stock_levels(const std::filesystem::path& base_folder);

// Makes a level from `bsp`. CHECKs that it succeeds.
TestLevel test_level(std::string name, formats::Bsp bsp);
TestLevel small_test_level(const artgen::SmallLevelOptions& options = {});

}  // namespace temblor::world
