// Writes trees and faces into a level's lumps, one model after another.
//
// Leaf 0 of a level is the solid leaf that all solid leaves of all trees share. If both children of a node
// are solid, one is a second solid leaf, because DarkPlaces refuses nodes with equal children. Edges are
// shared by the two faces on both sides of them.
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

// Use: add_model(), then set_hull() for each clip hull; the world first; take() at the end.
class LevelWriter {
 public:
  // `planes` outlives the writer.
  explicit LevelWriter(const PlaneSet& planes);

  // Adds a model. `faces` are in the order of their nodes; `box` bounds the model's brushes. Returns, by leaf
  // of the tree, its number in the level; 0 for solid leaves.
  std::vector<std::uint32_t> add_model(const Tree& tree, std::span<const LeafPortal> portals,
                                       std::span<const TreeFace> faces, const Box& box);
  // Sets clip hull 1 to 3 of the last model.
  void set_hull(std::size_t hull, const Tree& tree);

  // By face of the level: the surface that it shows.
  const std::vector<std::uint32_t>& surface_of_face() const { return surface_of_face_; }
  // The level so far.
  const formats::Bsp& level() const { return bsp_; }
  // Returns the level without texinfos, textures, entities, visibility and light.
  formats::Bsp take() &&;

 private:
  // The model that is being added.
  struct ModelParts {
    const Tree& tree;
    std::vector<Box> leaf_boxes;
    std::vector<std::uint32_t> leaf_numbers;
    // By node of the tree: the range of its faces in the level.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> first_face_and_count;
    std::size_t first_leaf;  // number of the model's first leaf in the level
  };
  void add_leaves(std::int32_t child, ModelParts& io_parts);
  void add_faces(std::span<const TreeFace> faces, ModelParts& io_parts);
  std::uint32_t add_face(const TreeFace& face, std::span<const std::uint32_t> loop);
  std::pair<std::int32_t, Box> add_node(std::int32_t child, const ModelParts& parts);
  std::int32_t add_clipnode(const Tree& tree, std::int32_t child);
  std::uint32_t plane_number(PlaneIndex plane);
  std::int32_t surfedge(std::uint32_t from, std::uint32_t to);

  const PlaneSet& planes_;
  formats::Bsp bsp_;
  std::map<PlaneIndex, std::uint32_t> plane_numbers_;
  VertexSet vertices_;
  // Edges that only one face uses so far, by their two vertices.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open_edges_;
  std::vector<std::uint32_t> surface_of_face_;
  // Nodes with faces between a fence and a solid: both children are leaf 0.
  std::vector<std::size_t> between_solids_;
};

}  // namespace temblor::compiler
