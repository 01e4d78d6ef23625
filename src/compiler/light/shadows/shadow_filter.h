// The share of a light that each luxel of a face gets, without stair-steps at the edges of shadows.
//
// The filter is a box: a luxel's share is the mean over the square that it stands for. That square depends on
// the position alone, not on the face, so neighbors in one plane agree along their seam. Most squares are
// completely in light or in shadow, which a few samples show; only where these, or those of neighboring
// luxels, disagree are all samples taken (adaptive supersampling, Whitted, "An improved illumination model
// for shaded display", 1980).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "compiler/light/faces/sample_points.h"
#include "math/vec.h"

namespace temblor::compiler {

// Samples for each luxel along each axis: everywhere, and at the edges of shadows.
struct ShadowSampling {
  int everywhere = 1, at_edges = 2;
};
// The sampling for LightOptions::extra of 1, 2 or 4.
ShadowSampling shadow_sampling(int extra);

// A share of light by channel, quantized to 0 .. kWholeShare: 2x2 and 4x4 samples give whole steps. So small
// that the light cache can hold all shadows of a level.
using Share = std::array<std::uint8_t, 3>;
constexpr std::uint8_t kWholeShare = 240;
// For inner loops, where == of arrays would call memcmp for three bytes.
constexpr bool are_equal(const Share& a, const Share& b) {
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
}

// Finds the unquantized share for each point.
using ShareQuery =
    base::FunctionRef<void(std::span<const math::Vec3> points, std::span<math::Vec3> out_share)>;

// Filters the shadows of one face, light after light; keeps the sample points. Used by one thread.
// `luxel_places`: from sample_points() with one sample for each luxel.
class ShadowFilter {
 public:
  ShadowFilter(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, ShadowSampling sampling,
               SamplePoints luxel_places);

  const SamplePoints& luxel_places() const { return single_; }

  // Returns the shares of the listed luxels: not hidden, each once, in ascending order. With `rough`, takes
  // one sample for each. Valid until the next call.
  std::span<const Share> compute_shares(std::span<const std::uint32_t> luxels, bool rough, ShareQuery query);

 private:
  // The sample points for more than one sample along each axis.
  struct FinerPoints {
    int per_luxel = 0;
    std::vector<math::Vec3> points;  // the samples of a luxel are next to each other
  };
  const std::vector<math::Vec3>& points_for(int per_luxel);
  void run_query(std::span<const std::uint32_t> luxels, const std::vector<math::Vec3>& from, std::size_t each,
                 ShareQuery query);
  void sample(std::span<const std::uint32_t> luxels, int per_luxel, ShareQuery query);
  bool is_at_edge(std::uint32_t luxel) const;
  std::span<const Share> quantize(std::span<const math::Vec3> shares);

  const LitLevel& lit_;
  const RayScene& scene_;
  const LightGrid& grid_;
  ShadowSampling sampling_;
  SamplePoints single_;
  std::vector<FinerPoints> finer_;
  std::vector<math::Vec3> points_, answers_;  // of the current query
  std::vector<math::Vec3> share_of_luxel_;    // by luxel of the whole grid
  std::vector<std::uint8_t> known_, mixed_;   // by luxel of the whole grid
  std::vector<std::uint32_t> at_edges_;
  std::vector<Share> result_;
};

}  // namespace temblor::compiler
