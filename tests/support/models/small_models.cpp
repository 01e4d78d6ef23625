#include "support/models/small_models.h"

#include <array>
#include <string>

namespace temblor::test {
namespace {

using formats::MdlPose;
using formats::MdlVertex;

std::vector<std::uint8_t> picture(std::size_t texels, std::uint8_t first) {
  std::vector<std::uint8_t> indices(texels);
  for (std::size_t i = 0; i < texels; ++i) indices[i] = static_cast<std::uint8_t>(first + i);
  return indices;
}

// Every second corner of a cube with sides of `side` steps.
MdlPose tetrahedron(const std::string& name, std::uint8_t side) {
  MdlPose pose;
  pose.name = name;
  pose.mins = {{0, 0, 0}, 0};
  pose.maxs = {{side, side, side}, 0};
  pose.vertices = {{{0, 0, 0}, 0},
                   {{side, side, 0}, 41},
                   {{side, 0, side}, 60},
                   {{0, side, side}, formats::kMdlNormals - 1}};
  return pose;
}

}  // namespace

formats::Mdl small_mdl() {
  constexpr std::uint32_t kWidth = 7, kHeight = 3;
  formats::Mdl mdl;
  mdl.scale = {0.5f, 0.25f, 1.0f};
  mdl.origin = {-8.0f, -4.0f, 2.5f};
  mdl.bounding_radius = 100.25f;
  mdl.eye = {1.0f, 2.0f, 3.0f};
  mdl.skin_width = kWidth;
  mdl.skin_height = kHeight;
  mdl.skins = {{{picture(kWidth * kHeight, 0)}, {}},
               {{picture(kWidth * kHeight, 50), picture(kWidth * kHeight, 250)}, {0.25f, 1.0f}}};
  mdl.texels = {{false, 0, 0}, {true, 3, 0}, {true, 3, 2}, {false, 6, 2}};
  mdl.triangles = {{true, {0, 1, 2}}, {true, {0, 3, 1}}, {false, {0, 2, 3}}, {false, {1, 3, 2}}};
  mdl.frames = {{{tetrahedron("stand", 200)}, {}, {}, {}},
                {{tetrahedron("run1", 100), tetrahedron("run2", 150), tetrahedron("fifteen letters", 255)},
                 {0.1f, 0.2f, 0.5f},
                 {{0, 0, 0}, 7},
                 {{255, 255, 255}, 9}}};
  mdl.random_phase = true;
  mdl.flags = formats::kMdlRotate | formats::kMdlTracer3;
  mdl.average_triangle_size = 42.5f;
  return mdl;
}

formats::Spr small_spr() {
  formats::Spr spr;
  spr.orientation = formats::SprOrientation::kParallelOriented;
  spr.bounding_radius = 2.5f;
  spr.max_width = 3;
  spr.max_height = 4;
  spr.beam_length = 1.5f;
  spr.random_phase = true;
  spr.frames = {{{{-1, 1, 3, 2, picture(6, 250)}}, {}},
                {{{0, 0, 1, 4, picture(4, 1)}, {-2, 5, 2, 1, picture(2, 254)}}, {0.5f, 0.75f}}};
  return spr;
}

}  // namespace temblor::test
