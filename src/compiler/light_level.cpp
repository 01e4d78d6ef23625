// Method: every face that gets light asks every light that can reach it, by itself; then faces exchange what
// they send back; then all of it is put into bytes, in the order of faces.
#include "compiler/light_level.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "compiler/light/bounce.h"
#include "compiler/light/direct_light.h"
#include "compiler/light/entity_lights.h"
#include "compiler/light/leaf_sight.h"
#include "compiler/light/light_hash.h"
#include "compiler/light/light_maps.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/phong.h"
#include "compiler/light/settings.h"
#include "compiler/light/shard_file.h"
#include "compiler/light/sky_lights.h"
#include "compiler/light/surface_lights.h"
#include "formats/entities.h"

namespace temblor::compiler {
namespace {

constexpr const char* kColouredLump = "RGBLIGHTING";

// Everything that is known before the first ray.
struct Preparation {
  std::vector<formats::Entity> entities;
  bool styles_changed = false;
  LightSettings settings;
  LitLevel lit;
  RayScene scene;
  std::vector<LightSource> lights;
  std::vector<SkyBeam> beams;
};

LightSettings settings_of(const std::vector<formats::Entity>& entities, const LightOptions& options) {
  const auto world = std::find_if(entities.begin(), entities.end(), [](const formats::Entity& entity) {
    return entity.classname() == "worldspawn";
  });
  LightSettings settings = light_settings_of(world != entities.end() ? *world : formats::Entity{});
  if (options.bounces) settings.bounce.count = std::max(0, *options.bounces);
  if (options.dirt) settings.dirt.on = *options.dirt;
  if (options.fast) {
    settings.bounce.count = 0;
    settings.dirt.on = false;
  }
  return settings;
}

// Games without the BSPX lumps for it would show other grids than 16 texels as noise.
void warn_of_scaled_grids(const FaceKeys& face_keys, Warnings& io_warnings) {
  const bool any = std::any_of(face_keys.keys.begin(), face_keys.keys.end(),
                               [](const SurfaceKeys& keys) { return keys.light_map_scale != 1; });
  if (any) io_warnings.push_back({"_lmscale is not known", "light is measured every 16 texels"});
}

base::Result<Preparation> prepare(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                  const LightOptions& options, Warnings& io_warnings) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(bsp.entities));
  warn_of_scaled_grids(face_keys, io_warnings);
  const bool styles_changed = assign_switchable_styles(entities, io_warnings);
  const LightSettings settings = settings_of(entities, options);
  TRY(LitLevel lit, make_lit_level(unlit(bsp), face_keys));
  TRY(RayScene scene, RayScene::make(occluders_of(lit)));
  EntityLights found = entity_lights_of(entities, settings, io_warnings);
  const std::vector<LightSource> surface_lights = surface_lights_of(lit, found.templates);
  found.lights.insert(found.lights.end(), surface_lights.begin(), surface_lights.end());
  const int sky_rays = options.fast ? std::max(1, options.sky_rays / 8) : options.sky_rays;
  std::vector<SkyBeam> beams = sky_beams_of(entities, settings, sky_rays);
  return Preparation{std::move(entities), styles_changed,          settings,        std::move(lit),
                     std::move(scene),    std::move(found.lights), std::move(beams)};
}

// The direct light of a shard's faces; what other faces get is empty.
base::Result<std::vector<FaceLight>> direct_light(const Preparation& prepared, const LightOptions& options,
                                                  const LightShard& shard, base::Jobs& io_jobs,
                                                  Progress progress) {
  const LitLevel& lit = prepared.lit;
  const PhongNormals phong(lit);
  const LeafSight sight(lit, prepared.lights);
  const DirectLightInput input{lit,
                               prepared.scene,
                               phong,
                               sight,
                               prepared.settings,
                               prepared.lights,
                               prepared.beams,
                               shadow_sampling(options.extra)};
  std::vector<FaceLight> light(lit.level->faces.size());
  const std::size_t count = (light.size() + shard.count - 1 - shard.index) / shard.count;
  std::atomic<bool> stopped{false};
  std::mutex reporting;
  std::size_t done = 0;
  io_jobs.parallel_for(count, [&](std::size_t i) {
    if (stopped.load(std::memory_order_relaxed)) return;
    const std::size_t face = shard.index + i * shard.count;
    if (lit.gets_light[face]) light[face] = direct_light_of(input, face);
    const std::lock_guard lock(reporting);
    if (!progress(++done, count)) stopped = true;
  });
  if (stopped) return base::error(base::ErrorCode::kUsage, "light was stopped");
  return light;
}

void set_coloured_lump(const formats::Lit& lit, formats::Bsp& io_bsp) {
  const base::Bytes bytes = std::as_bytes(std::span(lit.samples));
  io_bsp.bspx.push_back({kColouredLump, base::ByteVector(bytes.begin(), bytes.end())});
}

LightSummary finish(const Preparation& prepared, const LightOptions& options, std::vector<FaceLight> light,
                    formats::Bsp& io_bsp, base::Jobs& io_jobs, Warnings& io_warnings) {
  const LightSettings& settings = prepared.settings;
  if (settings.bounce.count > 0)
    add_bounced_light(prepared.lit, prepared.scene, settings.bounce, options.palette, io_jobs, light);
  PackedLight packed = pack_light_maps(prepared.lit, settings, light, io_bsp, io_warnings);
  if (prepared.styles_changed) io_bsp.entities = formats::write_entities(prepared.entities);
  std::erase_if(io_bsp.bspx, [](const formats::BspxLump& lump) { return lump.name == kColouredLump; });
  if (packed.coloured) set_coloured_lump(packed.lit, io_bsp);
  LightSummary summary{prepared.lights.size(), packed.lit_faces, packed.dark_faces,
                       io_bsp.lighting.size(), packed.coloured,  {}};
  if (packed.coloured) summary.lit = std::move(packed.lit);
  return summary;
}

std::vector<std::size_t> luxels_of_faces(const LitLevel& lit) {
  std::vector<std::size_t> luxels;
  for (const world::Face& face : lit.level->faces)
    luxels.push_back(static_cast<std::size_t>(face.light_width()) *
                     static_cast<std::size_t>(face.light_height()));
  return luxels;
}

}  // namespace

base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings) {
  TRY(const Preparation prepared, prepare(io_bsp, face_keys, options, io_warnings));
  TRY(std::vector<FaceLight> light, direct_light(prepared, options, {}, io_jobs, progress));
  return finish(prepared, options, std::move(light), io_bsp, io_jobs, io_warnings);
}

base::Result<base::ByteVector> light_shard(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                           const LightOptions& options, const LightShard& shard,
                                           base::Jobs& io_jobs, Progress progress) {
  CHECK(shard.index < shard.count);
  Warnings told_by_the_merge;
  TRY(const Preparation prepared, prepare(bsp, face_keys, options, told_by_the_merge));
  TRY(const std::vector<FaceLight> light, direct_light(prepared, options, shard, io_jobs, progress));
  return write_shard({hash_of_light_input(unlit(bsp), face_keys, options), shard.index, shard.count}, light);
}

base::Result<LightSummary> merge_light(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, std::span<const base::Bytes> shards,
                                       base::Jobs& io_jobs, Warnings& io_warnings) {
  TRY(const Preparation prepared, prepare(io_bsp, face_keys, options, io_warnings));
  const std::vector<std::size_t> luxels = luxels_of_faces(prepared.lit);
  const std::uint64_t level = hash_of_light_input(unlit(io_bsp), face_keys, options);
  std::vector<FaceLight> light(luxels.size());
  std::vector<bool> merged(shards.size());
  for (const base::Bytes bytes : shards) {
    TRY(Shard shard, read_shard(bytes, luxels));
    const ShardHeader& header = shard.header;
    if (header.level != level)
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} is of another level or other options",
                         header.index, header.count);
    if (header.count != shards.size() || merged[header.index])
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} among {} shards", header.index,
                         header.count, shards.size());
    merged[header.index] = true;
    for (auto& [face, face_light] : shard.faces) light[face] = std::move(face_light);
  }
  if (shards.empty()) return base::error(base::ErrorCode::kUsage, "no light shards to merge");
  return finish(prepared, options, std::move(light), io_bsp, io_jobs, io_warnings);
}

}  // namespace temblor::compiler
