// The faces of the level and of brush models that a frame shows, in the order in which they are drawn, with
// the vertices of their triangles.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "render_gl/lit/lit_method.h"
#include "render_gl/world/face_programs.h"
#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

struct QueuedFace {
  FaceProgramKind program;
  LitLook look;            // of a lit face
  bool has_bright;         // whether that texture has full-bright texels
  std::uint32_t instance;  // 0: the world; i + 1: Scene::brush_models[i]
  world::FaceIndex face;
  // Its fragments: EdgeTable::surfaces from `surface` on.
  std::uint32_t surface, fragments;
  std::uint32_t tiles;
  // Its vertices in indices(). None: another fragment draws the face.
  std::uint32_t first_index, index_count;
  const render::FaceOpacity* opacity;  // null: opaque
};

class FaceQueue {
 public:
  // `method` may be null: no face is lit by the card. Leaves out faces of which `has_room` says that their
  // tiles have no room on the card.
  using HasRoom = std::function<bool(const render::ScreenSurface& surface)>;
  void collect(const FrameInput& input, const LitMethod* method, const HasRoom& has_room);

  const std::vector<QueuedFace>& faces() const { return faces_; }
  // The number of TranslucentOrder::faces.translucent[0]; the others follow.
  std::size_t first_translucent() const { return first_translucent_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }

 private:
  // How to draw a surface of EdgeTable::surfaces. Opaque ones are ordered by it.
  struct Choice {
    FaceProgramKind program;
    LitLook look;
    bool has_bright;
    std::size_t surface;
  };
  static std::optional<Choice> choose_lit(const FrameInput& input, const LitMethod* method,
                                          std::size_t surface);
  Choice choose(const FrameInput& input, const LitMethod* method, std::size_t surface) const;
  Choice choose(const FrameInput& input, const LitMethod* method, const render::DeferredFace& face) const;
  struct LargestFragment {
    std::uint64_t pixels = 0;
    std::size_t surface = 0;
  };
  static std::uint32_t find_first_fragment(const FrameInput& input, std::size_t surface);
  void choose_fragments(const FrameInput& input, std::span<const render::DeferredFace> faces);
  void add(const FrameInput& input, const Choice& choice, const render::FaceOpacity* opacity);

  HasRoom has_room_;
  std::vector<QueuedFace> faces_;
  std::size_t first_translucent_ = 0;
  std::vector<std::uint32_t> indices_;
  std::vector<Choice> choices_;                                 // scratch
  std::unordered_map<std::uint32_t, LargestFragment> largest_;  // of deferred faces, by first fragment
};

// The draw of a tile of the face that is seen, or nothing. The last one counts if several fragments show it.
std::optional<std::uint32_t> find_seen_draw(const FrameInput& input, const QueuedFace& face,
                                            std::uint32_t tile);

}  // namespace temblor::render_gl
