// The contents of an AliasModel: a mesh laid out for drawing. Vertices on the seam of the skin that are used
// on both of its sides are stored twice, so that every vertex has one skin position. Unused vertices are
// dropped.
//
//   MDL:   vertex + "on seam"; triangle + "faces front"   (back triangles add half the skin's width to s)
//   here:  vertex = position, normal, one skin position;  triangle = three vertices
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "math/vec.h"
#include "render/alias/triangle_kernels.h"
#include "render/alias_model.h"

namespace temblor::render {

// Clockwise seen from outside.
using MeshTriangle = std::array<std::uint32_t, 3>;

// A frame or a skin: `count` members from number `first` on. For a group, end_times_s holds the time at which
// each member ends; otherwise it is empty.
struct AnimatedMembers {
  std::uint32_t first = 0, count = 1;
  std::vector<float> end_times_s;
};

// One pose: four rows of `vertices_per_row` elements, with x, y, z, and the index of the normal. Rows instead
// of records, so that kernels load a vector of each.
template <typename Element>
struct PoseRows {
  const Element *x, *y, *z, *normals;
};
using PoseBytes = PoseRows<std::uint8_t>;
using WidePose = PoseRows<std::uint16_t>;

// Distinguishes models, as LevelIdentity does levels: a cache that keeps a copy of a model's identity pointer
// never confuses the model with a later one at the same address. Once only caches keep it, the model is gone.
struct AliasIdentity {};

// The mesh with its poses and skins. A vertex's position in model space is elements * scale + origin. Poses
// are bytes if the model was an MDL file, and otherwise have 16 bits.
struct AliasModel {
  // Row lengths are multiples of this: kernels process so many vertices at once. The last vertex is repeated.
  static constexpr std::size_t kRowMultiple = 16;

  std::shared_ptr<const AliasIdentity> identity = std::make_shared<const AliasIdentity>();
  std::string name;
  std::uint32_t flags = 0;  // formats::MdlFlags
  bool random_phase = false;
  math::Bounds bounds;  // of all poses, model space
  math::Vec3 scale{1.0f}, origin{0.0f};

  std::size_t vertex_count = 0;      // at least 1
  std::size_t vertices_per_row = 0;  // vertex_count, rounded up to kRowMultiple
  // By vertex; centers of texels, inside the skin.
  std::vector<TexelPoint> texels;
  std::vector<MeshTriangle> triangles;
  float mean_side = 0;  // of the triangles, in units, in the first pose
  // Pose by pose, as PoseRows has it; one of the two is empty.
  std::vector<std::uint8_t> poses;
  std::vector<std::uint16_t> wide_poses;
  std::vector<AnimatedMembers> frames;

  std::uint32_t skin_width = 0, skin_height = 0;
  std::vector<std::uint8_t> skin_texels;  // picture by picture, rows from the top
  std::vector<AnimatedMembers> skins;

  bool is_wide() const { return !wide_poses.empty(); }
  PoseBytes pose(PoseIndex index) const { return rows(poses, index); }
  WidePose wide_pose(PoseIndex index) const { return rows(wide_poses, index); }
  std::size_t pose_count() const { return (poses.size() + wide_poses.size()) / (4 * vertices_per_row); }
  // `number` is a result of skin_at().
  const std::uint8_t* skin_picture(std::uint32_t number) const {
    return skin_texels.data() + number * picture_bytes();
  }
  std::size_t picture_bytes() const { return std::size_t{skin_width} * skin_height; }
  std::size_t picture_count() const { return skin_texels.size() / picture_bytes(); }

 private:
  template <typename Element>
  PoseRows<Element> rows(const std::vector<Element>& all, PoseIndex index) const {
    const Element* first = all.data() + base::to_size(index) * 4 * vertices_per_row;
    return {first, first + vertices_per_row, first + 2 * vertices_per_row, first + 3 * vertices_per_row};
  }
};

// Returns the mean length of the triangles' sides. It decides between rasterizers, so one pose is enough.
double compute_mean_side(std::span<const MeshTriangle> triangles, std::span<const math::Vec3d> positions);

}  // namespace temblor::render
