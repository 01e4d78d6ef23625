// Inner loops of lit spans (lit_kernels.h) that compute the light of each pixel from point lights, as SIMD
// and as the scalar reference with the same results, bit for bit.
//
// A lamp at distance d, at least 1, gives
//
//   (max(0, brightness - falloff * d) + inverse / d + inverse_square / d^2) * (1 + cosine of the angle) / 2
//
// where the angle is that between the normal and the direction to the lamp, and nothing outside of a
// spotlight's cone. Nothing casts a shadow.
#pragma once

#include "lab/world_light/kernels/lit_kernels.h"

namespace temblor::lab {

struct PointLamp {
  float from_eye[3];  // world space
  // 256 times light as stored.
  float brightness, falloff, inverse, inverse_square;
  // The lamp shines only where the cosine between this direction, of length 1 or 0, and the way from the lamp
  // is at least spot_cosine.
  float spot[3] = {0, 0, 0};
  float spot_cosine = -2;
  bool is_sky = false;  // the kernels ignore this
};

// Pixel i of the span sees along ray + ray_step * i, whose length is 1 along the view. Its normal, of any
// length, is normal + normal_step * i: a linear function over z, or constant.
struct PhongPart {
  float ray[3];
  float normal[3], normal_step[3];
  std::int32_t pixels_before;  // as in LineLight
};

// In perspective only.
struct PhongLights {
  const PhongPart* parts;  // one for each of LitSpans::spans
  float ray_step[3];
  const PointLamp* lamps;
  std::int32_t lamp_count;
};

void draw_phong_lit_u8_scalar(const LitSpans& spans, const PhongLights& light,
                              const render::KernelTarget& target);
void draw_phong_lit_u32_scalar(const LitSpans& spans, const PhongLights& light,
                               const render::KernelTarget& target);
void draw_phong_lit_u8_simd(const LitSpans& spans, const PhongLights& light,
                            const render::KernelTarget& target);
void draw_phong_lit_u32_simd(const LitSpans& spans, const PhongLights& light,
                             const render::KernelTarget& target);

}  // namespace temblor::lab
