// Method: pieces are grouped by the clusters they join and by their plane. Within a group, pairs with a
// common edge are joined until no pair is convex together.
#include "compiler/vis/flow/merge_portals.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "compiler/vis/flow/winding.h"

namespace temblor::compiler::vis {

namespace {

using math::Vec3d;
using Corners = std::vector<Vec3d>;

// Joining is quadratic in the number of pieces of an opening; in known levels that is below a hundred.
constexpr std::size_t kMaxPieces = 1000;

bool same_point(const Vec3d& a, const Vec3d& b) {
  const Vec3d offset = a - b;
  return glm::dot(offset, offset) < kEpsilon * kEpsilon;
}

enum class Turn { kRight, kStraight, kLeft };

// The turn at a corner seen from in front of the plane; clockwise polygons turn right.
Turn turn_at(const Vec3d& before, const Vec3d& corner, const Vec3d& after, const Vec3d& normal) {
  const Vec3d to_right = glm::cross(corner - before, normal);
  const double length = glm::length(to_right);
  if (length == 0) return Turn::kStraight;
  const double right = glm::dot(after - corner, to_right) / length;
  if (right > kEpsilon) return Turn::kRight;
  return right < -kEpsilon ? Turn::kLeft : Turn::kStraight;
}

// Joins two polygons without their common edge: `a` from its corner `a_edge + 1` around to `a_edge`, then `b`
// likewise. Returns nothing if the result is not convex.
std::optional<Corners> join_at(const Corners& a, std::size_t a_edge, const Corners& b, std::size_t b_edge,
                               const Vec3d& normal) {
  Corners joined;
  for (std::size_t i = 1; i <= a.size(); ++i) joined.push_back(a[(a_edge + i) % a.size()]);
  for (std::size_t i = 2; i < b.size(); ++i) joined.push_back(b[(b_edge + i) % b.size()]);
  // The two ends of the edge, the later one first, so that erasing it does not move the other.
  for (const std::size_t end : {a.size() - 1, std::size_t{0}}) {
    const std::size_t count = joined.size();
    switch (turn_at(joined[(end + count - 1) % count], joined[end], joined[(end + 1) % count], normal)) {
      case Turn::kLeft:
        return std::nullopt;
      case Turn::kStraight:
        joined.erase(joined.begin() + static_cast<std::ptrdiff_t>(end));
        break;
      case Turn::kRight:
        break;
    }
  }
  return joined.size() >= 3 ? std::optional(std::move(joined)) : std::nullopt;
}

// Joins two polygons along a common edge, if there is one.
std::optional<Corners> join(const Corners& a, const Corners& b, const Vec3d& normal) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k)
      if (same_point(a[i], b[(k + 1) % b.size()]) && same_point(a[(i + 1) % a.size()], b[k]))
        return join_at(a, i, b, k, normal);
  return std::nullopt;
}

// Starts over until a pass joins nothing, since a joined piece may fit pieces that did not fit before.
void join_pieces(std::vector<Portal>& io_pieces) {
  if (io_pieces.size() > kMaxPieces) return;
  for (bool joined_any = true; joined_any;) {
    joined_any = false;
    for (std::size_t i = 0; i < io_pieces.size(); ++i) {
      for (std::size_t k = i + 1; k < io_pieces.size();) {
        auto joined = join(io_pieces[i].winding_world, io_pieces[k].winding_world, io_pieces[i].normal);
        if (!joined) {
          ++k;
          continue;
        }
        joined_any = true;
        io_pieces[i].winding_world = std::move(*joined);
        io_pieces.erase(io_pieces.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
  }
}

using Opening = std::tuple<std::uint32_t, std::uint32_t, std::array<double, 4>>;

Opening opening_key(const Portal& portal) {
  return {portal.clusters[0],
          portal.clusters[1],
          {portal.normal.x, portal.normal.y, portal.normal.z, portal.distance}};
}

}  // namespace

std::vector<Portal> merge_portals(const std::vector<Portal>& portals) {
  std::vector<std::vector<Portal>> openings;
  std::map<Opening, std::size_t> known;
  for (const Portal& portal : portals) {
    const auto [at, is_new] = known.try_emplace(opening_key(portal), openings.size());
    if (is_new) openings.emplace_back();
    openings[at->second].push_back(portal);
  }
  std::vector<Portal> merged;
  for (std::vector<Portal>& pieces : openings) {
    join_pieces(pieces);
    std::ranges::move(pieces, std::back_inserter(merged));
  }
  return merged;
}

}  // namespace temblor::compiler::vis
