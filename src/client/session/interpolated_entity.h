// An entity at the time of a frame, interpolated so that it moves smoothly between updates.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "math/vec.h"

namespace temblor::client {

// Bits of EntityUpdate::effects, the EF_ constants of game code.
enum EntityEffects : std::uint8_t {
  kEffectBrightField = 1,
  kEffectMuzzleFlash = 2,
  kEffectBrightLight = 4,
  kEffectDimLight = 8,
  // Tint the two lights above; other engines' names are EF_BLUE and EF_RED. They have no light of their own.
  kEffectBlue = 64,
  kEffectRed = 128
};

// Two frames of a model, and how far it has changed from one to the other, in [0, 1).
struct FrameBlend {
  std::uint16_t from = 0, to = 0;  // equal if nothing is being blended
  float blend = 0;
  bool operator==(const FrameBlend&) const = default;
};

struct InterpolatedEntity {
  std::uint32_t number = 0;  // from 1; static entities are numbered from kFirstStatic
  // Index in the precache list, from 1; it may be past the end. The view entity alone may have 0, which draws
  // nothing (a player in an intermission).
  std::uint16_t model = 0;
  math::Vec3 origin_world{0.0f}, angles_deg{0.0f};
  // The origin at the last query. Equals origin_world if the entity is new or has jumped, so that no trail
  // leads there.
  math::Vec3 previous_origin_world{0.0f};
  // New or has jumped since the last query.
  bool is_new = false;
  std::uint16_t from_frame = 0, to_frame = 0;  // see FrameBlend
  float blend = 0;                             // 0: from_frame, 1: to_frame
  std::uint8_t skin = 0;
  // Player number, from 1, whose colors it wears; 0: the model's own colors.
  std::uint8_t colormap = 0;
  std::uint8_t effects = 0;  // EntityEffects
  // An update with a flash has arrived since the last query.
  bool has_muzzle_flash = false;
  float alpha = 1, scale = 1;

  // Above all numbers of other entities.
  static constexpr std::uint32_t kFirstStatic = 1u << 16;
};

// An entity as the last packet described it.
struct EntityPlace {
  std::uint16_t number = 0, model = 0;
  math::Vec3 origin_world{0.0f};
};

// Finds an entity in a list sorted by number; null if it is not in it.
inline const InterpolatedEntity* find_entity(std::span<const InterpolatedEntity> entities,
                                             std::uint32_t number) {
  const auto found = std::lower_bound(
      entities.begin(), entities.end(), number,
      [](const InterpolatedEntity& entity, std::uint32_t wanted) { return entity.number < wanted; });
  return found != entities.end() && found->number == number ? &*found : nullptr;
}

}  // namespace temblor::client
