#include "fuzz/targets/models/posed_checks.h"

#include <cmath>

#include "base/check.h"
#include "formats/models/mdl_normals.h"
#include "render/alias_model.h"

namespace temblor::fuzz {

namespace {

// Skins that repeat thousands of times are joined to pictures of up to 2^25 texels. Filling those would take
// all of the fuzzer's time.
bool has_small_skins(const formats::PosedModel& model) {
  constexpr float kMaxRepetitions = 64;
  for (const formats::PosedMesh& mesh : model.meshes)
    for (const math::Vec2& texel : mesh.texels)
      if (std::abs(texel.x) > kMaxRepetitions || std::abs(texel.y) > kMaxRepetitions) return false;
  return true;
}

}  // namespace

void check_drawable(formats::PosedModel model) {
  CHECK(model.pose_count > 0 && !model.frames.empty());
  for (const formats::PosedMesh& mesh : model.meshes) {
    CHECK(mesh.positions.size() == model.pose_count * mesh.texels.size());
    CHECK(mesh.normals.size() == mesh.positions.size());
    for (const math::Vec3& position : mesh.positions)
      for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(position[axis]) <= formats::kMaxMdlCoordinate);
    for (const std::uint8_t normal : mesh.normals) CHECK(normal < formats::mdl_normals().size());
  }
  if (!has_small_skins(model)) return;
  const formats::Picture skin{2, 1, {1, 2}};
  model.skins = {{{std::vector<formats::Picture>(model.meshes.size(), skin)}, {}}};
  const auto drawable = render::make_alias_model(model, "fuzz");
  if (!drawable.ok()) return;
  const math::Bounds made = render::model_bounds(**drawable), all = formats::compute_bounds(model);
  for (int axis = 0; axis < 3; ++axis)
    CHECK(made.mins[axis] <= all.mins[axis] && made.maxs[axis] >= all.maxs[axis]);
}

}  // namespace temblor::fuzz
