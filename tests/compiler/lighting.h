// Levels lit for a test, and what light lies where.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "compiler/light_level.h"
#include "formats/bsp.h"
#include "math/vec.h"

namespace temblor::test {

struct LitResult {
  formats::Bsp bsp;
  compiler::LightSummary summary;
  compiler::Warnings warnings;
};

// Lights a level by its own entity text; CHECKs that it works.
LitResult light(formats::Bsp bsp, const compiler::LightOptions& options = {}, int threads = 1,
                compiler::LightCache* io_cache = nullptr);

// The cube room of tests/formats with these entities ("{...}{...}" in .map spelling, single quotes for
// double) behind worldspawn, which has `world_keys`. Under `sky`, its ceiling is sky.
struct RoomSetup {
  std::string entities{};
  std::string world_keys{};
  bool sky = false;
};
formats::Bsp room_with(const RoomSetup& setup);

// One luxel of a wall of the room, at least `margin` from the wall's edges.
struct RoomLuxel {
  int wall = 0;                  // +x -x +y -y +z -z
  math::Vec3d place_world{0.0};  // a unit before the wall, where light is measured
  math::Vec3d normal{0.0};
  std::array<std::uint8_t, 3> rgb{};  // of all styles asked for
  std::uint8_t grey = 0;
};
// 0 where the wall does not have that style.
std::vector<RoomLuxel> room_luxels(const LitResult& lit, std::uint8_t style = 0, double margin = 8);

}  // namespace temblor::test
