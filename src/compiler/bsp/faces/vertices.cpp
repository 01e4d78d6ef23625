// Method: points are hashed by cells of 64 units; a query looks into all cells that its box touches. To close
// T-junctions, each side of each loop asks for the vertices near it and inserts those that are on it.
#include "compiler/bsp/faces/vertices.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace temblor::compiler {
namespace {

struct OnSide {
  double along;
  std::uint32_t vertex;
};

// Finds the vertices on the line between two others, in order from the first.
void find_between(std::uint32_t from, std::uint32_t to, const VertexSet& vertices, std::vector<OnSide>& out) {
  out.clear();
  const math::Vec3d begin = vertices.points()[from], side = vertices.points()[to] - begin;
  const double length = glm::length(side);
  if (length < VertexSet::kSamePlace) return;
  const math::Vec3d direction = side / length;
  // Short pieces, since the box around a long slanted side contains far too many vertices.
  constexpr double kPiece = 64;
  const int pieces = static_cast<int>(std::ceil(length / kPiece));
  for (int i = 0; i < pieces; ++i) {
    Box box;
    box.add(begin + side * (double{1} * i / pieces));
    box.add(begin + side * (double{1} * (i + 1) / pieces));
    vertices.for_each_near(box, [&](std::uint32_t vertex) {
      const math::Vec3d away = vertices.points()[vertex] - begin;
      const double along = glm::dot(away, direction);
      if (along < VertexSet::kSamePlace || along > length - VertexSet::kSamePlace) return;
      if (glm::length(away - direction * along) < VertexSet::kSamePlace) out.push_back({along, vertex});
    });
  }
  std::sort(out.begin(), out.end(), [](const OnSide& a, const OnSide& b) {
    return a.along != b.along ? a.along < b.along : a.vertex < b.vertex;
  });
}

// Half of the length of the vector area of a loop: for a loop in a plane, its area.
double compute_area(std::span<const std::uint32_t> loop, const VertexSet& vertices) {
  Winding winding;
  for (const std::uint32_t vertex : loop) winding.push_back(vertices.points()[vertex]);
  return area(winding);
}

// Cuts a loop in two, with the same number of vertices. A line along one side would leave a half without
// area, so the line is chosen whose smaller half is the largest.
std::pair<FaceLoop, FaceLoop> halve(const FaceLoop& loop, const VertexSet& vertices) {
  const std::size_t half = loop.size() / 2;
  std::pair<FaceLoop, FaceLoop> best;
  double largest = -1;
  FaceLoop turned = loop;
  for (std::size_t first = 0; first < loop.size(); ++first) {
    const auto middle = turned.begin() + static_cast<std::ptrdiff_t>(half);
    FaceLoop one(turned.begin(), middle + 1), other(middle, turned.end());
    other.push_back(turned.front());
    const double smaller = std::min(compute_area(one, vertices), compute_area(other, vertices));
    if (smaller > largest) {
      largest = smaller;
      best = {std::move(one), std::move(other)};
    }
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  return best;
}

}  // namespace

VertexSet::Cell VertexSet::find_cell(const math::Vec3d& point) {
  return {static_cast<std::int64_t>(std::floor(point.x / kCellUnits)),
          static_cast<std::int64_t>(std::floor(point.y / kCellUnits)),
          static_cast<std::int64_t>(std::floor(point.z / kCellUnits))};
}

std::int64_t VertexSet::make_key(const Cell& cell) {
  constexpr std::int64_t kCells = 1 << 20;  // along each axis, far more than a level has
  return (cell.x * kCells + cell.y) * kCells + cell.z;
}

std::uint32_t VertexSet::find_or_add(const math::Vec3d& point) {
  Box box;
  box.add(point);
  std::uint32_t found = static_cast<std::uint32_t>(points_.size());
  for_each_near(box, [&](std::uint32_t vertex) {
    const math::Vec3d apart = glm::abs(points_[vertex] - point);
    if (std::max({apart.x, apart.y, apart.z}) < kSamePlace) found = std::min(found, vertex);
  });
  if (found == points_.size()) {
    points_.push_back(point);
    by_cell_.emplace(make_key(find_cell(point)), found);
  }
  return found;
}

void close_t_junctions(std::vector<FaceLoop>& io_loops, const VertexSet& vertices) {
  FaceLoop closed;
  std::vector<OnSide> between;
  for (FaceLoop& loop : io_loops) {
    closed.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto add = [&](std::uint32_t vertex) {
        if (closed.empty() || closed.back() != vertex) closed.push_back(vertex);
      };
      add(loop[i]);
      find_between(loop[i], loop[(i + 1) % loop.size()], vertices, between);
      for (const OnSide& on : between) add(on.vertex);
    }
    while (closed.size() > 1 && closed.front() == closed.back()) closed.pop_back();
    loop = closed;
  }
}

std::vector<FaceLoop> split_long_loop(FaceLoop loop, std::size_t max_vertices, const VertexSet& vertices) {
  std::vector<FaceLoop> pending, done;
  pending.push_back(std::move(loop));
  while (!pending.empty()) {
    FaceLoop next = std::move(pending.back());
    pending.pop_back();
    if (next.size() <= max_vertices) {
      done.push_back(std::move(next));
      continue;
    }
    auto [one, other] = halve(next, vertices);
    pending.push_back(std::move(other));
    pending.push_back(std::move(one));
  }
  return done;
}

}  // namespace temblor::compiler
