#include "artgen/models/skin.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "artgen/models/noise.h"
#include "artgen/models/occlusion.h"

namespace temblor::artgen {
namespace {

using math::Vec2d;
using math::Vec3d;

// How far outside a triangle texels take their color from it, so that no seam shows when the renderer samples
// its edge.
constexpr double kBleedTexels = 1.0;
// How much occlusion darkens. Above 1, because even deep creases are rarely hidden completely.
constexpr double kDeepCrease = 1.25;
// The width of worn edges.
constexpr double kWearUnits = 0.7;

// The point of a triangle that is nearest to a given one, in barycentric coordinates.
struct Nearest {
  double distance;
  Vec3d weights;
};

// On the side from corner `side` to the next one.
Nearest find_nearest_on_side(const std::array<Vec2d, 3>& corners, int side, const Vec2d& point) {
  const Vec2d from = corners[static_cast<std::size_t>(side)],
              to = corners[static_cast<std::size_t>((side + 1) % 3)];
  const Vec2d direction = to - from;
  const double squared = glm::dot(direction, direction);
  const double t = squared > 0 ? std::clamp(glm::dot(point - from, direction) / squared, 0.0, 1.0) : 0.0;
  Nearest nearest{glm::distance(point, from + direction * t), Vec3d(0.0)};
  nearest.weights[side] = 1 - t;
  nearest.weights[(side + 1) % 3] = t;
  return nearest;
}

// Twice the signed area of a triangle.
double double_area(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// At distance 0 inside the triangle, else on its nearest side.
Nearest find_nearest_in_triangle(const std::array<Vec2d, 3>& corners, const Vec2d& point) {
  const double area = double_area(corners[0], corners[1], corners[2]);
  if (std::abs(area) > 1e-9) {
    const Vec3d weights(double_area(point, corners[1], corners[2]) / area,
                        double_area(corners[0], point, corners[2]) / area,
                        double_area(corners[0], corners[1], point) / area);
    if (std::min({weights.x, weights.y, weights.z}) >= 0) return {0, weights};
  }
  Nearest nearest = find_nearest_on_side(corners, 0, point);
  for (int side = 1; side < 3; ++side)
    if (const Nearest other = find_nearest_on_side(corners, side, point); other.distance < nearest.distance)
      nearest = other;
  return nearest;
}

// Normals of the mesh at rest: flat ones by triangle, and smooth ones by point and smoothing group, weighted
// by area.
class RestNormals {
 public:
  explicit RestNormals(const Mesh& mesh) {
    for (const MeshTriangle& triangle : mesh.triangles) {
      const std::array<Vec3d, 3> at = {mesh.points[triangle.corners[0].point].rest,
                                       mesh.points[triangle.corners[1].point].rest,
                                       mesh.points[triangle.corners[2].point].rest};
      const Vec3d area = glm::cross(at[1] - at[0], at[2] - at[0]);
      flat_.push_back(triangle_normal(at[0], at[1], at[2]));
      for (std::size_t i = 0; i < 3; ++i) {
        sums_[{triangle.corners[i].point, triangle.smooth}] += area;
        const auto [low, high] = std::minmax(triangle.corners[i].point, triangle.corners[(i + 1) % 3].point);
        sides_[{low, high}].push_back(flat_.size() - 1);
      }
    }
  }

  const Vec3d& flat(std::size_t triangle) const { return flat_[triangle]; }
  Vec3d smooth(const MeshTriangle& triangle, const Vec3d& weights) const {
    Vec3d sum(0.0);
    for (int i = 0; i < 3; ++i) {
      const Vec3d& corner = sums_.at({triangle.corners[static_cast<std::size_t>(i)].point, triangle.smooth});
      if (glm::length(corner) > 0) sum += glm::normalize(corner) * weights[i];
    }
    return glm::length(sum) > 1e-9 ? glm::normalize(sum) : Vec3d(0, 0, 1);
  }
  // Whether the surface bends sharply outward at a side of a triangle. Only those edges wear off.
  bool is_convex_edge(const Mesh& mesh, std::size_t triangle, std::size_t side) const {
    const auto& corners = mesh.triangles[triangle].corners;
    const auto [low, high] = std::minmax(corners[side].point, corners[(side + 1) % 3].point);
    for (const std::size_t other : sides_.at({low, high})) {
      if (other == triangle || glm::dot(flat_[triangle], flat_[other]) > 0.75) continue;
      for (const MeshCorner& corner : mesh.triangles[other].corners)
        if (glm::dot(mesh.points[corner.point].rest - mesh.points[corners[side].point].rest,
                     flat_[triangle]) < -1e-6)
          return true;
    }
    return false;
  }

 private:
  std::vector<Vec3d> flat_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> sums_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> sides_;
};

double measure_height(const Mesh& mesh) {
  double low = 1e9, high = -1e9;
  for (const MeshPoint& point : mesh.points) {
    low = std::min(low, point.rest.z);
    high = std::max(high, point.rest.z);
  }
  return high - low;
}

// The distance from a position on a triangle to its nearest marked side; `is_convex_edge` marks them.
double distance_to_edges(const std::array<Vec3d, 3>& at, const std::array<bool, 3>& is_convex_edge,
                         const Vec3d& position) {
  double nearest = 1e9;
  for (std::size_t side = 0; side < 3; ++side) {
    if (!is_convex_edge[side]) continue;
    const Vec3d from = at[side], direction = at[(side + 1) % 3] - from;
    const double squared = std::max(glm::dot(direction, direction), 1e-12);
    const double t = std::clamp(glm::dot(position - from, direction) / squared, 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(position, from + direction * t));
  }
  return nearest;
}

// Angles wrap around at 360 degrees.
bool is_between(double angle_deg, double low_deg, double high_deg) {
  const double turn = angle_deg - low_deg - 360 * std::floor((angle_deg - low_deg) / 360);
  return turn <= high_deg - low_deg;
}

// The last patch that contains the texel decides.
const Paint& paint_at(const SkinTexel& texel, const ShapeLook& look, const std::vector<Paint>& paints) {
  std::size_t paint = look.paint;
  for (const Patch& patch : look.patches)
    if (texel.along >= patch.along_low && texel.along <= patch.along_high &&
        is_between(texel.around_deg, patch.around_low_deg, patch.around_high_deg))
      paint = patch.paint;
  return paints[paint];
}

// Whether a pattern covers the texel.
bool is_covered(const PaintLayer& layer, const SkinTexel& texel, std::uint64_t seed) {
  const double noise = lump_noise(texel.position / std::max(layer.grain, 0.1), seed);
  // The noise is concentrated around 0.5, so thresholds outside 0.22 to 0.78 would change little.
  if (layer.every <= 0) return noise < 0.22 + 0.56 * layer.amount;
  const double at = (glm::dot(texel.position, layer.axis) + layer.waver * (noise - 0.5) * 2) / layer.every;
  return at - std::floor(at) < layer.amount;
}

std::uint8_t choose_texel_color(const SkinTexel& texel, const Paint& paint, std::size_t number) {
  // Seeded by the paint's name, so that additional paints do not change the noise of others.
  std::uint64_t seed = 17;
  for (const char c : paint.name) seed = seed * 131 + static_cast<unsigned char>(c);
  Ramp ramp = paint.ramp;
  double low = paint.low, high = paint.high;
  for (std::size_t i = 0; i < paint.layers.size(); ++i) {
    if (!is_covered(paint.layers[i], texel, seed + 100 * (i + 1))) continue;
    ramp = paint.layers[i].ramp;
    low = paint.layers[i].low;
    high = paint.layers[i].high;
  }
  const double lumps = lump_noise(texel.position / std::max(paint.grain, 0.1), seed);
  double bright = 0.55 + paint.noise * (lumps - 0.5) * 2.4 + 0.2 * paint.shade * texel.normal.z;
  if (texel.edge_units < kWearUnits)
    bright +=
        paint.wear * (1 - texel.edge_units / kWearUnits) * (0.3 + 0.7 * lump_noise(texel.position, seed + 7));
  bright = std::clamp(bright, 0.0, 1.0);
  // Full-bright colors have no shadows.
  const bool glows = ramp == Ramp::kFire || ramp == Ramp::kElectric;
  double value = low + (high - low) * bright;
  if (!glows) value *= 1 - std::min(0.9, kDeepCrease * texel.hidden) * paint.shade;
  const auto x = static_cast<std::int32_t>(number % 65536), y = static_cast<std::int32_t>(number / 65536);
  // Random dithering, below one step of the ramp, hides the bands between its 16 colors.
  const double dither = (hash_at(x, y, 0, seed) - 0.5) * 0.7 / static_cast<double>(kRampColors - 1);
  return ramp_color(ramp, value + dither);
}

}  // namespace

std::vector<SkinTexel> find_skin_texels(const Mesh& mesh, const Atlas& atlas) {
  const RestNormals normals(mesh);
  // The reach of occlusion is proportional to the model's height, within limits.
  const Occlusion occlusion(mesh, std::clamp(0.16 * measure_height(mesh), 1.5, 14.0));
  std::vector<SkinTexel> texels(static_cast<std::size_t>(atlas.width) *
                                static_cast<std::size_t>(atlas.height));
  std::vector<double> nearest(texels.size(), 1e9);
  struct Source {
    std::size_t triangle = 0;
    Vec3d weights{0.0};
  };
  std::vector<Source> sources(texels.size());
  // First pass: find the nearest triangle for each texel.
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.is_image[i]) continue;
    const MeshTriangle& triangle = mesh.triangles[i];
    std::array<Vec2d, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
      corners[c] = atlas.texel(triangle.chart, triangle.corners[c].position);
    const Vec2d low = glm::min(glm::min(corners[0], corners[1]), corners[2]) - kBleedTexels;
    const Vec2d high = glm::max(glm::max(corners[0], corners[1]), corners[2]) + kBleedTexels;
    for (double y = low.y; y <= high.y; ++y) {
      for (double x = low.x; x <= high.x; ++x) {
        if (x < 0 || y < 0 || x >= atlas.width || y >= atlas.height) continue;
        const Nearest found = find_nearest_in_triangle(corners, {x, y});
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(atlas.width) + static_cast<std::size_t>(x);
        if (found.distance > kBleedTexels * 1.42 || found.distance >= nearest[at]) continue;
        nearest[at] = found.distance;
        sources[at] = {i, found.weights};
        texels[at].used = true;
      }
    }
  }
  // Second pass: interpolate the triangle's attributes and compute the expensive ones once per used texel.
  for (std::size_t at = 0; at < texels.size(); ++at) {
    SkinTexel& texel = texels[at];
    if (!texel.used) continue;
    const auto& [number, weights] = sources[at];
    const MeshTriangle& triangle = mesh.triangles[number];
    std::array<Vec3d, 3> positions;
    std::array<bool, 3> is_convex_edge{};
    for (std::size_t c = 0; c < 3; ++c) {
      const MeshCorner& corner = triangle.corners[c];
      positions[c] = mesh.points[corner.point].rest;
      const double weight = weights[static_cast<int>(c)];
      texel.position += positions[c] * weight;
      texel.along += corner.along * weight;
      texel.around_deg += corner.around_deg * weight;
      is_convex_edge[c] = normals.is_convex_edge(mesh, number, c);
    }
    texel.shape = mesh.chart_shapes[triangle.chart];
    texel.normal = normals.smooth(triangle, weights);
    texel.edge_units = distance_to_edges(positions, is_convex_edge, texel.position);
    texel.hidden = occlusion.at(number, texel.position, normals.flat(number));
  }
  return texels;
}

std::vector<std::uint8_t> paint_skin(const std::vector<SkinTexel>& texels, std::int32_t width,
                                     const std::vector<ShapeLook>& shapes, const std::vector<Paint>& paints) {
  std::vector<std::uint8_t> skin(texels.size(), 0);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if (!texels[i].used) continue;
    const std::size_t row = i / static_cast<std::size_t>(width), column = i % static_cast<std::size_t>(width);
    skin[i] = choose_texel_color(texels[i], paint_at(texels[i], shapes[texels[i].shape], paints),
                                 row * 65536 + column);
  }
  return skin;
}

}  // namespace temblor::artgen
