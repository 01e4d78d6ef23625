#include "formats/levels/cube_room.h"

#include <algorithm>

namespace temblor::test {
namespace {

constexpr float kHalfSize = 64;
constexpr std::int32_t kSolidLeaf = -1, kRoomLeaf = -2;  // as children of nodes
constexpr std::int32_t kEmpty = -1, kSolid = -2;         // contents
constexpr std::int32_t kWallSamples = (128 / 16 + 1) * (128 / 16 + 1);

// Corner i lies on the positive side of each axis whose bit is set in i.
math::Vec3 corner_position(std::uint32_t corner) {
  math::Vec3 position;
  for (int axis = 0; axis < 3; ++axis) position[axis] = (corner >> axis & 1) != 0 ? kHalfSize : -kHalfSize;
  return position;
}

// Returns the surfedge from one corner to another.
std::int32_t edge_between(formats::Bsp& io_bsp, std::uint32_t from, std::uint32_t to) {
  for (std::size_t i = 1; i < io_bsp.edges.size(); ++i) {
    if (io_bsp.edges[i] == formats::BspEdge{{from, to}}) return static_cast<std::int32_t>(i);
    if (io_bsp.edges[i] == formats::BspEdge{{to, from}}) return -static_cast<std::int32_t>(i);
  }
  io_bsp.edges.push_back({{from, to}});
  return static_cast<std::int32_t>(io_bsp.edges.size() - 1);
}

// The corners of a wall, clockwise as seen from inside of the room.
std::array<std::uint32_t, 4> wall_corners(std::uint32_t axis, bool positive) {
  const std::uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
  const std::uint32_t base = positive ? 1u << axis : 0;
  if (positive) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

formats::BspTexinfo wall_texinfo(std::uint32_t axis) {
  formats::BspTexinfo texinfo;
  texinfo.s_axis[static_cast<int>((axis + 1) % 3)] = 1;
  texinfo.t_axis[static_cast<int>((axis + 2) % 3)] = 1;
  texinfo.t_offset = 0.5f;
  return texinfo;
}

void add_wall(formats::Bsp& io_bsp, std::uint32_t axis, bool positive) {
  const auto wall = static_cast<std::uint32_t>(io_bsp.faces.size());
  const bool last = wall == 5;
  formats::BspPlane plane;
  plane.normal[static_cast<int>(axis)] = 1;
  plane.distance = positive ? kHalfSize : -kHalfSize;
  plane.type = static_cast<std::int32_t>(axis);
  io_bsp.planes.push_back(plane);

  formats::BspFace face;
  face.plane = wall;
  face.side = positive ? 1 : 0;
  face.first_surfedge = static_cast<std::uint32_t>(io_bsp.surfedges.size());
  face.surfedge_count = 4;
  face.texinfo = axis;
  face.styles[0] = 0;
  face.light_offset = static_cast<std::int32_t>(wall) * kWallSamples;
  io_bsp.faces.push_back(face);
  io_bsp.marksurfaces.push_back(wall);
  const auto corners = wall_corners(axis, positive);
  for (std::size_t i = 0; i < 4; ++i)
    io_bsp.surfedges.push_back(edge_between(io_bsp, corners[i], corners[(i + 1) % 4]));

  // The outside of the wall is solid; on the inside follow the other walls, and after the last one the room.
  const auto next = static_cast<std::int32_t>(wall + 1);
  formats::BspNode node;
  node.plane = wall;
  node.children = {kSolidLeaf, last ? kRoomLeaf : next};
  node.mins = math::Vec3(-kHalfSize);
  node.maxs = math::Vec3(kHalfSize);
  node.first_face = wall;
  node.face_count = 1;
  formats::BspClipnode clipnode{wall, {kSolid, last ? kEmpty : next}};
  if (!positive) {
    std::swap(node.children[0], node.children[1]);
    std::swap(clipnode.children[0], clipnode.children[1]);
  }
  io_bsp.nodes.push_back(node);
  io_bsp.clipnodes.push_back(clipnode);
}

formats::BspMiptex wall_texture() {
  formats::BspMiptex texture{true, "wall", 16, 16, {}};
  for (std::size_t mip = 0; mip < 4; ++mip) {
    texture.mips[mip].resize(256u >> (2 * mip));
    for (std::size_t i = 0; i < texture.mips[mip].size(); ++i)
      texture.mips[mip][i] = static_cast<std::uint8_t>(i + mip);
  }
  return texture;
}

}  // namespace

formats::Bsp make_cube_room() {
  formats::Bsp bsp;
  bsp.entities =
      "{\n\"classname\" \"worldspawn\"\n}\n{\n\"classname\" \"info_player_start\"\n\"origin\" \"0 0 "
      "-40\"\n}\n";
  bsp.miptexes = {wall_texture(), {}, {true, "outside", 32, 16, {}}};
  for (std::uint32_t corner = 0; corner < 8; ++corner) bsp.vertices.push_back(corner_position(corner));
  bsp.edges.emplace_back();
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    bsp.texinfos.push_back(wall_texinfo(axis));
    add_wall(bsp, axis, true);
    add_wall(bsp, axis, false);
  }
  bsp.lighting.resize(6 * kWallSamples);
  for (std::size_t i = 0; i < bsp.lighting.size(); ++i) bsp.lighting[i] = static_cast<std::uint8_t>(i);

  const math::Vec3 mins(-kHalfSize), maxs(kHalfSize);
  bsp.leaves = {{kSolid, -1, {}, {}, 0, 0, {}}, {kEmpty, 0, mins, maxs, 0, 6, {1, 2, 3, 4}}};
  bsp.visibility = {1};
  bsp.nodes.push_back({0, {kRoomLeaf, kSolidLeaf}, mins, maxs, 0, 0});
  bsp.models = {{mins, maxs, math::Vec3(0.0f), {0, 0, 0, 0}, 1, 0, 6},
                {mins, maxs, math::Vec3(8.0f), {6, kSolid, kEmpty, 0}, 1, 6, 0}};
  return bsp;
}

base::ByteVector make_cube_room_file(formats::BspVersion version) {
  return formats::write_bsp(make_cube_room(), version).value();
}

}  // namespace temblor::test
