// BSPX BRUSHLIST: the solid brushes of a level, by which newer engines let boxes of any size collide. For
// each model:
//
//    0  version u32 (1)
//    4  model u32: 0 is the world
//    8  number of brushes u32
//   12  number of planes of all its brushes u32
//   16  brushes:
//         0  mins f32[3], maxs f32[3]: the brush is inside of this box
//        24  contents i16, number of planes u16
//        28  planes: normal f32[3], distance f32; the brush is behind them
//
// Planes along an axis are left out, because the box has them. A model that is not in the lump is not solid.
// Layout: FTE's description of BSPX (specs/bspx.txt).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

inline constexpr const char* kBrushListLump = "BRUSHLIST";

// Contents besides those of leaves (world::Contents): blocks only what has a size.
constexpr std::int16_t kClipContents = -8;

struct ListedPlane {
  math::Vec3 normal{0.0f};
  float distance = 0;
  bool operator==(const ListedPlane&) const = default;
};

// In the space of its model.
struct ListedBrush {
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::int16_t contents = 0;
  std::vector<ListedPlane> planes;
  bool operator==(const ListedBrush&) const = default;
};

struct ListedModel {
  std::uint32_t model = 0;
  std::vector<ListedBrush> brushes;
  bool operator==(const ListedModel&) const = default;
};

// Fails if the lump ends early, has another version, counts that do not fit each other, or numbers that are
// not finite. Memory is at most 8 times the lump's size.
base::Result<std::vector<ListedModel>> read_brush_list(base::Bytes lump);

// A brush has at most 65535 planes (CHECKed).
base::ByteVector write_brush_list(std::span<const ListedModel> models);

}  // namespace temblor::formats
