// Map text made in code: rooms of axial brushes.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::test {

// A brush in the shape of a box, with one texture on all sides.
inline std::string box_text(const math::Vec3d& mins, const math::Vec3d& maxs, std::string_view texture) {
  std::string text = "{\n";
  const auto side = [&](const math::Vec3d& a, const math::Vec3d& b, const math::Vec3d& c) {
    text += fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) {} 0 0 0 1 1\n", a.x, a.y, a.z, b.x, b.y, b.z,
                        c.x, c.y, c.z, texture);
  };
  const math::Vec3d size = maxs - mins;
  const math::Vec3d x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  side(mins, mins + y, mins + z);
  side(mins, mins + z, mins + x);
  side(mins, mins + x, mins + y);
  side(maxs, maxs - z, maxs - y);
  side(maxs, maxs - x, maxs - z);
  side(maxs, maxs - y, maxs - x);
  return text + "}\n";
}

// The six walls around a box, 16 units thick.
inline std::string walls_text(const math::Vec3d& mins, const math::Vec3d& maxs, std::string_view texture) {
  constexpr double kThick = 16;
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      math::Vec3d low = mins - kThick, high = maxs + kThick;
      (upper ? low : high)[axis] = upper ? maxs[axis] : mins[axis];
      text += box_text(low, high, texture);
    }
  return text;
}

inline std::string entity_text(std::string_view classname, std::string_view fields,
                               std::string_view brushes = {}) {
  return fmt::format("{{\n\"classname\" \"{}\"\n{}\n{}}}\n", classname, fields, brushes);
}

inline std::string point_text(std::string_view classname, const math::Vec3d& origin) {
  return entity_text(classname, fmt::format("\"origin\" \"{} {} {}\"", origin.x, origin.y, origin.z));
}

inline formats::Map parse_map(const std::string& text) {
  return formats::read_map(text).value();
}

}  // namespace temblor::test
