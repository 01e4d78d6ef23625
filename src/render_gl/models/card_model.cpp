#include "render_gl/models/card_model.h"

#include <array>
#include <vector>

namespace temblor::render_gl {

namespace {

template <typename Element>
using PosedVertex = std::array<Element, 4>;

template <typename Element>
void append_vertices(const render::PoseRows<Element>& rows, std::size_t count,
                     std::vector<PosedVertex<Element>>& io_vertices) {
  for (std::size_t i = 0; i < count; ++i)
    io_vertices.push_back({rows.x[i], rows.y[i], rows.z[i], rows.normals[i]});
}

template <typename Element>
void fill_buffer(const Functions& gl, GLenum target, const Buffer& buffer,
                 const std::vector<Element>& elements) {
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
                GL_STATIC_DRAW);
}

// `find_pose` returns the rows of a pose.
template <typename Element, typename FindPose>
void upload_poses(const Functions& gl, const render::AliasModel& model, const Buffer& buffer,
                  FindPose find_pose) {
  std::vector<PosedVertex<Element>> vertices;
  vertices.reserve(model.pose_count() * model.vertex_count);
  for (std::size_t pose = 0; pose < model.pose_count(); ++pose)
    append_vertices<Element>(find_pose(base::to_index<render::PoseIndex>(pose)), model.vertex_count,
                             vertices);
  fill_buffer(gl, GL_ARRAY_BUFFER, buffer, vertices);
}

}  // namespace

base::Result<CardModel> CardModel::make(const Functions& gl, const render::AliasModel& model) {
  CardModel card;
  card.poses_ = make_buffer(gl);
  card.texels_ = make_buffer(gl);
  card.triangles_ = make_buffer(gl);
  card.vertex_array_ = make_vertex_array(gl);
  gl.BindVertexArray(card.vertex_array_.name());
  if (model.is_wide()) {
    card.element_type_ = GL_UNSIGNED_SHORT;
    card.pose_bytes_ = model.vertex_count * sizeof(PosedVertex<std::uint16_t>);
    upload_poses<std::uint16_t>(gl, model, card.poses_,
                                [&](render::PoseIndex pose) { return model.wide_pose(pose); });
  } else {
    card.pose_bytes_ = model.vertex_count * sizeof(PosedVertex<std::uint8_t>);
    upload_poses<std::uint8_t>(gl, model, card.poses_,
                               [&](render::PoseIndex pose) { return model.pose(pose); });
  }
  fill_buffer(gl, GL_ARRAY_BUFFER, card.texels_, model.texels);
  gl.VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  for (GLuint location = 0; location < 3; ++location) gl.EnableVertexAttribArray(location);
  fill_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, card.triangles_, model.triangles);
  card.triangle_count_ = static_cast<std::uint32_t>(model.triangles.size());
  gl.BindVertexArray(0);
  TRY_STATUS(card.upload_skins(gl, model));
  TRY_STATUS(gl.check("loading a model"));
  return card;
}

base::Status CardModel::upload_skins(const Functions& gl, const render::AliasModel& model) {
  GLint max_side = 0, max_layers = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &max_layers);
  skin_width_ = static_cast<int>(model.skin_width);
  skin_height_ = static_cast<int>(model.skin_height);
  const auto count = static_cast<std::uint32_t>(model.picture_count());
  const auto layer_limit = static_cast<std::uint32_t>(max_layers);
  skins_per_layer_ = (count + layer_limit - 1) / layer_limit;
  if (skin_width_ > max_side ||
      static_cast<std::uint64_t>(skin_height_) * skins_per_layer_ > static_cast<std::uint64_t>(max_side))
    return base::error(base::ErrorCode::kTooLarge,
                       "{}: the graphics card's textures have up to {} texels a side and {} layers; the "
                       "model has {} skins of {}x{}",
                       model.name, max_side, max_layers, count, skin_width_, skin_height_);
  const std::uint32_t layers = (count + skins_per_layer_ - 1) / skins_per_layer_;
  TRY(skins_, make_texture(gl, GL_R8UI,
                           {skin_width_, skin_height_ * static_cast<int>(skins_per_layer_),
                            static_cast<int>(layers)}));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::uint32_t number = 0; number < count; ++number) {
    const SkinPlace place = skin_place(number);
    gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, place.first_row, place.layer, place.width, place.height, 1,
                     GL_RED_INTEGER, GL_UNSIGNED_BYTE, model.skin_picture(number));
  }
  return base::Ok{};
}

SkinPlace CardModel::skin_place(std::uint32_t number) const {
  return {static_cast<int>(number % skins_per_layer_) * skin_height_,
          static_cast<int>(number / skins_per_layer_), skin_width_, skin_height_};
}

void CardModel::draw(const Functions& gl, render::PoseIndex from, render::PoseIndex to) const {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, poses_.name());
  for (const auto& [location, pose] : {std::pair{0u, from}, std::pair{1u, to}})
    gl.VertexAttribIPointer(location, 4, element_type_, 0,
                            reinterpret_cast<const void*>(base::to_size(pose) * pose_bytes_));
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangle_count_ * 3), GL_UNSIGNED_INT, nullptr);
}

}  // namespace temblor::render_gl
