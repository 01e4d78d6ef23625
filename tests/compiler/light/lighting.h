// Levels lit for a test, and what light lies where.
#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "compiler/light/light_level.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"
#include "world/face_at.h"
#include "world/level.h"

namespace temblor::test {

struct LitResult {
  formats::Bsp bsp;
  compiler::LightSummary summary;
  compiler::Warnings warnings;
};

// Lights a level by its own entity text; CHECKs that it works.
LitResult light(formats::Bsp bsp, const compiler::LightOptions& options = {}, int threads = 1,
                compiler::LightCache* io_cache = nullptr);

// A closed cube around the origin, all of it textured "wall" at a texel a unit: kHalfRoom units to each side.
constexpr double kHalfRoom = 64;
// Map text of entities behind worldspawn, and keys of worldspawn; single quotes stand for double.
struct RoomSetup {
  std::string entities{};
  std::string world_keys{};
  bool sky = false;  // for a ceiling
};
// Compiled as far as the BSP stage; CHECKs that it can be.
formats::Bsp room_with(const RoomSetup& setup);

// Where a luxel lies in its face's plane: the point that has its texture coordinates.
math::Vec3d luxel_place(const world::Level& level, const world::Face& face, int column, int row);

// Of a face along axes of the world that is not sky.
struct RoomLuxel {
  bool of_world = true;          // not of a brush entity
  math::Vec3d place_world{0.0};  // a unit before the face, where light is measured
  math::Vec3d normal{0.0};
  std::array<std::uint8_t, 3> rgb{};  // of the style asked for; without it dark
  std::uint8_t gray = 0;
};
// Those at least `margin` from their face's edges.
std::vector<RoomLuxel> room_luxels(const LitResult& lit, std::uint8_t style = 0, double margin = 8);
std::ostream& operator<<(std::ostream& io_stream, const RoomLuxel& luxel);

}  // namespace temblor::test
