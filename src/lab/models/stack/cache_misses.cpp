#include "lab/models/stack/cache_misses.h"

#include <array>

#include "lab/models/stack/cache_simulator.h"

namespace temblor::lab {

namespace {

constexpr std::size_t kTexelBytes = sizeof(render::TexelPoint), kVertexBytes = sizeof(render::ScreenVertex);
// On the screen only: to find front faces.
constexpr std::size_t kPointBytes = 2 * sizeof(std::int32_t);
constexpr std::size_t kEntryBytes = kVertexBytes + kTexelBytes;
constexpr std::size_t kLights = 256;

// Gives arrays their addresses, one after another.
class MemoryMap {
 public:
  std::uint64_t add(std::size_t bytes) {
    constexpr std::uint64_t kAlignment = 64;
    const std::uint64_t address = end_;
    end_ = (end_ + bytes + kAlignment - 1) / kAlignment * kAlignment;
    return address;
  }

 private:
  std::uint64_t end_ = 0;
};

// The numbers of the model's normals in its first pose, and which triangles face front.
class FirstPose {
 public:
  explicit FirstPose(const render::AliasModel& model) : model_(model) {}

  std::size_t element_bytes() const { return model_.is_wide() ? sizeof(std::uint16_t) : 1; }
  std::uint32_t element(std::size_t row, std::size_t vertex) const {
    const std::size_t at = row * model_.vertices_per_row + vertex;
    return model_.is_wide() ? model_.wide_poses[at] : model_.poses[at];
  }
  bool faces_front(const render::MeshTriangle& triangle) const {
    const auto side = [&](std::size_t corner, std::size_t row) {
      return std::int64_t{element(row, triangle[corner])} - element(row, triangle[0]);
    };
    return side(1, 1) * side(2, 2) > side(2, 1) * side(1, 2);
  }

 private:
  const render::AliasModel& model_;
};

// The poses that an instance blends, and the lights of normals.
class PoseMemory {
 public:
  PoseMemory(const FirstPose& pose, std::size_t row, MemoryMap& io_map)
      : pose_(pose), row_bytes_(row * pose.element_bytes()), lights_(io_map.add(kLights * sizeof(float))) {
    for (std::uint64_t& address : poses_) address = io_map.add(4 * row_bytes_);
  }

  // Transforms `vertex`, whose elements are number `at` of their rows.
  void transform(std::size_t vertex, std::size_t at, UseMemory use) const {
    const std::size_t bytes = pose_.element_bytes();
    for (const std::uint64_t pose : poses_) {
      for (std::size_t row = 0; row < 4; ++row) use(pose + row * row_bytes_ + at * bytes, bytes);
      use(lights_ + pose_.element(3, vertex) % kLights * sizeof(float), sizeof(float));
    }
  }

 private:
  const FirstPose& pose_;
  const std::size_t row_bytes_;
  const std::uint64_t lights_;
  std::array<std::uint64_t, 2> poses_{};
};

std::uint64_t count_misses(const CacheShape& shape, base::FunctionRef<void(UseMemory)> trace) {
  CacheSimulator cache(shape);
  const auto use = [&](std::uint64_t address, std::size_t bytes) { cache.touch(address, bytes); };
  trace(use);
  return cache.misses();
}

}  // namespace

void trace_vertex_list(const render::AliasModel& model, UseMemory use) {
  const FirstPose pose(model);
  MemoryMap map;
  const PoseMemory poses(pose, model.vertices_per_row, map);
  const std::uint64_t vertices = map.add(model.vertex_count * kVertexBytes);
  const std::uint64_t texels = map.add(model.vertex_count * kTexelBytes);
  const std::uint64_t triangles = map.add(model.triangles.size() * sizeof(render::MeshTriangle));
  for (std::size_t i = 0; i < model.vertex_count; ++i) {
    poses.transform(i, i, use);
    use(vertices + i * kVertexBytes, kVertexBytes);
  }
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    const render::MeshTriangle& triangle = model.triangles[i];
    use(triangles + i * sizeof(render::MeshTriangle), sizeof(render::MeshTriangle));
    for (const std::uint32_t vertex : triangle) use(vertices + vertex * kVertexBytes, kPointBytes);
    if (!pose.faces_front(triangle)) continue;
    for (const std::uint32_t vertex : triangle) {
      use(vertices + vertex * kVertexBytes, kVertexBytes);
      use(texels + vertex * kTexelBytes, kTexelBytes);
    }
  }
}

void trace_stack(const render::AliasModel& model, const StackMesh& mesh, UseMemory use) {
  const FirstPose pose(model);
  MemoryMap map;
  const PoseMemory poses(pose, mesh.push_row(), map);
  const std::uint64_t stack = map.add(mesh.sizes().places * kEntryBytes);
  const std::uint64_t texels = map.add(mesh.push_row() * kTexelBytes);
  const std::uint64_t triangles = map.add(model.triangles.size() * sizeof(render::MeshTriangle));
  std::size_t depth = 0, push = 0, draw = 0;
  for (const StackCommand& command : mesh.stream().commands) {
    switch (command.kind) {
      case StackCommand::Kind::kPush:
        poses.transform(command.number, push, use);
        use(texels + push * kTexelBytes, kTexelBytes);
        use(stack + depth * kEntryBytes, kEntryBytes);
        ++push;
        ++depth;
        break;
      case StackCommand::Kind::kPop:
        depth -= command.number;
        break;
      case StackCommand::Kind::kDraw:
        use(triangles + draw * sizeof(render::MeshTriangle), sizeof(render::MeshTriangle));
        ++draw;
        for (const std::uint8_t place : command.positions) use(stack + place * kEntryBytes, kPointBytes);
        if (!pose.faces_front(model.triangles[command.number])) break;
        for (const std::uint8_t place : command.positions) use(stack + place * kEntryBytes, kEntryBytes);
        break;
    }
  }
}

Counts count_vertex_work(const render::AliasModel& model, const StackMesh& mesh) {
  const auto of_list = [&](UseMemory use) { trace_vertex_list(model, use); };
  const auto of_stack = [&](UseMemory use) { trace_stack(model, mesh, use); };
  Counts counts;
  counts.vertices = model.vertex_count;
  counts.vertex_loads = mesh.stream().pushes;
  counts.model_triangles = model.triangles.size();
  counts.list_misses = count_misses(kPentiumCache, of_list);
  counts.stack_misses = count_misses(kPentiumCache, of_stack);
  counts.list_misses_today = count_misses(kTodaysCache, of_list);
  counts.stack_misses_today = count_misses(kTodaysCache, of_stack);
  return counts;
}

}  // namespace temblor::lab
