#include "render_gl/world/face_queue.h"

#include "render_gl/world/level_mesh.h"

namespace temblor::render_gl {

namespace {

bool is_same_face(const render::ScreenSurface& a, const render::ScreenSurface& b) {
  return a.face == b.face && a.instance == b.instance;
}

// For an opaque face; those with holes and opacity need kBlocks for kOneBlock.
FaceProgramKind choose_program(const FrameInput& input, const render::ScreenSurface& surface) {
  const world::Face& face = input.context.level().face(surface.face);
  if (render::has_surface(face))
    return surface.tiles.s == 1 && surface.tiles.t == 1 ? FaceProgramKind::kOneBlock
                                                        : FaceProgramKind::kBlocks;
  if (face.kind == world::FaceKind::kSky)
    return input.sources.skybox ? FaceProgramKind::kSkybox : FaceProgramKind::kSky;
  return face.kind == world::FaceKind::kLiquid ? FaceProgramKind::kLiquid : FaceProgramKind::kTexture;
}

FaceProgramKind choose_program(const FrameInput& input, const render::DeferredFace& face) {
  const FaceProgramKind program =
      choose_program(input, input.record.edges.surfaces[base::to_size(face.surface)]);
  return program == FaceProgramKind::kOneBlock ? FaceProgramKind::kBlocks : program;
}

bool is_seen(const FrameInput& input, const QueuedFace& face) {
  for (std::uint32_t tile = 0; tile < face.tiles; ++tile)
    if (find_seen_draw(input, face, tile)) return true;
  return false;
}

}  // namespace

std::optional<std::uint32_t> find_seen_draw(const FrameInput& input, const QueuedFace& face,
                                            std::uint32_t tile) {
  for (std::uint32_t i = face.fragments; i-- > 0;) {
    const std::uint32_t draw = input.record.edges.surfaces[face.surface + i].first_draw + tile;
    const render::SurfaceKind kind = input.record.surfaces.draws.all[draw].kind;
    if (kind != render::SurfaceKind::kHidden && kind != render::SurfaceKind::kNothing) return draw;
  }
  return std::nullopt;
}

void FaceQueue::collect(const FrameInput& input, const HasRoom& has_room) {
  has_room_ = has_room;
  const render::EdgeTable& edges = input.record.edges;
  faces_.clear();
  indices_.clear();
  for (std::size_t kind = 0; kind < kFaceProgramKinds; ++kind)
    for (std::size_t i = 1; i < edges.first_deferred(); ++i)
      if (const auto program = choose_program(input, edges.surfaces[i]);
          program == static_cast<FaceProgramKind>(kind))
        add(input, i, program, nullptr);
  for (const render::DeferredFace& face : input.order.faces.opaque)
    add(input, base::to_size(face.surface), choose_program(input, face), &face.opacity);
  first_translucent_ = faces_.size();
  for (const render::DeferredFace& face : input.order.faces.translucent)
    add(input, base::to_size(face.surface), choose_program(input, face), &face.opacity);
}

// Fragments of one face are adjacent, and draw it once.
void FaceQueue::add(const FrameInput& input, std::size_t number, FaceProgramKind program,
                    const render::FaceOpacity* opacity) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  const render::ScreenSurface& surface = surfaces[number];
  QueuedFace face{.program = program,
                  .instance = surface.instance,
                  .face = surface.face,
                  .surface = static_cast<std::uint32_t>(number),
                  .fragments = 0,
                  .tiles = std::uint32_t{surface.tiles.s} * surface.tiles.t,
                  .first_index = static_cast<std::uint32_t>(indices_.size()),
                  .index_count = 0,
                  .opacity = opacity};
  if (number <= 1 || !is_same_face(surfaces[number - 1], surface))
    for (std::size_t i = number; i < surfaces.size() && is_same_face(surfaces[i], surface); ++i)
      ++face.fragments;
  // Translucent faces keep the numbers that layers have for them.
  const bool is_translucent = opacity != nullptr && opacity->is_translucent();
  if (has_room_(surface) && is_seen(input, face)) {
    LevelMesh::add_triangles(input.level_data.outlines.faces[base::to_size(surface.face)], indices_);
    face.index_count = static_cast<std::uint32_t>(indices_.size()) - face.first_index;
  }
  if (face.index_count > 0 || is_translucent) faces_.push_back(face);
}

}  // namespace temblor::render_gl
