// Two parallel passes over the faces: first outlines on the screen, then, when all surfaces have their
// numbers, edges. Each job has a range of the sequence of faces (the world's, then those of visible brush
// models). Ranges are concatenated in order, so it does not matter where they were cut.
#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "base/check.h"
#include "render/edges/brush_fragments.h"
#include "render/edges/edge_emitter.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

namespace {

// More than one, because faces take unequal time; few, because each job counts its edges row by row.
constexpr std::size_t kJobsPerThread = 4;

// Tests a sphere around the model's box against the frustum; conservative.
bool in_frustum(const ViewFrame& view, const ModelView& model_view, const math::Bounds& bounds) {
  const math::Vec3d mins(bounds.mins), maxs(bounds.maxs);
  const math::Vec3d center = model_view.to_world((mins + maxs) * 0.5);
  const double radius = glm::length(maxs - mins) / 2;
  return std::all_of(view.frustum.begin(), view.frustum.end(), [&](const FrustumPlane& plane) {
    return glm::dot(plane.normal, center) + plane.offset >= -radius * glm::length(plane.normal);
  });
}

// A brush model that may be on the screen, and the range of its faces in the sequence of all faces, in which
// the world's faces come first.
struct VisibleModel {
  std::uint32_t instance;
  std::size_t first_face;  // in the level
  std::size_t begin, end;  // in the sequence
};

struct FaceSequence {
  std::span<const ModelView> model_views;
  std::span<const VisibleModel> models;
  std::size_t face_count;
};

FaceSequence order_faces(const Scene& scene, const ViewFrame& view, std::size_t world_faces,
                         base::Arena& arena) {
  const world::Level& level = *scene.level;
  std::span<ModelView> model_views = arena.allocate<ModelView>(scene.brush_models.size() + 1);
  base::ArenaVector<VisibleModel> shown(arena, scene.brush_models.size());
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

// The surfaces of all jobs, concatenated.
struct NumberedSurfaces {
  std::span<ScreenSurface> surfaces;
  std::span<BrushFragment> fragments;
  std::span<SurfaceIndex> first_of_job;
  std::span<SurfaceIndex> by_face;  // the world's faces; kBackground: not on the screen
  std::uint32_t draw_count = 1;     // draw 0 is the background
};

// The last job holds the deferred faces. They get no entry in by_face, so no edge is shared with them.
NumberedSurfaces number_surfaces(std::span<const EdgeEmitter> emitters, std::size_t level_faces,
                                 base::Arena& arena) {
  std::size_t surface_count = 1, fragment_count = 0;
  for (const EdgeEmitter& emitter : emitters) {
    surface_count += emitter.surfaces().size();
    fragment_count += emitter.fragments().size();
  }
  NumberedSurfaces numbered{arena.allocate<ScreenSurface>(surface_count),
                            arena.allocate<BrushFragment>(fragment_count),
                            arena.allocate<SurfaceIndex>(emitters.size()),
                            arena.allocate_filled<SurfaceIndex>(level_faces, kBackground)};
  numbered.surfaces[0] = {std::numeric_limits<SortKey>::max(), 0, world::FaceIndex{0}, 0, {}, 0, 0};
  std::size_t number = 1;
  std::uint32_t fragments_before = 0;
  for (std::size_t job = 0; job < emitters.size(); ++job) {
    const bool deferred = job + 1 == emitters.size();
    numbered.first_of_job[job] = base::to_index<SurfaceIndex>(number);
    for (ScreenSurface surface : emitters[job].surfaces()) {
      surface.first_draw += numbered.draw_count;
      if (surface.instance != 0)
        surface.fragment += fragments_before;
      else if (!deferred)
        numbered.by_face[base::to_size(surface.face)] = base::to_index<SurfaceIndex>(number);
      numbered.surfaces[number++] = surface;
    }
    std::copy(emitters[job].fragments().begin(), emitters[job].fragments().end(),
              numbered.fragments.begin() + fragments_before);
    fragments_before += static_cast<std::uint32_t>(emitters[job].fragments().size());
    numbered.draw_count += emitters[job].draw_count();
  }
  return numbered;
}

// Where each job's edges go in `order`: after the edges of the rows above, and after those of the same row
// from earlier jobs.
struct EdgePlaces {
  std::span<std::uint32_t> row_begin;
  std::span<std::size_t> first_of_job;
  std::size_t edge_count;
};

// A counting sort by first row, across jobs. Turns each emitter's counts into positions.
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

// Copies one job's edges to their places.
void gather_edges(EdgeEmitter& io_emitter, std::size_t first, std::span<Edge> out_edges,
                  std::span<std::uint32_t> out_order) {
  const std::span<std::uint32_t> place_in_row = io_emitter.edges_by_row();
  std::size_t number = first;
  for (const Edge& edge : io_emitter.edges()) {
    out_order[place_in_row[static_cast<std::size_t>(edge.first_row)]++] = static_cast<std::uint32_t>(number);
    out_edges[number++] = edge;
  }
}

// The first edge of each deferred surface, and one more at the end: edges were made surface by surface.
std::span<const std::uint32_t> find_deferred_edges(const EdgeEmitter& deferred, SurfaceIndex first,
                                                   base::Arena& arena) {
  const std::span<std::uint32_t> begin = arena.allocate<std::uint32_t>(deferred.surfaces().size() + 1);
  std::size_t surface = 0;
  for (std::uint32_t i = 0; i < deferred.edges().size(); ++i) {
    const Edge& edge = deferred.edges()[i];
    const SurfaceIndex owner = edge.leading != kBackground ? edge.leading : edge.trailing;
    for (; base::to_size(first) + surface <= base::to_size(owner); ++surface) begin[surface] = i;
  }
  for (; surface < begin.size(); ++surface)
    begin[surface] = static_cast<std::uint32_t>(deferred.edges().size());
  return begin;
}

std::size_t choose_job_count(std::size_t faces, std::size_t faces_per_job, int threads) {
  if (threads == 1) return 1;
  return std::clamp<std::size_t>(faces / faces_per_job, 1,
                                 static_cast<std::size_t>(threads) * kJobsPerThread);
}

}  // namespace

EdgeTable emit_edges(const FrameContext& context, const ViewFrame& view, const VisibleFaces& visible,
                     const FaceOutlines& outlines, std::size_t faces_per_job) {
  const Scene& scene = context.scene;
  FrameArenas& arenas = context.arenas;
  base::Arena& arena = context.arena();
  base::Jobs& jobs = context.jobs;
  const std::size_t world_faces = visible.faces.size();
  const FaceSequence sequence = order_faces(scene, view, world_faces, arena);
  const std::size_t job_count = choose_job_count(sequence.face_count, faces_per_job, jobs.threads());
  FrameArenas::grow(arenas.edges, job_count + 1);
  FrameArenas::grow(arenas.scratch, job_count + 1);
  // One more than jobs: the last emitter collects the deferred faces.
  std::span<EdgeEmitter> emitters = arena.allocate<EdgeEmitter>(job_count + 1);
  const auto add_brush_faces = [&](std::size_t begin, std::size_t end, bool deferred, base::Arena& scratch,
                                   EdgeEmitter& emitter) {
    for (const VisibleModel& model : sequence.models)
      for (std::size_t i = std::max(begin, model.begin); i < std::min(end, model.end); ++i) {
        const auto face = base::to_index<world::FaceIndex>(model.first_face + (i - model.begin));
        const FaceOpacity opacity =
            brush_face_opacity(visible.opacities, *scene.level, scene.level->face(face).texture,
                               scene.brush_models[model.instance - 1]);
        if (opacity.opacity <= 0 || opacity.is_deferred() != deferred) continue;
        const BrushFace brush_face{model.instance, face, sequence.model_views[model.instance]};
        add_brush_face(*scene.level, view, visible, outlines, brush_face, scratch, emitter);
      }
  };

  jobs.parallel_for(job_count + 1, [&](std::size_t job) {
    arenas.edges[job].reset();
    EdgeEmitter& emitter = *std::construct_at(&emitters[job], view, arenas.edges[job]);
    if (job == job_count) {
      for (const VisibleFace& face : visible.deferred_faces) emitter.add_world_face(face, outlines);
      add_brush_faces(0, sequence.face_count, true, arenas.scratch[job], emitter);
      return;
    }
    const std::size_t begin = sequence.face_count * job / job_count;
    const std::size_t end = sequence.face_count * (job + 1) / job_count;
    for (std::size_t i = begin; i < std::min(end, world_faces); ++i)
      emitter.add_world_face(visible.faces[i], outlines);
    add_brush_faces(begin, end, false, arenas.scratch[job], emitter);
  });
  const NumberedSurfaces numbered = number_surfaces(emitters, scene.level->faces.size(), arena);
  jobs.parallel_for(job_count + 1, [&](std::size_t job) {
    emitters[job].make_edges(numbered.first_of_job[job], numbered.by_face);
  });

  const EdgePlaces places =
      place_edges(emitters.first(job_count), static_cast<std::size_t>(view.height), arena);
  std::span<Edge> edges = arena.allocate<Edge>(places.edge_count);
  std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(places.edge_count);
  jobs.parallel_for(job_count, [&](std::size_t job) {
    gather_edges(emitters[job], places.first_of_job[job], edges, order);
  });
  const std::span<const Edge> deferred_made = emitters[job_count].edges();
  const std::span<Edge> deferred_edges = arena.allocate<Edge>(deferred_made.size());
  std::copy(deferred_made.begin(), deferred_made.end(), deferred_edges.begin());
  return {edges,
          order,
          places.row_begin,
          numbered.surfaces,
          numbered.fragments,
          sequence.model_views,
          numbered.draw_count,
          deferred_edges,
          find_deferred_edges(emitters[job_count], numbered.first_of_job[job_count], arena)};
}

}  // namespace temblor::render
