// Method: a face is cut into strips along s, and each strip into pieces along t. Cuts are on multiples of 16
// texels, so that the luxels on both sides of a cut are at the same places.
#include <cmath>

#include "compiler/bsp/faces/faces.h"

namespace temblor::compiler {
namespace {

constexpr double kTexelsASample = 16;  // between two samples of a light map

// The plane on which a texture coordinate has a value.
Plane make_plane_at(const math::Vec3& axis, float offset, double texel) {
  const math::Vec3d along(axis);
  const double length = glm::length(along);
  return {along / length, (texel - double{offset}) / length, 3};
}

// Cuts strips of `texels` off a face until the rest is no longer than that. Cuts are on whole luxels.
void cut_along(const TreeFace& face, const math::Vec3& axis, float offset, double texels,
               std::vector<TreeFace>& out) {
  TreeFace rest = face;
  while (true) {
    double least = 1e30, most = -1e30;
    for (const math::Vec3d& point : rest.winding) {
      const double texel = glm::dot(point, math::Vec3d(axis)) + double{offset};
      least = std::min(least, texel);
      most = std::max(most, texel);
    }
    if (!(most - least > texels + kOnPlaneEpsilon)) break;
    const double cut = std::floor(least / kTexelsASample) * kTexelsASample + texels;
    WindingParts parts = split(rest.winding, make_plane_at(axis, offset, cut));
    if (parts.front.empty() || parts.back.empty()) break;
    TreeFace part = rest;
    part.winding = std::move(parts.back);
    out.push_back(std::move(part));
    rest.winding = std::move(parts.front);
  }
  out.push_back(std::move(rest));
}

}  // namespace

void subdivide_faces(std::vector<TreeFace>& io_faces, std::span<const Surface> surfaces, double texels) {
  std::vector<TreeFace> cut, both;
  for (const TreeFace& face : io_faces) {
    const formats::BspTexinfo& texinfo = surfaces[face.surface].texinfo;
    if ((texinfo.flags & kUnlitTexinfo) != 0 || texinfo.s_axis == math::Vec3(0.0f) ||
        texinfo.t_axis == math::Vec3(0.0f)) {
      both.push_back(face);
      continue;
    }
    cut.clear();
    cut_along(face, texinfo.s_axis, texinfo.s_offset, texels, cut);
    for (const TreeFace& strip : cut) cut_along(strip, texinfo.t_axis, texinfo.t_offset, texels, both);
  }
  io_faces = std::move(both);
}

}  // namespace temblor::compiler
