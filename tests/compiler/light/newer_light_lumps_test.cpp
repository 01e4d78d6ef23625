// LIGHTING_E5BGR9 and FACENORMALS.
#include <gtest/gtest.h>

#include <cmath>

#include "compiler/light/lighting.h"
#include "formats/bspx/face_normals.h"
#include "formats/bspx/hdr_light.h"
#include "world/face_at.h"

namespace temblor::test {
namespace {

// Where the usual light is not cut off, HDR light is the same.
TEST(NewerLightLumps, HdrLightEqualsTheUsualLightBelowItsLimit) {
  const formats::Bsp room = room_with({.entities = "{ 'classname' 'light' 'origin' '0 0 40' 'light' '640' "
                                                   "'_color' '1 0.5 0.25' }"});
  const LitResult lit = light(room, {.hdr = true}), usual = light(room);
  EXPECT_EQ(lit.bsp.lighting, usual.bsp.lighting);
  EXPECT_EQ(usual.bsp.find_bspx(formats::kHdrLightLump), nullptr);
  const std::vector<std::uint32_t> samples = formats::read_hdr_light(lit.bsp).value();
  ASSERT_EQ(samples.size(), lit.bsp.lighting.size());
  std::size_t below = 0, beyond = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const math::Vec3 steps = formats::unpack_e5bgr9(samples[i]) / formats::kHdrPerGrayStep;
    const float brightest = std::max({steps.x, steps.y, steps.z});
    if (brightest < 254) {
      ++below;
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(steps[channel], lit.summary.lit.samples[i * 3 + static_cast<std::size_t>(channel)], 1.0);
    } else {
      beyond += brightest > 260 ? 1 : 0;
      ASSERT_GE(lit.bsp.lighting[i], 253);
    }
  }
  EXPECT_GT(below, 100u);
  EXPECT_GE(beyond, 3u) << "brighter than a gray sample can be";
  // Lighting it again without the option removes the lump.
  EXPECT_EQ(light(lit.bsp).bsp.find_bspx(formats::kHdrLightLump), nullptr);
}

TEST(NewerLightLumps, NormalsOfFlatFacesAreThoseOfTheirPlanes) {
  const LitResult lit = light(room_with({}), {.face_normals = true});
  const formats::FaceNormals normals = formats::read_face_normals(lit.bsp).value();
  ASSERT_FALSE(normals.corners.empty());
  const auto level = world::make_level(lit.bsp, "room").value();
  std::size_t corner = 0;
  for (const world::Face& face : level->faces)
    for (std::uint32_t i = 0; i < face.surfedge_count; ++i, ++corner) {
      const formats::CornerVectors& at = normals.corners[corner];
      const math::Vec3 normal = normals.vectors[at.normal], tangent = normals.vectors[at.tangent],
                       bitangent = normals.vectors[at.bitangent];
      EXPECT_LT(glm::distance(normal, math::Vec3(world::compute_face_plane(*level, face).normal)), 1e-6);
      for (const math::Vec3& across : {tangent, bitangent}) {
        EXPECT_NEAR(glm::length(across), 1, 1e-6);
        EXPECT_NEAR(glm::dot(across, normal), 0, 1e-6);
      }
      EXPECT_GT(glm::dot(tangent, level->texture_axes[face.axes].s_axis), 0.9);
      EXPECT_GT(glm::dot(bitangent, level->texture_axes[face.axes].t_axis), 0.9);
    }
  EXPECT_EQ(corner, normals.corners.size());
}

}  // namespace
}  // namespace temblor::test
