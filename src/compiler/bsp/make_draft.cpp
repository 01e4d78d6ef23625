#include "compiler/bsp/make_draft.h"

#include <algorithm>
#include <array>
#include <mutex>

#include "base/text.h"
#include "compiler/bsp/brushes/expand_brush.h"
#include "compiler/bsp/brushes/level_brushes.h"
#include "compiler/bsp/brushes/list_brushes.h"
#include "compiler/bsp/cluster_portals.h"
#include "compiler/bsp/faces/faces.h"
#include "compiler/bsp/fence_sight.h"
#include "compiler/bsp/leaf_portals.h"
#include "compiler/bsp/level_writer.h"
#include "compiler/bsp/outside/fill_outside.h"
#include "compiler/bsp/second_tree.h"
#include "compiler/bsp/tree.h"
#include "compiler/stock_limits.h"

namespace temblor::compiler {
namespace {

// A tree and what was made from it. For clip hulls, only the tree and the leak.
struct Partition {
  Tree tree;
  LeafPortals portals;
  std::vector<TreeFace> faces;
  std::optional<Leak> leak;
};

// Reports progress over all trees of all models; each counts by its number of brushes.
class DraftMeter {
 public:
  DraftMeter(Progress progress, std::size_t brushes)
      : progress_(progress), brushes_(static_cast<double>(std::max<std::size_t>(1, brushes))) {}

  void add(double brushes) {
    constexpr std::size_t kSteps = 1000;
    const std::lock_guard lock(mutex_);
    done_ += brushes;
    const auto step = std::min(kSteps, static_cast<std::size_t>(done_ / brushes_ * kSteps));
    if (step > step_) progress_(step_ = step, kSteps);
  }

 private:
  std::mutex mutex_;
  Progress progress_;
  double brushes_, done_ = 0;
  std::size_t step_ = 0;
};

// Builds the first tree of a model, which takes most of the time.
Tree build_first_tree(std::span<const Brush> brushes, const PlaneSet& planes, Cover cover,
                      DraftMeter& io_meter) {
  const auto weight = static_cast<double>(brushes.size());
  return build_tree(brushes, planes, cover, [&](double share) { io_meter.add(share * weight); });
}

// Leaves that the level need not tell apart. Fences stay apart: faces inside them are visible.
bool are_equivalent(const TreeLeaf& a, const TreeLeaf& b) {
  return a.fill == b.fill && a.structure == b.structure && is_blocked(a.fill) && a.fill != Fill::kFence;
}

// Fills what nobody reaches in the world's drawn hull. Returns its leak.
std::optional<Leak> fill_world(Tree& io_tree, const LeafPortals& portals, const LevelBrushes& level) {
  if (auto leak = fill_outside(io_tree, level.planes, portals, level.occupants_world)) return leak;
  std::vector<Box> entity_brushes;
  for (std::size_t model = 1; model < level.models.size(); ++model)
    for (const Brush& brush : level.models[model]) entity_brushes.push_back(brush.box);
  fill_pockets(io_tree, level.planes, portals, level.occupants_world, entity_brushes);
  return std::nullopt;
}

// Makes the drawn hull of a model: its tree, portals and faces.
Partition partition_drawn(std::span<const Brush> brushes, const LevelBrushes& level, bool is_world,
                          const DraftOptions& options, DraftMeter& io_meter) {
  std::vector<Brush> drawn;
  std::copy_if(brushes.begin(), brushes.end(), std::back_inserter(drawn),
               [](const Brush& brush) { return (brush.hulls & kDrawnHull) != 0; });
  Tree first = build_first_tree(drawn, level.planes, Cover::kLast, io_meter);
  const LeafPortals first_portals = make_leaf_portals(first, level.planes);
  Partition made;
  if (is_world && options.fill_outside) made.leak = fill_world(first, first_portals, level);
  const std::vector<TreeFace> faces = make_faces(first, first_portals.portals, drawn);
  SecondTree second = make_second_tree(first, first_portals.portals, drawn, level.planes);
  made.tree = std::move(second.tree);
  made.portals = std::move(second.portals);
  prune(made.tree, [](const TreeLeaf& a, const TreeLeaf& b) { return are_equivalent(a, b); });
  made.faces = place_faces(faces, made.tree, level.planes);
  merge_faces(made.faces, level.planes);
  mark_around_fences(made.faces, made.tree, made.portals.portals);
  subdivide_faces(made.faces, level.surfaces, options.subdivide_texels);
  return made;
}

// Makes a clip hull of a model, of which only the tree is needed.
Partition partition_hull(std::vector<Brush> expanded, const LevelBrushes& level, bool is_world,
                         const DraftOptions& options, DraftMeter& io_meter) {
  for (Brush& brush : expanded) add_windings(brush, level.planes);
  Tree first = build_first_tree(expanded, level.planes, Cover::kAnySolid, io_meter);
  const LeafPortals first_portals = make_leaf_portals(first, level.planes);
  Partition made;
  if (is_world && options.fill_outside && options.clip_hulls)
    made.leak = fill_outside(first, level.planes, first_portals, level.occupants_world);
  made.tree = make_second_tree(first, first_portals.portals, expanded, level.planes).tree;
  prune(made.tree, [](const TreeLeaf& a, const TreeLeaf& b) { return a.fill == b.fill; });
  return made;
}

// The box around all brushes except hints, which are not there in the game.
Box compute_box(std::span<const Brush> brushes) {
  Box box;
  for (const Brush& brush : brushes) {
    if (brush.fill == Fill::kEmpty) continue;
    box.add(brush.box.mins);
    box.add(brush.box.maxs);
  }
  return box;
}

std::span<const HullBox> choose_hull_boxes(const DraftOptions& options) {
  if (options.half_life) return kHalfLifeBoxes;
  return kQuakeBoxes;
}

// By model: its brushes for each clip hull.
using ModelHulls = std::vector<std::vector<std::vector<Brush>>>;

// Expands all brushes before any tree is built, one after another, so that planes get the same numbers in
// every run and jobs only read them.
ModelHulls expand_brushes(LevelBrushes& io_level, std::span<const HullBox> boxes) {
  ModelHulls expanded(io_level.models.size(), std::vector<std::vector<Brush>>(boxes.size()));
  for (std::size_t model = 0; model < expanded.size(); ++model)
    for (std::size_t hull = 0; hull < boxes.size(); ++hull)
      for (const Brush& brush : io_level.models[model])
        if ((brush.hulls & hull_bit(boxes[hull].key_hull)) != 0)
          expanded[model][hull].push_back(expand(brush, boxes[hull], io_level.planes));
  return expanded;
}

// Makes one partition for each model and hull, the drawn hull first.
std::vector<Partition> partition_models(LevelBrushes& io_level, const DraftOptions& options, base::Jobs& jobs,
                                        Progress progress) {
  const std::span<const HullBox> boxes = choose_hull_boxes(options);
  const std::size_t trees = 1 + boxes.size();
  ModelHulls expanded(io_level.models.size(), std::vector<std::vector<Brush>>(boxes.size()));
  if (options.clip_hulls) expanded = expand_brushes(io_level, boxes);
  std::size_t brushes = 0;
  for (const std::vector<Brush>& model : io_level.models) brushes += model.size();
  for (const auto& model : expanded)
    for (const std::vector<Brush>& hull : model) brushes += hull.size();
  DraftMeter meter(progress, brushes);
  std::vector<Partition> parts(expanded.size() * trees);
  jobs.parallel_for(parts.size(), [&](std::size_t job) {
    const std::size_t model = job / trees, hull = job % trees;
    parts[job] = hull == 0 ? partition_drawn(io_level.models[model], io_level, model == 0, options, meter)
                           : partition_hull(std::move(expanded[model][hull - 1]), io_level, model == 0,
                                            options, meter);
  });
  return parts;
}

}  // namespace

// Trees are built in parallel; everything that gets a number in the level is written afterwards, one model
// after another.
base::Result<DraftResult> make_draft(const formats::Map& map, TextureSize texture_size,
                                     const DraftOptions& options, base::Jobs& jobs, Warnings& io_warnings,
                                     Progress progress) {
  TRY(LevelBrushes level, sort_brushes(map, texture_size, io_warnings));
  const std::vector<Partition> parts = partition_models(level, options, jobs, progress);
  const std::size_t models = level.models.size(), trees = parts.size() / models;
  DraftResult result;
  result.is_region = level.is_region;
  LevelWriter writer(level.planes);
  std::vector<std::uint32_t> leaves_of_world;
  std::vector<std::vector<PartCount>> after_model;

  for (std::size_t model = 0; model < models; ++model) {
    const Partition& drawn = parts[model * trees];
    const std::vector<std::uint32_t> leaves =
        writer.add_model(drawn.tree, drawn.portals.portals, drawn.faces, compute_box(level.models[model]));
    if (model == 0) leaves_of_world = leaves;

    for (std::size_t hull = 1; hull < trees; ++hull) writer.set_hull(hull, parts[model * trees + hull].tree);
    after_model.push_back(count_records(writer.level()));
  }
  const std::vector<std::uint32_t> surface_of_face = writer.surface_of_face();
  Draft& draft = result.draft;
  draft.bsp = std::move(writer).take();
  if (options.brush_list)
    draft.bsp.bspx.push_back({formats::kBrushListLump, formats::write_brush_list(list_brushes(level))});
  draft.portals = make_cluster_portals(parts.front().tree, level.planes, leaves_of_world,
                                       draft.bsp.leaves.size(), options.water_is_transparent);

  for (const Surface& surface : level.surfaces) draft.bsp.texinfos.push_back(surface.texinfo);
  for (std::size_t face = 0; face < draft.bsp.faces.size(); ++face) {
    draft.bsp.faces[face].texinfo = surface_of_face[face];
    draft.keys_of_face.push_back(level.surfaces[surface_of_face[face]].keys);
  }
  for (const std::string& texture : level.textures) draft.bsp.miptexes.emplace_back().name = texture;
  draft.bsp.entities = formats::write_entities(level.entities);
  draft.brush_entities = std::move(level.brush_entities);
  draft.surface_keys = std::move(level.surface_keys);
  if (!options.half_life)
    warn_about_records({map, draft.brush_entities}, draft.bsp, after_model, io_warnings);
  if (const auto& leak = parts.front().leak) {
    const std::size_t entity = level.entity_of_occupant[leak->entity];
    result.leak = LeakPath{entity, map.entities[entity].line,
                           base::quotable(map.entities[entity].fields.classname()), leak->path_world};
  }
  for (std::size_t hull = 1; hull < trees; ++hull)
    result.clip_hulls_leak |= !result.leak && parts[hull].leak.has_value();
  if (options.fill_outside && level.occupants_world.empty())
    io_warnings.push_back({"no entity has an origin",
                           "the compiler cannot tell inside from outside, so it draws both; that suits an "
                           "item box, but a level needs an info_player_start"});
  if (draft.bsp.faces.empty())
    io_warnings.push_back({"no visible faces",
                           "every side is buried in another brush, faces the void, or has a texture that is "
                           "never drawn (skip, clip, hint)"});
  return result;
}

}  // namespace temblor::compiler
