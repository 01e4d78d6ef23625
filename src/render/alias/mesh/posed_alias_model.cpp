// Makes an AliasModel of an MD3 or MD5 model. Positions become 16-bit multiples of a step. The step is a
// power of two, so that it represents the positions of MD3 files exactly.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "formats/models/posed_model.h"
#include "render/alias/alias_mesh.h"
#include "render/alias/mesh/skin_atlas.h"

namespace temblor::render {

namespace {

constexpr float kMaxElement = 65535;
// Limit of the pictures of all skins, a byte each.
constexpr std::size_t kMaxSkinTexels = std::size_t{1} << 27;

// Returns the least power of two whose multiples reach from `least` to `most` in 16 bits.
float choose_step(float least, float most) {
  constexpr int kFinest = -20;
  float step = std::ldexp(1.0f, kFinest);
  while (most - std::floor(least / step) * step > kMaxElement * step) step *= 2;
  return step;
}

// Bounds are whole steps too, so that rounding moves no vertex out of them.
void choose_scale(const math::Bounds& bounds, AliasModel& io_model) {
  for (int axis = 0; axis < 3; ++axis) {
    const float step = choose_step(bounds.mins[axis], bounds.maxs[axis]);
    io_model.scale[axis] = step;
    io_model.origin[axis] = io_model.bounds.mins[axis] = std::floor(bounds.mins[axis] / step) * step;
    io_model.bounds.maxs[axis] = std::ceil(bounds.maxs[axis] / step) * step;
  }
}

// Appends the meshes' triangles, with the numbers of the joined vertices.
void join_triangles(const formats::PosedModel& posed, AliasModel& io_model) {
  std::uint32_t first_vertex = 0;
  for (const formats::PosedMesh& mesh : posed.meshes) {
    for (const auto& [a, b, c] : mesh.triangles)
      io_model.triangles.push_back({first_vertex + a, first_vertex + b, first_vertex + c});
    first_vertex += static_cast<std::uint32_t>(mesh.texels.size());
  }
  io_model.vertex_count = first_vertex;
  io_model.vertices_per_row = (io_model.vertex_count + AliasModel::kRowMultiple - 1) /
                              AliasModel::kRowMultiple * AliasModel::kRowMultiple;
}

// Writes one pose to four rows, and fills the padding at their ends with the last vertex.
void write_pose(const formats::PosedModel& posed, std::size_t number, const AliasModel& model,
                std::uint16_t* out_rows) {
  const std::size_t row = model.vertices_per_row;
  std::size_t at = 0;
  for (const formats::PosedMesh& mesh : posed.meshes) {
    const std::size_t count = mesh.texels.size(), first = number * count;
    for (std::size_t i = 0; i < count; ++i, ++at) {
      const math::Vec3 elements = (mesh.positions[first + i] - model.origin) / model.scale;
      for (int axis = 0; axis < 3; ++axis)
        out_rows[static_cast<std::size_t>(axis) * row + at] =
            static_cast<std::uint16_t>(std::clamp(std::nearbyint(elements[axis]), 0.0f, kMaxElement));
      out_rows[3 * row + at] = mesh.normals[first + i];
    }
  }
  for (std::size_t line = 0; line < 4; ++line)
    std::fill(out_rows + line * row + at, out_rows + (line + 1) * row, out_rows[line * row + at - 1]);
}

std::vector<math::Vec3d> list_first_pose(const formats::PosedModel& posed) {
  std::vector<math::Vec3d> positions;
  for (const formats::PosedMesh& mesh : posed.meshes)
    for (std::size_t i = 0; i < mesh.texels.size(); ++i) positions.emplace_back(mesh.positions[i]);
  return positions;
}

base::Status add_skins(const formats::PosedModel& posed, AliasModel& io_model) {
  TRY(const SkinAtlas atlas, make_skin_atlas(posed.meshes, posed.skins.front().pictures.front()));
  io_model.skin_width = atlas.width;
  io_model.skin_height = atlas.height;
  for (std::size_t mesh = 0; mesh < posed.meshes.size(); ++mesh) {
    const std::vector<TexelPoint> texels = place_texels(atlas.parts[mesh], posed.meshes[mesh].texels);
    io_model.texels.insert(io_model.texels.end(), texels.begin(), texels.end());
  }
  std::size_t texels = 0;
  for (const formats::PosedSkin& skin : posed.skins)
    texels += skin.pictures.size() * atlas.width * atlas.height;
  if (texels > kMaxSkinTexels)
    return base::error(base::ErrorCode::kTooLarge, "its skins have {} texels; the limit is {}", texels,
                       kMaxSkinTexels);
  std::uint32_t picture_count = 0;
  for (const formats::PosedSkin& skin : posed.skins) {
    const auto count = static_cast<std::uint32_t>(skin.pictures.size());
    io_model.skins.push_back({picture_count, count, skin.end_times_s});
    picture_count += count;
    for (const std::vector<formats::Picture>& pictures : skin.pictures) {
      const std::vector<std::uint8_t> joined = join_pictures(atlas, pictures);
      io_model.skin_texels.insert(io_model.skin_texels.end(), joined.begin(), joined.end());
    }
  }
  return base::Ok{};
}

}  // namespace

base::Result<std::shared_ptr<const AliasModel>> make_alias_model(const formats::PosedModel& posed,
                                                                 std::string name) {
  CHECK(!posed.frames.empty() && !posed.skins.empty(), "{}", name);
  for (const formats::PosedSkin& skin : posed.skins) {
    CHECK(!skin.pictures.empty(), "{}", name);
    for (const auto& pictures : skin.pictures) CHECK(pictures.size() == posed.meshes.size(), "{}", name);
  }
  auto model = std::make_shared<AliasModel>();
  model->name = std::move(name);
  model->flags = posed.flags;
  model->random_phase = posed.random_phase;
  choose_scale(formats::compute_bounds(posed), *model);
  join_triangles(posed, *model);
  CHECK(model->vertex_count > 0, "{}", model->name);
  for (const formats::PosedFrame& frame : posed.frames)
    model->frames.push_back({frame.first_pose, frame.count, frame.end_times_s});
  model->wide_poses.resize(posed.pose_count * 4 * model->vertices_per_row);
  for (std::size_t pose = 0; pose < posed.pose_count; ++pose)
    write_pose(posed, pose, *model, model->wide_poses.data() + pose * 4 * model->vertices_per_row);
  model->mean_side = static_cast<float>(compute_mean_side(model->triangles, list_first_pose(posed)));
  TRY_STATUS(add_skins(posed, *model));
  return std::shared_ptr<const AliasModel>(std::move(model));
}

}  // namespace temblor::render
