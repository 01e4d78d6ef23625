#include "render_gl/models/card_model.h"

#include <array>
#include <cmath>
#include <vector>

#include "render_gl/gl/texture_limits.h"

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

// The places of vertices in skins whose sides were halved.
std::vector<render::TexelPoint> scale_texels(const render::AliasModel& model, int halvings) {
  std::vector<render::TexelPoint> texels = model.texels;
  const auto scale = static_cast<float>(std::ldexp(1.0, -halvings));
  for (render::TexelPoint& texel : texels) {
    texel.s *= scale;
    texel.t *= scale;
  }
  return texels;
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
  card.choose_skin_size(gl, model);
  fill_buffer(gl, GL_ARRAY_BUFFER, card.texels_, scale_texels(model, card.skin_halvings_));
  gl.VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  for (GLuint location = 0; location < 3; ++location) gl.EnableVertexAttribArray(location);
  fill_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, card.triangles_, model.triangles);
  card.triangle_count_ = static_cast<std::uint32_t>(model.triangles.size());
  gl.BindVertexArray(0);
  TRY_STATUS(card.upload_skins(gl, model));
  TRY_STATUS(gl.check("loading a model"));
  return card;
}

void CardModel::choose_skin_size(const Functions& gl, const render::AliasModel& model) {
  const TextureLimits limits = find_texture_limits(gl);
  const auto count = static_cast<int>(model.picture_count());
  skins_per_layer_ = static_cast<std::uint32_t>((count + limits.layers - 1) / limits.layers);
  const int width = static_cast<int>(model.skin_width), height = static_cast<int>(model.skin_height);
  const int max_height = std::max(limits.side / static_cast<int>(skins_per_layer_), 1);
  skin_halvings_ = std::max(count_halvings(width, 1, limits.side), count_halvings(1, height, max_height));
  skin_width_ = halve(width, skin_halvings_);
  skin_height_ = halve(height, skin_halvings_);
}

base::Status CardModel::upload_skins(const Functions& gl, const render::AliasModel& model) {
  const auto count = static_cast<std::uint32_t>(model.picture_count());
  const std::uint32_t layers = (count + skins_per_layer_ - 1) / skins_per_layer_;
  TRY(skins_, make_texture(gl, GL_R8UI,
                           {skin_width_, skin_height_ * static_cast<int>(skins_per_layer_),
                            static_cast<int>(layers)}));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::uint32_t number = 0; number < count; ++number) {
    const SkinPlace place = skin_place(number);
    const std::vector<std::uint8_t> picture =
        halve_picture(model.skin_picture(number), static_cast<int>(model.skin_width),
                      static_cast<int>(model.skin_height), skin_halvings_);
    gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, place.first_row, place.layer, place.width, place.height, 1,
                     GL_RED_INTEGER, GL_UNSIGNED_BYTE, picture.data());
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
