// A frame's fog, prepared for pixels: it is applied to the finished opaque picture, and to every translucent
// thing before that is blended in. Stock Quake has no fog.
//
//   share of fog = 1 - exp(-(density * z / 64)^2)
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/color/color_tables.h"
#include "render/color/fog_kernels.h"
#include "render/frame_buffer.h"
#include "render/scene.h"

namespace temblor::render {

// Sky has no distance of its own: it gets this share of fog, in 256ths. Half of it shows, as mappers expect.
constexpr std::int32_t kSkyFogShare = 128;

class FrameFog {
 public:
  // `io_tables` are recomputed if the fog's color has changed (indexed only).
  FrameFog(const Fog& fog, bool perspective, PixelFormat format, const ColorTables& tables,
           FogTables& io_tables, bool simd_kernels);

  // False without density: then nothing has to be called.
  bool is_on() const { return is_on_; }

  // Fogs pixels of the frame's format, which have these depths (ViewFrame::depth). In rgb, alpha stays;
  // indexed, 255 stays.
  void apply(void* io_pixels, std::span<const float> depth) const;
  // The same, but pixel i is sky if its depth is exactly sky + i * sky_step: nothing was drawn over it.
  void apply_sky(void* io_pixels, std::span<const float> depth, float sky, float sky_step) const;

 private:
  FogRow make_row(void* io_pixels, std::span<const float> depth) const;
  void run(const FogRow& row) const;

  FogRow row_;  // everything that is the same for all rows of the frame
  std::array<float, kFogSteps + 2> step_end_depths_{};
  FogCells cells_{};
  bool has_cells_ = false;
  bool is_on_;
  PixelFormat format_;
  bool simd_kernels_;
};

}  // namespace temblor::render
