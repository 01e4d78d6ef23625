#include "compiler/build/incremental_build.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/hash.h"
#include "compiler/bsp/brushes/level_entities.h"
#include "compiler/build/build_keys.h"
#include "compiler/light/build_light.h"
#include "compiler/textures/level_textures.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {
namespace {

// Writes the level and reads it back, so that a build in memory equals one that a later run reads from the
// file.
base::Result<formats::Bsp> read_back(const formats::Bsp& bsp, const CompileOptions& options) {
  using formats::BspVersion;
  const BspVersion version = options.draft.half_life ? BspVersion::k30
                             : options.psb2          ? BspVersion::k2Psb
                             : options.bsp2          ? BspVersion::kBsp2
                                                     : BspVersion::k29;
  base::Result<base::ByteVector> bytes = formats::write_bsp(bsp, version);
  if (!bytes.ok() && version == BspVersion::k29) bytes = formats::write_bsp(bsp, BspVersion::kBsp2);
  TRY(const base::ByteVector written, std::move(bytes));
  TRY(formats::Bsp back, formats::read_bsp(written));
  if (!back.repairs.empty()) return base::malformed("{}", back.repairs);
  return back;
}

// Textures come first: a .bsp stores no names for textures without pixels.
base::Result<Build> make_build(Draft draft, const TextureSet& textures, const CompileOptions& options) {
  Build build;
  build.own_textures = draft.bsp.miptexes.size();
  build.water_is_transparent = options.draft.water_is_transparent;
  set_textures(textures, build.own_textures, draft.bsp);
  TRY(build.bsp, read_back(draft.bsp, options));
  build.brush_entities = std::move(draft.brush_entities);
  build.portals = std::move(draft.portals);
  build.face_keys = {std::move(draft.surface_keys), std::move(draft.keys_of_face)};
  return build;
}

}  // namespace

bool IncrementalBuild::is_bsp_up_to_date(const formats::Map& map) const {
  if (build_.bsp.models.empty() || build_.brushes_key != brushes_key_) return false;
  const auto brush_entities = std::ranges::count_if(
      map.entities, [](const formats::MapEntity& entity) { return !is_point_entity(entity); });
  if (static_cast<std::size_t>(brush_entities) != build_.brush_entities.size()) return false;
  // Visibility cannot be taken out of leaves and models again, so the level is made without it.
  if (options_.visibility_policy == StagePolicy::kSkip && build_.visibility != VisibilityKind::kNone)
    return false;
  return build_.solid_occupants_key == make_solid_occupants_key(map, build_.bsp);
}

StagePolicy IncrementalBuild::choose_bsp(const formats::Map& map, const TextureSet& textures) {
  const auto texture_size = [&](std::string_view name) { return find_texture_size(textures, name); };
  brushes_key_ =
      base::hash_with(make_brushes_key(map, texture_size, options_.draft), options_.draft.half_life ? 2
                                                                           : options_.psb2          ? 3
                                                                           : options_.bsp2          ? 1
                                                                                                    : 0);
  return is_bsp_up_to_date(map) ? StagePolicy::kReuse : StagePolicy::kBuild;
}

void IncrementalBuild::reuse_bsp(const formats::Map& map, const TextureSet& textures) {
  set_textures(textures, build_.own_textures, build_.bsp);
  build_.bsp.entities = formats::write_entities(make_level_entities(map, build_.brush_entities));
}

// The keys stay 0 after a leak: where a leak goes depends on point entities, which the brushes key leaves
// out.
base::Status IncrementalBuild::store_bsp(DraftResult made, bool leaks, const formats::Map& map,
                                         const TextureSet& textures) {
  TRY(Build build, make_build(std::move(made.draft), textures, options_));
  build.visibility_state = std::move(build_.visibility_state);
  build.light_cache = std::move(build_.light_cache);
  build_ = std::move(build);
  if (leaks || made.clip_hulls_leak || made.is_region) return base::Ok{};
  build_.brushes_key = brushes_key_;
  build_.solid_occupants_key = make_solid_occupants_key(map, build_.bsp);
  return base::Ok{};
}

VisibilityKind IncrementalBuild::wanted_visibility() const {
  return options_.fast_visibility ? VisibilityKind::kRough : VisibilityKind::kFull;
}

StagePolicy IncrementalBuild::choose_visibility(bool leaks) const {
  if (!leaks && options_.visibility_policy == StagePolicy::kBuild && build_.visibility != wanted_visibility())
    return StagePolicy::kBuild;
  return build_.visibility != VisibilityKind::kNone ? StagePolicy::kReuse : StagePolicy::kSkip;
}

base::Result<StagePolicy> IncrementalBuild::choose_light(const LightOptions& options) const {
  if (options_.light_policy == StagePolicy::kSkip) return StagePolicy::kSkip;
  TRY(const StageKey key, find_light_key(build_, options));
  return options_.light_policy == StagePolicy::kReuse || key == build_.light_key ? StagePolicy::kReuse
                                                                                 : StagePolicy::kBuild;
}

}  // namespace temblor::compiler
