#include "compiler/light/shadows/shadow_filter.h"

#include <algorithm>
#include <utility>

namespace temblor::compiler {

// Values in between count as the lower one.
ShadowSampling shadow_sampling(int extra) {
  if (extra >= 4) return {2, 4};
  if (extra >= 2) return {2, 2};
  return {1, 2};
}

ShadowFilter::ShadowFilter(const LitLevel& lit, const RayScene& scene, const LightGrid& grid,
                           ShadowSampling sampling, SamplePoints luxel_places)
    : lit_(lit),
      scene_(scene),
      grid_(grid),
      sampling_(sampling),
      single_(std::move(luxel_places)),
      share_of_luxel_(grid.size()),
      known_(grid.size()),
      mixed_(grid.size()) {}

// The sample points of all luxels; computed when they are first asked for, because most faces need only one
// for each luxel.
const std::vector<math::Vec3>& ShadowFilter::points_for(int per_luxel) {
  if (per_luxel == 1) return single_.points;
  for (const FinerPoints& finer : finer_)
    if (finer.per_luxel == per_luxel) return finer.points;
  const SamplePoints rows = sample_points(lit_, scene_, grid_, per_luxel);
  std::vector<math::Vec3> points;
  points.reserve(rows.points.size());
  const int columns = grid_.width * per_luxel;
  for (int luxel = 0; luxel < grid_.width * grid_.height; ++luxel)
    for (int i = 0; i < per_luxel * per_luxel; ++i) {
      const int column = luxel % grid_.width * per_luxel + i % per_luxel;
      const int row = luxel / grid_.width * per_luxel + i / per_luxel;
      const auto from = static_cast<std::size_t>(row * columns + column);
      // A sample in a corner without open space counts as the luxel's center.
      const bool hidden = rows.is_hidden(from);
      points.push_back(hidden ? single_.points[static_cast<std::size_t>(luxel)] : rows.points[from]);
    }
  return finer_.emplace_back(FinerPoints{per_luxel, std::move(points)}).points;
}

// Queries the samples of the listed luxels, `each` for each of them.
void ShadowFilter::run_query(std::span<const std::uint32_t> luxels, const std::vector<math::Vec3>& from,
                             std::size_t each, ShareQuery query) {
  answers_.resize(luxels.size() * each);
  if (answers_.size() == from.size()) return query(from, answers_);
  points_.clear();
  for (const std::uint32_t luxel : luxels)
    points_.insert(points_.end(), from.begin() + static_cast<std::ptrdiff_t>(luxel * each),
                   from.begin() + static_cast<std::ptrdiff_t>((luxel + 1) * each));
  query(points_, answers_);
}

// Takes per_luxel x per_luxel samples of each listed luxel. Records their mean, and whether they differ.
void ShadowFilter::sample(std::span<const std::uint32_t> luxels, int per_luxel, ShareQuery query) {
  const std::vector<math::Vec3>& from = points_for(per_luxel);
  const auto each = static_cast<std::size_t>(per_luxel) * static_cast<std::size_t>(per_luxel);
  run_query(luxels, from, each, query);
  for (std::size_t i = 0; i < luxels.size(); ++i) {
    const std::span<const math::Vec3> answers(answers_.data() + i * each, each);
    math::Vec3 sum(0.0f);
    bool mixed = false;
    for (const math::Vec3& answer : answers) {
      sum += answer;
      mixed = mixed || answer != answers[0];
    }
    share_of_luxel_[luxels[i]] = sum / static_cast<float>(each);
    mixed_[luxels[i]] = mixed;
  }
}

// Whether the samples of a luxel differ from each other or from those of a neighbor.
bool ShadowFilter::is_at_edge(std::uint32_t luxel) const {
  if (mixed_[luxel] != 0) return true;
  const int column = static_cast<int>(luxel) % grid_.width, row = static_cast<int>(luxel) / grid_.width;
  for (int y = std::max(0, row - 1); y <= std::min(grid_.height - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(grid_.width - 1, column + 1); ++x) {
      const auto other = static_cast<std::size_t>(y * grid_.width + x);
      if (known_[other] != 0 && share_of_luxel_[other] != share_of_luxel_[luxel]) return true;
    }
  return false;
}

// Rounds shares to steps of 1 / kWholeShare.
std::span<const Share> ShadowFilter::quantize(std::span<const math::Vec3> shares) {
  const auto step = [](float share) { return static_cast<std::uint8_t>(share * kWholeShare + 0.5f); };
  result_.resize(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
    result_[i] = {step(shares[i].x), step(shares[i].y), step(shares[i].z)};
  return result_;
}

// Two passes: a coarse one over all luxels, then a fine one where the first found an edge. known_ marks the
// luxels of this query, so that neighbors outside of it do not count.
std::span<const Share> ShadowFilter::compute_shares(std::span<const std::uint32_t> luxels, bool rough,
                                                    ShareQuery query) {
  if (rough) {
    run_query(luxels, single_.points, 1, query);
    return quantize(answers_);
  }
  sample(luxels, sampling_.everywhere, query);
  if (sampling_.at_edges > sampling_.everywhere) {
    for (const std::uint32_t luxel : luxels) known_[luxel] = 1;
    at_edges_.clear();
    for (const std::uint32_t luxel : luxels)
      if (is_at_edge(luxel)) at_edges_.push_back(luxel);
    for (const std::uint32_t luxel : luxels) known_[luxel] = 0;
    if (!at_edges_.empty()) sample(at_edges_, sampling_.at_edges, query);
  }
  answers_.clear();
  for (const std::uint32_t luxel : luxels) answers_.push_back(share_of_luxel_[luxel]);
  return quantize(answers_);
}

}  // namespace temblor::compiler
