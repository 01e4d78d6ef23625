#include "lab/models/stack/stack_mesh.h"

#include <algorithm>
#include <cstring>

#include "base/check.h"

namespace temblor::lab {

namespace {

// The bytes of a model's first pose.
std::span<const std::uint8_t> find_first_pose(const render::AliasModel& model) {
  const std::size_t elements = 4 * model.vertices_per_row;
  if (model.is_wide())
    return {reinterpret_cast<const std::uint8_t*>(model.wide_poses.data()), elements * sizeof(std::uint16_t)};
  return {model.poses.data(), elements};
}

template <typename Element>
std::vector<Element> order_poses(std::span<const Element> poses, std::size_t row,
                                 std::span<const std::uint32_t> vertices) {
  std::vector<Element> ordered;
  ordered.reserve(poses.size() / std::max<std::size_t>(row, 1) * vertices.size());
  for (std::size_t first = 0; first < poses.size(); first += row)
    for (const std::uint32_t vertex : vertices) ordered.push_back(poses[first + vertex]);
  return ordered;
}

// Groups the commands of a stream: StackMesh's lists.
class CommandGrouper {
 public:
  explicit CommandGrouper(const StackSizes& sizes) : sizes_(sizes) {}

  void add(const StackCommand& command) {
    switch (command.kind) {
      case StackCommand::Kind::kPush:
        if (group_.push_count == sizes_.pushes_per_group) end_group();
        stack_.push_back({static_cast<std::uint32_t>(sizes_.places) + group_.push_count++, number()});
        vertices.push_back(command.number);
        break;
      case StackCommand::Kind::kPop:
        stack_.resize(stack_.size() - command.number);
        break;
      case StackCommand::Kind::kDraw:
        if (group_.draw_count == StackMesh::kMaxDrawsPerGroup) end_group();
        ++group_.draw_count;
        triangles.push_back(
            {use(command.positions[0]), use(command.positions[1]), use(command.positions[2])});
        break;
    }
  }

  // Keeps the entries of the room that are still in the stack.
  void end_group() {
    for (std::uint32_t place = 0; place < stack_.size(); ++place) {
      if (stack_[place].at < sizes_.places) continue;
      kept.push_back({static_cast<std::uint8_t>(stack_[place].at), static_cast<std::uint8_t>(place)});
      stack_[place].at = place;
    }
    group_.kept_count = static_cast<std::uint32_t>(kept.size()) - group_.first_kept;
    group_.source_count = static_cast<std::uint32_t>(sources.size()) - group_.first_source;
    if (group_.push_count + group_.draw_count > 0) groups.push_back(group_);
    while (vertices.size() % StackMesh::kPushesAtOnce != 0) vertices.push_back(vertices.back());
    group_ = {};
    group_.first_push = static_cast<std::uint32_t>(vertices.size());
    group_.first_draw = static_cast<std::uint32_t>(triangles.size());
    group_.first_kept = static_cast<std::uint32_t>(kept.size());
    group_.first_source = static_cast<std::uint32_t>(sources.size());
  }

  std::vector<StackGroup> groups;
  std::vector<render::MeshTriangle> triangles;
  std::vector<KeptEntry> kept;
  std::vector<std::uint32_t> sources;
  std::vector<std::uint32_t> vertices;

 private:
  struct Entry {
    std::uint32_t at;  // in the stack or in the room
    std::uint32_t group;
  };

  std::uint32_t number() const { return static_cast<std::uint32_t>(groups.size()); }

  std::uint32_t use(std::uint8_t position) {
    const Entry& entry = stack_[position];
    const auto own = std::span(sources).subspan(group_.first_source);
    if (entry.group != number() && std::ranges::find(own, entry.group) == own.end())
      sources.push_back(entry.group);
    return entry.at;
  }

  const StackSizes sizes_;
  std::vector<Entry> stack_;
  StackGroup group_{};
};

}  // namespace

StackMesh::StackMesh(const render::AliasModel& model, const StackSizes& sizes)
    : sizes_(sizes),
      model_triangles_(model.triangles),
      model_texels_(model.texels),
      model_poses_(find_first_pose(model).data()),
      first_pose_(find_first_pose(model).begin(), find_first_pose(model).end()),
      stream_(find_command_stream(model.triangles, model.vertex_count, sizes.places)) {
  CHECK(sizes.pushes_per_group > 0 && sizes.pushes_per_group <= kMaxPushesPerGroup &&
            sizes.pushes_per_group % kPushesAtOnce == 0,
        "{}", sizes.pushes_per_group);
  group_commands();
  order_vertices(model);
}

bool StackMesh::match(const render::AliasModel& model) const {
  const auto same = [](const render::TexelPoint& a, const render::TexelPoint& b) {
    return a.s == b.s && a.t == b.t;
  };
  const auto first_pose = find_first_pose(model);
  return first_pose.data() == model_poses_ && std::ranges::equal(first_pose, first_pose_) &&
         model.triangles == model_triangles_ && std::ranges::equal(model.texels, model_texels_, same);
}

std::size_t StackMesh::size_bytes() const {
  return groups_.size() * sizeof(StackGroup) + triangles_.size() * sizeof(render::MeshTriangle) +
         kept_.size() * sizeof(KeptEntry) + texels_.size() * sizeof(render::TexelPoint) + poses_.size() +
         wide_poses_.size() * sizeof(std::uint16_t);
}

void StackMesh::group_commands() {
  CommandGrouper grouper(sizes_);
  for (const StackCommand& command : stream_.commands) grouper.add(command);
  grouper.end_group();
  groups_ = std::move(grouper.groups);
  triangles_ = std::move(grouper.triangles);
  kept_ = std::move(grouper.kept);
  sources_ = std::move(grouper.sources);
  vertices_ = std::move(grouper.vertices);
}

void StackMesh::order_vertices(const render::AliasModel& model) {
  row_ = vertices_.size();
  texels_.reserve(row_);
  for (const std::uint32_t vertex : vertices_) texels_.push_back(model.texels[vertex]);
  poses_ = order_poses<std::uint8_t>(model.poses, model.vertices_per_row, vertices_);
  wide_poses_ = order_poses<std::uint16_t>(model.wide_poses, model.vertices_per_row, vertices_);
}

}  // namespace temblor::lab
