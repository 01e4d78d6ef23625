#include "host/video/render_settings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <thread>

namespace temblor::host {
namespace {

// Names of the choices, in the order of the enumerations that read() casts them to, unless a table of values
// follows. The first name is the default.
constexpr std::array<std::string_view, 2> kJobBackends = {"onetbb", "stdthread"};
constexpr std::array<std::string_view, 2> kMipRules = {"footprint", "stock"};
constexpr std::array<render::MipRule, 2> kMipRuleValues = {render::MipRule::kFootprint,
                                                           render::MipRule::kStock};
constexpr std::array<std::string_view, 4> kFilters = {"nearest", "bilinear", "trilinear", "anisotropic"};
constexpr std::array<std::string_view, 2> kPerspectives = {"exact", "every16"};
constexpr std::array<std::string_view, 9> kShows = {"picture", "faces", "edges",    "spans", "surfaces",
                                                    "mips",    "pvs",   "overdraw", "depth"};

constexpr std::array<std::string_view, 3> kAliasRasters = {"auto", "affine", "subdivision"};

constexpr double kBytesPerMebibyte = 1024.0 * 1024.0;

}  // namespace

RenderSettings::RenderSettings(command::Variables& variables) {
  const render::Settings defaults;
  threads_ = variables.add_int("r_threads", 0, 0, 256, "Threads that draw a frame; 0: one per core.");
  job_backend_ = variables.add_choice("r_job_backend", kJobBackends, "The library that runs the threads.");
  filter_ = variables.add_choice("r_filter", kFilters,
                                 "Blending of texels with OpenGL; the CPU shows the nearest.");
  sharp_texels_ = variables.add_bool("r_filter_sharp", defaults.sharp_texels,
                                     "Keeps large texels sharp where r_filter blends.");
  mip_rule_ = variables.add_choice("r_mip_rule", kMipRules,
                                   "How a surface's mip level is chosen: from the pixels that a texel "
                                   "covers, or by the thresholds of the stock game.");
  force_mip_ = variables.add_int("r_mip_force", defaults.force_mip, -1, 3,
                                 "Draws all surfaces at this mip level; -1: automatic.");
  perspective_ = variables.add_choice("r_perspective", kPerspectives,
                                      "Texture perspective: exact at every pixel, or one division every 16 "
                                      "pixels, like the stock game.");
  simd_kernels_ = variables.add_bool("r_simd", defaults.simd_kernels,
                                     "Uses SIMD instructions; 0: the scalar reference code.");
  prefetch_ = variables.add_bool("r_prefetch", defaults.prefetch,
                                 "Prefetches a surface's texels before it is drawn.");
  surface_cache_ =
      variables.add_bool("r_surface_cache", defaults.surface_cache,
                         "Keeps lit surfaces from frame to frame; 0: rebuilds them in every frame.");
  cache_mb_ = variables.add_float("r_cache_mb", static_cast<double>(defaults.cache_bytes) / kBytesPerMebibyte,
                                  0, 65536, "Size of the surface cache, in MiB.");
  use_pvs_ = variables.add_bool("r_use_pvs", defaults.use_pvs,
                                "Skips leaves outside the potentially visible set (PVS).");
  fill_depth_ = variables.add_bool("r_fill_depth", defaults.fill_depth,
                                   "Fills the depth buffer; 0 only to measure its cost.");
  draw_world_ = variables.add_bool("r_drawworld", defaults.draw_world, "Draws the level itself.");
  full_bright_ = variables.add_bool("r_fullbright", false, "Draws the level without light and shadows.");
  light_only_ = variables.add_bool("r_lightmap", false, "Draws the level's light without its textures.");
  colored_light_ =
      variables.add_bool("r_colored_light", defaults.colored_light,
                         "Shows colored light: the level's in true color only, that of blasts always.");
  variables.add_alias("r_coloured_light", "r_colored_light");  // old spelling
  lit_liquids_ = variables.add_bool("r_litwater", defaults.lit_liquids,
                                    "Lights liquids, in levels that were compiled for it.");
  caustics_ = variables.add_bool("r_caustics", defaults.caustics, "Water throws moving light on its ground.");
  relight_alternate_ =
      variables.add_bool("r_relight_alternate", defaults.relight_alternate,
                         "Relights only half of the faces with changing light in each frame.");
  band_rows_ =
      variables.add_int("r_band_rows", defaults.band_rows, 0, 8192, "Scan lines per job; 0: automatic.");
  alias_raster_ = variables.add_choice("r_alias_raster", kAliasRasters,
                                       "How the triangles of models are filled: by scan lines, by recursive "
                                       "subdivision, or automatically by the size of each model.");
  alias_snap_ = variables.add_bool("r_alias_snap", defaults.alias_snap,
                                   "Snaps vertices of models to whole pixels and draws their textures "
                                   "without perspective, like the stock game.");
  show_ = variables.add_choice("r_show", kShows, "Debug view: shows how the picture was drawn.");
}

render::Settings RenderSettings::read(const command::Variables& variables) const {
  render::Settings settings;
  const auto threads = static_cast<int>(variables.int_value(threads_));
  settings.threads =
      threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  settings.job_backend = static_cast<base::JobBackend>(variables.choice_value(job_backend_));
  settings.filter = static_cast<render::TextureFilter>(variables.choice_value(filter_));
  settings.sharp_texels = variables.bool_value(sharp_texels_);
  settings.mip_rule = kMipRuleValues[variables.choice_value(mip_rule_)];
  settings.force_mip = static_cast<int>(variables.int_value(force_mip_));
  settings.perspective = static_cast<render::Perspective>(variables.choice_value(perspective_));
  settings.simd_kernels = variables.bool_value(simd_kernels_);
  settings.prefetch = variables.bool_value(prefetch_);
  settings.surface_cache = variables.bool_value(surface_cache_);
  settings.cache_bytes = static_cast<std::size_t>(variables.float_value(cache_mb_) * kBytesPerMebibyte);
  settings.use_pvs = variables.bool_value(use_pvs_);
  settings.fill_depth = variables.bool_value(fill_depth_);
  settings.draw_world = variables.bool_value(draw_world_);
  settings.light_view = variables.bool_value(light_only_)    ? render::LightView::kLightOnly
                        : variables.bool_value(full_bright_) ? render::LightView::kFullBright
                                                             : render::LightView::kLit;
  settings.colored_light = variables.bool_value(colored_light_);
  settings.lit_liquids = variables.bool_value(lit_liquids_);
  settings.caustics = variables.bool_value(caustics_);
  settings.relight_alternate = variables.bool_value(relight_alternate_);
  settings.band_rows = static_cast<int>(variables.int_value(band_rows_));
  settings.alias_raster = static_cast<render::AliasRaster>(variables.choice_value(alias_raster_));
  settings.alias_snap = variables.bool_value(alias_snap_);
  settings.show = static_cast<render::Show>(variables.choice_value(show_));
  return settings;
}

}  // namespace temblor::host
