// Built-in functions of the 2021 re-release that draw shapes into the level, for developers of game code. The
// last two parameters are always the lifetime in seconds (0: until the next tick) and whether walls hide the
// shape (depth test).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "server/builtins/families.h"

namespace temblor::server {
namespace {

DebugLook read_look(const Call& call, int first) {
  const float lifetime_s = call.number(first);
  // A comparison with NaN is false.
  return {call.world.time_s + (lifetime_s > 0 ? double{lifetime_s} : 0.0), call.number(first + 1) != 0};
}

// Draws lines of one color with the look of parameters `first_of_look` and the next.
class LinePen {
 public:
  LinePen(Call& io_call, int color, int first_of_look)
      : call_(io_call),
        color_(static_cast<std::uint8_t>(io_call.whole(color) & 255)),
        look_(read_look(io_call, first_of_look)) {}

  void draw(const math::Vec3& from, const math::Vec3& to) const {
    call_.machine.charge(kInstructionsPerLine);
    call_.game.debug_shapes.add({from, to, color_}, look_);
  }

  // A circle around `middle`, through middle + a and middle + b.
  void draw_circle(const math::Vec3& middle, const math::Vec3& a, const math::Vec3& b) const {
    constexpr int kSides = 24;
    math::Vec3 from = middle + a;
    for (int side = 1; side <= kSides; ++side) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
      const math::Vec3 to = middle + a * std::cos(angle) + b * std::sin(angle);
      draw(from, to);
      from = to;
    }
  }

  // A line with a head of four strokes, `size` long and half as wide, at its end.
  void draw_arrow(const math::Vec3& from, const math::Vec3& to, float size) const {
    draw(from, to);
    const math::Vec3 span = to - from;
    const float length = glm::length(span);
    if (!(length > 0)) return;
    const math::Vec3 forward = span / length;
    // Any direction that is not along the arrow.
    const math::Vec3 other = std::abs(forward.z) < 0.9f ? math::Vec3(0, 0, 1) : math::Vec3(1, 0, 0);
    const math::Vec3 right = glm::normalize(glm::cross(forward, other)), up = glm::cross(right, forward);
    const math::Vec3 base = to - forward * size;
    for (const math::Vec3& side : {right, -right, up, -up}) draw(to, base + side * (size / 4));
  }

 private:
  static constexpr std::uint64_t kInstructionsPerLine = 4;
  Call& call_;
  std::uint8_t color_;
  DebugLook look_;
};

// ex_draw_point(point, color, lifetime, depth_test): a cross.
base::Status ex_draw_point(Call& io_call) {
  constexpr float kArm = 4;
  const LinePen pen(io_call, 1, 2);
  for (int axis = 0; axis < 3; ++axis) {
    math::Vec3 arm(0.0f);
    arm[axis] = kArm;
    pen.draw(io_call.vector(0) - arm, io_call.vector(0) + arm);
  }
  return base::Ok{};
}

// ex_draw_line(start, end, color, lifetime, depth_test)
base::Status ex_draw_line(Call& io_call) {
  LinePen(io_call, 2, 3).draw(io_call.vector(0), io_call.vector(1));
  return base::Ok{};
}

// ex_draw_arrow(start, end, color, size, lifetime, depth_test)
base::Status ex_draw_arrow(Call& io_call) {
  LinePen(io_call, 2, 4).draw_arrow(io_call.vector(0), io_call.vector(1), io_call.number(3));
  return base::Ok{};
}

// ex_draw_ray(start, direction, length, color, size, lifetime, depth_test): an arrow.
base::Status ex_draw_ray(Call& io_call) {
  const math::Vec3 direction = io_call.vector(1);
  const float length = glm::length(direction);
  const math::Vec3 span = length > 0 ? direction / length * io_call.number(2) : math::Vec3(0.0f);
  LinePen(io_call, 3, 5).draw_arrow(io_call.vector(0), io_call.vector(0) + span, io_call.number(4));
  return base::Ok{};
}

// ex_draw_circle(origin, radius, color, lifetime, depth_test): a horizontal one.
base::Status ex_draw_circle(Call& io_call) {
  const float radius = io_call.number(1);
  LinePen(io_call, 2, 3).draw_circle(io_call.vector(0), {radius, 0, 0}, {0, radius, 0});
  return base::Ok{};
}

// ex_draw_bounds(mins, maxs, color, lifetime, depth_test): the twelve edges of a box.
base::Status ex_draw_bounds(Call& io_call) {
  const std::array<math::Vec3, 2> ends = {io_call.vector(0), io_call.vector(1)};
  const LinePen pen(io_call, 2, 3);
  for (int axis = 0; axis < 3; ++axis)
    for (unsigned corner = 0; corner < 4; ++corner) {
      math::Vec3 from = ends[0];
      from[(axis + 1) % 3] = ends[corner & 1][(axis + 1) % 3];
      from[(axis + 2) % 3] = ends[corner >> 1][(axis + 2) % 3];
      math::Vec3 to = from;
      to[axis] = ends[1][axis];
      pen.draw(from, to);
    }
  return base::Ok{};
}

// ex_draw_sphere(origin, radius, color, lifetime, depth_test): a circle around each axis.
base::Status ex_draw_sphere(Call& io_call) {
  const math::Vec3 origin = io_call.vector(0), x(io_call.number(1), 0, 0), y(0, io_call.number(1), 0),
                   z(0, 0, io_call.number(1));
  const LinePen pen(io_call, 2, 3);
  pen.draw_circle(origin, x, y);
  pen.draw_circle(origin, y, z);
  pen.draw_circle(origin, z, x);
  return base::Ok{};
}

// ex_draw_cylinder(origin, half_height, radius, color, lifetime, depth_test): an upright one.
base::Status ex_draw_cylinder(Call& io_call) {
  const math::Vec3 origin = io_call.vector(0), up(0, 0, io_call.number(1)), x(io_call.number(2), 0, 0),
                   y(0, io_call.number(2), 0);
  const LinePen pen(io_call, 3, 4);
  pen.draw_circle(origin + up, x, y);
  pen.draw_circle(origin - up, x, y);
  for (const math::Vec3& side : {x, -x, y, -y}) pen.draw(origin + side - up, origin + side + up);
  return base::Ok{};
}

// ex_draw_worldtext(text, origin, size, lifetime, depth_test)
base::Status ex_draw_worldtext(Call& io_call) {
  io_call.game.debug_shapes.add({std::string(io_call.text(0)), io_call.vector(1), io_call.number(2)},
                                read_look(io_call, 3));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> debug_drawing_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {0, "ex_draw_point", ex_draw_point},         {0, "ex_draw_line", ex_draw_line},
      {0, "ex_draw_arrow", ex_draw_arrow},         {0, "ex_draw_ray", ex_draw_ray},
      {0, "ex_draw_circle", ex_draw_circle},       {0, "ex_draw_bounds", ex_draw_bounds},
      {0, "ex_draw_worldtext", ex_draw_worldtext}, {0, "ex_draw_sphere", ex_draw_sphere},
      {0, "ex_draw_cylinder", ex_draw_cylinder},
  };
  return kEntries;
}

}  // namespace temblor::server
