// Finds the leaves that a straight line passes through, by the tree in the file and nothing else.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "formats/levels/bsp.h"
#include "math/vec.h"
#include "support/random.h"

namespace temblor::compiler {

// A finished level of the game data. CHECKs that it can be read.
formats::Bsp finished_level(const std::filesystem::path& base_folder, const std::string& name);

struct LeafCrossing {
  std::size_t leaf;
  math::Vec3d enters_at;  // where the line enters it
};

// In order from start to end. The point of every crossing but the first is on a plane of the tree.
std::vector<LeafCrossing> leaves_along(const formats::Bsp& bsp, const math::Vec3d& start,
                                       const math::Vec3d& end);

std::size_t leaf_at(const formats::Bsp& bsp, const math::Vec3d& point);

// A random point in the box of the world.
math::Vec3d random_point(const formats::Bsp& bsp, test::Random& random);

// A random point in a leaf that is neither solid nor sky; nothing if 1,000 points are not.
std::optional<math::Vec3d> random_open_point(const formats::Bsp& bsp, test::Random& random);

}  // namespace temblor::compiler
