// Method: every face that gets light asks every light that can reach it, by itself; then faces exchange what
// they send back; then all of it is put into bytes, in the order of faces.
#include "compiler/light/light_level.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "compiler/light/bounce.h"
#include "compiler/light/cached_light.h"
#include "compiler/light/direct_light.h"
#include "compiler/light/faces/light_hash.h"
#include "compiler/light/faces/light_maps.h"
#include "compiler/light/faces/phong.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/rays/leaf_sight.h"
#include "compiler/light/shard_file.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"
#include "compiler/light/sources/surface_lights.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {
namespace {

constexpr const char* kColoredLump = "RGBLIGHTING";

// Everything that is known before the first ray.
struct SurfaceSelector {
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

base::Result<SurfaceSelector> prepare(const formats::Bsp& bsp, const FaceKeys& face_keys,
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
  return SurfaceSelector{std::move(entities), styles_changed,          settings,        std::move(lit),
                         std::move(scene),    std::move(found.lights), std::move(beams)};
}

// One progress over all that is done face by face, by any thread.
class SharedProgress {
 public:
  SharedProgress(Progress report, std::size_t total, std::size_t done = 0)
      : report_(report), total_(total), done_(done) {}

  // False: stop here.
  bool step() {
    const std::lock_guard lock(reporting_);
    stopped_ = stopped_ || !report_(++done_, total_);
    return !stopped_;
  }

 private:
  Progress report_;
  std::size_t total_, done_;
  bool stopped_ = false;
  std::mutex reporting_;
};

base::Error stopped() {
  return base::error(base::ErrorCode::kUsage, "light was stopped");
}

constexpr ShardHeader kWhole{};

bool bounces(const SurfaceSelector& prepared) {
  return prepared.settings.bounce.count > 0;
}

// Whether the rays of a shard could be this level's.
bool are_bounces_of(const SurfaceSelector& prepared, const LightWork& work) {
  return !bounces(prepared) || are_bounces_of(prepared.lit, work.bounces.seen);
}

// The direct light of a shard's light maps that are not lit yet. `io_learned`: gets what was found out of
// them; may be null. False when the progress ever said stop.
bool add_direct_light(const SurfaceSelector& prepared, const LightOptions& options, const ShardHeader& shard,
                      base::Jobs& io_jobs, SharedProgress& io_progress, LightWork& io_work,
                      const CachedLight* known = nullptr, LightCache* io_learned = nullptr) {
  const LitLevel& lit = prepared.lit;
  const PhongNormals phong(lit);
  const Leavesight sight(lit, prepared.lights);
  const DirectLightInput input{lit,
                               prepared.scene,
                               phong,
                               sight,
                               prepared.settings,
                               prepared.lights,
                               prepared.beams,
                               shadow_sampling(options.extra),
                               known};
  if (io_learned != nullptr) io_learned->maps.resize(lit.maps.size());
  const std::vector<std::uint32_t> maps = share_of(shard, lit.maps.size());
  std::atomic<bool> is_stopped{false};
  io_jobs.parallel_for(maps.size(), [&](std::size_t i) {
    const std::uint32_t map = maps[i];
    if (io_work.is_lit[map] != 0 || is_stopped.load(std::memory_order_relaxed)) return;
    if (lit.gets_light[lit.maps[map].face])
      io_work.light[map] =
          direct_light_of(input, map, io_learned != nullptr ? &io_learned->maps[map] : nullptr);
    io_work.is_lit[map] = 1;
    if (!io_progress.step()) is_stopped = true;
  });
  return !is_stopped;
}

// The rays of bounced light: known ones, or traced now. False when the progress ever said stop.
bool add_bounces(const SurfaceSelector& prepared, const ShardHeader& shard, base::Jobs& io_jobs,
                 SharedProgress& io_progress, LightWork& io_work, const CachedLight* known = nullptr) {
  if (!bounces(prepared)) return true;
  BounceRays& rays = io_work.bounces;
  if (known != nullptr && are_bounces_of(prepared.lit, known->bounces())) {
    rays.seen.assign(known->bounces().begin(), known->bounces().end());
    return true;
  }
  return trace_bounces(
      prepared.lit, prepared.scene, share_of(shard, rays.is_traced.size()), io_jobs,
      [&] { return io_progress.step(); }, rays);
}

void set_colored_lump(const formats::Lit& lit, formats::Bsp& io_bsp) {
  const base::Bytes bytes = std::as_bytes(std::span(lit.samples));
  io_bsp.bspx.push_back({kColoredLump, base::ByteVector(bytes.begin(), bytes.end())});
}

LightSummary finish(const SurfaceSelector& prepared, const LightOptions& options, LightWork& io_work,
                    formats::Bsp& io_bsp, base::Jobs& io_jobs, Warnings& io_warnings) {
  const LightSettings& settings = prepared.settings;
  if (bounces(prepared))
    add_bounced_light(prepared.lit, io_work.bounces.seen, settings.bounce, options.palette, io_jobs,
                      io_work.light);
  PackedLight packed = pack_light_maps(prepared.lit, settings, io_work.light, io_jobs, io_bsp, io_warnings);
  if (prepared.styles_changed) io_bsp.entities = formats::write_entities(prepared.entities);
  std::erase_if(io_bsp.bspx, [](const formats::BspxLump& lump) { return lump.name == kColoredLump; });
  if (packed.colored) set_colored_lump(packed.lit, io_bsp);
  LightSummary summary{prepared.lights.size(), packed.lit_faces, packed.dark_faces,
                       io_bsp.lighting.size(), packed.colored,   {}};
  if (packed.colored) summary.lit = std::move(packed.lit);
  return summary;
}

std::vector<std::size_t> luxels_of_maps(const LitLevel& lit) {
  std::vector<std::size_t> luxels;
  for (const LightMapShape& map : lit.maps) luxels.push_back(map.size());
  return luxels;
}

// A cache for what is about to be lit, with nothing in it yet.
LightCache empty_cache(const SurfaceSelector& prepared, formats::Bsp unlit_bsp, const LightOptions& options) {
  LightCache cache;
  cache.geometry = hash_of_geometry(std::move(unlit_bsp), prepared.lit, options);
  cache.dirt = hash_of_dirt(prepared.settings.dirt);
  cache.sky = hash_of_sky(prepared.beams, prepared.settings.range);
  for (const LightSource& light : prepared.lights) cache.lights.push_back(light.origin_world);
  return cache;
}

}  // namespace

base::Status check_light() {
  return RayScene::check();
}

base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings, LightCache* io_cache) {
  TRY(const SurfaceSelector prepared, prepare(io_bsp, face_keys, options, io_warnings));
  LightWork work = begin_light(prepared.lit, bounces(prepared));
  SharedProgress shared(progress, work.light.size() + work.bounces.is_traced.size());
  LightCache learned;
  std::optional<CachedLight> known;
  if (io_cache != nullptr) {
    learned = empty_cache(prepared, unlit(io_bsp), options);
    known.emplace(*io_cache, learned, prepared.lights);
  }
  const CachedLight* const use = known ? &*known : nullptr;
  LightCache* const learns = io_cache != nullptr ? &learned : nullptr;
  if (!add_direct_light(prepared, options, kWhole, io_jobs, shared, work, use, learns) ||
      !add_bounces(prepared, kWhole, io_jobs, shared, work, use))
    return stopped();
  const LightSummary summary = finish(prepared, options, work, io_bsp, io_jobs, io_warnings);
  if (io_cache != nullptr) {
    learned.bounces = std::move(work.bounces.seen);
    *io_cache = std::move(learned);
  }
  return summary;
}

base::Result<LightShardBytes> light_shard(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                          const LightOptions& options, const LightShard& shard,
                                          base::Bytes begun, base::Jobs& io_jobs, Progress progress) {
  CHECK(shard.index < shard.count);
  Warnings told_by_the_merge;
  TRY(const SurfaceSelector prepared, prepare(bsp, face_keys, options, told_by_the_merge));
  const ShardHeader header{hash_of_light_input(unlit(bsp), face_keys, options), shard.index, shard.count};
  LightWork work = begin_light(prepared.lit, bounces(prepared));
  const base::Result<ReadShard> read = read_shard(begun, luxels_of_maps(prepared.lit), work);
  if (!read.ok() || read->header != header || !are_bounces_of(prepared, work))
    work = begin_light(prepared.lit, bounces(prepared));
  const auto done = [&] {
    return static_cast<std::size_t>(std::ranges::count(work.is_lit, 1) +
                                    std::ranges::count(work.bounces.is_traced, 1));
  };
  const std::size_t total =
      share_of(header, work.is_lit.size()).size() + share_of(header, work.bounces.is_traced.size()).size();
  SharedProgress shared(progress, total, done());
  if (add_direct_light(prepared, options, header, io_jobs, shared, work))
    add_bounces(prepared, header, io_jobs, shared, work);
  return LightShardBytes{write_shard(header, work), done() == total};
}

base::Result<LightSummary> merge_light(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, std::span<const base::Bytes> shards,
                                       base::Jobs& io_jobs, Warnings& io_warnings) {
  TRY(const SurfaceSelector prepared, prepare(io_bsp, face_keys, options, io_warnings));
  const std::vector<std::size_t> luxels = luxels_of_maps(prepared.lit);
  const std::uint64_t level = hash_of_light_input(unlit(io_bsp), face_keys, options);
  LightWork work = begin_light(prepared.lit, bounces(prepared));
  std::vector<bool> merged(shards.size());
  for (const base::Bytes bytes : shards) {
    TRY(const ReadShard shard, read_shard(bytes, luxels, work));
    const ShardHeader& header = shard.header;
    if (header.level != level)
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} is of another level or other options",
                         header.index + 1, header.count);
    if (header.count != shards.size() || merged[header.index])
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} {} among {} shards", header.index + 1,
                         header.count, header.count == shards.size() ? "is there twice" : "is",
                         shards.size());
    if (!shard.is_finished)
      return base::error(base::ErrorCode::kUsage, "light shard {} of {} is not finished: run it again",
                         header.index + 1, header.count);
    merged[header.index] = true;
  }
  if (shards.empty()) return base::error(base::ErrorCode::kUsage, "no light shards to merge");
  if (!are_bounces_of(prepared, work)) return base::malformed("light shards: rays end on what is not there");
  return finish(prepared, options, work, io_bsp, io_jobs, io_warnings);
}

}  // namespace temblor::compiler
