// Hot loop. The scalar reference: it defines the results of the kernels.
#include <cmath>

#include "lab/world_light/kernels/lit_spans_scalar.h"
#include "lab/world_light/kernels/phong_kernels.h"

namespace temblor::lab {

namespace {

constexpr float kFullSum = 65280;

// kDark: the units of bytes.
template <bool kDark>
class LampSampler {
 public:
  explicit LampSampler(const PhongLights& lights) : lights_(lights) {}

  int begin_span(std::size_t number) {
    part_ = &lights_.parts[number];
    return part_->pixels_before;
  }
  std::int32_t channels() const { return 1; }
  std::int32_t find_light(const Place& place, std::int32_t /*channel*/) const {
    const float sum = smaller(sum_light(place), kFullSum);
    const float light = kDark ? larger((kFullSum - sum) * 0.25f, 64.0f) : sum * 0.5f;
    return static_cast<std::int32_t>(light + 0.5f);
  }

 private:
  float sum_light(const Place& place) const {
    float at[3], normal[3];
    for (int i = 0; i < 3; ++i) {
      at[i] = (part_->ray[i] + place.lane * lights_.ray_step[i]) * place.z;
      normal[i] = part_->normal[i] + place.lane * part_->normal_step[i];
    }
    const float square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    const float per_length = 0.5f / std::sqrt(square);
    float sum = 0;
    for (std::int32_t i = 0; i < lights_.lamp_count; ++i) {
      const PointLamp& lamp = lights_.lamps[i];
      const float x = lamp.from_eye[0] - at[0], y = lamp.from_eye[1] - at[1], z = lamp.from_eye[2] - at[2];
      const float distance = larger(std::sqrt(x * x + y * y + z * z), 1.0f);
      const float per_distance = 1.0f / distance;
      const float along = normal[0] * x + normal[1] * y + normal[2] * z;
      const float share = along * per_length * per_distance + 0.5f;
      const float linear = larger(lamp.brightness - lamp.falloff * distance, 0.0f);
      const float curved = (lamp.inverse + lamp.inverse_square * per_distance) * per_distance;
      const float from_lamp = 0.0f - (lamp.spot[0] * x + lamp.spot[1] * y + lamp.spot[2] * z);
      if (from_lamp >= lamp.spot_cosine * distance) sum = sum + (linear + curved) * share;
    }
    return sum;
  }

  const PhongLights& lights_;
  const PhongPart* part_ = nullptr;
};

}  // namespace

void draw_phong_lit_u8_scalar(const LitSpans& spans, const PhongLights& light,
                              const render::KernelTarget& target) {
  draw_lit<std::uint8_t>(spans, LampSampler<true>(light), target);
}
void draw_phong_lit_u32_scalar(const LitSpans& spans, const PhongLights& light,
                               const render::KernelTarget& target) {
  draw_lit<std::uint32_t>(spans, LampSampler<false>(light), target);
}

}  // namespace temblor::lab
