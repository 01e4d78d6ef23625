#include "world/loading/faces.h"

#include <algorithm>
#include <cmath>

#include "world/loading/light_maps.h"
#include "world/loading/texel_range.h"

namespace temblor::world {
namespace {

constexpr std::int32_t kLightGridTexels = 16;
constexpr double kMaxExtentTexels = 1 << 20;
// Above this, a float cannot distinguish neighboring texels.
constexpr double kMaxTexelCoordinate = 1 << 24;

// Rounds the texture rectangle outward to multiples of 16, the grid of light samples: [17, 50] becomes [16,
// 64].
base::Status set_extents(const Level& level, std::size_t number, Face& io_face) {
  for (std::size_t i = 0; i < 2; ++i) {
    const TexelRange range = find_texel_range(level, io_face, static_cast<int>(i));
    const bool sane = range.min >= -kMaxTexelCoordinate && range.max <= kMaxTexelCoordinate &&
                      range.max - range.min <= kMaxExtentTexels;
    if (!sane)
      return base::malformed(
          "face {}: its texture coordinates range from {} to {} texels, more than in any real level", number,
          range.min, range.max);
    const auto first = static_cast<std::int32_t>(std::floor(range.min / kLightGridTexels));
    const auto last = static_cast<std::int32_t>(std::ceil(range.max / kLightGridTexels));
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

}  // namespace

base::Status make_faces(const formats::Bsp& bsp, Level& io_level) {
  // make_textures() puts the placeholder for missing textures last.
  const std::size_t missing = io_level.textures.size() - 1;
  io_level.faces.reserve(bsp.faces.size());
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
    face.styles = {kNoStyle, kNoStyle, kNoStyle, kNoStyle};
    face.light = kNoLight;
    io_level.faces.push_back(face);
  }
  return set_light_maps(bsp, io_level);
}

}  // namespace temblor::world
