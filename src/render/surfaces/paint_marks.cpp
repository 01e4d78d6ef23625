#include "render/surfaces/paint_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "render/color/blend_tables.h"
#include "render/edges/face_outlines.h"
#include "render/frame_buffer.h"
#include "render/view/model_view.h"

namespace temblor::render {

namespace {

// Colors from shade 0 to shade 1.
struct Ink {
  formats::Rgb first, last;
};
constexpr std::array<Ink, MarkShapes::kKinds> kInks = {{
    {{14, 12, 11}, {116, 108, 98}},  // a hole, and dust
    {{8, 7, 6}, {56, 44, 34}},       // soot
    {{36, 4, 3}, {88, 13, 9}},       // blood
}};

formats::Rgb ink_color(MarkKind kind, float shade) {
  const Ink& ink = kInks[static_cast<std::size_t>(kind)];
  return blend_colors(ink.last, ink.first, opacity_256(shade));
}

// A full-bright texel stops glowing when a mark covers at least half of it.
bool glows_through(int opacity_256) {
  return opacity_256 < kOpaque256 / 2;
}

// A unit vector in a random direction, without trigonometry: the same on every machine.
math::Vec2d random_turn(std::uint64_t hash) {
  const double t = static_cast<double>(hash >> 40) * 0x1p-23 - 1;  // tangent of a quarter of the turn
  const double cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
  const double sign = (hash & 1) != 0 ? 1 : -1;
  return {cosine * sign, sine * sign};
}

// The sizes of a shape or picture.
struct ShapeSizes {
  int side = MarkShapes::kSide;  // texels of the largest size, from -1 to 1
  int levels = MarkShapes::kLevels;
};

ShapeSizes shape_sizes(const Mark& mark) {
  if (mark.kind != MarkKind::kPicture) return {};
  return {mark.picture->longer_side(), mark.picture->level_count()};
}

// The smallest size of the shape at which a step of one texel of the block skips no texel of the shape.
int shape_level(const ShapeSizes& sizes, double texel_size) {
  constexpr double kLargest = 2;
  double shape_texels = texel_size * sizes.side / 2;
  int level = 0;
  for (; level < sizes.levels - 1 && shape_texels > kLargest; ++level) shape_texels /= 2;
  return level;
}

// The distance from the center to the corners of a picture, relative to half its side.
constexpr double kCorner = 1.4142135623730951;

std::int32_t to_texel(double position, std::int32_t size) {
  return static_cast<std::int32_t>(std::clamp(position, 0.0, static_cast<double>(size)));
}

// Places marks on a face, for a block whose first texel is texel (first_s, first_t) of the face at mip 0.
class MarkPlacer {
 public:
  MarkPlacer(const FacePlacement& placed, const TexelSteps& steps, math::Vec2d first, int mip,
             SurfaceShape shape)
      : placed_(placed), steps_(steps), first_(first), texel_(std::ldexp(1.0, mip)), shape_(shape) {}

  std::optional<PlacedMark> place(const Mark& mark) const {
    const math::Vec3d position(mark.position_model);
    const math::Vec3d on_plane =
        position - placed_.normal * (glm::dot(placed_.normal, position) - placed_.distance);
    const double s = glm::dot(placed_.s_axis, on_plane) + placed_.s_offset;
    const double t = glm::dot(placed_.t_axis, on_plane) + placed_.t_offset;
    const double radius = static_cast<double>(mark.radius);
    if (!std::isfinite(s) || !std::isfinite(t) || !(radius > 0)) return std::nullopt;

    const std::uint64_t hash = base::mix_bits(mark.seed + std::uint64_t{1});
    const bool is_picture = mark.kind == MarkKind::kPicture;
    const std::optional<MarkAxes> axes = is_picture ? picture_axes(mark) : shape_axes(hash);
    if (!axes) return std::nullopt;
    const math::Vec3d u_axis = axes->u / radius, v_axis = axes->v / radius;

    PlacedMark out;
    out.kind = mark.kind;
    out.picture = mark.picture.get();
    out.variant = static_cast<int>(hash >> 8 & 0xff) % MarkShapes::kVariants;
    const math::Vec2d u(glm::dot(u_axis, steps_.s) * texel_, glm::dot(u_axis, steps_.t) * texel_);
    const math::Vec2d v(glm::dot(v_axis, steps_.s) * texel_, glm::dot(v_axis, steps_.t) * texel_);
    const ShapeSizes sizes = shape_sizes(mark);
    out.level =
        shape_level(sizes, std::max(glm::length(math::Vec2d(u.x, v.x)), glm::length(math::Vec2d(u.y, v.y))));
    // From the mark to the center of the block's first texel, in texels of the block.
    const math::Vec2d offset((first_.x - s) / texel_ + 0.5, (first_.y - t) / texel_ + 0.5);
    out.u_first = static_cast<float>(glm::dot(u, offset));
    out.v_first = static_cast<float>(glm::dot(v, offset));
    out.u_per_column = static_cast<float>(u.x);
    out.u_per_row = static_cast<float>(u.y);
    out.v_per_column = static_cast<float>(v.x);
    out.v_per_row = static_cast<float>(v.y);
    // Interpolation extends the shape by up to one texel of its size beyond the radius.
    const double reach = radius * ((is_picture ? kCorner : 1) + std::ldexp(1.0, out.level + 1) / sizes.side);
    const double reach_s = reach * glm::length(placed_.s_axis) / texel_,
                 reach_t = reach * glm::length(placed_.t_axis) / texel_;
    out.left = to_texel(-offset.x - reach_s, shape_.width);
    out.right = to_texel(-offset.x + reach_s + 1, shape_.width);
    out.top = to_texel(-offset.y - reach_t, shape_.height);
    out.bottom = to_texel(-offset.y + reach_t + 1, shape_.height);
    if (out.left >= out.right || out.top >= out.bottom) return std::nullopt;
    return out;
  }

 private:
  // Unit vectors in the face's plane along which u and v increase.
  struct MarkAxes {
    math::Vec3d u, v;
  };
  MarkAxes shape_axes(std::uint64_t hash) const {
    const math::Vec3d across = glm::normalize(steps_.s);
    const math::Vec3d along = glm::cross(placed_.normal, across);
    const math::Vec2d turn = random_turn(hash);
    return {across * turn.x - along * turn.y, across * turn.y + along * turn.x};
  }
  // Nothing if the picture's upper edge has no direction in the plane.
  std::optional<MarkAxes> picture_axes(const Mark& mark) const {
    const math::Vec3d wanted(mark.up_model);
    const math::Vec3d up = wanted - placed_.normal * glm::dot(placed_.normal, wanted);
    constexpr double kShortest = 1e-4;  // relative
    const double length = glm::length(up);
    if (!(length > kShortest * glm::length(wanted))) return std::nullopt;
    return MarkAxes{glm::cross(up / length, placed_.normal), -up / length};
  }

  const FacePlacement& placed_;
  const TexelSteps& steps_;
  const math::Vec2d first_;
  const double texel_;  // the size of a texel of the block, in texels of mip 0
  const SurfaceShape shape_;
};

}  // namespace

// For every ink color and opacity step, the palette entry nearest to the blend with each palette entry.
MarkTables::MarkTables(const ColorTables& tables)
    : palette_(tables.palette),
      match_(tables.match),
      indices_(std::size_t{MarkShapes::kKinds} * kShades * kOpacities * 256) {
  std::uint8_t* out = indices_.data();
  for (int kind = 0; kind < MarkShapes::kKinds; ++kind)
    for (int shade = 0; shade < kShades; ++shade) {
      const formats::Rgb ink =
          ink_color(static_cast<MarkKind>(kind), static_cast<float>(shade) / (kShades - 1));
      for (int step = 0; step < kOpacities; ++step)
        for (std::size_t index = 0; index < 256; ++index) {
          const int opacity = step * kOpaque256 / (kOpacities - 1);
          const bool glows = match_.is_fullbright(index) && glows_through(opacity);
          *out++ = step == 0 ? static_cast<std::uint8_t>(index)
                             : match_(blend_colors(ink, palette_[index], opacity), glows);
        }
    }
}

std::uint8_t MarkTables::over(MarkKind kind, MarkTexel texel, std::uint8_t index) const {
  const int shade = static_cast<int>(texel.shade * (kShades - 1) + 0.5f);
  const int step = static_cast<int>(texel.opacity * (kOpacities - 1) + 0.5f);
  const int row = (static_cast<int>(kind) * kShades + shade) * kOpacities + step;
  return indices_[static_cast<std::size_t>(row) * 256 + index];
}

std::uint32_t MarkTables::over(MarkKind kind, MarkTexel texel, std::uint32_t under) const {
  return over(PictureTexel{ink_color(kind, texel.shade), opacity_256(texel.opacity)}, under);
}

std::uint8_t MarkTables::over(const PictureTexel& texel, std::uint8_t index) const {
  if (texel.opacity_256 == 0) return index;
  const bool glows = match_.is_fullbright(index) && glows_through(texel.opacity_256);
  return match_(blend_colors(texel.color, palette_[index], texel.opacity_256), glows);
}

std::uint32_t MarkTables::over(const PictureTexel& texel, std::uint32_t under) const {
  if (texel.opacity_256 == 0) return under;
  const bool glows = under >> 24 == 0 && glows_through(texel.opacity_256);
  const std::uint32_t blend = blend_rgb(to_rgb(texel.color), under, texel.opacity_256);
  return glows ? blend & 0xffffffu : blend;
}

std::span<const PlacedMark> place_marks(const world::Level& level, const world::Face& face,
                                        std::span<const Mark> marks, const BlockPlace& place,
                                        base::Arena& arena) {
  if (marks.empty()) return {};
  const FacePlacement placed = place_face(level, face, ModelView{});
  const std::optional<TexelSteps> steps = find_texel_steps(placed);
  if (!steps) return {};
  const MarkPlacer placer(placed, *steps, {place.tile_s * kTileTexels, place.tile_t * kTileTexels}, place.mip,
                          place.shape);
  base::ArenaVector<PlacedMark> out(arena, marks.size());
  for (const Mark& mark : marks)
    if (const std::optional<PlacedMark> there = placer.place(mark)) out.push_back(*there);
  return out.view();
}

template <typename Texel>
void paint_marks(const MarkTables& look, std::span<const PlacedMark> marks, std::int32_t y,
                 std::span<Texel> io_row) {
  for (const PlacedMark& mark : marks) {
    if (y < mark.top || y >= mark.bottom) continue;
    const auto row = static_cast<float>(y);
    for (std::int32_t x = mark.left; x < mark.right; ++x) {
      const auto column = static_cast<float>(x);
      const float u = mark.u_first + column * mark.u_per_column + row * mark.u_per_row;
      const float v = mark.v_first + column * mark.v_per_column + row * mark.v_per_row;
      Texel& under = io_row[static_cast<std::size_t>(x)];
      if (mark.picture != nullptr) {
        under = look.over(mark.picture->at(mark.level, u, v), under);
        continue;
      }
      const MarkTexel texel = look.shapes().at(mark.kind, mark.variant, mark.level, u, v);
      if (texel.opacity > 0) under = look.over(mark.kind, texel, under);
    }
  }
}

template void paint_marks(const MarkTables&, std::span<const PlacedMark>, std::int32_t,
                          std::span<std::uint8_t>);
template void paint_marks(const MarkTables&, std::span<const PlacedMark>, std::int32_t,
                          std::span<std::uint32_t>);

}  // namespace temblor::render
