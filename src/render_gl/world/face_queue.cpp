#include "render_gl/world/face_queue.h"

#include <algorithm>
#include <utility>

#include "render_gl/world/level_mesh.h"

namespace temblor::render_gl {

namespace {

bool is_same_face(const render::ScreenSurface& a, const render::ScreenSurface& b) {
  return a.face == b.face && a.instance == b.instance;
}

// Visits the draws of lit tiles of the surface's face, of this fragment and of those that follow.
template <typename Visit>
void visit_lit_draws(const FrameInput& input, const LitTiles& lit, std::size_t number, Visit visit) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  for (std::size_t i = number; i < surfaces.size() && is_same_face(surfaces[i], surfaces[number]); ++i) {
    const std::uint32_t first = surfaces[i].first_draw;
    for (std::uint32_t tile = 0; tile < std::uint32_t{surfaces[i].tiles.s} * surfaces[i].tiles.t; ++tile)
      if (lit.contains(first + tile)) visit(first + tile);
  }
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

// All tiles of a face have the same texture.
std::optional<FaceQueue::Choice> FaceQueue::choose_lit(const FrameInput& input, const LitMethod* method,
                                                       std::size_t number) {
  using enum FaceProgramKind;
  if (method == nullptr) return std::nullopt;
  const LitTiles& lit = method->tiles();
  const render::TileGrid tiles = input.record.edges.surfaces[number].tiles;
  std::optional<Choice> choice;
  visit_lit_draws(input, lit, number, [&](std::uint32_t draw) {
    if (!choice)
      choice =
          Choice{tiles.s * tiles.t == 1 ? kOneLit : kLit, {lit.array(draw)}, lit.has_bright(draw), number};
    choice->look.has_lights |= method->separates_lights() && !lit.request(draw).lights.empty();
  });
  return choice;
}

// For an opaque face.
FaceQueue::Choice FaceQueue::choose(const FrameInput& input, const LitMethod* method,
                                    std::size_t number) const {
  using enum FaceProgramKind;
  const render::ScreenSurface& surface = input.record.edges.surfaces[number];
  const world::Face& face = input.context.level().face(surface.face);
  const std::uint32_t tiles = std::uint32_t{surface.tiles.s} * surface.tiles.t;
  if (render::has_surface(face)) {
    if (const std::optional<Choice> lit = choose_lit(input, method, number)) return *lit;
    const bool is_blended = input.options.filter != render::TextureFilter::kNearest;
    return {tiles == 1 && !is_blended ? kOneBlock : kBlocks, {}, false, number};
  }
  if (face.kind == world::FaceKind::kSky) return {input.sources.skybox ? kSkybox : kSky, {}, false, number};
  return {face.kind == world::FaceKind::kLiquid ? kLiquid : kTexture, {}, false, number};
}

// Holes and opacity need the programs of several tiles. One color for all texels needs none of them.
FaceQueue::Choice FaceQueue::choose(const FrameInput& input, const LitMethod* method,
                                    const render::DeferredFace& face) const {
  using enum FaceProgramKind;
  Choice choice = choose(input, method, base::to_size(face.surface));
  choice.program = without_one_tile(choice.program);
  if (choice.program == kLit && face.opacity.color) choice = {kBlocks, {}, false, choice.surface};
  return choice;
}

std::uint32_t FaceQueue::find_first_fragment(const FrameInput& input, std::size_t surface) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  std::size_t first = surface;
  while (first > 1 && is_same_face(surfaces[first - 1], surfaces[surface])) --first;
  return static_cast<std::uint32_t>(first);
}

void FaceQueue::choose_fragments(const FrameInput& input, std::span<const render::DeferredFace> faces) {
  for (const render::DeferredFace& face : faces) {
    const std::size_t surface = base::to_size(face.surface);
    LargestFragment& largest = largest_[find_first_fragment(input, surface)];
    if (face.pixels > largest.pixels) largest = {face.pixels, surface};
  }
}

void FaceQueue::collect(const FrameInput& input, const LitMethod* method, const HasRoom& has_room) {
  has_room_ = has_room;
  const render::EdgeTable& edges = input.record.edges;
  faces_.clear();
  indices_.clear();
  choices_.clear();
  largest_.clear();
  choose_fragments(input, input.order.faces.opaque);
  choose_fragments(input, input.order.faces.translucent);
  for (std::size_t i = 1; i < edges.first_deferred(); ++i) choices_.push_back(choose(input, method, i));
  std::ranges::stable_sort(choices_, {},
                           [](const Choice& choice) { return std::pair(choice.program, choice.look); });
  for (const Choice& choice : choices_) add(input, choice, nullptr);
  for (const render::DeferredFace& face : input.order.faces.opaque)
    add(input, choose(input, method, face), &face.opacity);
  first_translucent_ = faces_.size();
  for (const render::DeferredFace& face : input.order.faces.translucent)
    add(input, choose(input, method, face), &face.opacity);
}

// Fragments of one face are adjacent, and one of them draws it: the first one, or the largest one of a
// deferred face. Those come only if pixels show them, and from back to front.
void FaceQueue::add(const FrameInput& input, const Choice& choice, const render::FaceOpacity* opacity) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  const render::ScreenSurface& surface = surfaces[choice.surface];
  const std::uint32_t number = find_first_fragment(input, choice.surface);
  const std::size_t drawing = opacity == nullptr ? number : largest_.at(number).surface;
  QueuedFace face{.program = choice.program,
                  .look = choice.look,
                  .has_bright = choice.has_bright,
                  .instance = surface.instance,
                  .face = surface.face,
                  .surface = number,
                  .fragments = 0,
                  .tiles = std::uint32_t{surface.tiles.s} * surface.tiles.t,
                  .first_index = static_cast<std::uint32_t>(indices_.size()),
                  .index_count = 0,
                  .opacity = opacity};
  if (drawing == choice.surface)
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
