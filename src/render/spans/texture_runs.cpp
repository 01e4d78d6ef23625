#include "render/spans/texture_runs.h"

#include <cmath>
#include <numbers>

#include "render/spans/span_kernels.h"

namespace temblor::render {

namespace {

// The original's liquids.
constexpr double kTurbulenceAmplitude_texels = 8, kTurbulencePhases_s = 20;

struct Coordinates {
  std::span<const float> s, t;
};

// A size that coordinates wrap at, and the cheap way where it is a power of two.
class Wrap {
 public:
  explicit Wrap(std::int32_t size) : size_(size), power_of_two_((size & (size - 1)) == 0) {}
  std::int32_t operator()(float coordinate) const {
    const std::int32_t whole = static_cast<std::int32_t>(std::floor(coordinate));
    if (power_of_two_) return whole & (size_ - 1);
    const std::int32_t rest = whole % size_;
    return rest < 0 ? rest + size_ : rest;
  }

 private:
  std::int32_t size_;
  bool power_of_two_;
};

// Coordinates beyond this many texels are not told apart (and fit 32-bit numbers): far out on faces that
// stretch for ever.
float bounded(float texel) {
  constexpr float kMost = 1e9f;
  return texel > -kMost ? (texel < kMost ? texel : kMost) : -kMost;
}

Coordinates find_run_coordinates(const TextureRunFrame& frame, const DrawItem& item, const SpanRun& run,
                                 float* out_depth, base::Arena& scratch) {
  const std::span<float> s = scratch.allocate<float>(run.count), t = scratch.allocate<float>(run.count);
  const auto at = [&](const ScreenPlane& plane) { return static_cast<float>(plane.at(run.x, run.y)); };
  const CoordinateRun job{at(item.depth),
                          static_cast<float>(item.depth.dx),
                          at(item.s),
                          static_cast<float>(item.s.dx),
                          at(item.t),
                          static_cast<float>(item.t.dx),
                          frame.view.perspective,
                          run.count,
                          out_depth,
                          s.data(),
                          t.data()};
  frame.vector_kernels ? find_coordinates_vector(job) : find_coordinates_plain(job);
  for (std::size_t i = 0; i < s.size(); ++i) {
    s[i] = bounded(s[i]);
    t[i] = bounded(t[i]);
  }
  return {s, t};
}

// Writes a run's palette indices.
void sample_texture(const DrawItem& item, const Coordinates& at, std::span<std::uint8_t> out) {
  const auto mip = item.mip;
  const std::int32_t width = std::max(1, static_cast<std::int32_t>(item.texture->width >> mip));
  const std::int32_t height = std::max(1, static_cast<std::int32_t>(item.texture->height >> mip));
  const Wrap wrap_s(width), wrap_t(height);
  const std::uint8_t* texels = item.texture->mips[mip].data();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = texels[wrap_t(at.t[i]) * width + wrap_s(at.s[i])];
}

void sample_liquid(const TextureRunFrame& frame, const DrawItem& item, const Coordinates& at,
                   std::span<std::uint8_t> out) {
  const std::int32_t width = static_cast<std::int32_t>(item.texture->width);
  const Wrap wrap_s(width), wrap_t(static_cast<std::int32_t>(item.texture->height)), wrap_table(128);
  const std::uint8_t* texels = item.texture->mips[0].data();
  for (std::size_t i = 0; i < out.size(); ++i) {
    const float s = at.s[i] + frame.turbulence[static_cast<std::size_t>(wrap_table(at.t[i]))];
    const float t = at.t[i] + frame.turbulence[static_cast<std::size_t>(wrap_table(at.s[i]))];
    out[i] = texels[wrap_t(t) * width + wrap_s(s)];
  }
}

}  // namespace

TextureRunFrame make_texture_run_frame(const Scene& scene, const Settings& settings, const ViewFrame& view,
                                       const BuildTables& tables) {
  TextureRunFrame frame{view, tables, scene.time_s, settings.vector_kernels, settings.fill_depth, {}};
  const double size = static_cast<double>(frame.turbulence.size());
  const double phase = std::fmod(scene.time_s * kTurbulencePhases_s, size);
  for (std::size_t i = 0; i < frame.turbulence.size(); ++i)
    frame.turbulence[i] =
        static_cast<float>(kTurbulenceAmplitude_texels *
                           (1 + std::sin((static_cast<double>(i) + phase) * 2 * std::numbers::pi / size)));
  return frame;
}

void draw_texture_runs(const TextureRunFrame& frame, const DrawItem& item, std::span<const SpanRun> runs,
                       base::Arena& scratch, FrameBuffer& io_frame) {
  const std::uint8_t* lit = frame.tables.colormap.rows.data() + std::size_t{item.light_row} * 256;
  for (const SpanRun& run : runs) {
    scratch.reset();
    const std::size_t first = std::size_t{run.y} * static_cast<std::size_t>(io_frame.width()) + run.x;
    float* depth = frame.fill_depth ? io_frame.depth().data() + first : nullptr;
    const std::span<std::uint8_t> indices = scratch.allocate<std::uint8_t>(run.count);
    const Coordinates at = find_run_coordinates(frame, item, run, depth, scratch);
    if (item.kind == ItemKind::kLiquid)
      sample_liquid(frame, item, at, indices);
    else
      sample_texture(item, at, indices);
    if (io_frame.format() == PixelFormat::kIndexed) {
      std::uint8_t* out = io_frame.indexed().data() + first;
      for (std::size_t i = 0; i < indices.size(); ++i) out[i] = lit[indices[i]];
    } else {
      std::uint32_t* out = io_frame.rgb().data() + first;
      for (std::size_t i = 0; i < indices.size(); ++i) out[i] = frame.tables.rgb[lit[indices[i]]];
    }
  }
}

}  // namespace temblor::render
