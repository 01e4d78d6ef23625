// One alias model on the graphics card: all poses, triangles, and skins, uploaded once.
//
//   poses      x, y, z, number of the normal   by pose, then by vertex: four bytes, or four 16-bit numbers
//   texels     s, t                            by vertex
//   triangles  three vertices each
//   skins      palette indices                 layers of an array texture, with one picture or several that
//                                              are stacked if there are more pictures than layers
//
// A draw reads two poses as two attributes of each vertex, so poses need no place in a texture.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/alias/alias_mesh.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

// A skin picture in the array texture, in texels.
struct SkinPlace {
  int first_row, layer, width, height;
};

class CardModel {
 public:
  // Skins that are larger than the card's textures lose texels. Fails if the card lacks memory.
  static base::Result<CardModel> make(const Functions& gl, const render::AliasModel& model);

  // `number` is a result of skin_at().
  SkinPlace skin_place(std::uint32_t number) const;
  GLuint skin_texture() const { return skins_.name(); }
  std::uint32_t triangle_count() const { return triangle_count_; }

  // Draws all triangles between two poses. The layout of the vertices: an element of each pose (locations 0
  // and 1), and the texel (2).
  void draw(const Functions& gl, render::PoseIndex from, render::PoseIndex to) const;

 private:
  CardModel() = default;
  // Decides how often the sides of skins are halved, and how many are stacked in a layer.
  void choose_skin_size(const Functions& gl, const render::AliasModel& model);
  base::Status upload_skins(const Functions& gl, const render::AliasModel& model);

  Buffer poses_, texels_, triangles_;
  VertexArray vertex_array_;
  Texture skins_;
  GLenum element_type_ = GL_UNSIGNED_BYTE;
  std::size_t pose_bytes_ = 0;
  int skin_halvings_ = 0, skin_width_ = 0, skin_height_ = 0;
  std::uint32_t skins_per_layer_ = 1, triangle_count_ = 0;
};

}  // namespace temblor::render_gl
