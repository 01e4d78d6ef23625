#include "app/level/viewpoints.h"

#include <array>
#include <optional>
#include <utility>

namespace temblor::app {
namespace {

constexpr std::string_view kIntermission = "info_intermission";
// In order of preference for a first view.
constexpr std::array<std::string_view, 5> kViewpointClasses = {"info_player_start", "info_player_deathmatch",
                                                               "info_player_coop",
                                                               "info_teleport_destination", kIntermission};

// Returns nothing for an entity of any other class.
std::optional<Viewpoint> make_viewpoint(const formats::Entity& entity) {
  const std::string_view classname = entity.classname();
  for (const std::string_view known : kViewpointClasses) {
    if (classname != known) continue;
    Viewpoint viewpoint;
    viewpoint.classname = classname;
    viewpoint.eye_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
    // An intermission entity is a camera, not a player: no eye height, and all three angles.
    if (known == kIntermission) {
      viewpoint.angles_deg = entity.find_vec3("mangle").value_or(math::Vec3(0.0f));
    } else {
      viewpoint.eye_world.z += kEyeHeight;
      viewpoint.angles_deg.y = entity.find_number("angle").value_or(0.0f);
    }
    return viewpoint;
  }
  return std::nullopt;
}

}  // namespace

math::Vec3 level_center(const world::Level& level) {
  const math::Bounds& bounds = level.world().bounds;
  return (bounds.mins + bounds.maxs) * 0.5f;
}

double level_diagonal(const world::Level& level) {
  const math::Bounds& bounds = level.world().bounds;
  return glm::length(math::Vec3d(bounds.maxs) - math::Vec3d(bounds.mins));
}

// Classes in order of preference, then entities in order of the level.
Viewpoint find_start_viewpoint(const world::Level& level, const world::SpawnRules& rules) {
  std::array classes = kViewpointClasses;
  if (rules.deathmatch) std::swap(classes[0], classes[1]);
  for (const std::string_view wanted : classes)
    for (const formats::Entity& entity : level.entities)
      if (entity.classname() == wanted && !world::is_excluded(entity, rules))
        if (auto viewpoint = make_viewpoint(entity)) return *viewpoint;
  return Viewpoint{"level center", level_center(level), math::Vec3(0.0f)};
}

std::vector<Viewpoint> list_viewpoints(const world::Level& level) {
  std::vector<Viewpoint> viewpoints;
  for (const formats::Entity& entity : level.entities)
    if (auto viewpoint = make_viewpoint(entity)) viewpoints.push_back(std::move(*viewpoint));
  if (viewpoints.empty()) viewpoints.push_back(find_start_viewpoint(level));
  return viewpoints;
}

}  // namespace temblor::app
