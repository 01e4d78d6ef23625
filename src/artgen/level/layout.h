// The description of the small level before it becomes geometry: boxes, lights, and entities.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/small_level.h"
#include "math/vec.h"

namespace temblor::artgen {

// Contents as BSP files store them; only those that the small level uses.
constexpr std::int32_t kContentsEmpty = -1;
constexpr std::int32_t kContentsSolid = -2;
constexpr std::int32_t kContentsWater = -3;
constexpr std::int32_t kContentsSky = -6;

// Chooses the materials of a box's surfaces. An empty box gets them on the walls around it, a solid box on
// its own sides.
enum class CellLook : std::uint8_t { kNone, kHall, kCorridor, kCourt, kCellar, kTrim, kPanel, kDoor };

// A box that is painted over the boxes before it.
struct LayoutBox {
  math::Bounds bounds;
  std::int32_t contents;
  CellLook look;
};

struct LayoutLight {
  math::Vec3 origin;
  // The distance in units at which the light fades to nothing. Also its brightness at distance 0, as in
  // Quake's "light" key.
  float reach;
  std::uint8_t style;
  // Red, green, and blue; 1 is full intensity.
  math::Vec3 color;
};

// A point entity without keys besides its origin and its angle.
struct LayoutEntity {
  const char* classname;
  math::Vec3 origin;
  float yaw_deg;
};

// Everything that make_small_level needs to know about a variant of the level.
struct SmallLevelLayout {
  std::vector<LayoutBox> boxes;
  // The box of the closed door, which is not one of the boxes above.
  math::Bounds door;
  std::vector<LayoutLight> lights;
  std::vector<LayoutEntity> entities;
};

// Only `tiny` and `four_styles` change the layout; the other options change how it is turned into a BSP.
SmallLevelLayout make_layout(const SmallLevelOptions& options);

}  // namespace temblor::artgen
