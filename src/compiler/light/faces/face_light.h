// The light of one face while it is being worked out, in the lights' own measure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

// In this order light becomes what is stored: sums, then least lights, then negative lights.
enum class LayerKind : std::uint8_t { kAdd, kRaise, kSubtract };

struct LightLayer {
  std::uint8_t style = 0;
  LayerKind kind = LayerKind::kAdd;
  std::vector<math::Vec3> samples;  // by luxel
  bool operator==(const LightLayer&) const = default;
};

struct FaceLight {
  std::vector<LightLayer> layers;  // in the order in which lights came
  std::vector<float> dirt;         // by luxel: the share of light left; empty: all

  const LightLayer* find(std::uint8_t style, LayerKind kind) const {
    for (const LightLayer& layer : layers)
      if (layer.style == style && layer.kind == kind) return &layer;
    return nullptr;
  }
  LightLayer& layer(std::uint8_t style, LayerKind kind, std::size_t luxels) {
    for (LightLayer& layer : layers)
      if (layer.style == style && layer.kind == kind) return layer;
    return layers.emplace_back(LightLayer{style, kind, std::vector<math::Vec3>(luxels, math::Vec3(0.0f))});
  }
};

}  // namespace temblor::compiler
