#include "formats/levels/bsp/unused.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "formats/levels/bsp/repair_faces.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr BspPlane kSomePlane{{1, 0, 0}, 0, 0};
constexpr std::int32_t kSolidLeaf = -2, kEmptyClip = -1;  // contents

// The records of one lump that are in use.
class Marks {
 public:
  explicit Marks(std::size_t size) : is_marked_(size) {}

  // Marks a record. Returns false if it was marked, or does not exist.
  bool add(std::int64_t record) {
    if (record < 0 || record >= static_cast<std::int64_t>(is_marked_.size())) return false;
    const auto position = static_cast<std::size_t>(record);
    if (is_marked_[position]) return false;
    return is_marked_[position] = true;
  }
  bool operator[](std::size_t record) const { return is_marked_[record]; }
  std::size_t size() const { return is_marked_.size(); }

 private:
  std::vector<bool> is_marked_;
};

// Many ranges of records, which may overlap. Marking each one by itself could take quadratic time.
class Ranges {
 public:
  explicit Ranges(std::size_t size) : changes_(size + 1) {}

  void add(std::uint64_t first, std::uint64_t count) {
    const std::uint64_t size = changes_.size() - 1;
    if (first >= size) return;
    ++changes_[first];
    --changes_[std::min(first + count, size)];
  }
  // Calls `visit` with each record that is in a range.
  template <typename Visit>
  void visit_all(Visit visit) const {
    std::int64_t open = 0;
    for (std::size_t i = 0; i + 1 < changes_.size(); ++i)
      if ((open += changes_[i]) > 0) visit(i);
  }

 private:
  std::vector<std::int64_t> changes_;  // ranges that begin at a record, less those that end before it
};

struct Used {
  explicit Used(const Bsp& bsp)
      : planes(bsp.planes.size()),
        vertices(bsp.vertices.size()),
        nodes(bsp.nodes.size()),
        texinfos(bsp.texinfos.size()),
        faces(bsp.faces.size()),
        clipnodes(bsp.clipnodes.size()),
        leaves(bsp.leaves.size()),
        marksurfaces(bsp.marksurfaces.size()),
        edges(bsp.edges.size()),
        surfedges(bsp.surfedges.size()) {}

  Marks planes, vertices, nodes, texinfos, faces, clipnodes, leaves, marksurfaces, edges, surfedges;
};

void mark_nodes(const Bsp& bsp, Used& io_used) {
  std::vector<std::int32_t> to_visit;
  for (const BspModel& model : bsp.models) to_visit.push_back(model.head_nodes[0]);
  io_used.leaves.add(0);
  while (!to_visit.empty()) {
    const std::int32_t child = to_visit.back();
    to_visit.pop_back();
    if (child < 0) io_used.leaves.add(~child);
    if (!io_used.nodes.add(child)) continue;
    const BspNode& node = bsp.nodes[static_cast<std::size_t>(child)];
    io_used.planes.add(node.plane);
    to_visit.insert(to_visit.end(), node.children.begin(), node.children.end());
  }
}

void mark_clipnodes(const Bsp& bsp, Used& io_used) {
  std::vector<std::int32_t> to_visit;
  for (const BspModel& model : bsp.models)
    to_visit.insert(to_visit.end(), model.head_nodes.begin() + 1, model.head_nodes.end());
  while (!to_visit.empty()) {
    const std::int32_t child = to_visit.back();
    to_visit.pop_back();
    if (!io_used.clipnodes.add(child)) continue;
    const BspClipnode& clipnode = bsp.clipnodes[static_cast<std::size_t>(child)];
    io_used.planes.add(clipnode.plane);
    to_visit.insert(to_visit.end(), clipnode.children.begin(), clipnode.children.end());
  }
}

// Requires that the nodes and leaves are marked.
void mark_faces(const Bsp& bsp, Used& io_used) {
  Ranges marksurfaces(bsp.marksurfaces.size()), faces(bsp.faces.size());
  for (std::size_t i = 0; i < bsp.leaves.size(); ++i)
    if (io_used.leaves[i]) marksurfaces.add(bsp.leaves[i].first_marksurface, bsp.leaves[i].marksurface_count);
  for (std::size_t i = 0; i < bsp.nodes.size(); ++i)
    if (io_used.nodes[i]) faces.add(bsp.nodes[i].first_face, bsp.nodes[i].face_count);
  for (std::size_t i = 1; i < bsp.models.size(); ++i)
    faces.add(bsp.models[i].first_face, bsp.models[i].face_count);
  faces.visit_all([&](std::size_t face) { io_used.faces.add(static_cast<std::int64_t>(face)); });
  marksurfaces.visit_all([&](std::size_t i) {
    io_used.marksurfaces.add(static_cast<std::int64_t>(i));
    io_used.faces.add(bsp.marksurfaces[i]);
  });
}

// Requires that the faces are marked.
void mark_outlines(const Bsp& bsp, Used& io_used) {
  Ranges surfedges(bsp.surfedges.size());
  for (std::size_t i = 0; i < bsp.faces.size(); ++i) {
    if (!io_used.faces[i]) continue;
    const BspFace& face = bsp.faces[i];
    io_used.planes.add(face.plane);
    io_used.texinfos.add(face.texinfo);
    surfedges.add(face.first_surfedge, face.surfedge_count);
  }
  surfedges.visit_all([&](std::size_t i) {
    io_used.surfedges.add(static_cast<std::int64_t>(i));
    io_used.edges.add(std::abs(std::int64_t{bsp.surfedges[i]}));
  });
  for (std::size_t i = 0; i < bsp.edges.size(); ++i)
    if (io_used.edges[i])
      for (const std::uint32_t vertex : bsp.edges[i].vertices) io_used.vertices.add(vertex);
}

template <typename Record>
void reset(std::vector<Record>& io_records, const Marks& used, const Record& replacement) {
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) io_records[i] = replacement;
}

template <typename Record>
void make_not_empty(std::vector<Record>& io_records, const Record& record) {
  if (io_records.empty()) io_records.push_back(record);
}

std::vector<bool> list_unused(const Marks& used) {
  std::vector<bool> unused(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) unused[i] = !used[i];
  return unused;
}

}  // namespace

// The replacements refer to the first plane, vertex, texinfo, texture, edge, and face.
void reset_unused(Bsp& io_bsp) {
  Used used(io_bsp);
  mark_nodes(io_bsp, used);
  mark_clipnodes(io_bsp, used);
  mark_faces(io_bsp, used);
  mark_outlines(io_bsp, used);

  BspLeaf leaf;
  leaf.contents = kSolidLeaf;
  BspNode node;
  node.children = {~0, ~0};  // the solid leaf
  BspClipnode clipnode;
  clipnode.children = {kEmptyClip, kEmptyClip};
  reset(io_bsp.planes, used.planes, kSomePlane);
  reset(io_bsp.vertices, used.vertices, math::Vec3(0.0f));
  reset(io_bsp.texinfos, used.texinfos, BspTexinfo{});
  reset(io_bsp.edges, used.edges, BspEdge{});
  reset(io_bsp.surfedges, used.surfedges, 0);
  reset(io_bsp.leaves, used.leaves, leaf);
  reset(io_bsp.nodes, used.nodes, node);
  reset(io_bsp.clipnodes, used.clipnodes, clipnode);
  reset(io_bsp.marksurfaces, used.marksurfaces, 0u);
  make_not_empty(io_bsp.planes, kSomePlane);
  make_not_empty(io_bsp.vertices, math::Vec3(0.0f));
  clear_faces(io_bsp, list_unused(used.faces));
  if (!io_bsp.texinfos.empty()) make_not_empty(io_bsp.miptexes, BspMiptex{});
  if (!io_bsp.surfedges.empty()) make_not_empty(io_bsp.edges, BspEdge{});
}

}  // namespace temblor::formats::bsp_file
