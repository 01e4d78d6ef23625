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
#include "compiler/light/known_light.h"
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

base::Result<Preparation> prepare(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                  const LightOptions& options, Warnings& io_warnings) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(bsp.entities));
  const bool styles_changed = assign_switchable_styles(entities, io_warnings);
  const LightSettings settings = settings_of(entities, options);
  TRY(LitLevel lit, make_lit_level(unlit(bsp), face_keys));
  TRY(RayScene scene, RayScene::make(occluders_of(lit, options.palette)));
  EntityLights found = entity_lights_of(entities, settings, io_warnings);
  const std::vector<LightSource> surface_lights = surface_lights_of(lit, found.templates);
  found.lights.insert(found.lights.end(), surface_lights.begin(), surface_lights.end());
  const int sky_rays = options.fast ? std::max(1, options.sky_rays / 8) : options.sky_rays;
  std::vector<SkyBeam> beams = sky_beams_of(entities, settings, sky_rays);
  return Preparation{std::move(entities), styles_changed,          settings,        std::move(lit),
                     std::move(scene),    std::move(found.lights), std::move(beams)};
}

// One progress over all that is done face by face, by any thread.
class SharedProgress {
 public:
  SharedProgress(Progress report, std::size_t total) : report_(report), total_(total) {}

  // False: stop here.
  bool step() {
    const std::lock_guard lock(reporting_);
    stopped_ = stopped_ || !report_(++done_, total_);
    return !stopped_;
  }

 private:
  Progress report_;
  std::size_t total_, done_ = 0;
  bool stopped_ = false;
  std::mutex reporting_;
};

base::Error stopped() {
  return base::error(base::ErrorCode::kUsage, "light was stopped");
}

std::size_t maps_of(const LightShard& shard, std::size_t maps) {
  return (maps + shard.count - 1 - shard.index) / shard.count;
}

// The direct light of a shard's light maps; what others get is empty. `io_learned`: gets them; may be null.
base::Result<std::vector<FaceLight>> direct_light(const Preparation& prepared, const LightOptions& options,
                                                  const LightShard& shard, base::Jobs& io_jobs,
                                                  SharedProgress& io_progress,
                                                  const KnownLight* known = nullptr,
                                                  LightCache* io_learned = nullptr) {
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
                               shadow_sampling(options.extra),
                               known};
  std::vector<FaceLight> light(lit.maps.size());
  if (io_learned != nullptr) io_learned->maps.resize(light.size());
  std::atomic<bool> is_stopped{false};
  io_jobs.parallel_for(maps_of(shard, light.size()), [&](std::size_t i) {
    if (is_stopped.load(std::memory_order_relaxed)) return;
    const std::size_t map = shard.index + i * shard.count;
    if (lit.gets_light[lit.maps[map].face])
      light[map] = direct_light_of(input, map, io_learned != nullptr ? &io_learned->maps[map] : nullptr);
    if (!io_progress.step()) is_stopped = true;
  });
  if (is_stopped) return stopped();
  return light;
}

// The rays of bounced light: known ones, or traced now.
base::Result<std::vector<std::uint32_t>> bounces_of(const Preparation& prepared, base::Jobs& io_jobs,
                                                    SharedProgress& io_progress,
                                                    const KnownLight* known = nullptr) {
  if (prepared.settings.bounce.count == 0) return std::vector<std::uint32_t>();
  if (known != nullptr && are_bounces_of(prepared.lit, known->bounces()))
    return std::vector<std::uint32_t>(known->bounces().begin(), known->bounces().end());
  auto seen = trace_bounces(prepared.lit, prepared.scene, io_jobs, [&] { return io_progress.step(); });
  if (!seen) return stopped();
  return *std::move(seen);
}

void set_coloured_lump(const formats::Lit& lit, formats::Bsp& io_bsp) {
  const base::Bytes bytes = std::as_bytes(std::span(lit.samples));
  io_bsp.bspx.push_back({kColouredLump, base::ByteVector(bytes.begin(), bytes.end())});
}

LightSummary finish(const Preparation& prepared, const LightOptions& options, std::vector<FaceLight> light,
                    std::span<const std::uint32_t> bounces, formats::Bsp& io_bsp, base::Jobs& io_jobs,
                    Warnings& io_warnings) {
  const LightSettings& settings = prepared.settings;
  if (settings.bounce.count > 0)
    add_bounced_light(prepared.lit, bounces, settings.bounce, options.palette, io_jobs, light);
  PackedLight packed = pack_light_maps(prepared.lit, settings, light, io_jobs, io_bsp, io_warnings);
  if (prepared.styles_changed) io_bsp.entities = formats::write_entities(prepared.entities);
  std::erase_if(io_bsp.bspx, [](const formats::BspxLump& lump) { return lump.name == kColouredLump; });
  if (packed.coloured) set_coloured_lump(packed.lit, io_bsp);
  LightSummary summary{prepared.lights.size(), packed.lit_faces, packed.dark_faces,
                       io_bsp.lighting.size(), packed.coloured,  {}};
  if (packed.coloured) summary.lit = std::move(packed.lit);
  return summary;
}

std::vector<std::size_t> luxels_of_maps(const LitLevel& lit) {
  std::vector<std::size_t> luxels;
  for (const LightMapShape& map : lit.maps) luxels.push_back(map.size());
  return luxels;
}

// A cache for what is about to be lit, with nothing in it yet.
LightCache empty_cache(const Preparation& prepared, formats::Bsp unlit_bsp, const LightOptions& options) {
  LightCache cache;
  cache.geometry = hash_of_geometry(std::move(unlit_bsp), prepared.lit, options);
  cache.dirt = hash_of_dirt(prepared.settings.dirt);
  cache.sky = hash_of_sky(prepared.beams, prepared.settings.range);
  for (const LightSource& light : prepared.lights) cache.lights.push_back(light.origin_world);
  return cache;
}

}  // namespace

base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings, LightCache* io_cache) {
  TRY(const Preparation prepared, prepare(io_bsp, face_keys, options, io_warnings));
  const std::size_t maps = prepared.lit.maps.size();
  SharedProgress shared(progress, prepared.settings.bounce.count > 0 ? maps + io_bsp.faces.size() : maps);
  LightCache learned;
  std::optional<KnownLight> known;
  if (io_cache != nullptr) {
    learned = empty_cache(prepared, unlit(io_bsp), options);
    known.emplace(*io_cache, learned, prepared.lights);
  }
  const KnownLight* const use = known ? &*known : nullptr;
  TRY(std::vector<FaceLight> light,
      direct_light(prepared, options, {}, io_jobs, shared, use, io_cache != nullptr ? &learned : nullptr));
  TRY(std::vector<std::uint32_t> bounces, bounces_of(prepared, io_jobs, shared, use));
  const LightSummary summary =
      finish(prepared, options, std::move(light), bounces, io_bsp, io_jobs, io_warnings);
  if (io_cache != nullptr) {
    learned.bounces = std::move(bounces);
    *io_cache = std::move(learned);
  }
  return summary;
}

base::Result<base::ByteVector> light_shard(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                           const LightOptions& options, const LightShard& shard,
                                           base::Jobs& io_jobs, Progress progress) {
  CHECK(shard.index < shard.count);
  Warnings told_by_the_merge;
  TRY(const Preparation prepared, prepare(bsp, face_keys, options, told_by_the_merge));
  SharedProgress shared(progress, maps_of(shard, prepared.lit.maps.size()));
  TRY(const std::vector<FaceLight> light, direct_light(prepared, options, shard, io_jobs, shared));
  return write_shard({hash_of_light_input(unlit(bsp), face_keys, options), shard.index, shard.count}, light);
}

base::Result<LightSummary> merge_light(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, std::span<const base::Bytes> shards,
                                       base::Jobs& io_jobs, Warnings& io_warnings) {
  TRY(const Preparation prepared, prepare(io_bsp, face_keys, options, io_warnings));
  const std::vector<std::size_t> luxels = luxels_of_maps(prepared.lit);
  const std::uint64_t level = hash_of_light_input(unlit(io_bsp), face_keys, options);
  std::vector<FaceLight> light(luxels.size());
  std::vector<bool> merged(shards.size());
  for (const base::Bytes bytes : shards) {
    TRY(Shard shard, read_shard(bytes, luxels));
    const ShardHeader& header = shard.header;
    if (header.level != level)
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} is of another level or other options",
                         header.index + 1, header.count);
    if (header.count != shards.size() || merged[header.index])
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} {} among {} shards", header.index + 1,
                         header.count, header.count == shards.size() ? "is there twice" : "is",
                         shards.size());
    merged[header.index] = true;
    for (auto& [map, map_light] : shard.maps) light[map] = std::move(map_light);
  }
  if (shards.empty()) return base::error(base::ErrorCode::kUsage, "no light shards to merge");
  const auto unreported = [](std::size_t, std::size_t) { return true; };
  SharedProgress shared(unreported, 0);
  TRY(const std::vector<std::uint32_t> bounces, bounces_of(prepared, io_jobs, shared));
  return finish(prepared, options, std::move(light), bounces, io_bsp, io_jobs, io_warnings);
}

}  // namespace temblor::compiler
