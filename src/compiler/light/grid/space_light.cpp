#include "compiler/light/grid/space_light.h"

#include <algorithm>
#include <cmath>

#include "compiler/light/sources/directions.h"
#include "world/face_at.h"

namespace temblor::compiler {
namespace {

constexpr int kBounceRays = 64;              // of each point, over the whole sphere
constexpr float kFarthest = 1 << 20;         // longer than any level
constexpr std::uint32_t kModelChannels = 1;  // of models of other files

// The mean of angle_factor() over the hemisphere of normals that face the light.
float find_mean_angle_factor(float angle_scale) {
  return 1 - angle_scale / 2;
}

// The luxel of a light map that is nearest to a point on its face.
std::size_t find_luxel(const LitLevel& lit, const LightMapShape& map, const math::Vec3& point_world) {
  const world::TextureAxes& axes = lit.level->texture_axes[lit.level->faces[map.face].axes];
  const math::Vec3 local = point_world - lit.model_offset(map.face);
  const auto nearest = [&](float texel, std::size_t axis, std::int32_t luxels) {
    const float luxel = (texel - static_cast<float>(map.texture_mins[axis])) / static_cast<float>(map.texels);
    return static_cast<std::size_t>(std::clamp(std::round(luxel), 0.0f, static_cast<float>(luxels - 1)));
  };
  const std::size_t column = nearest(glm::dot(local, axes.s_axis) + axes.s_offset, 0, map.width);
  const std::size_t row = nearest(glm::dot(local, axes.t_axis) + axes.t_offset, 1, map.height);
  return row * static_cast<std::size_t>(map.width) + column;
}

// Lights the points of one block.
class SpaceLighter {
 public:
  SpaceLighter(const SpaceLightInput& input, const SamplePoints& places)
      : input_(input), points_(places.points), arriving_(points_.size()) {
    std::vector<world::LeafIndex> leaves = places.leaves;
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    for (std::size_t i = 0; i < input.lights.size(); ++i)
      if ((input.lights[i].channels & kModelChannels) != 0 && input.sight.light_may_reach(i, leaves))
        add(input.lights[i]);
    if (input.scene.has_sky() && !input.beams.empty() && input.sight.sky_may_reach(leaves))
      for (const SkyBeam& beam : input.beams) add(beam);
    if (input.settings.bounce.count > 0) add_first_bounce();
  }

  FaceLight take() && { return std::move(light_); }

 private:
  void add(const LightSource& light) {
    clear();
    const bool is_minimum = light.attenuation == Attenuation::kLocalMinlight;
    const float angle = is_minimum ? 1 : find_mean_angle_factor(light.angle_scale);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const math::Vec3 way = light.origin_world - points_[i];
      const float distance = glm::length(way);
      float value = value_at(light, distance) * angle;
      if (light.cone && distance > 0) value *= cone_factor(*light.cone, way / distance);
      if (std::abs(value) > kLightGate) push(i, value);
    }
    if (lit_points_.empty()) return;
    LightPath path;
    path.shadow_channels = light.shadow_channels;
    input_.scene.trace_to_point(lit_places_, light.origin_world, shares_, path);
    if (light.projection)
      for (std::size_t i = 0; i < shares_.size(); ++i)
        shares_[i] *=
            find_projected_color(input_.projections[*light.projection], lit_places_[i] - light.origin_world);
    const LayerKind kind = is_minimum        ? LayerKind::kRaise
                           : light.value < 0 ? LayerKind::kSubtract
                                             : LayerKind::kAdd;
    deposit(light.color, light.style, kind);
  }

  void add(const SkyBeam& beam) {
    clear();
    for (std::size_t i = 0; i < points_.size(); ++i)
      push(i, beam.value * find_mean_angle_factor(beam.angle_scale));
    LightPath path;
    path.sky_name = beam.sky_name;
    input_.scene.trace_to_sky(lit_places_, beam.toward_sky, shares_, path);
    deposit(beam.color, beam.style, beam.value < 0 ? LayerKind::kSubtract : LayerKind::kAdd);
  }

  // Each ray brings a part of the light of the luxel that it meets.
  void add_first_bounce() {
    std::vector<math::Vec3> directions(points_.size());
    std::vector<RayHit> hits(points_.size());
    for (int ray = 0; ray < kBounceRays; ++ray) {
      const math::Vec3 direction = cap_direction(ray, kBounceRays, -1);
      std::fill(directions.begin(), directions.end(), direction);
      input_.scene.find_nearest(points_, directions, kFarthest, hits);
      for (std::size_t i = 0; i < points_.size(); ++i)
        if (hits[i].surface != RayHit::kNone)
          add_bounce(i, hits[i].surface, direction, points_[i] + direction * hits[i].distance);
    }
  }

  void add_bounce(std::size_t point, std::size_t face, const math::Vec3& direction,
                  const math::Vec3& met_world) {
    const world::Level& level = *input_.lit.level;
    const math::Vec3 share = input_.first_bounces[face] / float{kBounceRays};
    const bool is_front =
        glm::dot(math::Vec3d(direction), world::compute_face_plane(level, level.faces[face]).normal) < 0;
    if (!is_front || share == math::Vec3(0.0f)) return;
    const std::size_t luxel = find_luxel(input_.lit, input_.lit.maps[face], met_world);
    for (const LightLayer& from : input_.face_light[face].layers)
      if ((from.kind == LayerKind::kAdd || from.kind == LayerKind::kBounceMore) &&
          (from.style == 0 || input_.settings.bounce.styled))
        light_.layer(from.style, LayerKind::kAdd, points_.size()).samples[point] +=
            from.samples[luxel] * share;
  }

  void clear() {
    lit_points_.clear();
    lit_places_.clear();
  }
  void push(std::size_t point, float value) {
    arriving_[lit_points_.size()] = std::abs(value);
    lit_points_.push_back(point);
    lit_places_.push_back(points_[point]);
    shares_.resize(lit_points_.size());
  }
  // Adds what arrives of a light, according to `shares_`.
  void deposit(const math::Vec3& color, std::uint8_t style, LayerKind kind) {
    if (std::all_of(shares_.begin(), shares_.end(),
                    [](const math::Vec3& share) { return share == math::Vec3(0.0f); }))
      return;
    std::vector<math::Vec3>& samples = light_.layer(style, kind, points_.size()).samples;
    for (std::size_t i = 0; i < lit_points_.size(); ++i) {
      math::Vec3& sample = samples[lit_points_[i]];
      const math::Vec3 light = color * shares_[i] * arriving_[i];
      sample = kind == LayerKind::kRaise ? glm::max(sample, light) : sample + light;
    }
  }

  const SpaceLightInput& input_;
  std::span<const math::Vec3> points_;
  // For the current light: the points that it may reach, their places, what arrives there without obstacles,
  // and the share that does.
  std::vector<std::size_t> lit_points_;
  std::vector<math::Vec3> lit_places_;
  std::vector<float> arriving_;
  std::vector<math::Vec3> shares_;
  FaceLight light_;
};

}  // namespace

FaceLight compute_space_light(const SpaceLightInput& input, const SamplePoints& places) {
  return SpaceLighter(input, places).take();
}

}  // namespace temblor::compiler
