// The outline of a projected model.
#pragma once

#include <span>
#include <vector>

#include "base/arena.h"
#include "render/alias/alias_mesh.h"
#include "render/alias/triangle_kernels.h"

namespace temblor::lab {

struct OutlineEdge {
  std::uint32_t from, to;  // vertices
};

// The edges of a mesh, each with the triangles on its two sides. Vertices on a skin's seam are stored twice,
// so edges along the seam have one triangle.
class MeshEdges {
 public:
  explicit MeshEdges(std::span<const render::MeshTriangle> triangles);

  // Whether these are the edges of the triangles.
  bool match(std::span<const render::MeshTriangle> triangles) const;

  static constexpr std::uint32_t kNoTriangle = 0xffffffffu;
  struct Edge {
    OutlineEdge ends;
    std::uint32_t triangle, other_triangle;  // the second may be kNoTriangle
  };
  std::span<const Edge> all() const { return edges_; }

 private:
  std::vector<render::MeshTriangle> triangles_;
  std::vector<Edge> edges_;
};

struct Outline {
  std::span<const OutlineEdge> edges;       // with a front triangle on one side only
  std::span<const std::uint32_t> vertices;  // of front triangles, each once
};

// `job` needs no front triangles; its triangles are those of `edges`. The result lives in `arena`.
Outline find_outline(const render::TriangleJob& job, const MeshEdges& edges, base::Arena& arena);

}  // namespace temblor::lab
