// Hot loop. The scalar reference: it defines the results of the span kernels.
#include <cmath>

#include "render/spans/span_kernels.h"

namespace temblor::render {

namespace {

float at(const KernelPlane& plane, const Span& span) {
  return static_cast<float>(plane.at_origin + plane.dx * span.x + plane.dy * span.y);
}

float larger(float a, float b) {
  return a > b ? a : b;
}
float smaller(float a, float b) {
  return a < b ? a : b;
}

// Written so that NaN becomes 0.
std::int32_t clamped(float texel, std::int32_t last) {
  return static_cast<std::int32_t>(smaller(larger(texel, 0.0f), static_cast<float>(last)));
}

// Draws spans of one surface block.
template <typename Texel>
class SpanDrawer {
 public:
  SpanDrawer(const SurfaceSpans& spans, const KernelTarget& target) : spans_(spans), target_(target) {}

  void draw(const Span& span) {
    const std::size_t first = span.y * target_.width + span.x;
    out_ = static_cast<Texel*>(target_.pixels) + first;
    const Line depth = line(spans_.depth, span), s = line(spans_.s, span), t = line(spans_.t, span);
    if (target_.depth != nullptr) fill_depth(target_.depth + first, depth, span.count);
    for (int i = 0; i < span.count; ++i) {
      const float lane = static_cast<float>(i);
      if (spans_.divide == KernelDivide::kNone) {
        put(i, s.at(lane), t.at(lane));
      } else if (spans_.divide == KernelDivide::kEveryPixel) {
        const float z = 1.0f / larger(depth.at(lane), kMinSpanDepth);
        put(i, s.at(lane) * z, t.at(lane) * z);
      } else {
        const int last = span.count - i < spans_.affine_pixels ? span.count - i : spans_.affine_pixels;
        draw_affine(i, last, depth, s, t);
        i += last - 1;
      }
    }
  }

 private:
  // A linear function along the span.
  struct Line {
    float base, step;
    float at(float lane) const { return base + lane * step; }
  };
  static Line line(const KernelPlane& plane, const Span& span) {
    return {render::at(plane, span), static_cast<float>(plane.dx)};
  }

  static void fill_depth(float* out, const Line& depth, int count) {
    for (int i = 0; i < count; ++i) out[i] = depth.at(static_cast<float>(i));
  }

  void put(int i, float s, float t) {
    const std::int32_t texel = clamped(t, spans_.last_t) * spans_.texels_per_row + clamped(s, spans_.last_s);
    out_[i] = static_cast<const Texel*>(spans_.texels)[texel];
  }

  // Pixels interpolated between two exact points.
  void draw_affine(int first, int count, const Line& depth, const Line& s, const Line& t) {
    const float lane = static_cast<float>(first), end = static_cast<float>(first + count - 1);
    const float z_first = 1.0f / larger(depth.at(lane), kMinSpanDepth);
    const float z_end = 1.0f / larger(depth.at(end), kMinSpanDepth);
    const float s_first = s.at(lane) * z_first, t_first = t.at(lane) * z_first;
    const float pixels = static_cast<float>(count > 1 ? count - 1 : 1);
    const float s_pixel = (s.at(end) * z_end - s_first) / pixels;
    const float t_pixel = (t.at(end) * z_end - t_first) / pixels;
    for (int i = 0; i < count; ++i)
      put(first + i, s_first + static_cast<float>(i) * s_pixel, t_first + static_cast<float>(i) * t_pixel);
  }

  const SurfaceSpans& spans_;
  const KernelTarget& target_;
  Texel* out_ = nullptr;
};

template <typename Texel>
void draw_surface_spans(const SurfaceSpans& spans, const KernelTarget& target) {
  SpanDrawer<Texel> drawer(spans, target);
  for (std::size_t i = 0; i < spans.span_count; ++i) drawer.draw(spans.spans[i]);
}

// `size` is a power of two.
std::int32_t wrapped(float texel, std::int32_t size) {
  return static_cast<std::int32_t>(std::floor(texel)) & (size - 1);
}

template <typename Texel>
void draw_sky_span(const SkySpans& sky, const Span& span, const KernelTarget& target) {
  const std::size_t first = span.y * target.width + span.x;
  const float depth = at(sky.depth, span), depth_step = static_cast<float>(sky.depth.dx);
  float ray[3], step[3];
  for (int axis = 0; axis < 3; ++axis) {
    ray[axis] = static_cast<float>(sky.forward[axis] + sky.right[axis] * span.x + sky.down[axis] * span.y);
    step[axis] = static_cast<float>(sky.right[axis]);
  }
  const auto texel = [&](const void* layer, float s, float t) {
    return static_cast<const Texel*>(layer)[wrapped(t, sky.height) * sky.width + wrapped(s, sky.width)];
  };
  for (int i = 0; i < span.count; ++i) {
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

// 1 + sin(2 pi turns), approximated by two parabolas and a correction: within 0.0012, and identical in SIMD.
float swing(float turns) {
  const float r = turns - std::nearbyint(turns);
  const float parabola = r * 8.0f - r * std::abs(r) * 16.0f;
  return 1.0f + (parabola + (parabola * std::abs(parabola) - parabola) * 0.225f);
}

float bounded(float texel) {
  return smaller(larger(texel, -kFarTexel), kFarTexel);
}

template <typename Texel>
void draw_repeat_span(const RepeatSpans& repeat, const Span& span, const KernelTarget& target) {
  const std::size_t first = span.y * target.width + span.x;
  const float depth = at(repeat.depth, span), s_base = at(repeat.s, span), t_base = at(repeat.t, span);
  const float depth_step = static_cast<float>(repeat.depth.dx);
  const float s_step = static_cast<float>(repeat.s.dx), t_step = static_cast<float>(repeat.t.dx);
  for (int i = 0; i < span.count; ++i) {
    const float lane = static_cast<float>(i);
    const float near = depth + lane * depth_step;
    if (target.depth != nullptr) target.depth[first + static_cast<std::size_t>(i)] = near;
    const float z = repeat.divide ? 1.0f / larger(near, kMinSpanDepth) : 1.0f;
    float s = bounded((s_base + lane * s_step) * z), t = bounded((t_base + lane * t_step) * z);
    if (repeat.amplitude != 0.0f) {
      const float s_swing = swing((t + repeat.phase) * repeat.turns_per_texel);
      t = t + swing((s + repeat.phase) * repeat.turns_per_texel) * repeat.amplitude;
      s = s + s_swing * repeat.amplitude;
    }
    static_cast<Texel*>(target.pixels)[first + static_cast<std::size_t>(i)] = static_cast<const Texel*>(
        repeat.texels)[wrapped(t, repeat.height) * repeat.width + wrapped(s, repeat.width)];
  }
}

}  // namespace

void draw_surface_spans_u8_scalar(const SurfaceSpans& spans, const KernelTarget& target) {
  draw_surface_spans<std::uint8_t>(spans, target);
}
void draw_surface_spans_u32_scalar(const SurfaceSpans& spans, const KernelTarget& target) {
  draw_surface_spans<std::uint32_t>(spans, target);
}

void draw_repeat_spans_u8_scalar(const RepeatSpans& spans, const KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_repeat_span<std::uint8_t>(spans, spans.spans[i], target);
}
void draw_repeat_spans_u32_scalar(const RepeatSpans& spans, const KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_repeat_span<std::uint32_t>(spans, spans.spans[i], target);
}

void draw_sky_spans_u8_scalar(const SkySpans& spans, const KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_sky_span<std::uint8_t>(spans, spans.spans[i], target);
}
void draw_sky_spans_u32_scalar(const SkySpans& spans, const KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_sky_span<std::uint32_t>(spans, spans.spans[i], target);
}

}  // namespace temblor::render
