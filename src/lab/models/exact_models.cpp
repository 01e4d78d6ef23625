#include "lab/exact_models.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/alias/alias_mesh.h"
#include "render/view/view_frame.h"

namespace temblor::lab {

namespace {

class ExactPicture {
 public:
  ExactPicture(const render::Scene& scene, int width, int height)
      : view_(render::make_view_frame(scene, width, height)),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void draw(const render::AliasInstance& instance) {
    const render::AliasModel& model = *instance.model;
    model.is_wide() ? place(instance, model.wide_pose(instance.from_pose), model.wide_pose(instance.to_pose))
                    : place(instance, model.pose(instance.from_pose), model.pose(instance.to_pose));
    for (const render::MeshTriangle& triangle : model.triangles) draw(model, triangle);
  }

  std::vector<ModelPixel> take() { return std::move(pixels_); }

 private:
  // The vertices in view space.
  template <typename Element>
  void place(const render::AliasInstance& instance, const render::PoseRows<Element>& from,
             const render::PoseRows<Element>& to) {
    const render::AliasModel& model = *instance.model;
    const math::Vec3& angles = instance.angles_deg;
    const math::Basis turn = math::basis_from_angles({-angles.x, angles.y, angles.z});
    const double blend = std::clamp(instance.blend, 0.0f, 1.0f);
    const auto mix = [&](Element a, Element b) { return a + (double{1} * b - a) * blend; };
    vertices_.clear();
    for (std::size_t i = 0; i < model.vertex_count; ++i) {
      const math::Vec3d element(mix(from.x[i], to.x[i]), mix(from.y[i], to.y[i]), mix(from.z[i], to.z[i]));
      const math::Vec3d p =
          (element * math::Vec3d(model.scale) + math::Vec3d(model.origin)) * double{instance.scale};
      vertices_.push_back(view_.to_view(math::Vec3d(instance.origin_world) + turn.forward * p.x -
                                        turn.right * p.y + turn.up * p.z));
    }
  }

  struct Box {
    int left, top, right, bottom;  // inclusive
  };

  // The pixels that the triangle may cover: all, if a corner is too near to be projected.
  Box find_box(const std::array<math::Vec3d, 3>& corners) const {
    Box box{0, 0, view_.width - 1, view_.height - 1};
    math::Vec2d least(1e9), most(-1e9);
    for (const math::Vec3d& corner : corners) {
      if (corner.z < view_.near_z) return box;
      const math::Vec2d screen = view_.to_screen(corner);
      least = glm::min(least, screen);
      most = glm::max(most, screen);
    }
    const auto inside = [](double value, int last) {
      return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(last) + 1));
    };
    box.left = std::max(box.left, inside(std::ceil(least.x), box.right));
    box.top = std::max(box.top, inside(std::ceil(least.y), box.bottom));
    box.right = std::min(box.right, inside(std::floor(most.x), box.right));
    box.bottom = std::min(box.bottom, inside(std::floor(most.y), box.bottom));
    return box;
  }

  // A ray meets the triangle where it is a sum of the corners with weights of one sign. Weights are volumes
  // of the tetrahedra that the ray makes with the sides.
  void draw(const render::AliasModel& model, const render::MeshTriangle& triangle) {
    const std::array<math::Vec3d, 3> corner{vertices_[triangle[0]], vertices_[triangle[1]],
                                            vertices_[triangle[2]]};
    if (corner[0].z < view_.near_z && corner[1].z < view_.near_z && corner[2].z < view_.near_z) return;
    const std::array<math::Vec3d, 3> side{glm::cross(corner[2], corner[1]), glm::cross(corner[0], corner[2]),
                                          glm::cross(corner[1], corner[0])};
    if (glm::dot(corner[0], side[0]) <= 0) return;  // a back face, or none
    const Box box = find_box(corner);
    for (int y = box.top; y <= box.bottom; ++y)
      for (int x = box.left; x <= box.right; ++x) {
        const math::Vec3d ray((x - view_.center_x) / view_.pixels_per_unit,
                              (view_.center_y - y) / view_.pixels_per_unit, 1);
        const math::Vec3d weight(glm::dot(ray, side[0]), glm::dot(ray, side[1]), glm::dot(ray, side[2]));
        if (weight.x < 0 || weight.y < 0 || weight.z < 0) continue;
        hit(model, triangle, corner, weight / (weight.x + weight.y + weight.z), x, y);
      }
  }

  void hit(const render::AliasModel& model, const render::MeshTriangle& triangle,
           const std::array<math::Vec3d, 3>& corner, const math::Vec3d& weight, int x, int y) {
    double z = 0, s = 0, t = 0;
    for (int i = 0; i < 3; ++i) {
      const auto number = static_cast<std::size_t>(i);
      const render::TexelPoint& texel = model.texels[triangle[number]];
      z += weight[i] * corner[number].z;
      s += weight[i] * double{texel.s};
      t += weight[i] * double{texel.t};
    }
    ModelPixel& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                                static_cast<std::size_t>(x)];
    if (z < view_.near_z || (pixel.hit && 1 / z < pixel.depth)) return;
    pixel = {true, 1 / z, s, t};
  }

  const render::ViewFrame view_;
  std::vector<math::Vec3d> vertices_;
  std::vector<ModelPixel> pixels_;
};

}  // namespace

std::vector<ModelPixel> draw_exact_models(const render::Scene& scene, int width, int height) {
  ExactPicture picture(scene, width, height);
  for (const render::AliasInstance& instance : scene.alias_models)
    if (instance.model != nullptr && instance.alpha >= 1) picture.draw(instance);
  return picture.take();
}

std::shared_ptr<const render::AliasModel> make_coordinate_model(const render::AliasModel& model, int axis) {
  auto coded = std::make_shared<render::AliasModel>(model);
  for (std::size_t i = 0; i < coded->skin_texels.size(); ++i) {
    const std::size_t texel = i % model.picture_bytes();
    coded->skin_texels[i] =
        static_cast<std::uint8_t>(axis == 0 ? texel % model.skin_width : texel / model.skin_width);
  }
  return coded;
}

formats::Colormap make_unlit_colormap() {
  formats::Colormap colormap;
  for (std::size_t i = 0; i < colormap.rows.size(); ++i) colormap.rows[i] = static_cast<std::uint8_t>(i);
  return colormap;
}

}  // namespace temblor::lab
