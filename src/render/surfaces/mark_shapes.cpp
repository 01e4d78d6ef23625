#include "render/surfaces/mark_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/hash.h"

namespace temblor::render {

namespace {

// Maps a hash to 0 to 1; 24 bits, exact in a float.
float fraction(std::uint64_t hash) {
  return static_cast<float>(hash >> 40) * 0x1p-24f;
}

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

// Smooth value noise from 0 to 1, with features about one unit in size: random values at whole coordinates,
// interpolated in between.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : seed_(seed) {}

  float at(float x, float y) const {
    const float left = std::floor(x), top = std::floor(y);
    const float s = smooth_step(0, 1, x - left), t = smooth_step(0, 1, y - top);
    const auto column = static_cast<std::int32_t>(left), row = static_cast<std::int32_t>(top);
    const float above = std::lerp(value(column, row), value(column + 1, row), s);
    const float below = std::lerp(value(column, row + 1), value(column + 1, row + 1), s);
    return std::lerp(above, below, t);
  }
  // The sum of three octaves.
  float rough_at(float x, float y) const {
    return 0.6f * at(x, y) + 0.3f * at(x * 2.1f + 7, y * 2.1f) + 0.1f * at(x * 4.3f, y * 4.3f + 3);
  }

 private:
  float value(std::int32_t column, std::int32_t row) const {
    const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 |
                                static_cast<std::uint32_t>(row);
    return fraction(base::hash_with(seed_, place));
  }
  std::uint64_t seed_;
};

// A point of a shape, relative to its center.
struct ShapePoint {
  float x, y, radius;              // -1 to 1; distance from the center
  float x_direction, y_direction;  // of length 1
};

ShapePoint shape_point(float x, float y) {
  const float radius = std::sqrt(x * x + y * y);
  if (radius < 1e-6f) return {x, y, radius, 1, 0};
  return {x, y, radius, x / radius, y / radius};
}

// A dark hole with a torn edge, in a ring of dust and splinters. Noise that depends only on the direction
// makes the outline ragged but closed.
MarkTexel bullet_hole(const ShapePoint& p, const Noise& noise) {
  const float torn = noise.rough_at(p.x_direction * 2, p.y_direction * 2);
  const float hole_radius = 0.30f + 0.22f * torn;
  const float hole = 1 - smooth_step(hole_radius - 0.08f, hole_radius + 0.06f, p.radius);
  const float splinters = noise.at(p.x_direction * 5 + 20, p.y_direction * 5);
  const float ring_radius = 0.5f + 0.5f * splinters;
  const float ring = 0.5f * (1 - smooth_step(hole_radius, ring_radius, p.radius));
  return {std::max(0.95f * hole, ring), 1 - hole};
}

// Soot: dense in the center, with streaks outward.
MarkTexel scorch(const ShapePoint& p, const Noise& noise) {
  const float streaks = noise.rough_at(p.x_direction * 4 + p.x * 0.7f, p.y_direction * 4 + p.y * 0.7f);
  const float edge = 0.45f + 0.55f * streaks;
  const float grain = 0.75f + 0.25f * noise.at(p.x * 14 + 40, p.y * 14);
  const float density = 1 - smooth_step(0.1f * edge, edge, p.radius);
  return {0.88f * density * grain, smooth_step(0.25f, 0.9f, p.radius)};
}

// A blot, and drops that flew away from it, stretched along their way.
MarkTexel splatter(const ShapePoint& p, const Noise& noise, std::uint64_t seed) {
  const float ragged = noise.rough_at(p.x_direction * 2.5f, p.y_direction * 2.5f);
  const float blot_radius = 0.12f + 0.5f * ragged * ragged;
  float cover = 1 - smooth_step(blot_radius - 0.02f, blot_radius + 0.02f, p.radius);
  constexpr std::uint64_t kDrops = 26;
  for (std::uint64_t drop = 0; drop < kDrops; ++drop) {
    const auto number = [&](std::uint64_t which) {
      return fraction(base::hash_with(seed, drop * 4 + which + 1));
    };
    const ShapePoint towards = shape_point(number(0) * 2 - 1, number(1) * 2 - 1);
    const float distance = 0.2f + 0.7f * number(2);
    const float size = (0.03f + 0.09f * number(3)) * (1.15f - distance);
    // Twice as long as wide, in the direction of flight.
    const float along = p.x * towards.x_direction + p.y * towards.y_direction - distance;
    const float across = p.y * towards.x_direction - p.x * towards.y_direction;
    const float away = std::sqrt(along * along / 4 + across * across);
    cover = std::max(cover, 1 - smooth_step(size * 0.8f, size * 1.1f, away));
  }
  const float thick = noise.at(p.x * 6, p.y * 6 + 9);
  return {0.86f * cover, 0.2f + 0.8f * thick * smooth_step(0.05f, 0.6f, p.radius + 0.15f)};
}

}  // namespace

MarkShapes::MarkShapes() {
  for (int kind = 0; kind < kKinds; ++kind)
    for (int variant = 0; variant < kVariants; ++variant) {
      pictures_.push_back(make_picture(static_cast<MarkKind>(kind), variant));
      for (int level = 1; level < kLevels; ++level) pictures_.push_back(make_smaller(pictures_.back()));
    }
}

MarkShapes::Picture MarkShapes::make_picture(MarkKind kind, int variant) {
  const std::uint64_t seed =
      base::hash_with(static_cast<std::uint64_t>(kind), static_cast<std::uint64_t>(variant));
  const Noise noise(seed);
  Picture picture{kSide, std::vector<MarkTexel>(std::size_t{kSide + 2} * (kSide + 2), MarkTexel{0, 0})};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto across = [](int texel) { return (static_cast<float>(texel) + 0.5f) * 2 / kSide - 1; };
      const ShapePoint point = shape_point(across(x), across(y));
      MarkTexel texel = kind == MarkKind::kBulletHole ? bullet_hole(point, noise)
                        : kind == MarkKind::kScorch   ? scorch(point, noise)
                                                      : splatter(point, noise, seed);
      texel.opacity *= 1 - smooth_step(0.85f, 1.0f, point.radius);
      texel.shade *= texel.opacity;
      picture.texel(x, y) = texel;
    }
  return picture;
}

// Box filter of 2 x 2 texels. Shades are premultiplied by opacity, so plain means are right.
MarkShapes::Picture MarkShapes::make_smaller(const Picture& picture) {
  const int side = picture.side / 2;
  Picture smaller{side,
                  std::vector<MarkTexel>(static_cast<std::size_t>((side + 2) * (side + 2)), MarkTexel{0, 0})};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::array<MarkTexel, 4> four = {picture.texel(2 * x, 2 * y), picture.texel(2 * x + 1, 2 * y),
                                             picture.texel(2 * x, 2 * y + 1),
                                             picture.texel(2 * x + 1, 2 * y + 1)};
      MarkTexel sum{0, 0};
      for (const MarkTexel& one : four) {
        sum.opacity += one.opacity / 4;
        sum.shade += one.shade / 4;
      }
      smaller.texel(x, y) = sum;
    }
  return smaller;
}

MarkTexel MarkShapes::at(MarkKind kind, int variant, int level, float u, float v) const {
  const Picture& picture = pictures_[number(kind, variant, level)];
  // In texels, from the center of the border texel before the first one.
  const auto side = static_cast<float>(picture.side);
  const float x = (u + 1) * 0.5f * side + 0.5f, y = (v + 1) * 0.5f * side + 0.5f;
  if (!(x >= 0 && y >= 0 && x < side + 1 && y < side + 1)) return {0, 0};
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const float s = x - static_cast<float>(column), t = y - static_cast<float>(row);
  const MarkTexel* const above = &picture.texel(column - 1, row - 1);
  const MarkTexel* const below = &picture.texel(column - 1, row);
  const auto mean = [&](float MarkTexel::*part) {
    const float top = above[0].*part + (above[1].*part - above[0].*part) * s;
    const float bottom = below[0].*part + (below[1].*part - below[0].*part) * s;
    return top + (bottom - top) * t;
  };
  const float opacity = mean(&MarkTexel::opacity);
  if (!(opacity > 0)) return {0, 0};
  return {std::min(opacity, 1.0f), std::clamp(mean(&MarkTexel::shade) / opacity, 0.0f, 1.0f)};
}

}  // namespace temblor::render
