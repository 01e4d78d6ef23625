// Hot loop. It moves between groups; the engine's kernels transform vertices and draw triangles.
#include "lab/models/stack/stack_painter.h"

#include <algorithm>
#include <array>

#include "lab/models/edges/row_painter.h"

namespace temblor::lab {

namespace {

template <typename Element>
render::PoseJob<Element> make_part(const render::PoseJob<Element>& whole, std::size_t first,
                                   std::size_t count, render::ScreenVertex* out) {
  render::PoseJob<Element> part = whole;
  for (std::size_t row = 0; row < 4; ++row) {
    part.from[row] += first;
    part.to[row] += first;
  }
  part.count = count;
  part.out = out;
  return part;
}

// Transforms the vertices of pushes from `first` on. With `simd`, `count` is a multiple of
// StackMesh::kPushesAtOnce.
void transform(const StackInstance& instance, bool simd, std::size_t first, std::size_t count,
               render::ScreenVertex* out) {
  if (instance.transform.from[0] != nullptr) {
    const render::VertexJob part = make_part(instance.transform, first, count, out);
    simd ? render::project_vertices_simd(part) : render::project_vertices_scalar(part);
  } else {
    const render::WideVertexJob part = make_part(instance.wide_transform, first, count, out);
    simd ? render::project_vertices_simd(part) : render::project_vertices_scalar(part);
  }
}

// The numbers of pushes in the rows of poses, which have gaps between groups.
class PushNumbers {
 public:
  explicit PushNumbers(std::span<const StackGroup> groups) : group_(groups.begin()) {}
  std::size_t next() {
    while (pushed_ == group_->push_count) {
      ++group_;
      pushed_ = 0;
    }
    return group_->first_push + pushed_++;
  }

 private:
  std::span<const StackGroup>::iterator group_;
  std::uint32_t pushed_ = 0;
};

void draw_triangles(const render::TriangleJob& job, const StackKernels& kernels,
                    const render::TriangleTarget& target) {
  if (kernels.format == render::PixelFormat::kIndexed)
    kernels.simd ? render::draw_triangles_u8_simd(job, target)
                 : render::draw_triangles_u8_scalar(job, target);
  else
    kernels.simd ? render::draw_triangles_u32_simd(job, target)
                 : render::draw_triangles_u32_scalar(job, target);
}

// The stack, and the room of a group above it.
class StackRoom {
 public:
  StackRoom(const StackInstance& instance, bool simd)
      : instance_(instance),
        mesh_(*instance.mesh),
        simd_(simd),
        room_(mesh_.sizes().places),
        job_(instance.skin) {
    job_.vertices = vertices_.data();
    job_.texels = texels_.data();
    job_.vertex_count = room_ + mesh_.sizes().pushes_per_group;
    job_.fronts = {numbers_.data(), rows_.data(), 0};
  }
  StackRoom(const StackRoom&) = delete;
  StackRoom& operator=(const StackRoom&) = delete;

  void push(const StackGroup& group) {
    constexpr std::size_t kAtOnce = StackMesh::kPushesAtOnce;
    const std::size_t pushes = (group.push_count + kAtOnce - 1) / kAtOnce * kAtOnce;
    transform(instance_, simd_, group.first_push, pushes, vertices_.data() + room_);
    std::copy_n(mesh_.texels() + group.first_push, group.push_count, texels_.data() + room_);
  }
  // The group's triangles, and those that face front.
  const render::TriangleJob& find_fronts(const StackGroup& group) {
    job_.triangles = group.draw_count > 0 ? mesh_.triangles()[group.first_draw].data() : nullptr;
    job_.triangle_count = group.draw_count;
    simd_ ? render::find_front_triangles_simd(job_, job_.fronts)
          : render::find_front_triangles_scalar(job_, job_.fronts);
    return job_;
  }
  // Copies entries that later groups need to the stack.
  void keep(const StackGroup& group) {
    for (const KeptEntry& kept : mesh_.kept().subspan(group.first_kept, group.kept_count)) {
      vertices_[kept.to] = vertices_[kept.from];
      texels_[kept.to] = texels_[kept.from];
    }
  }

 private:
  static constexpr std::size_t kEntries = kMaxStack + StackMesh::kMaxPushesPerGroup;
  static constexpr std::size_t kFronts = StackMesh::kMaxDrawsPerGroup + render::kFrontsSpare;

  const StackInstance& instance_;
  const StackMesh& mesh_;
  const bool simd_;
  const std::size_t room_;
  std::array<render::ScreenVertex, kEntries> vertices_;
  std::array<render::TexelPoint, kEntries> texels_;
  std::array<std::uint32_t, kFronts> numbers_;
  std::array<render::TriangleRows, kFronts> rows_;
  render::TriangleJob job_;
};

void join(const render::TriangleRows& rows, render::TriangleRows& io_all) {
  io_all.first = std::min(io_all.first, rows.first);
  io_all.end = std::max(io_all.end, rows.end);
}

bool touches(const render::TriangleRows& rows, const render::TriangleTarget& target) {
  return rows.first < target.row_end && rows.end > target.row_begin;
}

}  // namespace

std::span<const GroupRows> find_group_rows(const StackInstance& instance, bool simd, base::Arena& arena) {
  constexpr render::TriangleRows kNoRows{32767, 0};
  const StackMesh& mesh = *instance.mesh;
  const auto groups = mesh.groups();
  const std::span<GroupRows> all = arena.allocate_filled(groups.size(), GroupRows{kNoRows, kNoRows});
  StackRoom room(instance, simd);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    room.push(groups[i]);
    const render::FrontTriangles& fronts = room.find_fronts(groups[i]).fronts;
    for (std::size_t front = 0; front < fronts.count; ++front) join(fronts.rows[front], all[i].drawn);
    room.keep(groups[i]);
    join(all[i].drawn, all[i].needed);
    for (const std::uint32_t source : mesh.sources().subspan(groups[i].first_source, groups[i].source_count))
      join(all[i].drawn, all[source].needed);
  }
  return all;
}

void draw_groups(const StackInstance& instance, const StackKernels& kernels,
                 const render::TriangleTarget& target) {
  const auto groups = instance.mesh->groups();
  const std::span<const GroupRows> rows = instance.group_rows;
  StackRoom room(instance, kernels.simd);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!rows.empty() && !touches(rows[i].needed, target)) continue;
    room.push(groups[i]);
    if (rows.empty() || touches(rows[i].drawn, target)) {
      const render::TriangleJob& job = room.find_fronts(groups[i]);
      if (job.fronts.count > 0) draw_triangles(job, kernels, target);
    }
    room.keep(groups[i]);
  }
}

void draw_commands(const StackInstance& instance, const StackKernels& kernels,
                   const render::TriangleTarget& target, base::Arena& arena) {
  std::array<render::ScreenVertex, kMaxStack> vertices;
  std::array<render::TexelPoint, kMaxStack> texels;
  std::array<std::uint32_t, 3> corners;
  render::TriangleJob job = instance.skin;
  job.vertices = vertices.data();
  job.texels = texels.data();
  job.vertex_count = kMaxStack;
  job.triangles = corners.data();
  job.triangle_count = 1;
  RowPainter painter({kernels.format, kernels.simd}, target, arena);
  painter.begin_model(job);
  PushNumbers pushes(instance.mesh->groups());
  std::size_t depth = 0;
  for (const StackCommand& command : instance.mesh->stream().commands) {
    switch (command.kind) {
      case StackCommand::Kind::kPush: {
        const std::size_t push = pushes.next();
        transform(instance, false, push, 1, &vertices[depth]);
        texels[depth++] = instance.mesh->texels()[push];
        break;
      }
      case StackCommand::Kind::kPop:
        depth -= command.number;
        break;
      case StackCommand::Kind::kDraw:
        std::ranges::copy(command.positions, corners.begin());
        render::draw_affine_triangle(job, 0, target,
                                     [&](const render::TriangleSpan& span) { painter.add(span); });
        break;
    }
  }
  painter.draw();
}

}  // namespace temblor::lab
