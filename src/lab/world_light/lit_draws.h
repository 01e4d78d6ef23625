// The draws of a frame that techniques of light draw by themselves, without surface blocks: opaque faces with
// light maps. They show neither marks nor the tint of colored dynamic lights in indexed frames: those belong
// to surfaces. Textures with a glow of their own are left to the engine.
#pragma once

#include <span>
#include <vector>

#include "base/arena.h"
#include "base/function_ref.h"
#include "lab/world_light/kernels/lit_kernels.h"
#include "render/frame/frame_stages.h"

namespace temblor::lab {

struct LitDraw {
  const render::BlockRequest* request = nullptr;  // null: the engine draws it
  TileTexture texture{};
  std::int32_t first_s = 0, first_t = 0;  // of LitSpans
};

struct LitDraws {
  std::span<LitDraw> all;              // by draw number
  std::span<const std::uint32_t> own;  // numbers of the draws without blocks
  render::SurfaceRequests left;        // for the engine
};

// Everything lives in the frame's arena. The textures are copied in the frame's format, each once.
LitDraws choose_lit_draws(const render::FrameContext& context, const render::SurfaceRequests& requests);

// Prepares own draws in parallel, with memory that is kept for the next frame.
class LitPreparation {
 public:
  // Calls `prepare` for each of the draw numbers. The memory lasts until the next call.
  using Prepare = base::FunctionRef<void(std::uint32_t number, base::Arena& arena)>;
  void run(const render::FrameContext& context, std::span<const std::uint32_t> own, Prepare prepare);
  std::size_t used_bytes() const;

 private:
  std::vector<base::Arena> arenas_;  // by job
};

// One kernel for each pixel format, vectorized and not.
template <typename Kernel>
struct LitKernels {
  Kernel u8_simd, u8_scalar, u32_simd, u32_scalar;

  Kernel choose(const render::SpanSources& sources) const {
    if (sources.format == render::PixelFormat::kIndexed) return sources.simd_kernels ? u8_simd : u8_scalar;
    return sources.simd_kernels ? u32_simd : u32_scalar;
  }
};

template <typename Kernel>
LitKernels(Kernel, Kernel, Kernel, Kernel) -> LitKernels<Kernel>;

// The job of a draw for the kernels, without spans.
LitSpans make_lit_spans(const render::FrameContext& context, const render::ViewFrame& view,
                        const render::SurfaceDraw& draw, const LitDraw& lit);

// Draws the band: calls `draw_own` for the spans of each own draw, and the engine for the others.
struct BandPicture {
  const render::FrameContext& context;
  const render::ViewFrame& view;
  const render::Band& band;
  const render::SpanSources& sources;
};
using DrawOwn = base::FunctionRef<void(std::uint32_t number, std::span<const render::Span> spans,
                                       const render::KernelTarget& target)>;
void draw_lit_band(const BandPicture& picture, std::span<const LitDraw> draws, DrawOwn draw_own,
                   render::FrameBuffer& io_frame);

}  // namespace temblor::lab
