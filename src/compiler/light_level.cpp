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
#include "compiler/light/light_maps.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/phong.h"
#include "compiler/light/settings.h"
#include "compiler/light/sky_lights.h"
#include "compiler/light/surface_lights.h"
#include "formats/entities.h"

namespace temblor::compiler {
namespace {

constexpr const char* kColouredLump = "RGBLIGHTING";

// The level that light falls on: as it is, but unlit.
formats::Bsp unlit(const formats::Bsp& bsp) {
  formats::Bsp copy = bsp;
  copy.lighting.clear();
  copy.bspx.clear();
  for (formats::BspFace& face : copy.faces) {
    face.styles = {255, 255, 255, 255};
    face.light_offset = -1;
  }
  return copy;
}

LightSettings settings_of(const std::vector<formats::Entity>& entities, const LightOptions& options) {
  const auto world = std::find_if(entities.begin(), entities.end(), [](const formats::Entity& entity) {
    return entity.classname() == "worldspawn";
  });
  LightSettings settings = light_settings_of(world != entities.end() ? *world : formats::Entity{});
  if (options.bounces) settings.bounce.count = std::max(0, *options.bounces);
  if (options.fast) {
    settings.bounce.count = 0;
    settings.dirt.on = false;
  }
  return settings;
}

// All faces' direct light, or nothing when told to stop.
std::optional<std::vector<FaceLight>> direct_light(const DirectLightInput& input, base::Jobs& io_jobs,
                                                   Progress progress) {
  const std::size_t count = input.lit.level->faces.size();
  std::vector<FaceLight> light(count);
  std::atomic<bool> stopped{false};
  std::mutex reporting;
  std::size_t done = 0;
  io_jobs.parallel_for(count, [&](std::size_t face) {
    if (stopped.load(std::memory_order_relaxed)) return;
    if (input.lit.gets_light[face]) light[face] = direct_light_of(input, face);
    const std::lock_guard lock(reporting);
    if (!progress(++done, count)) stopped = true;
  });
  if (stopped) return std::nullopt;
  return light;
}

void set_coloured_lump(const formats::Lit& lit, formats::Bsp& io_bsp) {
  const base::Bytes bytes = std::as_bytes(std::span(lit.samples));
  io_bsp.bspx.push_back({kColouredLump, base::ByteVector(bytes.begin(), bytes.end())});
}

}  // namespace

base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(io_bsp.entities));
  const bool styles_changed = assign_switchable_styles(entities, io_warnings);
  const LightSettings settings = settings_of(entities, options);
  TRY(const LitLevel lit, make_lit_level(unlit(io_bsp), face_keys));
  TRY(const RayScene scene, RayScene::make(occluders_of(lit)));

  EntityLights found = entity_lights_of(entities, settings, io_warnings);
  const std::vector<LightSource> surface_lights = surface_lights_of(lit, found.templates);
  found.lights.insert(found.lights.end(), surface_lights.begin(), surface_lights.end());
  const int sky_rays = options.fast ? std::max(1, options.sky_rays / 8) : options.sky_rays;
  const std::vector<SkyBeam> beams = sky_beams_of(entities, settings, sky_rays);
  const PhongNormals phong(lit);
  const LeafSight sight(lit, found.lights);

  std::optional<std::vector<FaceLight>> light =
      direct_light({lit, scene, phong, sight, settings, found.lights, beams, shadow_sampling(options.extra)},
                   io_jobs, progress);
  if (!light) return base::error(base::ErrorCode::kUsage, "light was stopped");
  if (settings.bounce.count > 0) add_bounced_light(lit, scene, settings.bounce, io_jobs, *light);

  PackedLight packed = pack_light_maps(lit, settings, *light, io_bsp, io_warnings);
  if (styles_changed) io_bsp.entities = formats::write_entities(entities);
  std::erase_if(io_bsp.bspx, [](const formats::BspxLump& lump) { return lump.name == kColouredLump; });
  if (packed.coloured) set_coloured_lump(packed.lit, io_bsp);
  LightSummary summary{found.lights.size(),    packed.lit_faces, packed.dark_faces,
                       io_bsp.lighting.size(), packed.coloured,  {}};
  if (packed.coloured) summary.lit = std::move(packed.lit);
  return summary;
}

}  // namespace temblor::compiler
