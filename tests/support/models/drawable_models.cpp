#include "support/models/drawable_models.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "formats/models/mdl_normals.h"
#include "support/random.h"

namespace temblor::test {
namespace {

// `centered`: from -1 to 1.
formats::MdlVertex vertex_at(const math::Vec3d& centered, const math::Vec3d& normal) {
  formats::MdlVertex vertex;
  for (int axis = 0; axis < 3; ++axis)
    vertex.position[static_cast<std::size_t>(axis)] =
        static_cast<std::uint8_t>(std::clamp(std::lround((centered[axis] + 1) * 127.5), 0L, 255L));
  vertex.normal = nearest_normal(normal);
  return vertex;
}

formats::MdlSkin checkered_skin(std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint8_t> picture;
  for (std::uint32_t t = 0; t < height; ++t)
    for (std::uint32_t s = 0; s < width; ++s)
      picture.push_back(static_cast<std::uint8_t>((s * 7 + t * 13) % 224));
  return {{std::move(picture)}, {}};
}

formats::Mdl empty_mdl(std::uint32_t skin_width, std::uint32_t skin_height) {
  formats::Mdl mdl;
  mdl.scale = math::Vec3(1.0f);
  mdl.origin = math::Vec3(-127.5f);
  mdl.bounding_radius = 230;
  mdl.skin_width = skin_width;
  mdl.skin_height = skin_height;
  mdl.skins = {checkered_skin(skin_width, skin_height)};
  mdl.average_triangle_size = 16;
  return mdl;
}

formats::MdlPose named_pose(std::string name, std::vector<formats::MdlVertex> vertices) {
  formats::MdlPose pose;
  pose.maxs.position = {255, 255, 255};
  pose.name = std::move(name);
  pose.vertices = std::move(vertices);
  return pose;
}

// Clockwise as seen from outside of a body around the center.
void add_outward(formats::Mdl& io_mdl, const std::vector<formats::MdlVertex>& vertices, bool front,
                 std::array<std::uint32_t, 3> corners) {
  const auto at = [&](std::size_t i) {
    const auto& bytes = vertices[corners[i]].position;
    return math::Vec3d(bytes[0], bytes[1], bytes[2]) - 127.5;
  };
  const math::Vec3d normal = glm::cross(at(2) - at(0), at(1) - at(0));
  if (glm::dot(normal, at(0) + at(1) + at(2)) < 0) std::swap(corners[1], corners[2]);
  io_mdl.triangles.push_back({front, corners});
}

// The position of ring r and segment s of the sphere. Front and back meet at y = 0.
math::Vec3d sphere_point(std::uint32_t ring, std::uint32_t rings, std::uint32_t segment,
                         std::uint32_t segments) {
  const double polar = std::numbers::pi * ring / rings;
  const double around = 2 * std::numbers::pi * segment / segments;
  return {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
}

}  // namespace

std::uint8_t nearest_normal(const math::Vec3d& direction) {
  const auto normals = formats::mdl_normals();
  const auto along = [&](const math::Vec3& normal) { return glm::dot(math::Vec3d(normal), direction); };
  const auto nearest = std::max_element(normals.begin(), normals.end(),
                                        [&](const auto& a, const auto& b) { return along(a) < along(b); });
  return static_cast<std::uint8_t>(nearest - normals.begin());
}

formats::Mdl box_mdl() {
  formats::Mdl mdl = empty_mdl(64, 32);
  std::vector<formats::MdlVertex> vertices;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const math::Vec3d p(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    vertices.push_back(vertex_at(p, glm::normalize(p)));
    mdl.texels.push_back({false, corner & 1 ? 60 : 3, corner & 2 ? 28 : corner & 4 ? 3 : 15});
  }
  const std::array<std::array<std::uint32_t, 4>, 6> sides = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& side : sides) {
    add_outward(mdl, vertices, true, {side[0], side[1], side[2]});
    add_outward(mdl, vertices, true, {side[0], side[2], side[3]});
  }
  mdl.frames = {{{named_pose("box", std::move(vertices))}, {}, {}, {}}};
  return mdl;
}

formats::Mdl sphere_mdl(std::uint32_t segments, std::uint32_t rings) {
  formats::Mdl mdl = empty_mdl(128, 64);
  std::vector<formats::MdlVertex> vertices;
  const auto add = [&](const math::Vec3d& p, bool on_seam) {
    vertices.push_back(vertex_at(p, p));
    // The front (y > 0) is on the left half. Vertices of the back have the coordinates of the front, as if
    // folded over.
    const double across = (p.x + 1) / 2, down = (1 - p.z) / 2;
    const bool back = p.y < -1e-9;
    mdl.texels.push_back({on_seam, static_cast<std::int32_t>(2 + across * 59) + (back ? 64 : 0),
                          static_cast<std::int32_t>(2 + down * 59)});
  };
  add({0, 0, 1}, true);
  for (std::uint32_t ring = 1; ring < rings; ++ring)
    for (std::uint32_t segment = 0; segment < segments; ++segment)
      add(sphere_point(ring, rings, segment, segments), segment % (segments / 2) == 0);
  add({0, 0, -1}, true);

  const auto number = [&](std::uint32_t ring, std::uint32_t segment) {
    if (ring == 0) return 0u;
    if (ring == rings) return (rings - 1) * segments + 1;
    return 1 + (ring - 1) * segments + segment % segments;
  };
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t segment = 0; segment < segments; ++segment) {
      const bool front = segment < segments / 2;
      const std::uint32_t a = number(ring, segment), b = number(ring, segment + 1);
      const std::uint32_t c = number(ring + 1, segment), d = number(ring + 1, segment + 1);
      if (ring > 0) add_outward(mdl, vertices, front, {a, d, b});
      if (ring + 1 < rings) add_outward(mdl, vertices, front, {a, c, d});
    }
  mdl.frames = {{{named_pose("sphere", std::move(vertices))}, {}, {}, {}}};
  return mdl;
}

formats::Mdl many_pose_mdl(std::uint32_t poses) {
  formats::Mdl mdl = sphere_mdl(12, 6);
  const std::vector<formats::MdlVertex> round = mdl.frames[0].poses[0].vertices;
  mdl.frames.clear();
  formats::MdlFrame group;
  for (std::uint32_t number = 0; number < poses; ++number) {
    Random random(number);
    std::vector<formats::MdlVertex> bent = round;
    for (formats::MdlVertex& vertex : bent) {
      for (std::uint8_t& byte : vertex.position)
        byte = static_cast<std::uint8_t>(std::clamp(byte + random.uniform(-30, 30), 0.0, 255.0));
      vertex.normal = static_cast<std::uint8_t>(random.below(formats::kMdlNormals));
    }
    const formats::MdlPose pose = named_pose("pose" + std::to_string(number), std::move(bent));
    mdl.frames.push_back({{pose}, {}, {}, {}});
    group.poses.push_back(pose);
    group.end_times_s.push_back(0.1f * static_cast<float>(number + 1));
  }
  mdl.frames.push_back(std::move(group));
  return mdl;
}

std::shared_ptr<const render::AliasModel> small_model(formats::Mdl mdl, float size) {
  mdl.scale *= size / 255;
  mdl.origin *= size / 255;
  return render::make_alias_model(mdl, "small model");
}

}  // namespace temblor::test
