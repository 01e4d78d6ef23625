#include "oracle/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "world/visibility.h"

namespace temblor::oracle {
namespace {

// Faces this near to each other count as coplanar: compilers write planes and vertices no more precisely.
constexpr double kTieUnits = 1.0 / 64;

constexpr std::array<math::Vec2d, 8> kAround = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

world::LeafIndex leaf_in_front(const world::Level& level, const Ray& ray, double distance) {
  constexpr double kNudge = 1.0 / 64;  // units towards the eye
  const double back = kNudge / glm::length(ray.direction);
  return world::find_leaf(level, math::Vec3(ray.at(distance - back)));
}

}  // namespace

std::string Tally::summary() const {
  std::string text = fmt::format(
      "{} pixels ({} of brush models): face {:.4f} % (tied {}, within a pixel of an edge {}, wrong {}); "
      "color {:.4f} % of {}; "
      "depth {:.4f} % of {}",
      pixels, on_brush_models, face_agreement() * 100, tied, near_edge, wrong_face, color_agreement() * 100,
      colors, depth_agreement() * 100, depths);
  for (const std::string& finding : findings) text += "\n  " + finding;
  return text;
}

void Tally::add(const Tally& other) {
  pixels += other.pixels;
  same_face += other.same_face;
  tied += other.tied;
  near_edge += other.near_edge;
  wrong_face += other.wrong_face;
  on_brush_models += other.on_brush_models;
  colors += other.colors;
  right_colors += other.right_colors;
  depths += other.depths;
  right_depths += other.right_depths;
  for (const std::string& finding : other.findings)
    if (findings.size() < Tally::kMaxFindings) findings.push_back(finding);
}

VisibleSet::VisibleSet(const world::Level& level) : leaves_(level.leaves.size(), true) {
  show_faces_of_leaves(level);
}

VisibleSet::VisibleSet(const world::Level& level, const math::Vec3& eye_world) {
  std::vector<std::uint8_t> row;
  world::decompress_pvs(level, world::find_leaf(level, eye_world), row);
  for (std::size_t i = 0; i < level.leaves.size(); ++i)
    leaves_.push_back(world::is_in_pvs(row, base::to_index<world::LeafIndex>(i)));
  show_faces_of_leaves(level);
}

void VisibleSet::show_faces_of_leaves(const world::Level& level) {
  faces_.resize(level.faces.size());
  for (std::size_t i = 0; i < level.leaves.size(); ++i) {
    const world::Leaf& leaf = level.leaves[i];
    for (std::uint32_t mark = 0; leaves_[i] && mark < leaf.marked_face_count; ++mark)
      faces_[base::to_size(level.marked_faces[leaf.first_marked_face + mark])] = true;
  }
}

Comparison::Comparison(const PreparedLevel& prepared, const render::Scene& scene, const Drawn& drawn)
    : prepared_(prepared),
      level_(prepared.level()),
      scene_(scene),
      drawn_(drawn),
      ray_scene_(prepared, scene.brush_models),
      rays_(scene.camera, drawn.frame.width(), drawn.frame.height()),
      visible_(drawn.use_pvs && scene.camera.projection == render::Projection::kPerspective
                   ? VisibleSet(level_, scene.camera.origin_world)
                   : VisibleSet(level_)) {}

// A world face is drawn if the PVS includes it; a brush model's face, if the leaf in which it is seen is open
// and in the PVS.
bool Comparison::is_shown(const Ray& ray, const Hit& hit) const {
  if (hit.instance == 0) return visible_.has_face(hit.face);
  const world::LeafIndex leaf = leaf_in_front(level_, ray, hit.distance);
  return level_.leaf(leaf).contents != world::Contents::kSolid && visible_.has_leaf(leaf);
}

bool Comparison::has_holes(const Hit& hit) const {
  return level_.texture(level_.face(hit.face).texture).kind == world::TextureKind::kCutout;
}

// Faces with holes are drawn over the others and are not what the renderer reports for a pixel.
std::optional<Hit> Comparison::nearest(const Ray& ray) const {
  return ray_scene_.nearest(ray, kNearPlane,
                            [&](const Hit& hit) { return !has_holes(hit) && is_shown(ray, hit); });
}

bool Comparison::is_same(const std::optional<Hit>& hit, const render::PixelFace& drawn) const {
  if (!hit) return drawn.instance == render::PixelFace::kNothing;
  return hit->instance == drawn.instance && base::to_size(hit->face) == drawn.face;
}

bool Comparison::is_tied(const Ray& ray, const std::optional<Hit>& hit,
                         const render::PixelFace& drawn) const {
  if (!hit || drawn.instance == render::PixelFace::kNothing) return false;
  const world::FaceIndex face{drawn.face};
  return ray_scene_.distance_to(ray, drawn.instance, face) &&
         ray_scene_.distance_from_plane(ray.at(hit->distance), drawn.instance, face) <= kTieUnits;
}

bool Comparison::seen_within_a_pixel(int x, int y, const render::PixelFace& drawn) const {
  for (const double radius_px : {0.01, 0.1, 0.5, 1.0}) {
    for (const math::Vec2d& direction : kAround) {
      const Ray ray = rays_.ray(x + direction.x * radius_px, y + direction.y * radius_px);
      const std::optional<Hit> hit = nearest(ray);
      if (is_same(hit, drawn) || is_tied(ray, hit, drawn)) return true;
    }
  }
  return false;
}

void Comparison::pixel(int x, int y, Tally& io_tally) const {
  const render::PixelFace& drawn = drawn_.pixel_faces[pixel_index(x, y)];
  const Ray ray = rays_.ray(x, y);
  const std::optional<Hit> hit = nearest(ray);
  ++io_tally.pixels;
  if (hit && hit->instance > 0) ++io_tally.on_brush_models;
  if (is_same(hit, drawn)) {
    ++io_tally.same_face;
    if (!hit) return;
    const std::optional<Hit> seen = covering(x, y, *hit);
    if (!seen) return;
    judge_depth(x, y, *seen, io_tally);
    judge_color(x, y, *seen, io_tally);
  } else if (is_tied(ray, hit, drawn)) {
    ++io_tally.tied;
  } else if (seen_within_a_pixel(x, y, drawn)) {
    ++io_tally.near_edge;
  } else {
    ++io_tally.wrong_face;
    if (io_tally.findings.size() < Tally::kMaxFindings)
      io_tally.findings.push_back(describe(x, y, hit, drawn));
  }
}

Tally Comparison::whole_frame() const {
  Tally tally;
  for (int y = 0; y < drawn_.frame.height(); ++y)
    for (int x = 0; x < drawn_.frame.width(); ++x) pixel(x, y, tally);
  return tally;
}

std::string Comparison::describe(int x, int y, const std::optional<Hit>& hit,
                                 const render::PixelFace& drawn) const {
  const auto name = [](std::uint32_t instance, std::size_t face) {
    return instance == render::PixelFace::kNothing ? "background" : fmt::format("{}/{}", instance, face);
  };
  const Ray ray = rays_.ray(x, y);
  const std::optional<double> distance =
      drawn.instance == render::PixelFace::kNothing
          ? std::nullopt
          : ray_scene_.distance_to(ray, drawn.instance, world::FaceIndex{drawn.face});
  const render::Camera& camera = scene_.camera;
  return fmt::format(
      "--pos {},{},{} --angles {},{},{} fov {} size {}x{} pixel {},{}: oracle {} at {}, drawn {} at {}",
      camera.origin_world.x, camera.origin_world.y, camera.origin_world.z, camera.angles_deg.x,
      camera.angles_deg.y, camera.angles_deg.z, camera.fov_deg, drawn_.frame.width(), drawn_.frame.height(),
      x, y, hit ? name(hit->instance, base::to_size(hit->face)) : "background", hit ? hit->distance : 0.0,
      name(drawn.instance, drawn.face), distance.value_or(0.0));
}

}  // namespace temblor::oracle
