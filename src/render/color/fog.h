// A frame's fog, ready for the pixels: of the finished opaque picture, and of each translucent thing before
// it is blended in.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/color/color_tables.h"
#include "render/color/fog_kernels.h"
#include "render/frame.h"
#include "render/scene.h"

namespace temblor::render {

// Sky is fogged as if it were at one distance, in 256ths: half of it shows, as mappers have come to expect.
constexpr std::int32_t kSkyFogShare = 128;

class FrameFog {
 public:
  // `io_tables` follow the fog's color (indexed only).
  FrameFog(const Fog& fog, bool perspective, PixelFormat format, const ColorTables& tables,
           FogTables& io_tables, bool vector_kernels);

  // Without density nothing changes, and nothing need be called.
  bool is_on() const { return is_on_; }

  // Fogs pixels of the frame's format that lie at those depths (ViewFrame::depth). In rgb their alpha stays;
  // indexed, 255 does.
  void apply(void* io_pixels, std::span<const float> depth) const;
  // The same where pixel i is sky if its depth is still exactly sky + i * sky_step.
  void apply_sky(void* io_pixels, std::span<const float> depth, float sky, float sky_step) const;

 private:
  FogRow row_of(void* io_pixels, std::span<const float> depth) const;
  void run(const FogRow& row) const;

  FogRow row_;
  std::array<float, kFogSteps + 2> step_end_depths_{};
  bool is_on_;
  PixelFormat format_;
  bool vector_kernels_;
};

}  // namespace temblor::render
