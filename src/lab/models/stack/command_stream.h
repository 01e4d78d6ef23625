// A triangle mesh as a stream of commands for a stack of vertices: push a vertex, pop some, draw a triangle
// whose vertices are in the stack (Bar-Yehuda and Gotsman, "Time/Space Tradeoffs for Polygon Mesh Rendering",
// ACM Transactions on Graphics 15(2), 1996). A vertex that is popped before all of its triangles are drawn
// must be pushed again. They prove that some order of n vertices needs n(1 + c/k) pushes with k places, and n
// with a number of places that grows like the root of n.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/alias/alias_mesh.h"

namespace temblor::lab {

struct StackCommand {
  enum class Kind : std::uint8_t { kPush, kPop, kDraw };
  Kind kind;
  // Draw: of each corner, in the triangle's order. Position 0 is the bottom.
  std::array<std::uint8_t, 3> positions{};
  std::uint32_t number = 0;  // push: of the vertex; pop: of entries; draw: of the triangle
};

struct CommandStream {
  std::vector<StackCommand> commands;
  std::size_t pushes = 0;
};

constexpr std::size_t kMinStack = 4, kMaxStack = 64;

// Each of these draws each triangle once, with at most `places` entries in the stack, from kMinStack to
// kMaxStack. Vertices must be below `vertex_count`.

// The next vertex is the one that completes most triangles. A full stack is popped to the depth from which a
// trial run draws most triangles per push. Time grows with the mesh and the square of `places`.
CommandStream find_greedy_stream(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                                 std::size_t places);
// Halves the mesh, and again its halves. A part whose separators fit the stack is drawn with one push for
// each vertex: vertices of both halves stay at the bottom. Time grows with the mesh and the square of its
// logarithm.
CommandStream find_separated_stream(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                                    std::size_t places);
// The one of the two that has fewer pushes.
CommandStream find_command_stream(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                                  std::size_t places);

}  // namespace temblor::lab
