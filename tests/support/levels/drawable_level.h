// Levels with everything that a renderer needs: stock levels, and variants of the level made in code.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "artgen/small_level.h"
#include "formats/images/palette.h"
#include "world/level.h"

namespace temblor::test {

struct DrawableLevel {
  std::string name;
  std::shared_ptr<const world::Level> level;
  formats::Palette palette;
  formats::Colormap colormap;
};

// CHECKs that the data contains the level.
DrawableLevel stock_level(const std::filesystem::path& base_folder, const std::string& map_name);

// Makes each level once per process, because that takes longer than most tests. Not for several threads.
DrawableLevel small_level(const artgen::SmallLevelOptions& options = {}, const std::string& name = "small");

// A variant of the level made in code for each of its options, and one with all options that add something.
struct SmallLevelVariant {
  const char* name;
  artgen::SmallLevelOptions options;
};
std::vector<SmallLevelVariant> small_level_variants();

}  // namespace temblor::test
