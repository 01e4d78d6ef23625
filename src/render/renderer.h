// The world renderer: sorted edges, cached surfaces, perspective spans. One call draws one frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/parallel_for.h"
#include "formats/images/palette.h"
#include "render/draw_list.h"
#include "render/frame.h"
#include "render/scene.h"

namespace temblor::render {

enum class MipRule { kStock, kFootprint };
enum class Perspective { kExact, kEvery16 };
// Triangles of alias models: kAuto takes for each model the faster one that shows no difference.
enum class AliasRaster { kAuto, kAffine, kSubdivision };
enum class Show { kPicture, kFaces, kEdges, kSpans, kSurfaces, kMips, kPvs, kOverdraw, kDepth };

struct Settings {
  int threads = 1;
  base::JobBackend job_backend = base::JobBackend::kOneTbb;
  MipRule mip_rule = MipRule::kFootprint;
  int force_mip = -1;  // 0..3: every surface at that level
  Perspective perspective = Perspective::kExact;
  bool vector_kernels = true;  // false: the plain C++ twins
  bool prefetch = true;        // asks for a surface's texels before drawing from them
  bool surface_cache = true;   // false: everything is built anew for each frame
  std::size_t cache_bytes = std::size_t{256} << 20;
  bool use_pvs = true;
  // False: for measuring what filling 1/z costs; nothing that needs it (models) is drawn then.
  bool fill_depth = true;
  bool colored_light = true;  // false: gray light also where the level has colors
  AliasRaster alias_raster = AliasRaster::kAuto;
  bool alias_snap = false;  // alias models' vertices at whole pixels and textures affine, as the original
  // Faces of odd and of even number follow changes of light in turn, each every second frame, and show the
  // light of the frame before in between (Scene::light_before).
  bool relight_alternate = false;
  int band_rows = 0;  // scan lines a band; 0: chosen from size and threads
  Show show = Show::kPicture;
  bool operator==(const Settings&) const = default;
};

// Which face a pixel shows: kept when asked for, for tests and `show`.
struct PixelFace {
  std::uint32_t instance;  // 0: the world; i + 1: Scene::brush_models[i]; kNothing: background
  std::uint32_t face;
  static constexpr std::uint32_t kNothing = 0xffffffff;
};

// Not thread-safe; several can live in one process.
class Renderer {
 public:
  Renderer(const formats::Palette& palette, const formats::Colormap& colormap);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  // Draws `scene` into every pixel of `io_frame`. Width and height from 1 to 8192. The same scene and
  // settings give the same pixels, whatever was drawn before and however many threads.
  FrameStats render(const Scene& scene, const Settings& settings, FrameBuffer& io_frame);

  // Draws `list` over `io_frame`, command by command. CHECKs that parts lie in their pictures; areas may lie
  // anywhere. Opacity is blended exactly in rgb; in indexed color it is rounded to a sixteenth, and the
  // palette's nearest color is shown. The time it takes is added to `io_stats`.
  void draw_overlay(const DrawList& list, FrameBuffer& io_frame, FrameStats& io_stats) const;

  // The last frame's spans, expanded: one entry a pixel, and how often each pixel was written. For tests.
  void pixel_faces(std::span<PixelFace> out_faces, std::span<std::uint8_t> out_writes) const;

  // Forgets all cached surfaces (a cold frame follows).
  void drop_surfaces();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Palette expansion: what a window shows. `out` has one 0xffRRGGBB a pixel; kRgb frames are copied.
void present(const FrameBuffer& frame, const formats::Palette& palette, bool vector_kernels, base::Jobs& jobs,
             std::span<std::uint32_t> out);

}  // namespace temblor::render
