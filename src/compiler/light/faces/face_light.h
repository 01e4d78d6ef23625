// The light of one face while it is computed, in the units of the lights' "light" key.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

// How a layer joins the others, in this order: sums, then minimum lights, then negative lights. Two kinds are
// not shown. kBounceMore: faces send it back in addition to the sum (negative: they send back less).
// kDirection: the sum over all lights of brightness * unit vector toward the light, in the world's space;
// only with LightSettings::has_directions.
enum class LayerKind : std::uint8_t { kAdd, kRaise, kSubtract, kBounceMore, kDirection };
constexpr LayerKind kLastLayerKind = LayerKind::kDirection;

// The light of one style and kind on a face.
struct LightLayer {
  std::uint8_t style = 0;
  LayerKind kind = LayerKind::kAdd;
  std::vector<math::Vec3> samples;  // by luxel, red, green and blue; kDirection: x, y and z
  bool operator==(const LightLayer&) const = default;
};

// Everything that is known of one light map's light.
struct FaceLight {
  std::vector<LightLayer> layers;  // in the order of the first light of each
  std::vector<float> dirt;         // by luxel: from compute_dirt(); empty: no dirt

  // Returns the layer of a style and kind, or null.
  const LightLayer* find(std::uint8_t style, LayerKind kind) const {
    for (const LightLayer& layer : layers)
      if (layer.style == style && layer.kind == kind) return &layer;
    return nullptr;
  }
  // Returns the layer of a style and kind; adds a black one if there is none.
  LightLayer& layer(std::uint8_t style, LayerKind kind, std::size_t luxels) {
    for (LightLayer& layer : layers)
      if (layer.style == style && layer.kind == kind) return layer;
    return layers.emplace_back(LightLayer{style, kind, std::vector<math::Vec3>(luxels, math::Vec3(0.0f))});
  }
};

}  // namespace temblor::compiler
