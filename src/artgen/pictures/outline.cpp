#include "artgen/pictures/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "artgen/models/noise.h"

namespace temblor::artgen::pictures {
namespace {

using math::Vec2d;

// To an axis-aligned box around the origin with these half sizes.
double box_distance(Vec2d from_middle, Vec2d half) {
  const Vec2d out{std::abs(from_middle.x) - half.x, std::abs(from_middle.y) - half.y};
  const double x = std::max(out.x, 0.0), y = std::max(out.y, 0.0);
  return std::sqrt(x * x + y * y) + std::min(std::max(out.x, out.y), 0.0);
}

// To a line segment without width.
double segment_distance(Vec2d position, Vec2d from, Vec2d to) {
  const Vec2d along = to - from, there = position - from;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0 ? std::clamp(glm::dot(there, along) / length2, 0.0, 1.0) : 0;
  return glm::length(there - along * share);
}

// The distance to the nearest side. The sign comes from the even-odd rule: the number of sides that a ray to
// the right crosses.
double polygon_distance(const std::vector<Vec2d>& corners, Vec2d position) {
  double nearest = 1e9;
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d a = corners[i], b = corners[(i + 1) % corners.size()];
    nearest = std::min(nearest, segment_distance(position, a, b));
    const bool crosses = (a.y > position.y) != (b.y > position.y);
    if (crosses && position.x < a.x + (position.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

// To a rectangle along a line; its width grows with the cube of the distance from the middle, so only the
// ends flare.
double stroke_distance(Vec2d position, Vec2d from, Vec2d to, double width, double flare) {
  const double length = glm::length(to - from);
  const Vec2d along = length > 0 ? (to - from) / length : Vec2d{1, 0};
  const Vec2d there = position - (from + to) * 0.5;
  const double u = std::abs(glm::dot(there, along)), v = std::abs(there.x * along.y - there.y * along.x);
  const double from_middle = length > 0 ? std::min(u / (length / 2), 1.0) : 1;
  const double half = width / 2 * (1 + (flare - 1) * from_middle * from_middle * from_middle);
  return box_distance({u, v}, {length / 2 + width / 2, half});
}

}  // namespace

Outline make_box(Vec2d mins, Vec2d maxs, double rounding) {
  const Vec2d middle = (mins + maxs) * 0.5;
  const double limit = std::min(maxs.x - mins.x, maxs.y - mins.y) / 2;
  const double round = std::clamp(rounding, 0.0, std::max(limit, 0.0));
  const Vec2d half = (maxs - mins) * 0.5 - Vec2d{round, round};
  return {[=](Vec2d position) { return box_distance(position - middle, half) - round; }, mins, maxs};
}

Outline make_ellipse(Vec2d middle, Vec2d radii) {
  const auto distance = [=](Vec2d position) {
    const Vec2d scaled = (position - middle) / radii;
    const double reach = glm::length(scaled);
    if (reach < 1e-6) return -std::min(radii.x, radii.y);
    // There is no simple exact distance to an ellipse. One step of Newton's method from the implicit equation
    // is accurate near the edge.
    return (reach - 1) * reach / glm::length(scaled / radii);
  };
  return {distance, middle - radii, middle + radii};
}

Outline make_ring(Vec2d middle, double radius, double width) {
  const Vec2d reach{radius + width / 2, radius + width / 2};
  return {[=](Vec2d position) { return std::abs(glm::length(position - middle) - radius) - width / 2; },
          middle - reach, middle + reach};
}

Outline make_arc(Vec2d middle, double radius, double width, double from_deg, double to_deg) {
  std::vector<Vec2d> points;
  constexpr double kStep_deg = 6;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to_deg - from_deg) / kStep_deg)));
  for (int i = 0; i <= steps; ++i) {
    const double angle = (from_deg + (to_deg - from_deg) * i / steps) * std::numbers::pi / 180;
    points.push_back(middle + Vec2d{std::cos(angle), std::sin(angle)} * radius);
  }
  return make_trace(points, width);
}

Outline make_trace(const std::vector<Vec2d>& points, double width) {
  Vec2d mins = points.front(), maxs = points.front();
  for (const Vec2d& point : points) {
    mins = glm::min(mins, point);
    maxs = glm::max(maxs, point);
  }
  const auto distance = [=](Vec2d position) {
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      nearest = std::min(nearest, segment_distance(position, points[i], points[i + 1]));
    return nearest - width / 2;
  };
  return {distance, mins - Vec2d{width, width}, maxs + Vec2d{width, width}};
}

Outline make_polygon(std::vector<Vec2d> corners) {
  Vec2d mins = corners.front(), maxs = corners.front();
  for (const Vec2d& corner : corners) {
    mins = glm::min(mins, corner);
    maxs = glm::max(maxs, corner);
  }
  return {[kept = std::move(corners)](Vec2d position) { return polygon_distance(kept, position); }, mins,
          maxs};
}

Outline make_line(const std::vector<Vec2d>& points, double width, double flare) {
  Vec2d mins = points.front(), maxs = points.front();
  for (const Vec2d& point : points) {
    mins = glm::min(mins, point);
    maxs = glm::max(maxs, point);
  }
  const Vec2d reach = Vec2d{width, width} * std::max(flare, 1.0);
  const auto distance = [=](Vec2d position) {
    double nearest = points.size() == 1 ? stroke_distance(position, points[0], points[0], width, flare) : 1e9;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      nearest = std::min(nearest, stroke_distance(position, points[i], points[i + 1], width, flare));
    return nearest;
  };
  return {distance, mins - reach, maxs + reach};
}

Outline make_ground(std::vector<double> tops, double bottom) {
  // y points down, so the smallest value is the highest point.
  const double highest = *std::min_element(tops.begin(), tops.end());
  const auto width = static_cast<double>(tops.size() - 1);
  const auto distance = [kept = std::move(tops)](Vec2d position) {
    const auto last = static_cast<double>(kept.size() - 1);
    const double x = std::clamp(position.x, 0.0, last - 1e-6);
    const auto first = static_cast<std::size_t>(x);
    const double slope = kept[first + 1] - kept[first];
    return (kept[first] + slope * (x - std::floor(x)) - position.y) / std::hypot(1.0, slope);
  };
  return {distance, {0, highest}, {width, bottom}};
}

Outline make_blob(Vec2d middle, double radius, double rough, double lump, double seed) {
  const double reach = radius * (1 + rough);
  const auto distance = [=](Vec2d position) {
    const Vec2d out = position - middle;
    const double length = std::max(glm::length(out), 1e-6);
    if (length > radius * (1 + 2 * rough)) return length - radius * (1 + 2 * rough);
    // The noise is sampled on a cylinder, so that it has no seam at any angle. Its third coordinate changes
    // with the distance, which makes bulges differ between the edge and the inside.
    const math::Vec3d where{out.x / length / lump, out.y / length / lump, length / radius / lump / 2};
    const double wander = 2 * lump_noise(where, static_cast<std::uint64_t>(seed)) - 1;
    return length - radius * (1 + 2 * rough * wander);
  };
  return {distance, middle - Vec2d{reach, reach} * 1.5, middle + Vec2d{reach, reach} * 1.5};
}

Outline add_mirror_image(Outline outline, double x) {
  const auto flipped = [x](Vec2d position) { return Vec2d{2 * x - position.x, position.y}; };
  Outline both;
  both.mins = glm::min(outline.mins, flipped(outline.maxs) * Vec2d{1, 0} + outline.mins * Vec2d{0, 1});
  both.maxs = glm::max(outline.maxs, flipped(outline.mins) * Vec2d{1, 0} + outline.maxs * Vec2d{0, 1});
  both.distance = [one = std::move(outline.distance), flipped](Vec2d position) {
    return std::min(one(position), one(flipped(position)));
  };
  return both;
}

Outline join_outlines(std::vector<Outline> outlines) {
  Outline all;
  all.mins = outlines.front().mins;
  all.maxs = outlines.front().maxs;
  for (const Outline& outline : outlines) {
    all.mins = glm::min(all.mins, outline.mins);
    all.maxs = glm::max(all.maxs, outline.maxs);
  }
  all.distance = [kept = std::move(outlines)](Vec2d position) {
    double nearest = 1e9;
    for (const Outline& outline : kept) {
      const Vec2d middle = (outline.mins + outline.maxs) * 0.5;
      // A shape cannot be nearer than its bounding box, which is cheap to test.
      if (box_distance(position - middle, outline.maxs - middle) < nearest)
        nearest = std::min(nearest, outline.distance(position));
    }
    return nearest;
  };
  return all;
}

}  // namespace temblor::artgen::pictures
