#include "client/session/placeholder_model.h"

namespace temblor::client {
namespace {

constexpr std::uint32_t kSkinSide = 16, kCheck = 8;  // texels
// Palette indices: full-bright red and black in stock palettes.
constexpr std::uint8_t kLightTexel = 251, kDarkTexel = 0;
constexpr std::uint8_t kHalfSide = 127;  // vertex bytes, 1/16 unit each
constexpr float kByteUnits = 1.0f / 16.0f;

// The corners of each side, clockwise as seen from outside. The bits of a corner's number are its x, y and z.
constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
    {{1, 5, 7, 3}, {0, 2, 6, 4}, {2, 3, 7, 6}, {0, 4, 5, 1}, {4, 6, 7, 5}, {0, 1, 3, 2}}};

}  // namespace

// Each side has vertices of its own, so that it has a whole skin instead of sharing one with its neighbors.
formats::Mdl make_placeholder_model() {
  formats::Mdl mdl;
  mdl.scale = math::Vec3(kByteUnits);
  mdl.origin = math::Vec3(-kByteUnits * kHalfSide);
  mdl.bounding_radius = kByteUnits * kHalfSide * 1.74f;
  mdl.skin_width = mdl.skin_height = kSkinSide;
  std::vector<std::uint8_t> skin(std::size_t{kSkinSide} * kSkinSide);
  for (std::uint32_t i = 0; i < skin.size(); ++i)
    skin[i] = (i % kSkinSide / kCheck + i / kSkinSide / kCheck) % 2 == 0 ? kLightTexel : kDarkTexel;
  mdl.skins = {{{skin}, {}}};
  formats::MdlPose pose;
  pose.name = "missing";
  pose.maxs.position = {2 * kHalfSide, 2 * kHalfSide, 2 * kHalfSide};
  for (const auto& side : kSides) {
    const auto first = static_cast<std::uint32_t>(pose.vertices.size());
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      formats::MdlVertex vertex;
      for (std::size_t axis = 0; axis < 3; ++axis)
        vertex.position[axis] = (side[corner] >> axis & 1) != 0 ? 2 * kHalfSide : 0;
      pose.vertices.push_back(vertex);
      mdl.texels.push_back({false, corner == 1 || corner == 2 ? std::int32_t{kSkinSide} - 1 : 0,
                            corner >= 2 ? std::int32_t{kSkinSide} - 1 : 0});
    }
    mdl.triangles.push_back({true, {first, first + 1, first + 2}});
    mdl.triangles.push_back({true, {first, first + 2, first + 3}});
  }
  mdl.frames = {{{pose}, {}, {}, {}}};
  return mdl;
}

}  // namespace temblor::client
