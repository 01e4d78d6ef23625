#include "world/loading/faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "world/loading/light_maps.h"
#include "world/loading/texel_range.h"

namespace temblor::world {
namespace {

constexpr std::int32_t kLightGridTexels = 16;
constexpr double kMaxExtentTexels = 1 << 20;
// Above this, a float cannot distinguish neighboring texels.
constexpr double kMaxTexelCoordinate = 1 << 24;

bool is_in_real_range(const TexelRange& range) {
  return range.min >= -kMaxTexelCoordinate && range.max <= kMaxTexelCoordinate &&
         range.max - range.min <= kMaxExtentTexels;
}

// Rounds the texture rectangle outward to multiples of 16, the grid of light samples: [17, 50] becomes [16,
// 64].
void set_extents(const TexelRange& range, std::size_t axis, Face& io_face) {
  const auto first = static_cast<std::int32_t>(std::floor(range.min / kLightGridTexels));
  const auto last = static_cast<std::int32_t>(std::ceil(range.max / kLightGridTexels));
  io_face.texture_mins[axis] = first * kLightGridTexels;
  io_face.texture_extents[axis] = (last - first) * kLightGridTexels;
}

// Gives a face an outline without area, so that it shows nothing.
void leave_out(Level& io_level, Face& io_face) {
  const auto edge = static_cast<std::int32_t>(io_level.edges.size());
  const std::uint32_t vertex = io_level.surfedge_start(io_face.first_surfedge);
  io_level.edges.push_back({{vertex, vertex}});
  io_face.first_surfedge = static_cast<std::uint32_t>(io_level.surfedges.size());
  io_face.surfedge_count = 3;
  io_level.surfedges.insert(io_level.surfedges.end(), io_face.surfedge_count, edge);
  io_face.kind = FaceKind::kUnlit;
  io_face.texture_mins = io_face.texture_extents = {0, 0};
}

// Faces whose texture coordinates no real level has.
struct LeftOut {
  std::size_t count = 0, first = 0;
  TexelRange range{};  // of the first one
};

void measure_face(std::size_t number, Level& io_level, Face& io_face, LeftOut& io_left_out) {
  const TexelRange s = find_texel_range(io_level, io_face, 0), t = find_texel_range(io_level, io_face, 1);
  if (is_in_real_range(s) && is_in_real_range(t)) {
    set_extents(s, 0, io_face);
    set_extents(t, 1, io_face);
    return;
  }
  if (io_left_out.count++ == 0) io_left_out = {1, number, is_in_real_range(s) ? t : s};
  leave_out(io_level, io_face);
}

void add_note(const LeftOut& left_out, Level& io_level) {
  if (left_out.count == 0) return;
  io_level.notes.push_back(fmt::format(
      "{} left out: the texture coordinates of face {} range from {} to {} texels",
      base::counted(left_out.count, "face"), left_out.first, left_out.range.min, left_out.range.max));
}

FaceKind choose_face_kind(const Level& level, TextureKind texture, const formats::BspTexinfo& texinfo,
                          const formats::BspFace& face) {
  if (texture == TextureKind::kSky) return FaceKind::kSky;
  if (texture == TextureKind::kLiquid) return FaceKind::kLiquid;
  const bool never_lit = (texinfo.flags & kFlagNoLight) != 0 && face.light_offset < 0;
  return level.has_light && !never_lit ? FaceKind::kLit : FaceKind::kUnlit;
}

}  // namespace

void make_faces(const formats::Bsp& bsp, Level& io_level) {
  // make_textures() puts the placeholder for missing textures last.
  const std::size_t missing = io_level.textures.size() - 1;
  io_level.faces.reserve(bsp.faces.size());
  LeftOut left_out;
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
    measure_face(i, io_level, face, left_out);
    face.styles = {kNoStyle, kNoStyle, kNoStyle, kNoStyle};
    face.light = kNoLight;
    io_level.faces.push_back(face);
  }
  add_note(left_out, io_level);
  set_light_maps(bsp, io_level);
}

}  // namespace temblor::world
