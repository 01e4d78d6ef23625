#include "world/sample_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "world/light/sample_grid.h"

namespace temblor::world {
namespace {

constexpr double kReach = 2048;  // units
constexpr int kTexelsPerSample = 16;
// Units. A line that hits the edge of a face must not slip through between that face and its neighbor.
constexpr double kEdgeSlack = 1.0 / 16;

// The part of the line beyond a plane, which is walked if there is no face in that plane.
struct Beyond {
  NodeIndex node;
  std::size_t far_side;
  double cut_z, end_z;
};

// A stack without heap allocations for trees of ordinary depth.
class BeyondStack {
 public:
  void push(const Beyond& beyond) {
    if (size_ < first_.size())
      first_[size_] = beyond;
    else
      rest_.push_back(beyond);
    ++size_;
  }
  std::optional<Beyond> pop() {
    if (size_ == 0) return std::nullopt;
    --size_;
    if (size_ < first_.size()) return first_[size_];
    const Beyond beyond = rest_.back();
    rest_.pop_back();
    return beyond;
  }

 private:
  std::array<Beyond, 64> first_;
  std::vector<Beyond> rest_;
  std::size_t size_ = 0;
};

// Returns whether a point in the face's plane is inside of the face: not farther than kEdgeSlack outside of
// any edge.
bool face_contains(const Level& level, const Face& face, const math::Vec3d& point) {
  const math::Vec3d normal = math::Vec3d(level.planes[face.plane].normal) * (face.back_side ? -1.0 : 1.0);
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const std::uint32_t next = i + 1 < face.surfedge_count ? i + 1 : 0;
    const math::Vec3d a(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    const math::Vec3d b(level.vertices[level.surfedge_start(face.first_surfedge + next)]);
    const math::Vec3d outward = glm::cross(b - a, normal) * -1.0;
    if (glm::dot(outward, point - a) > kEdgeSlack * glm::length(outward)) return false;
  }
  return true;
}

// One axis of the light map: the samples before and after the point, and its fraction of the way.
struct SampleStep {
  std::size_t before, after;
  float fraction;
};
SampleStep find_samples(double along, std::int32_t samples) {
  const double position = std::clamp(along, 0.0, double{samples - 1.0});
  const auto before = static_cast<std::size_t>(position);
  return {before, std::min(before + 1, static_cast<std::size_t>(samples - 1)),
          static_cast<float>(position - static_cast<double>(before))};
}

// Returns the position of a point of the face in its light map: sample (x, y) lies at (x, y).
math::Vec2d find_light_position(const Level& level, const Face& face, const math::Vec3d& point) {
  const TextureAxes& axes = level.texture_axes[face.axes];
  const double s =
      glm::dot(point, math::Vec3d(axes.s_axis)) + double{axes.s_offset} - double(face.texture_mins[0]);
  const double t =
      glm::dot(point, math::Vec3d(axes.t_axis)) + double{axes.t_offset} - double(face.texture_mins[1]);
  if (face.light_map_grid == kStockGrid) return {s / kTexelsPerSample, t / kTexelsPerSample};
  return level.light_map_grids[face.light_map_grid].position(s, t);
}

// Bilinear interpolation between four samples, summed over the face's light styles.
PointLight interpolate_light(const Level& level, const Face& face, const LightStyleValues& styles,
                             const math::Vec3d& point) {
  const auto [columns, rows] = level.light_size(face);
  const math::Vec2d position = find_light_position(level, face, point);
  const SampleStep s = find_samples(position.x, columns), t = find_samples(position.y, rows);
  const auto width = static_cast<std::size_t>(columns);
  const std::size_t style_samples = width * static_cast<std::size_t>(rows);
  // Each sample of `light` has `channels` values; this reads number `channel`.
  const auto between = [&](const std::vector<std::uint8_t>& light, std::size_t first, std::size_t channels,
                           std::size_t channel) {
    const auto at = [&](std::size_t row, std::size_t column) {
      return static_cast<float>(light[(first + row * width + column) * channels + channel]);
    };
    const float above = at(t.before, s.before) * (1 - s.fraction) + at(t.before, s.after) * s.fraction;
    const float below = at(t.after, s.before) * (1 - s.fraction) + at(t.after, s.after) * s.fraction;
    return above * (1 - t.fraction) + below * t.fraction;
  };
  PointLight sum;
  for (std::size_t i = 0; i < face.style_count; ++i) {
    const float style = static_cast<float>(styles[face.styles[i]]) / 256;
    const std::size_t first = face.light + i * style_samples;
    sum.gray += between(level.light, first, 1, 0) * style;
    if (level.light_rgb.empty()) continue;
    for (std::size_t channel = 0; channel < 3; ++channel)
      sum.rgb[static_cast<int>(channel)] += between(level.light_rgb, first, 3, channel) * style;
  }
  if (level.light_rgb.empty()) sum.rgb = math::Vec3(sum.gray);
  return sum;
}

// Returns the light at a point in the node's plane, or nullopt if no lit face contains the point.
std::optional<PointLight> find_light_in_plane(const Level& level, const Node& node,
                                              const LightStyleValues& styles, const math::Vec3d& point) {
  for (std::uint32_t i = 0; i < node.face_count; ++i) {
    const Face& face = level.faces[node.first_face + i];
    if (face.kind != FaceKind::kLit || !face_contains(level, face, point)) continue;
    return face.light == kNoLight ? PointLight{} : interpolate_light(level, face, styles, point);
  }
  return std::nullopt;
}

PointLight sample_floor(const Level& level, const LightStyleValues& styles, const math::Vec3& point_world) {
  const auto point_at = [&](double z) { return math::Vec3d(point_world.x, point_world.y, z); };
  const auto height_over = [&](const Plane& plane, double z) {
    return glm::dot(point_at(z), math::Vec3d(plane.normal)) - double{plane.distance};
  };
  BeyondStack stack;
  Child at = level.world().head;
  double begin_z = point_world.z, end_z = begin_z - kReach;
  while (true) {
    // Descend to the leaf that contains the start of the remaining line; stack the parts beyond planes.
    while (!at.is_leaf()) {
      const Plane& plane = level.planes[level.node(at.node()).plane];
      const double begin = height_over(plane, begin_z), end = height_over(plane, end_z);
      const std::size_t near_side = begin >= 0 ? 0 : 1;
      if ((begin >= 0) != (end >= 0)) {
        const double cut_z = begin_z + (end_z - begin_z) * std::clamp(begin / (begin - end), 0.0, 1.0);
        stack.push({at.node(), 1 - near_side, cut_z, end_z});
        end_z = cut_z;
      }
      at = level.node(at.node()).children[near_side];
    }
    const std::optional<Beyond> beyond = stack.pop();
    if (!beyond) return {};
    const Node& node = level.node(beyond->node);
    if (const auto light = find_light_in_plane(level, node, styles, point_at(beyond->cut_z))) return *light;
    at = node.children[beyond->far_side];
    begin_z = beyond->cut_z;
    end_z = beyond->end_z;
  }
}

}  // namespace

PointLight sample_light(const Level& level, const LightStyleValues& styles, const math::Vec3& point_world) {
  if (!level.has_light) return {255, math::Vec3(255.0f)};
  if (level.light_grid)
    if (const auto light = sample_light_grid(*level.light_grid, styles, point_world)) return *light;
  return sample_floor(level, styles, point_world);
}

}  // namespace temblor::world
