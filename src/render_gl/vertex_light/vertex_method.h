// Light at vertices only (WorldMethod::kGouraud): the CPU lights the corners of visible faces, and the card
// interpolates between them, in perspective. Cards of Quake's time were built for this ("3-D hardware
// accelerators are designed to optimize Gouraud shading", Abrash, "Surface Caching Revisited"); Quake did
// without it, because light then depends on how faces are cut ("Quake's Lighting Model: Surface Caching").
// Faces have only the corners that their outlines need, so light between them is lost. That difference from
// the reference is what the laboratory shows.
//
// Tiles with caustics have the CPU's blocks: a net of light has no use for corners.
#pragma once

#include <vector>

#include "render_gl/lit/lit_method.h"
#include "render_gl/vertex_light/vertex_table.h"

namespace temblor::render_gl {

class VertexMethod final : public LitMethod {
 public:
  base::Status prepare(const Functions& gl, const FrameInput& input) override;
  std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                  BlockAtlas& io_atlas) override;
  void end_portion(const Functions& gl, const FrameInput& input, const BlockAtlas& atlas) override;
  void use(const Functions& gl, const FaceProgram& program, const LitLook& look) const override;
  void use_instance(const Functions& gl, const FaceProgram& program, std::uint32_t instance) const override;
  void clear_light() override { keys_.assign(keys_.size(), 0); }
  // Rows of VertexTable that were uploaded, and faces whose light had not changed.
  CacheCounts light_counts() const override { return counts_; }
  std::size_t bytes() const override { return tiles_.bytes() + table_.bytes(); }

 protected:
  base::Status set_level(const Functions& gl, const render::FrameContext& context) override;
  void begin_frame() override { counts_ = {}; }
  bool can_light(const world::Level&, const render::BlockRequest& request) const override {
    return request.contents.caustic_step == 0;
  }

 private:
  void light_face(const FrameInput& input, const render::BlockRequest& request, std::size_t first,
                  const render::FaceOutline& outline);

  VertexTable table_;
  // By instance: added to the numbers of the level's corners (FaceOutlines::corners), modulo 2^32.
  std::vector<std::uint32_t> first_light_;
  std::vector<std::uint64_t> keys_;  // of the light of the face that begins with a corner of table_; 0: none
  CacheCounts counts_;
  base::Arena scratch_, face_scratch_;
  std::vector<std::uint32_t> packed_;  // scratch
};

}  // namespace temblor::render_gl
