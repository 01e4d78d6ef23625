#include "oracle/polygon_level.h"

#include <cmath>

namespace temblor::oracle {
namespace {

// Newell's method, which also works for concave polygons. The normal of a clockwise polygon is the negative
// of the counterclockwise one.
math::Vec3d front_normal(const PolygonVertices& vertices) {
  math::Vec3d sum{0.0};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sum += glm::cross(math::Vec3d(vertices[i]), math::Vec3d(vertices[(i + 1) % vertices.size()]));
  return -glm::normalize(sum);
}

void add_face(const PolygonVertices& vertices, world::Level& io_level) {
  const math::Vec3d normal = front_normal(vertices);
  world::Face face{};
  face.plane = static_cast<std::uint32_t>(io_level.planes.size());
  face.kind = world::FaceKind::kLit;
  face.styles = {world::kNoStyle, world::kNoStyle, world::kNoStyle, world::kNoStyle};
  face.first_surfedge = static_cast<std::uint32_t>(io_level.surfedges.size());
  face.surfedge_count = static_cast<std::uint32_t>(vertices.size());
  face.light = world::kNoLight;
  math::Vec2d mins(1e9), maxs(-1e9);
  const auto first_vertex = static_cast<std::uint32_t>(io_level.vertices.size());
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    mins = glm::min(mins, math::Vec2d(vertices[i]));
    maxs = glm::max(maxs, math::Vec2d(vertices[i]));
    io_level.surfedges.push_back(static_cast<std::int32_t>(io_level.edges.size()));
    io_level.edges.push_back({{first_vertex + i, first_vertex + (i + 1) % face.surfedge_count}});
    io_level.vertices.push_back(vertices[i]);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<int>(axis);
    face.texture_mins[axis] = static_cast<std::int32_t>(std::floor(mins[i] / 16)) * 16;
    face.texture_extents[axis] =
        static_cast<std::int32_t>(std::ceil(maxs[i] / 16)) * 16 - face.texture_mins[axis];
  }
  const double distance = glm::dot(normal, math::Vec3d(vertices[0]));
  io_level.planes.push_back({math::Vec3(normal), static_cast<float>(distance), 3});
  io_level.faces.push_back(face);
}

world::Texture numbered_texture() {
  world::Texture texture{};
  texture.name = "numbered";
  texture.width = texture.height = 16;
  for (int i = 0; i < 256; ++i) texture.mips[0].push_back(static_cast<std::uint8_t>(i));
  return texture;
}

}  // namespace

world::Level make_polygon_level(std::span<const PolygonModel> models) {
  world::Level level;
  level.name = "polygons";
  level.edges.push_back({});  // unused, as in real levels: edge 0 equals its reverse
  level.texture_axes.push_back({{1, 0, 0}, 0, {0, 1, 0}, 0});
  level.textures.push_back(numbered_texture());
  for (const world::Contents contents : {world::Contents::kSolid, world::Contents::kEmpty}) {
    world::Leaf leaf{};
    leaf.contents = contents;
    leaf.visibility_offset = -1;
    level.leaves.push_back(leaf);
  }
  level.visible_leaf_count = 1;
  for (const PolygonModel& polygons : models) {
    world::Model model{};
    model.head.value = ~1;
    model.first_face = static_cast<std::uint32_t>(level.faces.size());
    model.face_count = static_cast<std::uint32_t>(polygons.polygons.size());
    for (const PolygonVertices& vertices : polygons.polygons) add_face(vertices, level);
    level.models.push_back(model);
  }
  for (std::uint32_t face = 0; face < level.world().face_count; ++face)
    level.marked_faces.push_back(world::FaceIndex{face});
  level.leaves[1].marked_face_count = level.world().face_count;
  return level;
}

}  // namespace temblor::oracle
