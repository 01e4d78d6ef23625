#include "support/pictures/viewpoints.h"

#include <algorithm>
#include <charconv>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include "base/check.h"
#include "math/angles.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

constexpr double kMaxMoved = 64;  // units

bool is_open(const world::Leaf& leaf) {
  return leaf.contents != world::Contents::kSolid && leaf.contents != world::Contents::kSky;
}

// Converts "*12" to 12, if the level has that model.
std::optional<world::ModelIndex> entity_brush_model(const world::Level& level,
                                                    const formats::Entity& entity) {
  const std::string_view model = entity.find("model").value_or("");
  if (!model.starts_with('*')) return std::nullopt;
  std::uint32_t number = 0;
  std::from_chars(model.data() + 1, model.data() + model.size(), number);
  if (number == 0 || number >= level.models.size()) return std::nullopt;
  return world::ModelIndex{number};
}

// The bounds of a leaf contain more than the leaf, so try points in them until one is in the leaf.
std::optional<math::Vec3> point_in_leaf(const world::Level& level, world::LeafIndex index,
                                        Random& io_random) {
  constexpr int kAttempts = 64;
  const math::Bounds& bounds = level.leaf(index).bounds;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    math::Vec3 point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float>(io_random.uniform(bounds.mins[axis], bounds.maxs[axis]));
    if (world::find_leaf(level, point) == index) return point;
  }
  return std::nullopt;
}

math::Vec3 random_open_point(const world::Level& level, Random& io_random) {
  constexpr int kAttempts = 10000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto index = base::to_index<world::LeafIndex>(1 + io_random.below(level.visible_leaf_count));
    if (!is_open(level.leaf(index))) continue;
    if (const auto point = point_in_leaf(level, index, io_random)) return *point;
  }
  CHECK(false, "level {} has no open leaf", level.name);
}

// The bounds in the world of a brush model that has moved and turned about z.
math::Bounds measure_bounds(const world::Level& level, const render::BrushModelInstance& instance) {
  const math::Bounds& bounds = level.models[base::to_size(instance.model)].bounds;
  const math::Basis basis = math::basis_from_angles(instance.angles_deg);
  const math::Vec3 middle = (bounds.mins + bounds.maxs) * 0.5f, half = (bounds.maxs - bounds.mins) * 0.5f;
  const math::Vec3 x_axis(basis.forward), y_axis(-basis.right), z_axis(basis.up);
  const math::Vec3 middle_world =
      instance.origin_world + x_axis * middle.x + y_axis * middle.y + z_axis * middle.z;
  const math::Vec3 half_world =
      glm::abs(x_axis) * half.x + glm::abs(y_axis) * half.y + glm::abs(z_axis) * half.z;
  return {middle_world - half_world, middle_world + half_world};
}

bool overlap(const math::Bounds& a, const math::Bounds& b) {
  return glm::all(glm::lessThan(a.mins, b.maxs)) && glm::all(glm::lessThan(b.mins, a.maxs));
}

}  // namespace

render::Scene Viewpoint::scene(const world::Level& level) const {
  return {.level = &level,
          .camera = camera,
          .brush_models = brush_models,
          .lights = lights,
          .marks = &marks,
          .time_s = time_s,
          .light_styles = world::compute_light_styles(world::make_standard_light_styles(), time_s)};
}

std::vector<render::BrushModelInstance> shown_brush_models(const world::Level& level) {
  std::vector<render::BrushModelInstance> shown;
  for (const formats::Entity& entity : level.entities) {
    const auto model = entity_brush_model(level, entity);
    if (!model || entity.classname().starts_with("trigger_")) continue;
    shown.push_back({.model = *model, .origin_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f))});
  }
  return shown;
}

void displace(const world::Level& level, std::span<render::BrushModelInstance> io_brush_models,
              Random& io_random) {
  constexpr int kAttempts = 8;
  for (render::BrushModelInstance& instance : io_brush_models) {
    const render::BrushModelInstance at_home = instance;
    const auto is_clear = [&](const math::Bounds& bounds) {
      return std::none_of(io_brush_models.begin(), io_brush_models.end(), [&](const auto& other) {
        return &other != &instance && overlap(bounds, measure_bounds(level, other));
      });
    };
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      instance = at_home;
      instance.origin_world += io_random.in_cube(kMaxMoved);
      if (io_random.below(3) == 0) instance.angles_deg.y = static_cast<float>(io_random.uniform(0, 360));
      if (is_clear(measure_bounds(level, instance))) break;
      instance = at_home;
    }
  }
}

render::Camera random_camera(const world::Level& level, Random& io_random) {
  render::Camera camera;
  camera.origin_world = random_open_point(level, io_random);
  const double pitch_range_deg = io_random.chance(0.7) ? 25 : 90;
  const double pitch_deg = io_random.uniform(-pitch_range_deg, pitch_range_deg);
  const double yaw_deg = io_random.uniform(0, 360);
  const double roll_deg = io_random.chance(0.8) ? 0 : io_random.uniform(-180, 180);
  camera.angles_deg = math::Vec3(math::Vec3d(pitch_deg, yaw_deg, roll_deg));
  if (io_random.chance(0.2)) camera.fov_deg = static_cast<float>(io_random.uniform(10, 150));
  return camera;
}

std::vector<render::Camera> player_cameras(const world::Level& level) {
  constexpr float kEyeHeight = 22;
  std::vector<render::Camera> cameras;
  for (const formats::Entity& entity : level.entities) {
    const std::string_view classname = entity.classname();
    if (!classname.starts_with("info_player") && classname != "info_teleport_destination") continue;
    render::Camera camera;
    camera.origin_world =
        entity.find_vec3("origin").value_or(math::Vec3(0.0f)) + math::Vec3(0, 0, kEyeHeight);
    camera.angles_deg.y = entity.find_number("angle").value_or(0);
    cameras.push_back(camera);
  }
  return cameras;
}

std::vector<render::DynamicLight> random_lights(const math::Vec3& middle_world, std::size_t max_count,
                                                Random& io_random) {
  std::vector<render::DynamicLight> lights(io_random.below(max_count + 1));
  for (render::DynamicLight& light : lights) {
    light.origin_world = middle_world + io_random.in_cube(200);
    light.radius = static_cast<float>(io_random.uniform(20, 400));
    if (io_random.chance(0.5)) light.least = static_cast<float>(io_random.uniform(0, 40));
    if (io_random.chance(0.5)) light.color = glm::abs(io_random.in_cube(2));
  }
  return lights;
}

render::MarkSet random_marks(const world::Level& level, std::size_t count, Random& io_random) {
  render::MarkSet marks;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = base::to_index<world::FaceIndex>(io_random.below(level.faces.size()));
    const world::Face& face = level.face(number);
    const std::size_t corner = face.first_surfedge + io_random.below(face.surfedge_count);
    marks.add(number, {.kind = static_cast<render::MarkKind>(io_random.below(3)),
                       .position_model = level.vertices[level.surfedge_start(corner)] + io_random.in_cube(8),
                       .radius = static_cast<float>(io_random.log_uniform(1, 64)),
                       .seed = static_cast<std::uint32_t>(io_random.bits())});
  }
  return marks;
}

}  // namespace temblor::test
