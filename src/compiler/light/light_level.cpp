// Method: every face gathers direct light on its own; then faces exchange the light that they send back; then
// all of it is packed into bytes, in the order of the faces.
#include "compiler/light/light_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/light/bounce.h"
#include "compiler/light/cached_light.h"
#include "compiler/light/direct_light.h"
#include "compiler/light/faces/face_normals.h"
#include "compiler/light/faces/light_hash.h"
#include "compiler/light/faces/light_maps.h"
#include "compiler/light/faces/phong.h"
#include "compiler/light/grid/light_grid.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/rays/leaf_sight.h"
#include "compiler/light/shard_file.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/projection.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"
#include "compiler/light/sources/surface_lights.h"
#include "compiler/light/sources/switchable_styles.h"
#include "formats/bspx/face_normals.h"
#include "formats/bspx/hdr_light.h"
#include "formats/bspx/light_directions.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {
namespace {

constexpr const char* kColoredLump = "RGBLIGHTING";
// Lumps of earlier light.
constexpr std::array<std::string_view, 3> kReplacedLumps = {kColoredLump, formats::kLightGridLump,
                                                            formats::kFaceNormalsLump};

// Everything that is known before the first ray is traced.
struct PreparedLight {
  std::vector<formats::Entity> entities;
  bool styles_changed = false;
  LightSettings settings;
  LitLevel lit;
  RayScene scene;
  std::vector<LightSource> lights;
  std::vector<Projection> projections;
  std::vector<SkyBeam> beams;
  bool needs_dirt = false;  // a light or minimum light takes dirt
};

// The level's own settings, as overridden by the mapper's options.
LightSettings read_settings(const std::vector<formats::Entity>& entities, const LightOptions& options) {
  const auto world = std::find_if(entities.begin(), entities.end(), [](const formats::Entity& entity) {
    return entity.classname() == "worldspawn";
  });
  LightSettings settings = read_light_settings(world != entities.end() ? *world : formats::Entity{});
  if (options.bounces) settings.bounce.count = std::max(0, *options.bounces);
  if (options.dirt) settings.dirt.on = *options.dirt;
  if (options.fast) settings.bounce.count = 0;
  settings.dirt.is_forbidden = options.fast || options.dirt == false;
  settings.min_light_dirt = settings.min_light_dirt && !settings.dirt.is_forbidden;
  settings.has_hdr = options.hdr;
  settings.has_directions = options.directions;
  return settings;
}

// The keys of all faces, as overridden by worldspawn and by the mapper's options.
FaceKeys choose_light_map_keys(FaceKeys keys, const LightSettings& settings, const LightOptions& options) {
  constexpr float kStockTexels = 16;
  for (SurfaceKeys& own : keys.keys) {
    const int texels = options.luxel_texels.value_or(settings.light_map_texels);
    if (texels > 0) own.light_map_scale = static_cast<float>(texels) / kStockTexels;
    if (options.units_per_luxel)
      own.units_per_luxel = *options.units_per_luxel;
    else if (own.units_per_luxel == 0)
      own.units_per_luxel = settings.units_per_luxel;
  }
  return keys;
}

void warn_of_too_fine_faces(const LitLevel& lit, Warnings& io_warnings) {
  if (lit.too_fine_faces.empty()) return;
  const std::uint32_t first = lit.too_fine_faces[0];
  const world::Level& level = *lit.level;
  const math::Vec3& corner = level.vertices[level.surfedge_start(level.faces[first].first_surfedge)];
  io_warnings.push_back(
      {"light map too fine", fmt::format("face {} at {} {} {}{}: more than a million luxels on a face, or {} "
                                         "million in all; it has only the "
                                         "usual light map: use a larger _lmscale or _world_units_per_luxel",
                                         first, corner.x, corner.y, corner.z,
                                         lit.too_fine_faces.size() == 1
                                             ? std::string()
                                             : fmt::format(" and {} others", lit.too_fine_faces.size() - 1),
                                         kMaxLevelLuxels >> 20)});
}

// Reads the entities and builds the scene that rays meet.
base::Result<PreparedLight> prepare(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                    const LightOptions& options, Warnings& io_warnings) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(bsp.entities));
  const bool styles_changed = assign_switchable_styles(entities, io_warnings);
  const LightSettings settings = read_settings(entities, options);
  formats::Bsp unlit = strip_light(bsp);
  if (styles_changed) unlit.entities = formats::write_entities(entities);
  TRY(LitLevel lit, make_lit_level(std::move(unlit), choose_light_map_keys(face_keys, settings, options)));
  warn_of_too_fine_faces(lit, io_warnings);
  TRY(RayScene scene, RayScene::make(make_occluders(lit, options.palette)));
  EntityLights found = find_entity_lights(entities, settings, io_warnings);
  const std::vector<LightSource> surface_lights = find_surface_lights(lit, found.templates);
  found.lights.insert(found.lights.end(), surface_lights.begin(), surface_lights.end());
  const int sky_rays = options.fast ? std::max(1, options.sky_rays / 8) : options.sky_rays;
  std::vector<SkyBeam> beams = find_sky_beams(entities, settings, sky_rays, *lit.level, io_warnings);
  load_pictures(*lit.level, options.palette, found.projections, io_warnings);
  const auto takes_dirt = [](const auto& light) { return light.takes_dirt; };
  const bool needs_dirt = settings.min_light_dirt || std::ranges::any_of(found.lights, takes_dirt) ||
                          std::ranges::any_of(beams, takes_dirt);
  return PreparedLight{std::move(entities),
                       styles_changed,
                       settings,
                       std::move(lit),
                       std::move(scene),
                       std::move(found.lights),
                       std::move(found.projections),
                       std::move(beams),
                       needs_dirt};
}

// One progress over all light maps and faces, reported from any thread.
class SharedProgress {
 public:
  SharedProgress(Progress report, std::size_t total, std::size_t done = 0)
      : report_(report), total_(total), done_(done) {}

  // Returns false to stop.
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

bool has_bounces(const PreparedLight& prepared) {
  return prepared.settings.bounce.count > 0;
}

// Whether the bounce rays of shards fit the level.
bool are_bounces_for(const PreparedLight& prepared, const LightWork& work) {
  return !has_bounces(prepared) || are_bounces_for(prepared.lit, work.bounces.seen);
}

// One pass over light maps and faces: which of them, with what help, and who watches.
struct LightPass {
  const PreparedLight& prepared;
  const LightOptions& options;
  ShardHeader shard;  // which maps and faces
  base::Jobs& jobs;
  SharedProgress& progress;
  const CachedLight* known = nullptr;  // null: no cache is used
  LightCache* learned = nullptr;       // gets what the pass finds out; null: nothing is kept
};

// Lights the maps of the pass that are not lit yet. Returns false if the progress said stop.
bool add_direct_light(const LightPass& pass, LightWork& io_work) {
  const PreparedLight& prepared = pass.prepared;
  const LitLevel& lit = prepared.lit;
  const PhongNormals phong(lit);
  const LeafSight sight(lit, prepared.lights);
  const DirectLightInput input{lit,
                               prepared.scene,
                               phong,
                               sight,
                               prepared.settings,
                               prepared.lights,
                               prepared.projections,
                               prepared.beams,
                               shadow_sampling(pass.options.extra),
                               prepared.needs_dirt,
                               pass.known};
  if (pass.learned != nullptr) pass.learned->maps.resize(lit.maps.size());
  const std::vector<std::uint32_t> maps = list_share(pass.shard, lit.maps.size());
  std::atomic<bool> is_stopped{false};
  pass.jobs.parallel_for(maps.size(), [&](std::size_t i) {
    const std::uint32_t map = maps[i];
    if (io_work.is_lit[map] != 0 || is_stopped.load(std::memory_order_relaxed)) return;
    if (lit.gets_light[lit.maps[map].face])
      io_work.light[map] =
          compute_direct_light(input, map, pass.learned != nullptr ? &pass.learned->maps[map] : nullptr);
    io_work.is_lit[map] = 1;
    if (!pass.progress.step()) is_stopped = true;
  });
  return !is_stopped;
}

// Takes the rays of bounced light from the cache, or traces them. Returns false if the progress said stop.
bool add_bounces(const LightPass& pass, LightWork& io_work) {
  const PreparedLight& prepared = pass.prepared;
  if (!has_bounces(prepared)) return true;
  BounceRays& rays = io_work.bounces;
  if (pass.known != nullptr && are_bounces_for(prepared.lit, pass.known->bounces())) {
    rays.seen.assign(pass.known->bounces().begin(), pass.known->bounces().end());
    return true;
  }
  return trace_bounces(
      prepared.lit, prepared.scene, list_share(pass.shard, rays.is_traced.size()), pass.jobs,
      [&] { return pass.progress.step(); }, rays);
}

// Lays the light grid that the options ask for.
std::optional<GridBlocks> begin_grid(const PreparedLight& prepared, const LightOptions& options,
                                     Warnings& io_warnings) {
  if (!options.grid_step) return std::nullopt;
  std::optional<GridBlocks> grid = lay_grid(*prepared.lit.level, *options.grid_step);
  if (!grid)
    io_warnings.push_back({"no light grid", fmt::format("it would have more than {} samples: use a larger "
                                                        "--lightgrid-dist",
                                                        kMaxGridSamples)});
  return grid;
}

// Lights the grid. Comes before bounced light is added to the faces. Returns false if the progress said stop.
bool light_grid(const LightPass& pass, const LightWork& work, GridBlocks& io_grid) {
  const PreparedLight& prepared = pass.prepared;
  const LeafSight sight(prepared.lit, prepared.lights);
  const std::vector<math::Vec3> first_bounces =
      compute_first_bounces(prepared.lit, prepared.settings.bounce, pass.options.palette);
  const SpaceLightInput input{prepared.lit,      prepared.scene,  sight,
                              prepared.settings, prepared.lights, prepared.projections,
                              prepared.beams,    work.light,      first_bounces};
  return light_grid_blocks(
      input, pass.jobs, [&] { return pass.progress.step(); }, io_grid);
}

void set_colored_lump(const formats::Lit& lit, formats::Bsp& io_bsp) {
  const base::Bytes bytes = std::as_bytes(std::span(lit.samples));
  io_bsp.bspx.push_back({kColoredLump, base::ByteVector(bytes.begin(), bytes.end())});
}

// Adds to the sum of each style what faces send back in addition to it, or takes it off again (`sign` -1).
void change_bounced_sums(float sign, std::vector<FaceLight>& io_light) {
  for (FaceLight& light : io_light)
    for (std::size_t more = 0; more < light.layers.size(); ++more) {
      if (light.layers[more].kind != LayerKind::kBounceMore) continue;
      const std::size_t luxels = light.layers[more].samples.size();
      std::vector<math::Vec3>& sum = light.layer(light.layers[more].style, LayerKind::kAdd, luxels).samples;
      for (std::size_t i = 0; i < luxels; ++i) sum[i] += light.layers[more].samples[i] * sign;
    }
}

// Adds bounced light, packs everything, and writes it into the level. `grid`: null for a level without one.
// The level changes only here, so all errors before leave it as it was.
LightSummary store_light(const PreparedLight& prepared, const LightOptions& options, const GridBlocks* grid,
                         LightWork& io_work, formats::Bsp& io_bsp, base::Jobs& io_jobs,
                         Warnings& io_warnings) {
  const LightSettings& settings = prepared.settings;
  if (has_bounces(prepared)) {
    change_bounced_sums(1, io_work.light);
    add_bounced_light(prepared.lit, io_work.bounces.seen, settings, options.palette, io_jobs, io_work.light);
    change_bounced_sums(-1, io_work.light);
  }
  const PackRules rules{settings, options.soft};
  PackedLight packed = pack_light_maps(prepared.lit, rules, io_work.light, io_jobs, io_bsp, io_warnings);
  if (prepared.styles_changed) io_bsp.entities = formats::write_entities(prepared.entities);
  std::erase_if(io_bsp.bspx, [](const formats::BspxLump& lump) {
    return std::ranges::find(kReplacedLumps, lump.name) != kReplacedLumps.end();
  });
  formats::set_hdr_light(packed.hdr, io_bsp);
  formats::set_light_directions(packed.directions, io_bsp);
  if (options.face_normals) formats::set_face_normals(make_face_normals(prepared.lit), io_bsp);
  if (packed.colored) set_colored_lump(packed.lit, io_bsp);
  if (grid != nullptr)
    io_bsp.bspx.push_back({formats::kLightGridLump, formats::write_light_grid(make_octree(*grid))});
  LightSummary summary{prepared.lights.size(), packed.lit_faces, packed.dark_faces,
                       io_bsp.lighting.size(), packed.colored,   {}};
  if (packed.colored) summary.lit = std::move(packed.lit);
  return summary;
}

std::vector<std::size_t> count_luxels_by_map(const LitLevel& lit) {
  std::vector<std::size_t> luxels;
  for (const LightMapShape& map : lit.maps) luxels.push_back(map.size());
  return luxels;
}

// A cache with the hashes and lights of what is about to be lit, but without results.
LightCache make_empty_cache(const PreparedLight& prepared, formats::Bsp unlit_bsp,
                            const LightOptions& options) {
  LightCache cache;
  cache.geometry = hash_geometry(std::move(unlit_bsp), prepared.lit, options);
  cache.dirt = hash_dirt(prepared.settings.dirt);
  cache.sky = hash_sky(prepared.beams, prepared.settings);
  for (const LightSource& light : prepared.lights) cache.lights.push_back(light.origin_world);
  return cache;
}

// `is_merged`: the shards before it, one place for each that there should be.
base::Status check_shard(const ReadShard& shard, std::uint64_t level, const std::vector<bool>& is_merged) {
  const ShardHeader& header = shard.header;
  if (header.level != level)
    return base::error(base::ErrorCode::kUsage,
                       "light shard {} of {} belongs to another level, or to other options: make it again",
                       header.index + 1, header.count);
  const bool is_one_of_them = header.count == is_merged.size();
  if (!is_one_of_them || is_merged[header.index])
    return base::error(base::ErrorCode::kUsage, "light shard {} of {} {} among {} shards", header.index + 1,
                       header.count, is_one_of_them ? "appears twice" : "is", is_merged.size());
  if (!shard.is_finished)
    return base::error(base::ErrorCode::kUsage, "light shard {} of {} is not finished: run its command again",
                       header.index + 1, header.count);
  return base::Ok{};
}

}  // namespace

base::Status check_light() {
  return RayScene::check();
}

base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings, LightCache* io_cache) {
  TRY(const PreparedLight prepared, prepare(io_bsp, face_keys, options, io_warnings));
  LightWork work = begin_light(prepared.lit, has_bounces(prepared));
  std::optional<GridBlocks> grid = begin_grid(prepared, options, io_warnings);
  SharedProgress shared(
      progress, work.light.size() + work.bounces.is_traced.size() + (grid ? grid->of_place.size() : 0));
  LightCache learned;
  std::optional<CachedLight> known;
  if (io_cache != nullptr) {
    learned = make_empty_cache(prepared, strip_light(io_bsp), options);
    known.emplace(*io_cache, learned, prepared.lights);
  }
  const LightPass pass{prepared,
                       options,
                       kWhole,
                       io_jobs,
                       shared,
                       known ? &*known : nullptr,
                       io_cache != nullptr ? &learned : nullptr};
  if (!add_direct_light(pass, work) || !add_bounces(pass, work)) return stopped();
  if (grid && !light_grid(pass, work, *grid)) return stopped();
  const LightSummary summary =
      store_light(prepared, options, grid ? &*grid : nullptr, work, io_bsp, io_jobs, io_warnings);
  if (io_cache != nullptr) {
    learned.bounces = std::move(work.bounces.seen);
    *io_cache = std::move(learned);
  }
  return summary;
}

// Work that was begun for another level, other options, or another shard starts over.
base::Result<LightShardBytes> light_shard(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                          const LightOptions& options, const LightShard& shard,
                                          base::Bytes begun, base::Jobs& io_jobs, Progress progress) {
  CHECK(shard.index < shard.count);
  Warnings reported_by_the_merge;
  TRY(const PreparedLight prepared, prepare(bsp, face_keys, options, reported_by_the_merge));
  const ShardHeader header{hash_light_input(strip_light(bsp), face_keys, options), shard.index, shard.count};
  LightWork work = begin_light(prepared.lit, has_bounces(prepared));
  const base::Result<ReadShard> read = read_shard(begun, count_luxels_by_map(prepared.lit), work);
  if (!read.ok() || read->header != header || !are_bounces_for(prepared, work))
    work = begin_light(prepared.lit, has_bounces(prepared));
  const auto done = [&] {
    return static_cast<std::size_t>(std::ranges::count(work.is_lit, 1) +
                                    std::ranges::count(work.bounces.is_traced, 1));
  };
  const std::size_t total = list_share(header, work.is_lit.size()).size() +
                            list_share(header, work.bounces.is_traced.size()).size();
  SharedProgress shared(progress, total, done());
  const LightPass pass{prepared, options, header, io_jobs, shared};
  if (add_direct_light(pass, work)) add_bounces(pass, work);
  return LightShardBytes{write_shard(header, work), done() == total};
}

// Checks all shards before it changes the level.
base::Result<LightSummary> merge_light(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, std::span<const NamedShard> shards,
                                       base::Jobs& io_jobs, Warnings& io_warnings) {
  TRY(const PreparedLight prepared, prepare(io_bsp, face_keys, options, io_warnings));
  const std::vector<std::size_t> luxels = count_luxels_by_map(prepared.lit);
  const std::uint64_t level = hash_light_input(strip_light(io_bsp), face_keys, options);
  LightWork work = begin_light(prepared.lit, has_bounces(prepared));
  std::vector<bool> merged(shards.size());
  for (const NamedShard& named : shards) {
    TRY(const ReadShard shard, read_shard(named.bytes, luxels, work).with_file(named.file));
    TRY_STATUS(check_shard(shard, level, merged).with_file(named.file));
    merged[shard.header.index] = true;
  }
  if (shards.empty()) return base::error(base::ErrorCode::kUsage, "there are no light shards to merge");
  if (!are_bounces_for(prepared, work))
    return base::malformed("light shards: their bounced light does not fit the level");
  std::optional<GridBlocks> grid = begin_grid(prepared, options, io_warnings);
  SharedProgress ignored(kIgnoreProgress, 0);
  if (grid) light_grid({prepared, options, kWhole, io_jobs, ignored}, work, *grid);
  return store_light(prepared, options, grid ? &*grid : nullptr, work, io_bsp, io_jobs, io_warnings);
}

}  // namespace temblor::compiler
