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

constexpr double kBleedTexels = 1.0;  // round a triangle that texels take their color from it
constexpr double kDeepCrease = 1.25;  // of the brightness that a wholly hidden place loses
constexpr double kWearUnits = 0.7;    // width of worn edges

struct Nearest {
  double distance;
  Vec3d weights;
};

// The place on a side of a triangle that is nearest to `point`.
Nearest nearest_on_side(const std::array<Vec2d, 3>& corners, int side, const Vec2d& point) {
  const Vec2d from = corners[static_cast<std::size_t>(side)],
              to = corners[static_cast<std::size_t>((side + 1) % 3)];
  const Vec2d way = to - from;
  const double squared = glm::dot(way, way);
  const double t = squared > 0 ? std::clamp(glm::dot(point - from, way) / squared, 0.0, 1.0) : 0.0;
  Nearest nearest{glm::distance(point, from + way * t), Vec3d(0.0)};
  nearest.weights[side] = 1 - t;
  nearest.weights[(side + 1) % 3] = t;
  return nearest;
}

double double_area(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Nearest nearest_in(const std::array<Vec2d, 3>& corners, const Vec2d& point) {
  const double area = double_area(corners[0], corners[1], corners[2]);
  if (std::abs(area) > 1e-9) {
    const Vec3d weights(double_area(point, corners[1], corners[2]) / area,
                        double_area(corners[0], point, corners[2]) / area,
                        double_area(corners[0], corners[1], point) / area);
    if (std::min({weights.x, weights.y, weights.z}) >= 0) return {0, weights};
  }
  Nearest nearest = nearest_on_side(corners, 0, point);
  for (int side = 1; side < 3; ++side)
    if (const Nearest other = nearest_on_side(corners, side, point); other.distance < nearest.distance)
      nearest = other;
  return nearest;
}

// Normals of the mesh at rest: of triangles, and of points by what they share them with.
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
  // Whether the surface bends away sharply at a triangle's side.
  bool stands_out(const Mesh& mesh, std::size_t triangle, std::size_t side) const {
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

double height_of(const Mesh& mesh) {
  double low = 1e9, high = -1e9;
  for (const MeshPoint& point : mesh.points) {
    low = std::min(low, point.rest.z);
    high = std::max(high, point.rest.z);
  }
  return high - low;
}

// Distance from a place on a triangle to its sides that stand out.
double distance_to_edges(const std::array<Vec3d, 3>& at, const std::array<bool, 3>& stands_out,
                         const Vec3d& place) {
  double nearest = 1e9;
  for (std::size_t side = 0; side < 3; ++side) {
    if (!stands_out[side]) continue;
    const Vec3d from = at[side], way = at[(side + 1) % 3] - from;
    const double squared = std::max(glm::dot(way, way), 1e-12);
    const double t = std::clamp(glm::dot(place - from, way) / squared, 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(place, from + way * t));
  }
  return nearest;
}

bool lies_between(double angle_deg, double low_deg, double high_deg) {
  const double turn = angle_deg - low_deg - 360 * std::floor((angle_deg - low_deg) / 360);
  return turn <= high_deg - low_deg;
}

const Paint& paint_at(const SkinTexel& texel, const ShapeLook& look, const std::vector<Paint>& paints) {
  std::size_t paint = look.paint;
  for (const Patch& patch : look.patches)
    if (texel.along >= patch.along_low && texel.along <= patch.along_high &&
        lies_between(texel.around_deg, patch.around_low_deg, patch.around_high_deg))
      paint = patch.paint;
  return paints[paint];
}

bool covers(const PaintLayer& layer, const SkinTexel& texel, std::uint64_t seed) {
  const double noise = lump_noise(texel.place / std::max(layer.grain, 0.1), seed);
  // The noise is mostly near its middle.
  if (layer.every <= 0) return noise < 0.22 + 0.56 * layer.amount;
  const double at = (glm::dot(texel.place, layer.axis) + layer.waver * (noise - 0.5) * 2) / layer.every;
  return at - std::floor(at) < layer.amount;
}

std::uint8_t color_of(const SkinTexel& texel, const Paint& paint, std::size_t number) {
  // By the paint's name, so that a paint more or less leaves the others' noise as it is.
  std::uint64_t seed = 17;
  for (const char c : paint.name) seed = seed * 131 + static_cast<unsigned char>(c);
  Ramp ramp = paint.ramp;
  double low = paint.low, high = paint.high;
  for (std::size_t i = 0; i < paint.layers.size(); ++i) {
    if (!covers(paint.layers[i], texel, seed + 100 * (i + 1))) continue;
    ramp = paint.layers[i].ramp;
    low = paint.layers[i].low;
    high = paint.layers[i].high;
  }
  const double lumps = lump_noise(texel.place / std::max(paint.grain, 0.1), seed);
  double bright = 0.55 + paint.noise * (lumps - 0.5) * 2.4 + 0.2 * paint.shade * texel.normal.z;
  if (texel.edge_units < kWearUnits)
    bright +=
        paint.wear * (1 - texel.edge_units / kWearUnits) * (0.3 + 0.7 * lump_noise(texel.place, seed + 7));
  bright = std::clamp(bright, 0.0, 1.0);
  const bool glows = ramp == Ramp::kFire || ramp == Ramp::kElectric;
  double value = low + (high - low) * bright;
  if (!glows) value *= 1 - std::min(0.9, kDeepCrease * texel.hidden) * paint.shade;
  const auto x = static_cast<std::int32_t>(number % 65536), y = static_cast<std::int32_t>(number / 65536);
  const double dither = (hash_at(x, y, 0, seed) - 0.5) * 0.7 / static_cast<double>(kRampColors - 1);
  return ramp_color(ramp, value + dither);
}

}  // namespace

std::vector<SkinTexel> find_skin_texels(const Mesh& mesh, const Atlas& atlas) {
  const RestNormals normals(mesh);
  const Occlusion occlusion(mesh, std::clamp(0.16 * height_of(mesh), 1.5, 14.0));
  std::vector<SkinTexel> texels(static_cast<std::size_t>(atlas.width) *
                                static_cast<std::size_t>(atlas.height));
  std::vector<double> nearest(texels.size(), 1e9);
  struct Source {
    std::size_t triangle = 0;
    Vec3d weights{0.0};
  };
  std::vector<Source> sources(texels.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.is_image[i]) continue;
    const MeshTriangle& triangle = mesh.triangles[i];
    std::array<Vec2d, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = atlas.texel(triangle.chart, triangle.corners[c].place);
    const Vec2d low = glm::min(glm::min(corners[0], corners[1]), corners[2]) - kBleedTexels;
    const Vec2d high = glm::max(glm::max(corners[0], corners[1]), corners[2]) + kBleedTexels;
    for (double y = low.y; y <= high.y; ++y) {
      for (double x = low.x; x <= high.x; ++x) {
        if (x < 0 || y < 0 || x >= atlas.width || y >= atlas.height) continue;
        const Nearest found = nearest_in(corners, {x, y});
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(atlas.width) + static_cast<std::size_t>(x);
        if (found.distance > kBleedTexels * 1.42 || found.distance >= nearest[at]) continue;
        nearest[at] = found.distance;
        sources[at] = {i, found.weights};
        texels[at].used = true;
      }
    }
  }
  for (std::size_t at = 0; at < texels.size(); ++at) {
    SkinTexel& texel = texels[at];
    if (!texel.used) continue;
    const auto& [number, weights] = sources[at];
    const MeshTriangle& triangle = mesh.triangles[number];
    std::array<Vec3d, 3> places;
    std::array<bool, 3> stands_out{};
    for (std::size_t c = 0; c < 3; ++c) {
      const MeshCorner& corner = triangle.corners[c];
      places[c] = mesh.points[corner.point].rest;
      const double weight = weights[static_cast<int>(c)];
      texel.place += places[c] * weight;
      texel.along += corner.along * weight;
      texel.around_deg += corner.around_deg * weight;
      stands_out[c] = normals.stands_out(mesh, number, c);
    }
    texel.shape = mesh.chart_shapes[triangle.chart];
    texel.normal = normals.smooth(triangle, weights);
    texel.edge_units = distance_to_edges(places, stands_out, texel.place);
    texel.hidden = occlusion.at(number, texel.place, normals.flat(number));
  }
  return texels;
}

std::vector<std::uint8_t> paint_skin(const std::vector<SkinTexel>& texels, std::int32_t width,
                                     const std::vector<ShapeLook>& shapes, const std::vector<Paint>& paints) {
  std::vector<std::uint8_t> skin(texels.size(), 0);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if (!texels[i].used) continue;
    const std::size_t row = i / static_cast<std::size_t>(width), column = i % static_cast<std::size_t>(width);
    skin[i] = color_of(texels[i], paint_at(texels[i], shapes[texels[i].shape], paints), row * 65536 + column);
  }
  return skin;
}

}  // namespace temblor::artgen
