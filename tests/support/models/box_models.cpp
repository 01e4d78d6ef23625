#include "support/models/box_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/check.h"
#include "support/models/drawable_models.h"

namespace temblor::test {
namespace {

using artgen::Ramp;

constexpr std::int32_t kCell = 16;  // texels: side of the square of each box on the skin
constexpr std::size_t kCornersOfABox = 24;

math::Bounds measure_bounds(std::span<const std::vector<ModelBox>> frames) {
  math::Bounds all = frames[0][0].bounds;
  for (const std::vector<ModelBox>& boxes : frames)
    for (const ModelBox& box : boxes) {
      all.mins = glm::min(all.mins, box.bounds.mins);
      all.maxs = glm::max(all.maxs, box.bounds.maxs);
    }
  return all;
}

// The skin has the squares of all boxes side by side.
std::vector<std::uint8_t> paint_skin(const std::vector<ModelBox>& boxes) {
  std::vector<std::uint8_t> texels;
  for (std::int32_t y = 0; y < kCell; ++y)
    for (const ModelBox& box : boxes)
      for (std::int32_t x = 0; x < kCell; ++x) {
        const bool frame = x == 0 || y == 0 || x == kCell - 1 || y == kCell - 1;
        const double checker = (x / 4 + y / 4) % 2 == 0 ? 0.85 : 0.6;
        texels.push_back(artgen::ramp_color(box.ramp, frame ? 0.4 : checker));
      }
  return texels;
}

// A corner of one of the six sides of a box. Side 2a faces along axis a, side 2a + 1 against it; corners are
// in order around the side.
struct SideCorner {
  std::array<bool, 3> at_maxs{};
  bool along_first = false, along_second = false;
};
SideCorner side_corner(std::size_t side, std::size_t corner) {
  const std::size_t axis = side / 2;
  SideCorner result;
  result.along_first = corner == 1 || corner == 2;
  result.along_second = corner >= 2;
  result.at_maxs[axis] = side % 2 == 0;
  result.at_maxs[(axis + 1) % 3] = result.along_first;
  result.at_maxs[(axis + 2) % 3] = result.along_second;
  return result;
}

class PoseMaker {
 public:
  explicit PoseMaker(const math::Bounds& all) : all_(all) {}

  formats::MdlPose pose(std::string name, const std::vector<ModelBox>& boxes) const {
    formats::MdlPose made;
    made.maxs.position = {255, 255, 255};
    made.name = std::move(name);
    for (const ModelBox& box : boxes)
      for (std::size_t side = 0; side < 6; ++side) {
        math::Vec3d normal(0.0);
        normal[static_cast<int>(side / 2)] = side % 2 == 0 ? 1 : -1;
        for (std::size_t corner = 0; corner < 4; ++corner)
          made.vertices.push_back(vertex(box.bounds, side_corner(side, corner), nearest_normal(normal)));
      }
    return made;
  }

 private:
  formats::MdlVertex vertex(const math::Bounds& box, const SideCorner& corner, std::uint8_t normal) const {
    formats::MdlVertex made{{}, normal};
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      const float place = corner.at_maxs[at] ? box.maxs[axis] : box.mins[axis];
      const float extent = all_.maxs[axis] - all_.mins[axis];
      made.position[at] = static_cast<std::uint8_t>(std::lround(255 * (place - all_.mins[axis]) / extent));
    }
    return made;
  }

  math::Bounds all_;
};

// Clockwise as seen from outside: on the sides that face along an axis, the corners run the other way.
void add_triangles(std::size_t boxes, std::vector<formats::MdlTriangle>& io_triangles) {
  for (std::size_t side = 0; side < 6 * boxes; ++side) {
    const auto first = static_cast<std::uint32_t>(4 * side);
    const bool along = side % 2 == 0;
    const std::uint32_t second = first + (along ? 3 : 1), fourth = first + (along ? 1 : 3);
    io_triangles.push_back({true, {first, second, first + 2}});
    io_triangles.push_back({true, {first, first + 2, fourth}});
  }
}

}  // namespace

formats::Mdl make_box_model(std::span<const std::vector<ModelBox>> frames) {
  CHECK(!frames.empty() && !frames[0].empty());
  const std::size_t boxes = frames[0].size();
  const math::Bounds all = measure_bounds(frames);
  formats::Mdl mdl;
  mdl.scale = (all.maxs - all.mins) / 255.0f;
  mdl.origin = all.mins;
  mdl.bounding_radius = glm::length(glm::max(glm::abs(all.mins), glm::abs(all.maxs)));
  mdl.skin_width = static_cast<std::uint32_t>(kCell) * static_cast<std::uint32_t>(boxes);
  mdl.skin_height = kCell;
  mdl.skins = {{{paint_skin(frames[0])}, {}}};
  for (std::size_t vertex = 0; vertex < kCornersOfABox * boxes; ++vertex) {
    const SideCorner corner = side_corner(vertex % kCornersOfABox / 4, vertex % 4);
    const std::int32_t left = static_cast<std::int32_t>(vertex / kCornersOfABox) * kCell;
    mdl.texels.push_back(
        {false, left + (corner.along_first ? kCell - 1 : 0), corner.along_second ? 0 : kCell - 1});
  }
  add_triangles(boxes, mdl.triangles);
  const PoseMaker maker(all);
  for (const std::vector<ModelBox>& frame : frames) {
    CHECK(frame.size() == boxes);
    const std::string name = "frame" + std::to_string(mdl.frames.size());
    mdl.frames.push_back({{maker.pose(name, frame)}, {}, {}, {}});
  }
  return mdl;
}

formats::Mdl walker_mdl() {
  constexpr Ramp kShirt = Ramp::kBrown, kTrousers = Ramp::kGold;
  std::vector<std::vector<ModelBox>> frames;
  for (const float stride : {0.0f, 10.0f, 0.0f, -10.0f})
    frames.push_back({{{{stride - 5, 2, -24}, {stride + 5, 11, 0}}, kTrousers},
                      {{{-stride - 5, -11, -24}, {-stride + 5, -2, 0}}, kTrousers},
                      {{{-8, -14, 0}, {8, 14, 20}}, kShirt},
                      {{{-6, -6, 20}, {9, 6, 32}}, Ramp::kSkin}});
  return make_box_model(frames);
}

formats::Mdl weapon_mdl() {
  std::vector<std::vector<ModelBox>> frames;
  for (const float back : {0.0f, 6.0f, 4.0f, 2.0f})
    frames.push_back({{{{10 - back, -3, -13}, {26 - back, 3, -8}}, Ramp::kSlate},
                      {{{26 - back, -1.5f, -11}, {40 - back, 1.5f, -8.5f}}, Ramp::kGray},
                      {{{12 - back, -2, -19}, {17 - back, 2, -13}}, Ramp::kRust},
                      {{{16 - back, -0.5f, -8}, {18 - back, 0.5f, -6.5f}}, Ramp::kFire}});
  return make_box_model(frames);
}

formats::Mdl rocket_mdl() {
  const std::vector<ModelBox> boxes = {{{{-12, -2, -2}, {6, 2, 2}}, Ramp::kGray},
                                       {{{6, -1, -1}, {12, 1, 1}}, Ramp::kRed},
                                       {{{-12, -5, -0.5f}, {-8, 5, 0.5f}}, Ramp::kRust},
                                       {{{-12, -0.5f, -5}, {-8, 0.5f, 5}}, Ramp::kRust}};
  formats::Mdl mdl = make_box_model({&boxes, 1});
  mdl.flags = formats::kMdlRocketTrail;
  return mdl;
}

formats::Mdl bolt_mdl() {
  const std::vector<ModelBox> boxes = {{{{0, -1, -3}, {10, 1, -1}}, Ramp::kElectric},
                                       {{{10, 1, 1}, {20, 3, 3}}, Ramp::kElectric},
                                       {{{20, -3, -1}, {30, -1, 1}}, Ramp::kElectric},
                                       {{{9, -1, -3}, {11, 3, 3}}, Ramp::kElectric},
                                       {{{19, -3, -1}, {21, 3, 3}}, Ramp::kElectric}};
  return make_box_model({&boxes, 1});
}

}  // namespace temblor::test
