// Levels that are lit for a test, and the light of their luxels.
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

// Lights the small level, with these keys of worldspawn and more entities, in all ways at once: bounces,
// dirt, colors. Expects the same level with several threads, with a cache, after lighting it again, and from
// shards.
LitResult light_in_all_ways(const std::string& world_keys, const std::string& entities = {});

// A closed cube around the origin, kHalfRoom units to each side. All of it has the texture "wall" at a texel
// per unit.
constexpr double kHalfRoom = 64;
// Entities behind worldspawn, and keys of worldspawn, as map text with single quotes for double ones.
struct RoomSetup {
  std::string entities{};
  std::string world_keys{};
  bool sky = false;  // for a ceiling
};
// Compiles the BSP stage only; CHECKs that it works.
formats::Bsp room_with(const RoomSetup& setup);

// The point in the face's plane that has a luxel's texture coordinates.
math::Vec3d luxel_place(const world::Level& level, const world::Face& face, int column, int row);

// A luxel of an axial face that is not sky.
struct RoomLuxel {
  bool of_world = true;          // not of a brush entity
  math::Vec3d place_world{0.0};  // a unit in front of the face, where light is measured
  math::Vec3d normal{0.0};
  std::array<std::uint8_t, 3> rgb{};  // of the requested style; black without it
  std::uint8_t gray = 0;
};
// All luxels at least `margin` units from their face's edges.
std::vector<RoomLuxel> room_luxels(const LitResult& lit, std::uint8_t style = 0, double margin = 8);
std::ostream& operator<<(std::ostream& io_stream, const RoomLuxel& luxel);

}  // namespace temblor::test
