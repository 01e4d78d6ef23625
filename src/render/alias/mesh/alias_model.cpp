#include "render/alias_model.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/check.h"
#include "formats/models/group_time.h"
#include "render/alias/alias_mesh.h"

namespace temblor::render {

namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

// Numbers the vertices of the mesh: one for each vertex of the file and side of the skin that a triangle
// uses.
class VertexSplitter {
 public:
  VertexSplitter(const formats::Mdl& mdl, AliasModel& io_model)
      : mdl_(mdl), model_(io_model), numbers_(mdl.texels.size(), {kUnused, kUnused}) {}

  void split() {
    for (const formats::MdlTriangle& triangle : mdl_.triangles) {
      MeshTriangle& split = model_.triangles.emplace_back();
      for (std::size_t corner = 0; corner < 3; ++corner)
        split[corner] = mesh_vertex(triangle.vertices[corner], triangle.faces_front);
    }
    // A model without triangles draws nothing, but rows must not be empty.
    if (sources_.empty()) mesh_vertex(0, true);
  }

  // By vertex of the mesh: the file's vertex that it comes from.
  const std::vector<std::uint32_t>& sources() const { return sources_; }

 private:
  std::uint32_t mesh_vertex(std::uint32_t vertex, bool front) {
    const formats::MdlTexel& texel = mdl_.texels[vertex];
    const bool shifted = texel.on_seam && !front;
    std::uint32_t& number = numbers_[vertex][shifted ? 1 : 0];
    if (number != kUnused) return number;
    number = static_cast<std::uint32_t>(sources_.size());
    sources_.push_back(vertex);
    const std::int64_t s = std::int64_t{texel.s} + (shifted ? mdl_.skin_width / 2 : 0);
    model_.texels.push_back(
        {middle_of_texel(s, mdl_.skin_width), middle_of_texel(texel.t, mdl_.skin_height)});
    return number;
  }

  static float middle_of_texel(std::int64_t texel, std::uint32_t size) {
    return static_cast<float>(std::clamp<std::int64_t>(texel, 0, std::int64_t{size} - 1)) + 0.5f;
  }

  const formats::Mdl& mdl_;
  AliasModel& model_;
  std::vector<std::array<std::uint32_t, 2>> numbers_;
  std::vector<std::uint32_t> sources_;
};

// Fills the padding at the end of each row with the last vertex.
void append_pose(const formats::MdlPose& pose, const std::vector<std::uint32_t>& sources,
                 AliasModel& io_model) {
  const std::size_t row = io_model.vertices_per_row;
  const std::size_t first = io_model.poses.size();
  io_model.poses.resize(first + 4 * row);
  std::uint8_t* out = io_model.poses.data() + first;
  for (std::size_t i = 0; i < row; ++i) {
    const formats::MdlVertex& vertex = pose.vertices[sources[std::min(i, sources.size() - 1)]];
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis * row + i] = vertex.position[axis];
    out[3 * row + i] = vertex.normal;
  }
}

// Computes the bounds of all poses from the extremes of their bytes.
math::Bounds compute_bounds(const AliasModel& model) {
  std::array<std::uint8_t, 3> least{255, 255, 255}, most{0, 0, 0};
  for (std::size_t number = 0; number < model.pose_count(); ++number) {
    const PoseBytes pose = model.pose(base::to_index<PoseIndex>(number));
    const std::array<const std::uint8_t*, 3> rows = {pose.x, pose.y, pose.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(rows[axis], rows[axis] + model.vertex_count);
      least[axis] = std::min(least[axis], *low);
      most[axis] = std::max(most[axis], *high);
    }
  }
  const auto position = [&](const std::array<std::uint8_t, 3>& bytes) {
    return math::Vec3(bytes[0], bytes[1], bytes[2]) * model.scale + model.origin;
  };
  // A scale may be negative.
  const math::Vec3 a = position(least), b = position(most);
  return {glm::min(a, b), glm::max(a, b)};
}

// Returns the first pose, relative to the model's origin.
std::vector<math::Vec3d> decode_first_pose(const AliasModel& model) {
  const PoseBytes pose = model.pose(PoseIndex{0});
  std::vector<math::Vec3d> positions;
  for (std::size_t i = 0; i < model.vertex_count; ++i)
    positions.push_back(math::Vec3d(pose.x[i], pose.y[i], pose.z[i]) * math::Vec3d(model.scale));
  return positions;
}

std::uint32_t member_at(const AnimatedMembers& members, double time_s) {
  const std::size_t member = formats::find_group_member(members.end_times_s, time_s);
  return members.first + static_cast<std::uint32_t>(std::min<std::size_t>(member, members.count - 1));
}

// Numbers that do not exist select number 0.
const AnimatedMembers& numbered(const std::vector<AnimatedMembers>& all, std::uint32_t number) {
  return all[number < all.size() ? number : 0];
}

}  // namespace

double compute_mean_side(std::span<const MeshTriangle> triangles, std::span<const math::Vec3d> positions) {
  double sum = 0;
  for (const MeshTriangle& triangle : triangles)
    for (std::size_t corner = 0; corner < 3; ++corner)
      sum += glm::distance(positions[triangle[corner]], positions[triangle[(corner + 1) % 3]]);
  return sum / static_cast<double>(std::max<std::size_t>(1, triangles.size() * 3));
}

std::shared_ptr<const AliasModel> make_alias_model(const formats::Mdl& mdl, std::string name) {
  CHECK(mdl.skin_width > 0 && mdl.skin_height > 0 && !mdl.frames.empty() && !mdl.skins.empty() &&
            !mdl.texels.empty(),
        "{}", name);
  auto model = std::make_shared<AliasModel>();
  model->name = std::move(name);
  model->flags = mdl.flags;
  model->random_phase = mdl.random_phase;
  model->scale = mdl.scale;
  model->origin = mdl.origin;
  model->skin_width = mdl.skin_width;
  model->skin_height = mdl.skin_height;

  VertexSplitter splitter(mdl, *model);
  splitter.split();
  model->vertex_count = splitter.sources().size();
  model->vertices_per_row = (model->vertex_count + AliasModel::kRowMultiple - 1) / AliasModel::kRowMultiple *
                            AliasModel::kRowMultiple;
  std::uint32_t pose_count = 0;
  for (const formats::MdlFrame& frame : mdl.frames) {
    const auto count = static_cast<std::uint32_t>(frame.poses.size());
    model->frames.push_back({pose_count, count, frame.end_times_s});
    pose_count += count;
    for (const formats::MdlPose& pose : frame.poses) append_pose(pose, splitter.sources(), *model);
  }
  model->bounds = compute_bounds(*model);
  model->mean_side = static_cast<float>(compute_mean_side(model->triangles, decode_first_pose(*model)));

  std::uint32_t picture_count = 0;
  for (const formats::MdlSkin& skin : mdl.skins) {
    const auto count = static_cast<std::uint32_t>(skin.pictures.size());
    model->skins.push_back({picture_count, count, skin.end_times_s});
    picture_count += count;
    for (const std::vector<std::uint8_t>& picture : skin.pictures)
      model->skin_texels.insert(model->skin_texels.end(), picture.begin(), picture.end());
  }
  return model;
}

PoseIndex pose_at(const AliasModel& model, std::uint32_t frame, double time_s) {
  return PoseIndex{member_at(numbered(model.frames, frame), time_s)};
}

std::uint32_t skin_at(const AliasModel& model, std::uint32_t skin, double time_s) {
  return member_at(numbered(model.skins, skin), time_s);
}

std::uint32_t find_model_flags(const AliasModel& model) {
  return model.flags;
}

bool has_random_phase(const AliasModel& model) {
  return model.random_phase;
}

std::uint32_t frame_count(const AliasModel& model) {
  return static_cast<std::uint32_t>(model.frames.size());
}

std::uint32_t skin_count(const AliasModel& model) {
  return static_cast<std::uint32_t>(model.skins.size());
}

const std::string& model_name(const AliasModel& model) {
  return model.name;
}

const math::Bounds& model_bounds(const AliasModel& model) {
  return model.bounds;
}

math::Vec3 find_foremost_point(const AliasModel& model) {
  const auto find = [&](const auto& pose) {
    constexpr float kReach = 1;
    const auto vertex = [&](std::size_t i) {
      return math::Vec3(pose.x[i], pose.y[i], pose.z[i]) * model.scale + model.origin;
    };
    float front = vertex(0).x;
    for (std::size_t i = 1; i < model.vertex_count; ++i) front = std::max(front, vertex(i).x);
    math::Vec3 sum(0.0f);
    float count = 0;
    for (std::size_t i = 0; i < model.vertex_count; ++i)
      if (vertex(i).x >= front - kReach) {
        sum += vertex(i);
        ++count;
      }
    return sum / count;
  };
  return model.is_wide() ? find(model.wide_pose(PoseIndex{})) : find(model.pose(PoseIndex{}));
}

}  // namespace temblor::render
