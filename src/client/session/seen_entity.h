// An entity at the moment of drawing: interpolated, so that it moves smoothly between two updates.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "math/vec.h"

namespace temblor::client {

// EntityUpdate::effects.
enum EntityEffects : std::uint8_t {
  kEffectBrightField = 1,
  kEffectMuzzleFlash = 2,
  kEffectBrightLight = 4,
  kEffectDimLight = 8
};

// Two frames of a model and how far it has come from one to the other, in [0, 1).
struct FrameBlend {
  std::uint16_t from = 0, to = 0;  // equal when nothing is being blended
  float blend = 0;
  bool operator==(const FrameBlend&) const = default;
};

struct SeenEntity {
  std::uint32_t number = 0;  // from 1; a static entity's counts on from kFirstStatic
  // Of the precache list, from 1, but it may be past its end. 0, which only the view entity can have: there
  // is nothing to draw (a player in an intermission).
  std::uint16_t model = 0;
  math::Vec3 origin_world{0.0f}, angles_deg{0.0f};
  // Where it was when it was last asked for; origin_world when it has just come or jumped, so that no trail
  // leads there.
  math::Vec3 previous_origin_world{0.0f};
  bool has_come = false;                       // since it was last asked for, or jumped
  std::uint16_t from_frame = 0, to_frame = 0;  // see FrameBlend
  float blend = 0;                             // 0: from_frame, 1: to_frame
  std::uint8_t skin = 0;
  std::uint8_t colormap = 0;      // of Game::players, from 1; 0: its own colors
  std::uint8_t effects = 0;       // EntityEffects
  bool muzzle_flash_now = false;  // the update that asked for it came since the last time
  float alpha = 1, scale = 1;

  static constexpr std::uint32_t kFirstStatic = 1u << 16;
};

// As the last packet said.
struct EntityPlace {
  std::uint16_t number = 0, model = 0;
  math::Vec3 origin_world{0.0f};
};

// `entities` are in order of number. Null: it is not among them.
inline const SeenEntity* find_entity(std::span<const SeenEntity> entities, std::uint32_t number) {
  const auto found =
      std::lower_bound(entities.begin(), entities.end(), number,
                       [](const SeenEntity& entity, std::uint32_t wanted) { return entity.number < wanted; });
  return found != entities.end() && found->number == number ? &*found : nullptr;
}

}  // namespace temblor::client
