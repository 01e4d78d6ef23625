// How a frame is drawn: speed, memory, and choices between two methods. Scene says what is drawn. Settings
// may hold any values: resolve_settings (render/frame) corrects them before each frame.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/parallel_for.h"

namespace temblor::render {

// kStock: Quake's rule, by the distance of the face's nearest point. kFootprint: by the texels under a pixel.
enum class MipRule { kStock, kFootprint };
// kExact divides by z at every pixel. kEvery16 divides at every 16th pixel, as stock Quake does, and
// interpolates linearly in between (Abrash, "Quake's 3-D Engine: The Big Picture").
enum class Perspective { kExact, kEvery16 };
// How a renderer on a graphics card blends texels that are not seen one to one. The CPU shows the nearest
// one, as kNearest does. kBilinear: between four texels of the CPU's mip level. kTrilinear: between two mip
// levels, which each pixel chooses. kAnisotropic: from more texels along the direction in which a face
// recedes.
enum class TextureFilter : std::uint8_t { kNearest, kBilinear, kTrilinear, kAnisotropic };
// The rasterizer of alias models. kAuto chooses the faster one for each model where both look the same.
enum class AliasRaster { kAuto, kAffine, kSubdivision };
// How the world is lit: as in the game, without light maps (every texture as it is), or light maps without
// textures. Mappers look at these two.
enum class LightView : std::uint8_t { kLit, kFullBright, kLightOnly };
// Debug views of `--show` and r_show. They are drawn over the finished picture.
enum class Show { kPicture, kFaces, kEdges, kSpans, kSurfaces, kMips, kPvs, kOverdraw, kDepth };

struct Settings {
  int threads = 1;  // at least 1
  base::JobBackend job_backend = base::JobBackend::kOneTbb;
  MipRule mip_rule = MipRule::kFootprint;
  TextureFilter filter = TextureFilter::kNearest;
  // Texels that cover many pixels keep sharp edges, one pixel wide, if the filter blends.
  bool sharp_texels = false;
  int force_mip = -1;  // 0 to 3: the mip level of every surface; negative: the rule decides
  Perspective perspective = Perspective::kExact;
  bool simd_kernels = true;  // false: the scalar reference kernels
  // Prefetches a surface block's texels before its spans in a band are drawn.
  bool prefetch = true;
  bool surface_cache = true;                         // false: builds every surface again in each frame
  std::size_t cache_bytes = std::size_t{256} << 20;  // budget of the surface cache
  // False: the whole level counts as potentially visible.
  bool use_pvs = true;
  // False skips the depth buffer and everything that needs it (models, sprites, particles), to measure its
  // cost. Frames with fog or deferred faces fill it anyway.
  bool fill_depth = true;
  // False: only models, sprites, and particles are drawn.
  bool draw_world = true;
  LightView light_view = LightView::kLit;
  bool colored_light = true;  // false: gray light even where the level has colored samples
  AliasRaster alias_raster = AliasRaster::kAuto;
  bool lit_liquids = true;  // false: liquids are full-bright even where the level has light for them
  bool caustics = false;    // moving light on what lies under water
  bool alias_snap = false;  // rounds alias vertices to whole pixels and maps textures affinely, as Quake did
  // Updates the light of odd and even faces in alternate frames; the other half shows the light of the
  // previous frame (Scene::light_before).
  bool relight_alternate = false;
  // Scan lines per band; 0 or less: chosen from the frame's size and the number of threads.
  int band_rows = 0;
  Show show = Show::kPicture;
  bool operator==(const Settings&) const = default;
};

}  // namespace temblor::render
