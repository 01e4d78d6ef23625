#include "artgen/level/mesh.h"

namespace temblor::artgen {

LevelMesh::LevelMesh(formats::Bsp& io_bsp, bool share_without_limit)
    : bsp_(io_bsp), share_without_limit_(share_without_limit) {
  // Edge 0 stays unused, because a surfedge of 0 could not have a sign.
  bsp_.edges.emplace_back();
}

std::uint32_t LevelMesh::add_vertex(const math::Vec3& position) {
  const auto next = static_cast<std::uint32_t>(bsp_.vertices.size());
  const auto [entry, is_new] = vertices_.try_emplace({position.x, position.y, position.z}, next);
  if (is_new) bsp_.vertices.push_back(position);
  return entry->second;
}

// Prefers an existing edge in the reverse direction, then (without a limit) one in the same direction, else
// adds an edge.
std::int32_t LevelMesh::add_surfedge(std::uint32_t from, std::uint32_t to) {
  if (const auto against = open_edges_.find({to, from}); against != open_edges_.end()) {
    const auto edge = static_cast<std::int32_t>(against->second);
    if (!share_without_limit_) open_edges_.erase(against);
    return -edge;
  }
  if (const auto along = open_edges_.find({from, to}); share_without_limit_ && along != open_edges_.end())
    return static_cast<std::int32_t>(along->second);
  const auto edge = static_cast<std::uint32_t>(bsp_.edges.size());
  bsp_.edges.push_back({{from, to}});
  open_edges_.emplace(Ends{from, to}, edge);
  return static_cast<std::int32_t>(edge);
}

SurfedgeRange LevelMesh::add_loop(std::span<const math::Vec3> vertices) {
  const auto first = static_cast<std::uint32_t>(bsp_.surfedges.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t from = add_vertex(vertices[i]);
    const std::uint32_t to = add_vertex(vertices[(i + 1) % vertices.size()]);
    bsp_.surfedges.push_back(add_surfedge(from, to));
  }
  return {first, static_cast<std::uint32_t>(vertices.size())};
}

}  // namespace temblor::artgen
