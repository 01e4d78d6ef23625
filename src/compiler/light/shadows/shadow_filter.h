// How much of a light each luxel of a face gets, without stair-steps along the edges of shadows.
//
// The filter is a box: a luxel's share is the mean over the square around it that it stands for. It depends
// on the place alone, not on the face, so that neighbors in one plane agree along their seam. Most squares
// lie all in the light or all in shadow: a few samples tell, and only where they, or those of neighboring
// luxels, disagree are all of them taken.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "compiler/light/faces/sample_points.h"
#include "math/vec.h"

namespace temblor::compiler {

// Samples each way in a luxel: everywhere, and at the edges of shadows.
struct ShadowSampling {
  int everywhere = 1, at_edges = 2;
};
// For LightOptions::extra of 1, 2, 4.
ShadowSampling shadow_sampling(int extra);

// The share of a light that a luxel gets, by channel: 0 to kWholeShare, in which those of 2x2 and 4x4 samples
// are whole steps. So little is kept of it that the shadows of a whole level can be (light_cache.h).
using Share = std::array<std::uint8_t, 3>;
constexpr std::uint8_t kWholeShare = 240;

using ShareQuery =
    base::FunctionRef<void(std::span<const math::Vec3> points, std::span<math::Vec3> out_share)>;

// For one face; keeps its samples' places from one light to the next. Used by one thread. `luxel_places` are
// those of sample_points with one sample a luxel.
class ShadowFilter {
 public:
  ShadowFilter(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, ShadowSampling sampling,
               SamplePlaces luxel_places);

  const SamplePlaces& luxel_places() const { return single_; }

  // The shares of the luxels named by `luxels`, none of them hidden, each once, in rising order; with
  // `rough`, of one sample each. Valid until the next call.
  std::span<const Share> shares(std::span<const std::uint32_t> luxels, bool rough, ShareQuery query);

 private:
  struct FinerPoints {
    int per_luxel = 0;
    std::vector<math::Vec3> points;  // all samples of a luxel together
  };
  const std::vector<math::Vec3>& points_for(int per_luxel);
  void ask(std::span<const std::uint32_t> luxels, const std::vector<math::Vec3>& from, std::size_t each,
           ShareQuery query);
  void sample(std::span<const std::uint32_t> luxels, int per_luxel, ShareQuery query);
  bool is_at_edge(std::uint32_t luxel) const;
  std::span<const Share> in_steps(std::span<const math::Vec3> shares);

  const LitLevel& lit_;
  const RayScene& scene_;
  const LightGrid& grid_;
  ShadowSampling sampling_;
  SamplePlaces single_;
  std::vector<FinerPoints> finer_;
  std::vector<math::Vec3> points_, answers_;  // of the samples asked for
  std::vector<math::Vec3> share_of_luxel_;    // of the whole grid
  std::vector<std::uint8_t> known_, mixed_;   // of the whole grid
  std::vector<std::uint32_t> at_edges_;
  std::vector<Share> result_;
};

}  // namespace temblor::compiler
