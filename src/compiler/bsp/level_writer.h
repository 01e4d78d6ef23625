// Trees and faces as a level's lumps, model by model.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "compiler/bsp/faces/faces.h"
#include "compiler/bsp/faces/vertices.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

class LevelWriter {
 public:
  explicit LevelWriter(const PlaneSet& planes);

  // The world first; `faces` in order of their nodes, `box` of the model's brushes. Returns the number of
  // each of the tree's leaves in the level; 0 for solid ones.
  std::vector<std::uint32_t> add_model(const Tree& tree, std::span<const LeafPortal> portals,
                                       std::span<const TreeFace> faces, const Box& box);
  // Of the last model: hull 1 or 2.
  void set_hull(std::size_t hull, const Tree& tree);

  // By face, its surface.
  const std::vector<std::uint32_t>& surface_of_face() const { return surface_of_face_; }
  // Everything but texinfos, textures, entities, visibility and light.
  formats::Bsp take() &&;

 private:
  // What is being added.
  struct ModelParts {
    const Tree& tree;
    std::vector<Box> leaf_boxes;
    std::vector<std::uint32_t> leaf_numbers;
    // By node of the tree: its faces in the level.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> first_face_and_count;
    std::size_t first_leaf;  // of its leaves in the level
  };
  void add_leaves(std::int32_t child, ModelParts& io_parts);
  void add_faces(std::span<const TreeFace> faces, ModelParts& io_parts);
  std::pair<std::int32_t, Box> add_node(std::int32_t child, const ModelParts& parts);
  std::int32_t add_clipnode(const Tree& tree, std::int32_t child);
  std::uint32_t plane_number(PlaneIndex plane);
  std::int32_t surfedge(std::uint32_t from, std::uint32_t to);

  const PlaneSet& planes_;
  formats::Bsp bsp_;
  std::map<PlaneIndex, std::uint32_t> plane_numbers_;
  VertexSet vertices_;
  // From vertex to vertex, while one face alone uses it.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open_edges_;
  std::vector<std::uint32_t> surface_of_face_;
};

}  // namespace temblor::compiler
