#include "lab/world_light/phong.h"

#include <array>

#include "lab/world_light/kernels/phong_kernels.h"
#include "lab/world_light/lamps/lamp_stages.h"
#include "lab/world_light/polygon_row.h"

namespace temblor::lab {

namespace {

constexpr LitKernels kPhongKernels{draw_phong_lit_u8_simd, draw_phong_lit_u8_scalar, draw_phong_lit_u32_simd,
                                   draw_phong_lit_u32_scalar};

// Draws the spans of one draw, in batches.
class PhongSpans {
 public:
  explicit PhongSpans(const LampSpans& spans)
      : job_(spans.job), draw_(spans.draw), view_(spans.view), spans_(spans) {
    lights_.lamps = draw_.lamps.data();
    lights_.lamp_count = static_cast<std::int32_t>(draw_.lamps.size());
    for (int i = 0; i < 3; ++i)
      lights_.ray_step[i] = static_cast<float>(view_.axes.right[i] / view_.pixels_per_unit);
  }

  void draw() {
    for (const render::Span& span : spans_.spans) {
      if (draw_.triangles.empty()) {
        add_part(span, span, nullptr);
        continue;
      }
      if (row_.y() != span.y) row_.find(draw_.triangles, span.y);
      row_.split(span, [&](const RowPart& part) { add_part(span, part.pixels, &part.interval.row); });
    }
    flush();
  }

 private:
  // `row`: the normals at the triangle's edges, over z; null: the face's own.
  void add_part(const render::Span& span, const render::Span& pixels, const RowLight* row) {
    if (count_ == kBatch) flush();
    PhongPart& part = lines_[count_] = PhongPart{};
    const math::Vec3d ray = view_.axes.forward +
                            view_.axes.right * ((span.x - view_.center_x) / view_.pixels_per_unit) -
                            view_.axes.up * ((span.y - view_.center_y) / view_.pixels_per_unit);
    for (std::size_t i = 0; i < 3; ++i) {
      part.ray[i] = static_cast<float>(ray[static_cast<int>(i)]);
      part.normal[i] = draw_.normal[i];
      if (row == nullptr) continue;
      const LightStep light = row->steps_from(span.x, i);
      part.normal[i] = static_cast<float>(light.first);
      part.normal_step[i] = static_cast<float>(light.step);
    }
    part.pixels_before = pixels.x - span.x;
    parts_[count_++] = pixels;
  }

  void flush() {
    job_.spans = parts_.data();
    job_.span_count = count_;
    lights_.parts = lines_.data();
    count_ = 0;
    kPhongKernels.choose(spans_.sources)(job_, lights_, spans_.target);
  }

  static constexpr std::size_t kBatch = 64;
  LitSpans job_;
  PhongLights lights_{};
  const LampDraw& draw_;
  const render::ViewFrame& view_;
  const LampSpans& spans_;
  PolygonRow row_;
  std::size_t count_ = 0;
  std::array<render::Span, kBatch> parts_;
  std::array<PhongPart, kBatch> lines_;
};

}  // namespace

render::FrameStages make_phong(std::span<const double> values, Counter* counter) {
  return make_lamp_stages(
      {.lamps_per_face = static_cast<std::size_t>(values[0]), .smooth_deg = values[1]}, counter,
      [](const world::Level&) { return true; }, [](const LampSpans& spans) { PhongSpans(spans).draw(); });
}

}  // namespace temblor::lab
