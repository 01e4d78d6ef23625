// Hot loop.
#include <cmath>

#include "render/spans/span_kernels.h"

namespace temblor::render {

namespace {

float at(const KernelPlane& plane, const SpanRun& run) {
  return static_cast<float>(plane.at_origin + plane.dx * run.x + plane.dy * run.y);
}

float larger(float a, float b) {
  return a > b ? a : b;
}
float smaller(float a, float b) {
  return a < b ? a : b;
}

std::int32_t clamped(float texel, std::int32_t last) {
  return static_cast<std::int32_t>(smaller(larger(texel, 0.0f), static_cast<float>(last)));
}

template <typename Texel>
class RunDrawer {
 public:
  RunDrawer(const SurfaceRuns& runs, const KernelTarget& target) : runs_(runs), target_(target) {}

  void draw(const SpanRun& run) {
    const std::size_t first = run.y * target_.width + run.x;
    out_ = static_cast<Texel*>(target_.pixels) + first;
    const float depth = at(runs_.depth, run), s = at(runs_.s, run), t = at(runs_.t, run);
    const float depth_step = static_cast<float>(runs_.depth.dx);
    const float s_step = static_cast<float>(runs_.s.dx), t_step = static_cast<float>(runs_.t.dx);
    if (target_.depth != nullptr) fill_depth(target_.depth + first, depth, depth_step, run.count);
    for (int i = 0; i < run.count; ++i) {
      const float lane = static_cast<float>(i);
      if (runs_.divide == KernelDivide::kNone) {
        put(i, s + lane * s_step, t + lane * t_step);
      } else if (runs_.divide == KernelDivide::kEveryPixel) {
        const float z = 1.0f / larger(depth + lane * depth_step, kFarthest);
        put(i, (s + lane * s_step) * z, (t + lane * t_step) * z);
      } else {
        const int last = run.count - i < kAffinePixels ? run.count - i : kAffinePixels;
        draw_affine(i, last, depth, depth_step, s, s_step, t, t_step);
        i += last - 1;
      }
    }
  }

 private:
  static void fill_depth(float* out, float depth, float step, int count) {
    for (int i = 0; i < count; ++i) out[i] = depth + static_cast<float>(i) * step;
  }

  void put(int i, float s, float t) {
    const std::int32_t texel = clamped(t, runs_.last_t) * runs_.texels_a_row + clamped(s, runs_.last_s);
    out_[i] = static_cast<const Texel*>(runs_.texels)[texel];
  }

  // Up to sixteen pixels between two exact points.
  void draw_affine(int first, int count, float depth, float depth_step, float s, float s_step, float t,
                   float t_step) {
    const float lane = static_cast<float>(first), end = static_cast<float>(first + count - 1);
    const float z_first = 1.0f / larger(depth + lane * depth_step, kFarthest);
    const float z_end = 1.0f / larger(depth + end * depth_step, kFarthest);
    const float s_first = (s + lane * s_step) * z_first, t_first = (t + lane * t_step) * z_first;
    const float pixels = static_cast<float>(count > 1 ? count - 1 : 1);
    const float s_pixel = ((s + end * s_step) * z_end - s_first) / pixels;
    const float t_pixel = ((t + end * t_step) * z_end - t_first) / pixels;
    for (int i = 0; i < count; ++i)
      put(first + i, s_first + static_cast<float>(i) * s_pixel, t_first + static_cast<float>(i) * t_pixel);
  }

  const SurfaceRuns& runs_;
  const KernelTarget& target_;
  Texel* out_ = nullptr;
};

template <typename Texel>
void draw_surface_runs(const SurfaceRuns& runs, const KernelTarget& target) {
  RunDrawer<Texel> drawer(runs, target);
  for (std::size_t i = 0; i < runs.run_count; ++i) drawer.draw(runs.runs[i]);
}

std::int32_t wrapped(float texel, std::int32_t size) {
  return static_cast<std::int32_t>(std::floor(texel)) & (size - 1);
}

template <typename Texel>
void draw_sky_run(const SkyRuns& sky, const SpanRun& run, const KernelTarget& target) {
  const std::size_t first = run.y * target.width + run.x;
  const float depth = at(sky.depth, run), depth_step = static_cast<float>(sky.depth.dx);
  float ray[3], step[3];
  for (int axis = 0; axis < 3; ++axis) {
    ray[axis] = static_cast<float>(sky.forward[axis] + sky.right[axis] * run.x + sky.down[axis] * run.y);
    step[axis] = static_cast<float>(sky.right[axis]);
  }
  const auto texel = [&](const void* layer, float s, float t) {
    return static_cast<const Texel*>(layer)[wrapped(t, sky.height) * sky.width + wrapped(s, sky.width)];
  };
  for (int i = 0; i < run.count; ++i) {
    const float lane = static_cast<float>(i);
    if (target.depth != nullptr)
      target.depth[first + static_cast<std::size_t>(i)] = depth + lane * depth_step;
    const float x = ray[0] + lane * step[0], y = ray[1] + lane * step[1];
    const float z = (ray[2] + lane * step[2]) * 3.0f;
    const float stretch = sky.scale / std::sqrt(x * x + y * y + z * z);
    const float s = x * stretch, t = y * stretch;
    Texel shown = texel(sky.clouds, s + sky.clouds_s, t + sky.clouds_t);
    if (shown == 0) shown = texel(sky.back, s + sky.back_s, t + sky.back_t);
    static_cast<Texel*>(target.pixels)[first + static_cast<std::size_t>(i)] = shown;
  }
}

// 1 + sin(2 pi turns), by two parabolas joined and bent once more: within 0.0012, and the same in vector
// code.
float swing(float turns) {
  const float r = turns - std::nearbyint(turns);
  const float parabola = r * 8.0f - r * std::abs(r) * 16.0f;
  return 1.0f + (parabola + (parabola * std::abs(parabola) - parabola) * 0.225f);
}

float bounded(float texel) {
  return smaller(larger(texel, -kFarTexel), kFarTexel);
}

template <typename Texel>
void draw_repeat_run(const RepeatRuns& repeat, const SpanRun& run, const KernelTarget& target) {
  const std::size_t first = run.y * target.width + run.x;
  const float depth = at(repeat.depth, run), s_base = at(repeat.s, run), t_base = at(repeat.t, run);
  const float depth_step = static_cast<float>(repeat.depth.dx);
  const float s_step = static_cast<float>(repeat.s.dx), t_step = static_cast<float>(repeat.t.dx);
  for (int i = 0; i < run.count; ++i) {
    const float lane = static_cast<float>(i);
    const float near = depth + lane * depth_step;
    if (target.depth != nullptr) target.depth[first + static_cast<std::size_t>(i)] = near;
    const float z = repeat.divide ? 1.0f / larger(near, kFarthest) : 1.0f;
    float s = bounded((s_base + lane * s_step) * z), t = bounded((t_base + lane * t_step) * z);
    if (repeat.amplitude != 0.0f) {
      const float s_swing = swing((t + repeat.phase) * kTurnsATexel);
      t = t + swing((s + repeat.phase) * kTurnsATexel) * repeat.amplitude;
      s = s + s_swing * repeat.amplitude;
    }
    static_cast<Texel*>(target.pixels)[first + static_cast<std::size_t>(i)] = static_cast<const Texel*>(
        repeat.texels)[wrapped(t, repeat.height) * repeat.width + wrapped(s, repeat.width)];
  }
}

}  // namespace

void draw_surface_runs_u8_scalar(const SurfaceRuns& runs, const KernelTarget& target) {
  draw_surface_runs<std::uint8_t>(runs, target);
}
void draw_surface_runs_u32_scalar(const SurfaceRuns& runs, const KernelTarget& target) {
  draw_surface_runs<std::uint32_t>(runs, target);
}

void draw_repeat_runs_u8_scalar(const RepeatRuns& runs, const KernelTarget& target) {
  for (std::size_t i = 0; i < runs.run_count; ++i) draw_repeat_run<std::uint8_t>(runs, runs.runs[i], target);
}
void draw_repeat_runs_u32_scalar(const RepeatRuns& runs, const KernelTarget& target) {
  for (std::size_t i = 0; i < runs.run_count; ++i) draw_repeat_run<std::uint32_t>(runs, runs.runs[i], target);
}

void draw_sky_runs_u8_scalar(const SkyRuns& runs, const KernelTarget& target) {
  for (std::size_t i = 0; i < runs.run_count; ++i) draw_sky_run<std::uint8_t>(runs, runs.runs[i], target);
}
void draw_sky_runs_u32_scalar(const SkyRuns& runs, const KernelTarget& target) {
  for (std::size_t i = 0; i < runs.run_count; ++i) draw_sky_run<std::uint32_t>(runs, runs.runs[i], target);
}

}  // namespace temblor::render
