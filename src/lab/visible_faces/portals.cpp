#include "lab/visible_faces/portals.h"

#include <algorithm>
#include <glm/common.hpp>
#include <memory>
#include <optional>

#include "lab/visible_faces/leaf_portals.h"
#include "lab/visible_faces/portal_flood.h"

namespace temblor::lab {

namespace {

// The portals of the level that was drawn last.
class KeptPortals {
 public:
  explicit KeptPortals(std::size_t max_portals) : max_portals_(max_portals) {}

  // Null if the level has too many.
  const LevelPortals* find(const world::Level& level) {
    if (level_ != level.identity) {
      level_ = level.identity;
      base::Result<LevelPortals> made = make_level_portals(level, max_portals_);
      portals_ = made.ok() ? std::optional(std::move(*made)) : std::nullopt;
    }
    return portals_ ? &*portals_ : nullptr;
  }

 private:
  const std::size_t max_portals_;
  std::shared_ptr<const world::LevelIdentity> level_;
  std::optional<LevelPortals> portals_;
};

// Whether the flood can begin at the eye. The scene may name the leaf whose PVS is shown; then the eye may be
// anywhere else.
bool can_flood(const render::FrameContext& context, const render::ViewFrame& view,
               const LevelPortals& portals) {
  const world::Contents contents = context.level().leaf(view.eye_leaf).contents;
  const math::Vec3d distance = glm::abs(view.eye_world);
  return view.eye_leaf != world::LeafIndex{0} && view.perspective && !context.scene.pvs_leaf &&
         !context.scene.is_overview && contents != world::Contents::kSolid &&
         contents != world::Contents::kSky &&
         std::max({distance.x, distance.y, distance.z}) < portals.extent / 2;
}

}  // namespace

render::FrameStages make_portal_stages(std::span<const double> values, Counter* counter) {
  render::FrameStages stages;
  const bool uses_octagons = values[0] != 0, uses_pvs = values[1] != 0;
  const auto kept = std::make_shared<KeptPortals>(static_cast<std::size_t>(values[2]));
  stages.find_visible_faces = [=](const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::LevelTables& tables) {
    const LevelPortals* const portals = kept->find(context.level());
    if (portals == nullptr || !can_flood(context, view, *portals))
      return render::find_visible_faces(context, view, tables);
    FloodRules rules{.uses_octagons = uses_octagons};
    if (uses_pvs) rules.enterable = render::find_leaves_in_pvs(context, view);
    const FloodResult flood = flood_portals(*portals, view, rules, context.arena());
    if (counter != nullptr)
      counter->add({.bytes = portals->size_bytes(),
                    .portals_clipped = flood.portals_clipped,
                    .leaves_reached = flood.leaves_reached});
    return render::find_faces_in_leaves(context, view, tables, flood.leaves);
  };
  return stages;
}

base::Status check_portals(std::span<const double> values, const world::Level& level) {
  TRY_STATUS(make_level_portals(level, static_cast<std::size_t>(values[2])));
  return base::Ok{};
}

}  // namespace temblor::lab
