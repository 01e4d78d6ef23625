// Light at single points of a face, for techniques that interpolate between vertices.
#pragma once

#include <array>
#include <optional>

#include "lab/world_light/kernels/lit_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::lab {

// In the units of the kernels: darkness, or blue, green, and red.
using PointLight = std::array<float, kMaxChannels>;

// A point of a face: in texels of mip 0 from the face's first one.
struct FacePoint {
  double s, t;
};

// The light of one face of a frame: light styles and dynamic lights together, without caustics.
class VertexLighter {
 public:
  // `arena` holds temporary memory.
  VertexLighter(const render::FrameContext& context, const render::BlockRequest& request,
                const render::FacePlacement& placed, base::Arena& arena);

  // Between the four samples around the point, like a surface. Outside the light map: that of its border.
  PointLight find_light(const FacePoint& point) const;
  // 1 or 3 of PointLight are used.
  int channels() const { return channels_; }

  // The brightest sample inside of the polygon, which is convex; nothing if a corner is as bright.
  std::optional<FacePoint> find_brightest(std::span<const FacePoint> polygon) const;

 private:
  std::span<const std::int16_t> make_samples(const render::SampleGrid& grid, std::size_t& out_stride) const;

  const render::FrameContext& context_;
  const world::Face& face_;
  base::Arena& arena_;
  render::SampleGrid whole_;
  render::TileLight light_;
  int channels_;
};

}  // namespace temblor::lab
