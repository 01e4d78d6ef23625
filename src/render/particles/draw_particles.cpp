// Particles are projected in batches and then distributed to bands. The result does not depend on where a
// batch or a band ends.
#include "render/particles/draw_particles.h"

#include <algorithm>

#include "base/check.h"

namespace temblor::render {

namespace {

constexpr double kSideUnits = 0.8;
constexpr double kMinSideOf320 = 1, kMaxSideOf320 = 4;  // pixels of a picture 320 wide
constexpr std::size_t kBatch = 4096;                    // particles

// The fields of ParticleBatch and the color, by particle.
struct Squares {
  std::span<std::int32_t> left, top, side;
  std::span<float> depth;
  std::span<std::uint32_t> color;
};

void copy_axis(const math::Vec3d& from, float (&out)[3]) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(from[i]);
}

ParticleProjection make_projection(const ViewFrame& view) {
  ParticleProjection projection{};
  copy_axis(view.eye_world, projection.eye);
  copy_axis(view.axes.right, projection.right);
  copy_axis(view.axes.up, projection.up);
  copy_axis(view.axes.forward, projection.forward);
  projection.perspective = view.perspective;
  projection.pixels_per_unit = static_cast<float>(view.pixels_per_unit);
  projection.center_x = static_cast<float>(view.center_x);
  projection.center_y = static_cast<float>(view.center_y);
  projection.width = static_cast<float>(view.width);
  projection.height = static_cast<float>(view.height);
  projection.side_at_one_unit = static_cast<float>(kSideUnits * view.pixels_per_unit);
  // Pictures wider than 4:3 show more, not larger things.
  const double growth = std::min<double>(view.width, view.height * 4.0 / 3.0) / 320.0;
  projection.min_side = static_cast<float>(std::max(1.0, kMinSideOf320 * growth));
  projection.max_side = static_cast<float>(std::max(1.0, kMaxSideOf320 * growth));
  return projection;
}

Squares project(const ParticleCloud& cloud, const ParticleProjection& projection, bool simd_kernels,
                base::Jobs& jobs, base::Arena& arena) {
  const std::size_t count = cloud.size();
  const Squares squares{arena.allocate<std::int32_t>(count), arena.allocate<std::int32_t>(count),
                        arena.allocate<std::int32_t>(count), arena.allocate<float>(count),
                        arena.allocate<std::uint32_t>(count)};
  jobs.parallel_for((count + kBatch - 1) / kBatch, [&](std::size_t number) {
    const std::size_t first = number * kBatch;
    const ParticleBatch batch{cloud.x.data() + first,      cloud.y.data() + first,
                              cloud.z.data() + first,      std::min(kBatch, count - first),
                              squares.left.data() + first, squares.top.data() + first,
                              squares.side.data() + first, squares.depth.data() + first};
    (simd_kernels ? project_particles_simd : project_particles_scalar)(projection, batch);
  });
  return squares;
}

// The bands that a visible square touches, both inclusive.
struct BandRange {
  std::size_t first, last;
};
BandRange find_bands(int top, int side, int height, int band_rows) {
  return {static_cast<std::size_t>(std::max(top, 0) / band_rows),
          static_cast<std::size_t>((std::min(top + side, height) - 1) / band_rows)};
}

ParticleRect clip(const Squares& squares, std::size_t i, RowRange rows, int width) {
  const int left = squares.left[i], top = squares.top[i], side = squares.side[i];
  const int x = std::max(left, 0), y = std::max(top, rows.first);
  return {squares.depth[i],
          static_cast<std::uint16_t>(x),
          static_cast<std::uint16_t>(y),
          static_cast<std::uint16_t>(std::min(left + side, width) - x),
          static_cast<std::uint16_t>(std::min(top + side, rows.end) - y),
          squares.color[i]};
}

// Counts first, so that each band's rectangles are one array.
ParticleBands distribute_to_bands(const Squares& squares, const ViewFrame& view, int band_rows,
                                  base::Arena& arena) {
  const std::size_t band_count = static_cast<std::size_t>((view.height + band_rows - 1) / band_rows);
  const std::span<std::size_t> rects_in = arena.allocate_filled<std::size_t>(band_count, 0);
  const auto for_each_touched_band = [&](std::size_t i, auto&& body) {
    if (squares.side[i] == 0) return;
    const BandRange range = find_bands(squares.top[i], squares.side[i], view.height, band_rows);
    for (std::size_t band = range.first; band <= range.last; ++band) body(band);
  };
  for (std::size_t i = 0; i < squares.side.size(); ++i)
    for_each_touched_band(i, [&](std::size_t band) { ++rects_in[band]; });
  const std::span<std::span<ParticleRect>> rects = arena.allocate<std::span<ParticleRect>>(band_count);
  for (std::size_t band = 0; band < band_count; ++band) {
    rects[band] = arena.allocate<ParticleRect>(rects_in[band]);
    rects_in[band] = 0;
  }
  for (std::size_t i = 0; i < squares.side.size(); ++i)
    for_each_touched_band(i, [&](std::size_t band) {
      const int first_row = static_cast<int>(band) * band_rows;
      const RowRange rows{first_row, std::min(first_row + band_rows, view.height)};
      rects[band][rects_in[band]++] = clip(squares, i, rows, view.width);
    });
  return {rects};
}

}  // namespace

ParticleBands place_particles(const FrameContext& context, const ViewFrame& view) {
  const ParticleCloud& cloud = context.scene.particles;
  CHECK(
      cloud.y.size() == cloud.size() && cloud.z.size() == cloud.size() && cloud.color.size() == cloud.size(),
      "{}, {}, {}, {} particles", cloud.x.size(), cloud.y.size(), cloud.z.size(), cloud.color.size());
  if (cloud.size() == 0) return {};
  const Squares squares =
      project(cloud, make_projection(view), context.settings.simd_kernels, context.jobs, context.arena());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    squares.color[i] = context.is_indexed() ? cloud.color[i] : context.colors.rgb[cloud.color[i]];
  return distribute_to_bands(squares, view, context.settings.band_rows, context.arena());
}

void draw_particles(const ParticleBands& particles, std::size_t band, bool simd_kernels,
                    FrameBuffer& io_frame) {
  if (particles.rects.empty()) return;
  const bool indexed = io_frame.format() == PixelFormat::kIndexed;
  const ParticleTarget target{indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data(),
                              io_frame.depth().data(), static_cast<std::size_t>(io_frame.width())};
  const auto draw = indexed ? (simd_kernels ? draw_particles_u8_simd : draw_particles_u8_scalar)
                            : (simd_kernels ? draw_particles_u32_simd : draw_particles_u32_scalar);
  draw(particles.rects[band].data(), particles.rects[band].size(), target);
}

}  // namespace temblor::render
