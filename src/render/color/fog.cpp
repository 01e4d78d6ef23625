#include "render/color/fog.h"

namespace temblor::render {

namespace {

// Densities are per this many units.
constexpr float kDensityUnits = 64;
// Beyond these densities per unit, depths of steps may be too small or too large for FogCells.
constexpr float kMinCellRate = 1e-30f, kMaxCellRate = 1e30f;

}  // namespace

FrameFog::FrameFog(const Fog& fog, bool perspective, PixelFormat format, const ColorTables& tables,
                   FogTables& io_tables, bool simd_kernels)
    : row_{}, is_on_(fog.density > 0), format_(format), simd_kernels_(simd_kernels) {
  if (!is_on_) return;
  const float rate = fog.density / kDensityUnits;
  row_.perspective = perspective;
  row_.inverse_rate = 1 / rate;
  row_.sky_share = kSkyFogShare;
  row_.color = to_rgb(to_bytes(fog.color));
  row_.curve = &io_tables.curve();
  for (std::size_t i = 0; i < step_end_depths_.size(); ++i) {
    const float nearness = row_.curve->step_ends[i];
    step_end_depths_[i] = perspective ? nearness * rate : -row_.inverse_rate / nearness;
  }
  // The outermost limits must lie beyond all depths; in parallel projection the formula above gives 0 for
  // them.
  step_end_depths_.front() = row_.curve->step_ends[0];
  step_end_depths_.back() = row_.curve->step_ends[kFogSteps + 1];
  if (format != PixelFormat::kIndexed) return;
  row_.rows = io_tables.rows_for(fog.color, tables.palette, tables.match);
  has_cells_ = perspective && rate > kMinCellRate && rate < kMaxCellRate;
  if (has_cells_) cells_ = make_fog_cells(step_end_depths_.data());
}

void FrameFog::apply(void* io_pixels, std::span<const float> depth) const {
  run(make_row(io_pixels, depth));
}

void FrameFog::apply_sky(void* io_pixels, std::span<const float> depth, float sky, float sky_step) const {
  FogRow row = make_row(io_pixels, depth);
  row.has_sky = true;
  row.sky = sky;
  row.sky_step = sky_step;
  run(row);
}

FogRow FrameFog::make_row(void* io_pixels, std::span<const float> depth) const {
  FogRow row = row_;
  row.pixels = io_pixels;
  row.depth = depth.data();
  row.count = static_cast<std::int32_t>(depth.size());
  row.step_end_depths = step_end_depths_.data();
  row.cells = has_cells_ ? &cells_ : nullptr;
  return row;
}

void FrameFog::run(const FogRow& row) const {
  if (format_ == PixelFormat::kIndexed)
    simd_kernels_ ? fog_row_u8_simd(row) : fog_row_u8_scalar(row);
  else
    simd_kernels_ ? fog_row_u32_simd(row) : fog_row_u32_scalar(row);
}

}  // namespace temblor::render
