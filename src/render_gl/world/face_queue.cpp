#include "render_gl/world/face_queue.h"

#include <algorithm>
#include <utility>

#include "render_gl/world/level_mesh.h"

namespace temblor::render_gl {

namespace {

bool is_same_face(const render::ScreenSurface& a, const render::ScreenSurface& b) {
  return a.face == b.face && a.instance == b.instance;
}

// The draw of a lit tile of the surface's face, of this fragment or of those that follow.
std::optional<std::uint32_t> find_lit_draw(const FrameInput& input, const LitTiles& lit, std::size_t number) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  for (std::size_t i = number; i < surfaces.size() && is_same_face(surfaces[i], surfaces[number]); ++i) {
    const std::uint32_t first = surfaces[i].first_draw;
    for (std::uint32_t tile = 0; tile < std::uint32_t{surfaces[i].tiles.s} * surfaces[i].tiles.t; ++tile)
      if (lit.contains(first + tile)) return first + tile;
  }
  return std::nullopt;
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

// For an opaque face.
FaceQueue::Choice FaceQueue::choose(const FrameInput& input, const LitTiles* lit, std::size_t number) const {
  using enum FaceProgramKind;
  const render::ScreenSurface& surface = input.record.edges.surfaces[number];
  const world::Face& face = input.context.level().face(surface.face);
  const std::uint32_t tiles = std::uint32_t{surface.tiles.s} * surface.tiles.t;
  if (render::has_surface(face)) {
    if (const auto draw = lit == nullptr ? std::nullopt : find_lit_draw(input, *lit, number))
      return {tiles == 1 ? kOneLit : kLit, lit->array(*draw), lit->has_bright(*draw), number};
    const bool is_blended = input.options.filter != render::TextureFilter::kNearest;
    return {tiles == 1 && !is_blended ? kOneBlock : kBlocks, 0, false, number};
  }
  if (face.kind == world::FaceKind::kSky) return {input.sources.skybox ? kSkybox : kSky, 0, false, number};
  return {face.kind == world::FaceKind::kLiquid ? kLiquid : kTexture, 0, false, number};
}

// Holes and opacity need the programs of several tiles. One color for all texels needs none of them.
FaceQueue::Choice FaceQueue::choose(const FrameInput& input, const LitTiles* lit,
                                    const render::DeferredFace& face) const {
  using enum FaceProgramKind;
  Choice choice = choose(input, lit, base::to_size(face.surface));
  choice.program = without_one_tile(choice.program);
  if (choice.program == kLit && face.opacity.color) choice = {kBlocks, 0, false, choice.surface};
  return choice;
}

void FaceQueue::collect(const FrameInput& input, const LitTiles* lit, const HasRoom& has_room) {
  has_room_ = has_room;
  const render::EdgeTable& edges = input.record.edges;
  faces_.clear();
  indices_.clear();
  choices_.clear();
  for (std::size_t i = 1; i < edges.first_deferred(); ++i) choices_.push_back(choose(input, lit, i));
  std::ranges::stable_sort(choices_, {},
                           [](const Choice& choice) { return std::pair(choice.program, choice.array); });
  for (const Choice& choice : choices_) add(input, choice, nullptr);
  for (const render::DeferredFace& face : input.order.faces.opaque)
    add(input, choose(input, lit, face), &face.opacity);
  first_translucent_ = faces_.size();
  for (const render::DeferredFace& face : input.order.faces.translucent)
    add(input, choose(input, lit, face), &face.opacity);
}

// Fragments of one face are adjacent, and draw it once.
void FaceQueue::add(const FrameInput& input, const Choice& choice, const render::FaceOpacity* opacity) {
  const std::size_t number = choice.surface;
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  const render::ScreenSurface& surface = surfaces[number];
  QueuedFace face{.program = choice.program,
                  .array = choice.array,
                  .has_bright = choice.has_bright,
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
