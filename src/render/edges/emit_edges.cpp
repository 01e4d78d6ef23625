// Two passes over the faces, each in parallel, with what they must agree on between them: outlines on the
// screen, then the surfaces' numbers, then edges. Each job has a run of the faces; as runs are put together
// in order, it does not matter where they were cut.
#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "base/check.h"
#include "render/edges/brush_pieces.h"
#include "render/edges/edge_emitter.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

namespace {

// More than one, as faces are not equally much work; not many, as each counts edges row by row.
constexpr std::size_t kJobsAThread = 4;

// Whether the model may be on the screen: a sphere round it against the frustum.
bool in_frustum(const ViewFrame& view, const ModelView& model_view, const math::Bounds& bounds) {
  const math::Vec3d mins(bounds.mins), maxs(bounds.maxs);
  const math::Vec3d center = model_view.to_world((mins + maxs) * 0.5);
  const double radius = glm::length(maxs - mins) / 2;
  return std::all_of(view.frustum.begin(), view.frustum.end(), [&](const FrustumPlane& plane) {
    return glm::dot(plane.normal, center) + plane.offset >= -radius * glm::length(plane.normal);
  });
}

// A brush model that may be on the screen, and where its faces stand in the sequence of all faces: those of
// the world are first.
struct ShownModel {
  std::uint32_t instance;
  std::size_t first_face;  // of the level
  std::size_t begin, end;  // of the sequence
};

struct FaceSequence {
  std::span<const ModelView> model_views;
  std::span<const ShownModel> models;
  std::size_t face_count;
};

FaceSequence order_faces(const Scene& scene, const ViewFrame& view, std::size_t world_faces,
                         base::Arena& arena) {
  const world::Level& level = *scene.level;
  std::span<ModelView> model_views = arena.allocate<ModelView>(scene.brush_models.size() + 1);
  base::ArenaVector<ShownModel> shown(arena, scene.brush_models.size());
  model_views[0] = ModelView{};
  std::size_t end = world_faces;
  for (std::uint32_t instance = 1; instance < model_views.size(); ++instance) {
    const BrushModelInstance& placed = scene.brush_models[instance - 1];
    CHECK(base::to_size(placed.model) < level.models.size(), "instance {}", instance);
    const world::Model& model = level.models[base::to_size(placed.model)];
    model_views[instance] = make_model_view(placed);
    if (!in_frustum(view, model_views[instance], model.bounds)) continue;
    shown.push_back({instance, model.first_face, end, end + model.face_count});
    end += model.face_count;
  }
  return {model_views, shown.view(), end};
}

// Surfaces of all jobs, one job's after another's.
struct NumberedSurfaces {
  std::span<ScreenSurface> surfaces;
  std::span<Piece> pieces;
  std::span<SurfaceIndex> first_of_job;
  std::span<SurfaceIndex> of_face;  // of the world; kBackground: not on the screen
  std::uint32_t item_count = 1;     // item 0 is the background
};

// The last job's faces are late, and nobody's neighbors.
NumberedSurfaces number_surfaces(std::span<const EdgeEmitter> emitters, std::size_t level_faces,
                                 base::Arena& arena) {
  std::size_t surface_count = 1, piece_count = 0;
  for (const EdgeEmitter& emitter : emitters) {
    surface_count += emitter.surfaces().size();
    piece_count += emitter.pieces().size();
  }
  NumberedSurfaces numbered{arena.allocate<ScreenSurface>(surface_count), arena.allocate<Piece>(piece_count),
                            arena.allocate<SurfaceIndex>(emitters.size()),
                            arena.allocate_filled<SurfaceIndex>(level_faces, kBackground)};
  numbered.surfaces[0] = {std::numeric_limits<SortKey>::max(), 0, world::FaceIndex{0}, 0, {}, 0, 0};
  std::size_t number = 1;
  std::uint32_t pieces_before = 0;
  for (std::size_t job = 0; job < emitters.size(); ++job) {
    const bool late = job + 1 == emitters.size();
    numbered.first_of_job[job] = base::to_index<SurfaceIndex>(number);
    for (ScreenSurface surface : emitters[job].surfaces()) {
      surface.first_item += numbered.item_count;
      if (surface.instance != 0)
        surface.piece += pieces_before;
      else if (!late)
        numbered.of_face[base::to_size(surface.face)] = base::to_index<SurfaceIndex>(number);
      numbered.surfaces[number++] = surface;
    }
    std::copy(emitters[job].pieces().begin(), emitters[job].pieces().end(),
              numbered.pieces.begin() + pieces_before);
    pieces_before += static_cast<std::uint32_t>(emitters[job].pieces().size());
    numbered.item_count += emitters[job].item_count();
  }
  return numbered;
}

// Where the edges of each job go: in `order`, after those of the rows above and those of the same row from
// the jobs before it.
struct EdgePlaces {
  std::span<std::uint32_t> row_begin;
  std::span<std::size_t> first_of_job;
  std::size_t edge_count;
};

// Counting sort by first row. Each emitter's counts become the places of its edges.
EdgePlaces place_edges(std::span<EdgeEmitter> io_emitters, std::size_t rows, base::Arena& arena) {
  EdgePlaces places{arena.allocate<std::uint32_t>(rows + 1), arena.allocate<std::size_t>(io_emitters.size()),
                    0};
  for (std::size_t job = 0; job < io_emitters.size(); ++job) {
    places.first_of_job[job] = places.edge_count;
    places.edge_count += io_emitters[job].edges().size();
  }
  std::uint32_t before = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    places.row_begin[row] = before;
    for (EdgeEmitter& emitter : io_emitters) before += std::exchange(emitter.edges_by_row()[row], before);
  }
  places.row_begin[rows] = before;
  return places;
}

// One job's edges to their places.
void gather_edges(EdgeEmitter& io_emitter, std::size_t first, std::span<Edge> out_edges,
                  std::span<std::uint32_t> out_order) {
  const std::span<std::uint32_t> place_in_row = io_emitter.edges_by_row();
  std::size_t number = first;
  for (const Edge& edge : io_emitter.edges()) {
    out_order[place_in_row[static_cast<std::size_t>(edge.first_row)]++] = static_cast<std::uint32_t>(number);
    out_edges[number++] = edge;
  }
}

// Where each late surface's edges begin: they were made surface by surface.
std::span<const std::uint32_t> find_deferred_edges(const EdgeEmitter& late, SurfaceIndex first,
                                                   base::Arena& arena) {
  const std::span<std::uint32_t> begin = arena.allocate<std::uint32_t>(late.surfaces().size() + 1);
  std::size_t surface = 0;
  for (std::uint32_t i = 0; i < late.edges().size(); ++i) {
    const Edge& edge = late.edges()[i];
    const SurfaceIndex whose = edge.leading != kBackground ? edge.leading : edge.trailing;
    for (; base::to_size(first) + surface <= base::to_size(whose); ++surface) begin[surface] = i;
  }
  for (; surface < begin.size(); ++surface) begin[surface] = static_cast<std::uint32_t>(late.edges().size());
  return begin;
}

std::size_t choose_job_count(std::size_t faces, std::size_t faces_a_job, int threads) {
  if (threads == 1) return 1;
  return std::clamp<std::size_t>(faces / faces_a_job, 1, static_cast<std::size_t>(threads) * kJobsAThread);
}

}  // namespace

EdgeTable emit_edges(const Scene& scene, const ViewFrame& view, const VisibleFaces& visible,
                     const FaceOutlines& outlines, base::Jobs& jobs, base::Arena& arena,
                     std::vector<EdgeJobArenas>& io_job_arenas, std::size_t faces_a_job) {
  const std::size_t world_faces = visible.faces.size();
  const FaceSequence sequence = order_faces(scene, view, world_faces, arena);
  const std::size_t job_count = choose_job_count(sequence.face_count, faces_a_job, jobs.threads());
  if (io_job_arenas.size() <= job_count) io_job_arenas.resize(job_count + 1);
  // One more, for late faces.
  std::span<EdgeEmitter> emitters = arena.allocate<EdgeEmitter>(job_count + 1);
  const auto add_brush_faces = [&](std::size_t begin, std::size_t end, bool late, base::Arena& pieces,
                                   EdgeEmitter& emitter) {
    for (const ShownModel& model : sequence.models)
      for (std::size_t i = std::max(begin, model.begin); i < std::min(end, model.end); ++i) {
        const auto face = base::to_index<world::FaceIndex>(model.first_face + (i - model.begin));
        const FaceOpacity opacity =
            opacity_on(visible.opacities, *scene.level, scene.level->face(face).texture,
                       scene.brush_models[model.instance - 1]);
        if (opacity.opacity <= 0 || opacity.is_late() != late) continue;
        add_brush_face(scene, view, visible, outlines, sequence.model_views[model.instance], model.instance,
                       face, pieces, emitter);
      }
  };

  jobs.parallel_for(job_count + 1, [&](std::size_t job) {
    EdgeJobArenas& arenas = io_job_arenas[job];
    arenas.faces.reset();
    EdgeEmitter& emitter = *std::construct_at(&emitters[job], view, arenas.faces);
    if (job == job_count) {
      for (const VisibleFace& face : visible.deferred_faces) emitter.add_world_face(face, outlines);
      add_brush_faces(0, sequence.face_count, true, arenas.pieces, emitter);
      return;
    }
    const std::size_t begin = sequence.face_count * job / job_count;
    const std::size_t end = sequence.face_count * (job + 1) / job_count;
    for (std::size_t i = begin; i < std::min(end, world_faces); ++i)
      emitter.add_world_face(visible.faces[i], outlines);
    add_brush_faces(begin, end, false, arenas.pieces, emitter);
  });
  const NumberedSurfaces numbered = number_surfaces(emitters, scene.level->faces.size(), arena);
  jobs.parallel_for(job_count + 1, [&](std::size_t job) {
    emitters[job].make_edges(numbered.first_of_job[job], numbered.of_face);
  });

  const EdgePlaces places =
      place_edges(emitters.first(job_count), static_cast<std::size_t>(view.height), arena);
  std::span<Edge> edges = arena.allocate<Edge>(places.edge_count);
  std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(places.edge_count);
  jobs.parallel_for(job_count, [&](std::size_t job) {
    gather_edges(emitters[job], places.first_of_job[job], edges, order);
  });
  const std::span<const Edge> made_late = emitters[job_count].edges();
  const std::span<Edge> deferred_edges = arena.allocate<Edge>(made_late.size());
  std::copy(made_late.begin(), made_late.end(), deferred_edges.begin());
  return {edges,
          order,
          places.row_begin,
          numbered.surfaces,
          numbered.pieces,
          sequence.model_views,
          numbered.item_count,
          deferred_edges,
          find_deferred_edges(emitters[job_count], numbered.first_of_job[job_count], arena)};
}

}  // namespace temblor::render
