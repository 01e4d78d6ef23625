#include "world/loading/faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/animation.h"

namespace temblor::world {
namespace {

constexpr std::int32_t kLightGridTexels = 16;
constexpr double kMaxExtentTexels = 1 << 20;
// Above this, a float cannot distinguish neighboring texels.
constexpr double kMaxTexelCoordinate = 1 << 24;
constexpr std::int32_t kFlagNoLight = 1;

// The range of a face's texture coordinates along one axis, in texels.
struct Interval {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
};

// The sum is computed in double and rounded to float once. Light compilers use the same rule; any other
// rounding gives some faces of real levels one column of light samples too many or too few.
double texel_coordinate(const math::Vec3& position, const math::Vec3& axis, float offset) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const double texel = glm::dot(math::Vec3d(position), math::Vec3d(axis)) + double{offset};
  return static_cast<float>(std::clamp(texel, -kLargest, kLargest));
}

Interval texel_interval(const Level& level, const Face& face, const math::Vec3& axis, float offset) {
  Interval interval;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const std::uint32_t vertex = level.surfedge_start(face.first_surfedge + i);
    const double texel = texel_coordinate(level.vertices[vertex], axis, offset);
    interval.min = std::min(interval.min, texel);
    interval.max = std::max(interval.max, texel);
  }
  return interval;
}

// Rounds the texture rectangle outward to multiples of 16, the grid of light samples: [17, 50] becomes [16,
// 64].
base::Status set_extents(const Level& level, std::size_t number, Face& io_face) {
  const TextureAxes& axes = level.texture_axes[io_face.axes];
  const Interval intervals[2] = {texel_interval(level, io_face, axes.s_axis, axes.s_offset),
                                 texel_interval(level, io_face, axes.t_axis, axes.t_offset)};
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval& interval = intervals[i];
    const bool sane = interval.min >= -kMaxTexelCoordinate && interval.max <= kMaxTexelCoordinate &&
                      interval.max - interval.min <= kMaxExtentTexels;
    if (!sane)
      return base::malformed(
          "face {}: its texture coordinates range from {} to {} texels, more than in any real level", number,
          interval.min, interval.max);
    const auto first = static_cast<std::int32_t>(std::floor(interval.min / kLightGridTexels));
    const auto last = static_cast<std::int32_t>(std::ceil(interval.max / kLightGridTexels));
    io_face.texture_mins[i] = first * kLightGridTexels;
    io_face.texture_extents[i] = (last - first) * kLightGridTexels;
  }
  return base::Ok{};
}

FaceKind choose_face_kind(const Level& level, TextureKind texture, const formats::BspTexinfo& texinfo,
                          const formats::BspFace& face) {
  if (texture == TextureKind::kSky) return FaceKind::kSky;
  if (texture == TextureKind::kLiquid) return FaceKind::kLiquid;
  const bool never_lit = (texinfo.flags & kFlagNoLight) != 0 && face.light_offset < 0;
  return level.has_light && !never_lit ? FaceKind::kLit : FaceKind::kUnlit;
}

// Finds the face's samples. The file stores only their offset; their number follows from the size of the face
// and the number of its styles. A file made for a face of another size must not read past the samples.
base::Status set_light(const Level& level, const formats::BspFace& bsp_face, std::size_t number,
                       Face& io_face) {
  io_face.styles = {kNoStyle, kNoStyle, kNoStyle, kNoStyle};
  io_face.light = kNoLight;
  if (io_face.kind != FaceKind::kLit || bsp_face.light_offset < 0) return base::Ok{};
  for (const std::uint8_t style : bsp_face.styles) {
    if (style == kNoStyle) break;
    if (style >= kLightStyles)
      return base::malformed("face {}: light style {}, but the highest is {}", number, style,
                             kLightStyles - 1);
    io_face.styles[io_face.style_count++] = style;
  }
  if (io_face.style_count == 0) return base::Ok{};
  const auto first = static_cast<std::uint64_t>(bsp_face.light_offset);
  const std::uint64_t samples = static_cast<std::uint64_t>(io_face.light_width()) *
                                static_cast<std::uint64_t>(io_face.light_height()) * io_face.style_count;
  if (first + samples > level.light.size())
    return base::malformed("face {}: its {} light samples at {} are outside of the level's {}", number,
                           samples, first, level.light.size());
  io_face.light = static_cast<std::uint32_t>(first);
  return base::Ok{};
}

}  // namespace

// Compilers let few faces share light samples, if any. A malicious file could let all faces share one large
// light map, and so ask for far more surface memory than the file has bytes.
constexpr std::uint64_t kMaxSharing = 64;

base::Status make_faces(const formats::Bsp& bsp, Level& io_level) {
  // make_textures() puts the placeholder for missing textures last.
  const std::size_t missing = io_level.textures.size() - 1;
  io_level.faces.reserve(bsp.faces.size());
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < bsp.faces.size(); ++i) {
    const formats::BspFace& bsp_face = bsp.faces[i];
    const formats::BspTexinfo& texinfo = bsp.texinfos[bsp_face.texinfo];
    const std::size_t texture = texinfo.miptex < 0 ? missing : static_cast<std::size_t>(texinfo.miptex);
    Face face{};
    face.plane = bsp_face.plane;
    face.back_side = bsp_face.side != 0;
    face.first_surfedge = bsp_face.first_surfedge;
    face.surfedge_count = bsp_face.surfedge_count;
    face.axes = bsp_face.texinfo;
    face.texture = base::to_index<TextureIndex>(std::min(texture, missing));
    face.kind = choose_face_kind(io_level, io_level.texture(face.texture).kind, texinfo, bsp_face);
    TRY_STATUS(set_extents(io_level, i, face));
    TRY_STATUS(set_light(io_level, bsp_face, i, face));
    if (face.light != kNoLight)
      samples +=
          static_cast<std::uint64_t>(face.light_width()) * static_cast<std::uint64_t>(face.light_height());
    if (samples > io_level.light.size() * kMaxSharing)
      return base::malformed(
          "face {}: the faces up to this one use the level's {} light samples more than {} times", i,
          io_level.light.size(), kMaxSharing);
    io_level.faces.push_back(face);
  }
  return base::Ok{};
}

}  // namespace temblor::world
