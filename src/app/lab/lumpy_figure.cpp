#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "app/lab/model_crowd.h"
#include "formats/models/mdl_normals.h"

namespace temblor::app {
namespace {

constexpr std::uint32_t kSegments = 20, kRings = 11, kPoses = 4;
constexpr std::uint32_t kSkinWidth = 128, kSkinHeight = 64, kChecks = 4;
constexpr float kHeight = 56;

std::uint8_t find_nearest_normal(const math::Vec3& direction) {
  const auto normals = formats::mdl_normals();
  std::size_t best = 0;
  for (std::size_t i = 1; i < normals.size(); ++i)
    if (glm::dot(normals[i], direction) > glm::dot(normals[best], direction)) best = i;
  return static_cast<std::uint8_t>(best);
}

// The radius in a direction, 0 to 1: lumps that move from pose to pose.
float find_radius(double around, double down, std::uint32_t pose) {
  const double phase = 2 * std::numbers::pi * pose / kPoses;
  return static_cast<float>(0.8 + 0.1 * std::sin(3 * around + phase) + 0.1 * std::sin(4 * down + phase));
}

formats::MdlVertex make_vertex(std::uint32_t segment, std::uint32_t ring, std::uint32_t pose) {
  const double around = 2 * std::numbers::pi * segment / kSegments;
  const double down = std::numbers::pi * ring / kRings;
  const math::Vec3 direction{static_cast<float>(std::sin(down) * std::cos(around)),
                             static_cast<float>(std::sin(down) * std::sin(around)),
                             static_cast<float>(std::cos(down))};
  const math::Vec3 at = direction * find_radius(around, down, pose) * math::Vec3(0.5f, 0.5f, 1.0f);
  formats::MdlVertex vertex;
  for (int axis = 0; axis < 3; ++axis)
    vertex.position[static_cast<std::size_t>(axis)] =
        static_cast<std::uint8_t>(std::lround(127.5f + 127.0f * at[axis]));
  vertex.normal = find_nearest_normal(direction);
  return vertex;
}

// One column more than segments, because the skin's ends meet there.
std::uint32_t vertex_number(std::uint32_t segment, std::uint32_t ring) {
  return ring * (kSegments + 1) + segment;
}

std::vector<std::uint8_t> make_skin() {
  std::vector<std::uint8_t> skin(std::size_t{kSkinWidth} * kSkinHeight);
  for (std::uint32_t t = 0; t < kSkinHeight; ++t)
    for (std::uint32_t s = 0; s < kSkinWidth; ++s) {
      constexpr std::uint8_t kRamp = 16, kOther = 64;
      const bool is_light = (s / kChecks + t / kChecks) % 2 == 0;
      skin[std::size_t{t} * kSkinWidth + s] = static_cast<std::uint8_t>((is_light ? kRamp : kOther) + 10);
    }
  return skin;
}

}  // namespace

formats::Mdl make_lumpy_figure() {
  formats::Mdl mdl;
  mdl.scale = math::Vec3(kHeight / 255);
  mdl.origin = math::Vec3(-kHeight / 2);
  mdl.bounding_radius = kHeight / 2;
  mdl.skin_width = kSkinWidth;
  mdl.skin_height = kSkinHeight;
  mdl.skins.push_back({{make_skin()}, {}});
  for (std::uint32_t ring = 0; ring <= kRings; ++ring)
    for (std::uint32_t segment = 0; segment <= kSegments; ++segment)
      mdl.texels.push_back({false, static_cast<std::int32_t>(segment * (kSkinWidth - 1) / kSegments),
                            static_cast<std::int32_t>(ring * (kSkinHeight - 1) / kRings)});
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t segment = 0; segment < kSegments; ++segment) {
      const std::uint32_t a = vertex_number(segment, ring), b = vertex_number(segment + 1, ring);
      const std::uint32_t c = vertex_number(segment, ring + 1), d = vertex_number(segment + 1, ring + 1);
      // At a pole, one of the two has no area.
      if (ring > 0) mdl.triangles.push_back({true, {a, b, c}});
      if (ring + 1 < kRings) mdl.triangles.push_back({true, {b, d, c}});
    }
  for (std::uint32_t pose = 0; pose < kPoses; ++pose) {
    formats::MdlPose vertices;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring)
      for (std::uint32_t segment = 0; segment <= kSegments; ++segment)
        vertices.vertices.push_back(make_vertex(segment % kSegments, ring, pose));
    mdl.frames.push_back({{std::move(vertices)}, {}, {}, {}});
  }
  return mdl;
}

}  // namespace temblor::app
