// A room for light keys: 256 units to each side, its floor at z 0, with known light.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "compiler/light/lit_map.h"
#include "support/levels/room_map.h"
#include "world/face_at.h"

namespace temblor::test {

constexpr math::Vec3d kFaceUp(0, 0, 1);

// `entities`: map text, in which single quotes stand for double ones, as in `world_keys`.
inline std::string key_room(std::string_view entities, std::string_view world_keys = {}) {
  std::string text =
      entity_text("worldspawn", world_keys, walls_text({-128, -128, 0}, {128, 128, 256}, "stone")) +
      point_text("info_player_start", {-100, -100, 40}) + std::string(entities);
  for (char& letter : text)
    if (letter == '\'') letter = '"';
  return text;
}

// A lamp under the middle of the ceiling, 240 units above the floor.
constexpr double kLampHeight = 240;
inline std::string lamp(std::string_view keys = {}, std::string_view origin = "0 0 240") {
  return fmt::format("{{ 'classname' 'light' 'origin' '{}' 'light' '400' {} }}\n", origin, keys);
}
// A brush entity in the shape of a box.
inline std::string box_entity(std::string_view keys, const math::Vec3d& mins, const math::Vec3d& maxs,
                              std::string_view texture = "wood", std::string_view classname = "func_wall") {
  return entity_text(classname, keys, box_text(mins, maxs, texture));
}

// The light of the lamp on a surface that faces up, in the steps of a light map: (light - distance) *
// (1 + cosine) / 2, times the usual _range of a half.
inline double find_lamp_light(const math::Vec3d& place, double height = kLampHeight, double value = 400) {
  const math::Vec3d way = math::Vec3d(0, 0, height) - place - kFaceUp;
  const double distance = glm::length(way);
  return std::max(0.0, value - distance) * (1 + way.z / distance) / 4;
}

// Red light on a surface that faces up.
inline double light_at(const world::Level& level, const math::Vec3d& place, std::uint8_t style = 0) {
  return shown_light(level, face_under(level, place, kFaceUp), place, style).x;
}

}  // namespace temblor::test
