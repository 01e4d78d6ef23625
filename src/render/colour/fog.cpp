#include "render/colour/fog.h"

#include <limits>

namespace temblor::render {

namespace {

// Density is given for this many units.
constexpr float kDensityUnits = 64;

constexpr float kNoSky = std::numeric_limits<float>::quiet_NaN();

}  // namespace

FrameFog::FrameFog(const Fog& fog, bool perspective, PixelFormat format, const ColourTables& tables,
                   FogTables& io_tables, bool vector_kernels)
    : row_{}, format_(format), vector_kernels_(vector_kernels) {
  row_.perspective = perspective;
  row_.rate = fog.density > 0 ? fog.density / kDensityUnits : 0;
  row_.sky = kNoSky;
  row_.sky_share = kSkyFogShare;
  row_.colour = to_rgb(to_bytes(fog.colour));
  if (is_on() && format == PixelFormat::kIndexed)
    row_.rows = io_tables.rows_for(fog.colour, tables.palette, tables.match);
}

void FrameFog::apply(void* io_pixels, std::span<const float> depth) const {
  FogRow row = row_;
  row.pixels = io_pixels;
  row.depth = depth.data();
  row.count = static_cast<std::int32_t>(depth.size());
  run(row);
}

void FrameFog::apply_sky(void* io_pixels, std::span<const float> depth, float sky, float sky_step) const {
  FogRow row = row_;
  row.pixels = io_pixels;
  row.depth = depth.data();
  row.count = static_cast<std::int32_t>(depth.size());
  row.sky = sky;
  row.sky_step = sky_step;
  run(row);
}

void FrameFog::run(const FogRow& row) const {
  if (format_ == PixelFormat::kIndexed)
    vector_kernels_ ? fog_row_u8_vector(row) : fog_row_u8_plain(row);
  else
    vector_kernels_ ? fog_row_u32_vector(row) : fog_row_u32_plain(row);
}

}  // namespace temblor::render
