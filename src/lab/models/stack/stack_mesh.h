// A model whose vertices are stored in the order in which a stack of vertices needs them, so that they are
// read from start to end. The commands of its stream are grouped: a group first pushes some vertices, then
// draws. They are transformed together, which SIMD code can do, into a room above the stack. Those that later
// groups need are copied to their places in the stack.
//
//   stack                                 room of the group
//   | 0 | 1 | ...     | places - 1 |      | places | places + 1 | ...
//
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/models/stack/command_stream.h"
#include "render/alias/alias_mesh.h"

namespace temblor::lab {

// Ranges of the lists below.
struct StackGroup {
  std::uint32_t first_push, push_count;  // in the rows of poses; the first is a multiple of kPushesAtOnce
  std::uint32_t first_draw, draw_count;
  std::uint32_t first_kept, kept_count;
  std::uint32_t first_source, source_count;
};

// A copy of an entry of the room to a place of the stack.
struct KeptEntry {
  std::uint8_t from, to;
};

struct StackSizes {
  std::size_t places = 16;            // of the stack: kMinStack to kMaxStack
  std::size_t pushes_per_group = 64;  // a multiple of kPushesAtOnce, up to kMaxPushesPerGroup
};

class StackMesh {
 public:
  static constexpr std::size_t kPushesAtOnce = render::AliasModel::kRowMultiple, kMaxPushesPerGroup = 64;
  static constexpr std::size_t kMaxDrawsPerGroup = 256;

  StackMesh(const render::AliasModel& model, const StackSizes& sizes);

  // Whether this is the model, which may have the address of one from before. Poses after the first are not
  // compared.
  bool match(const render::AliasModel& model) const;

  const StackSizes& sizes() const { return sizes_; }
  const CommandStream& stream() const { return stream_; }
  std::span<const StackGroup> groups() const { return groups_; }
  // By push, with gaps that complete the last vector of a group.
  const render::TexelPoint* texels() const { return texels_.data(); }
  render::PoseBytes pose(render::PoseIndex index) const { return rows(poses_, index); }
  render::WidePose wide_pose(render::PoseIndex index) const { return rows(wide_poses_, index); }
  // The corners of triangles: entries of the stack or of the room.
  std::span<const render::MeshTriangle> triangles() const { return triangles_; }
  std::span<const KeptEntry> kept() const { return kept_; }
  // Earlier groups whose entries a group draws with.
  std::span<const std::uint32_t> sources() const { return sources_; }
  std::size_t push_row() const { return row_; }
  std::size_t size_bytes() const;

 private:
  void group_commands();
  void order_vertices(const render::AliasModel& model);
  template <typename Element>
  render::PoseRows<Element> rows(const std::vector<Element>& all, render::PoseIndex index) const {
    const Element* const first = all.data() + base::to_size(index) * 4 * row_;
    return {first, first + row_, first + 2 * row_, first + 3 * row_};
  }

  StackSizes sizes_;
  std::vector<render::MeshTriangle> model_triangles_;
  std::vector<render::TexelPoint> model_texels_;
  const void* model_poses_;
  std::vector<std::uint8_t> first_pose_;
  CommandStream stream_;
  std::vector<StackGroup> groups_;
  std::vector<render::MeshTriangle> triangles_;
  std::vector<KeptEntry> kept_;
  std::vector<std::uint32_t> sources_;
  std::vector<std::uint32_t> vertices_;  // by push, with gaps
  std::vector<render::TexelPoint> texels_;
  std::size_t row_ = 0;
  // One of the two is empty.
  std::vector<std::uint8_t> poses_;
  std::vector<std::uint16_t> wide_poses_;
};

}  // namespace temblor::lab
