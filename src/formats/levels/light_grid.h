// The light in the open space of a level, for models: the BSPX lump LIGHTGRID_OCTREE. A regular grid of
// samples, stored as an octree, because most of a level's box is solid. The layout is that of ericw-tools'
// light -lightgrid.
//
//    0  step f32 x 3: units from sample to sample along each axis
//   12  size i32 x 3: number of samples along each axis
//   24  mins f32 x 3: the place of sample (0, 0, 0)
//   36  largest number of light styles of a sample, u8
//   37  root u32: a child, as below
//   41  node count u32, and nodes of 44 bytes:
//         0  middle u32 x 3: the first sample of the upper half along each axis
//        12  children u32 x 8, by 4 * (x >= middle.x) + 2 * (y >= middle.y) + (z >= middle.z):
//              bit 31: a leaf; bit 30: nothing is there; else: a node. The other bits are its number
//    .  leaf count u32, and leaves:
//         0  mins i32 x 3, size i32 x 3: the box of samples, of which x changes first, and z last
//        24  for each sample: number of styles u8, or 255 if it is inside of something solid;
//            then for each style: style u8, red u8, green u8, blue u8
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

inline constexpr const char* kLightGridLump = "LIGHTGRID_OCTREE";

// The light of one style at one sample, in the units of a light map.
struct GridLight {
  std::uint8_t style = 0;
  std::array<std::uint8_t, 3> rgb{};
  bool operator==(const GridLight&) const = default;
};

// A child of a node: a node, a leaf, or nothing.
struct GridChild {
  static constexpr std::uint32_t kLeafBit = 1u << 31, kMissingBit = 1u << 30;
  std::uint32_t value = kMissingBit;

  bool is_missing() const { return (value & kMissingBit) != 0; }
  bool is_leaf() const { return (value & kLeafBit) != 0; }
  std::uint32_t number() const { return value & ~(kLeafBit | kMissingBit); }
  bool operator==(const GridChild&) const = default;
};

struct GridNode {
  std::array<std::uint32_t, 3> middle{};
  std::array<GridChild, 8> children{};
  bool operator==(const GridNode&) const = default;
};

// A box of samples. Sample (x, y, z) relative to `mins` is number first_sample + x + size[0] * (y + size[1] *
// z).
struct GridLeaf {
  std::array<std::int32_t, 3> mins{}, size{};
  std::uint32_t first_sample = 0;
  bool operator==(const GridLeaf&) const = default;
};

// The lights of a sample, in LightGrid::lights.
struct GridSample {
  static constexpr std::uint8_t kOccluded = 255;
  std::uint32_t first_light = 0;
  std::uint8_t light_count = 0;  // or kOccluded
  bool operator==(const GridSample&) const = default;
};

struct LightGrid {
  math::Vec3 step{32.0f}, mins{0.0f};
  std::array<std::int32_t, 3> size{};
  GridChild root;
  std::vector<GridNode> nodes;
  std::vector<GridLeaf> leaves;
  std::vector<GridSample> samples;
  std::vector<GridLight> lights;
  bool operator==(const LightGrid&) const = default;
};

// Reads and checks the lump: the step is positive, all numbers are finite, children are in range, and no node
// is deeper than 32 or reached twice. Memory is at most 8 times the lump's size. Bytes after the last leaf
// are ignored.
base::Result<LightGrid> read_light_grid(base::Bytes lump);

// Writes a grid whose numbers are valid.
base::ByteVector write_light_grid(const LightGrid& grid);

// Returns the lights of a sample; nothing if it is outside of the grid or inside of something solid.
std::optional<std::span<const GridLight>> find_grid_lights(const LightGrid& grid,
                                                           const std::array<std::int32_t, 3>& sample);

}  // namespace temblor::formats
