// What the level made in code consists of, before any of it is geometry: boxes, lights, things.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/small_level.h"
#include "math/vec.h"

namespace temblor::artgen {

constexpr std::int32_t kContentsEmpty = -1;
constexpr std::int32_t kContentsSolid = -2;
constexpr std::int32_t kContentsWater = -3;
constexpr std::int32_t kContentsSky = -6;

// What the surfaces around (or of, for solid boxes) a box are covered with.
enum class CellLook : std::uint8_t { kNone, kHall, kCorridor, kCourt, kCellar, kTrim, kPanel, kDoor };

// Painted over what was there before.
struct PlanBox {
  math::Bounds bounds;
  std::int32_t contents;
  CellLook look;
};

struct PlanLight {
  math::Vec3 origin;
  float reach;  // the distance at which it has faded to nothing, and its brightness right beside it
  std::uint8_t style;
  math::Vec3 color;  // 1 is full
};

struct PlanThing {
  const char* classname;
  math::Vec3 origin;
  float yaw_deg;
};

struct SmallLevelPlan {
  std::vector<PlanBox> boxes;
  math::Bounds door;
  std::vector<PlanLight> lights;
  std::vector<PlanThing> things;
};

SmallLevelPlan make_plan(const SmallLevelOptions& options);

}  // namespace temblor::artgen
