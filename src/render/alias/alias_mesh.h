// What an AliasModel holds: a mesh laid out for drawing. Vertices on the skin's seam that both sides use are
// there twice, so that every vertex has one place on the skin; vertices that no triangle uses are gone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "math/vec.h"
#include "render/alias/triangle_kernels.h"
#include "render/alias_model.h"

namespace temblor::render {

// Clockwise seen from outside.
using MeshTriangle = std::array<std::uint32_t, 3>;

// A frame or a skin: `count` members from `first` on, which end at end_times_s (empty: it is no group).
struct AnimatedMembers {
  std::uint32_t first = 0, count = 1;
  std::vector<float> end_times_s;
};

// Four rows of `vertices_a_row` bytes: x, y, z, and the number of the normal.
struct PoseBytes {
  const std::uint8_t *x, *y, *z, *normals;
};

struct AliasModel {
  // Rows of vertices are a multiple of this long, filled up with the last vertex: kernels take that many.
  static constexpr std::size_t kRowMultiple = 16;

  std::string name;
  std::uint32_t flags = 0;  // formats::MdlFlags
  bool random_phase = false;
  math::Bounds bounds;  // of all poses, model space
  // position = bytes * scale + origin
  math::Vec3 scale{1.0f}, origin{0.0f};

  std::size_t vertex_count = 0;    // at least 1
  std::size_t vertices_a_row = 0;  // vertex_count, rounded up to kRowMultiple
  std::vector<TexelPoint> texels;  // by vertex: middles of texels, inside the skin
  std::vector<MeshTriangle> triangles;
  float mean_side = 0;              // of the triangles, in units, in the first pose
  std::vector<std::uint8_t> poses;  // pose by pose, as PoseBytes has it
  std::vector<AnimatedMembers> frames;

  std::uint32_t skin_width = 0, skin_height = 0;
  std::vector<std::uint8_t> skin_texels;  // picture by picture, rows from the top
  std::vector<AnimatedMembers> skins;

  PoseBytes pose(PoseIndex index) const {
    const std::uint8_t* first = poses.data() + base::to_size(index) * 4 * vertices_a_row;
    return {first, first + vertices_a_row, first + 2 * vertices_a_row, first + 3 * vertices_a_row};
  }
  std::size_t pose_count() const { return poses.size() / (4 * vertices_a_row); }
  // What skin_at() returned.
  const std::uint8_t* skin_picture(std::uint32_t number) const {
    return skin_texels.data() + number * picture_bytes();
  }
  std::size_t picture_bytes() const { return std::size_t{skin_width} * skin_height; }
  std::size_t picture_count() const { return skin_texels.size() / picture_bytes(); }
};

}  // namespace temblor::render
