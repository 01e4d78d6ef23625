#include "render_gl/vertex_light/vertex_method.h"

#include <algorithm>

#include "base/hash.h"
#include "render_gl/lit/light_texel.h"
#include "render_gl/vertex_light/vertex_light.h"

namespace temblor::render_gl {

namespace {

// Identifies the light of a face's corners, but never 0.
std::uint64_t find_light_key(const render::BlockRequest& request) {
  const render::BlockContents& contents = request.contents;
  std::uint64_t key = base::hash_with(base::to_size(request.face), contents.lights);
  for (const std::uint16_t value : contents.style_values) key = base::hash_with(key, value);
  key = base::hash_with(key, static_cast<std::uint64_t>(contents.light_view) << 1 | contents.colored);
  return key | 1;
}

// All lights that reach the face, where a tile's request has only those that reach the tile.
std::span<const render::FaceLight> find_face_lights(const FrameInput& input, std::uint32_t instance,
                                                    world::FaceIndex number, base::Arena& arena) {
  const world::Level& level = input.context.level();
  const world::Face& face = level.face(number);
  const render::FacePlacement placed =
      render::place_face(level, face, input.record.edges.model_views[instance]);
  const render::SampleGrid whole{0, 0, face.texture_extents[0] / render::kTexelsASample + 1,
                                 face.texture_extents[1] / render::kTexelsASample + 1};
  base::ArenaVector<render::FaceLight> lights(arena, 4);
  for (const render::DynamicLight& light : input.scene().lights) {
    const auto on_face = render::light_on_face(light, placed, input.context.settings.colored_light);
    if (on_face && render::reaches(*on_face, whole)) lights.push_back(*on_face);
  }
  return lights.view();
}

}  // namespace

base::Status VertexMethod::set_level(const Functions& gl, const render::FrameContext& context) {
  clear_light();
  return LitMethod::set_level(gl, context);
}

// A brush model's corners follow those of the level's faces, and those of earlier instances.
base::Status VertexMethod::prepare(const Functions& gl, const FrameInput& input) {
  const world::Level& level = input.context.level();
  const render::FaceOutlines& outlines = input.level_data.outlines;
  first_light_.assign(1, 0);
  std::size_t next = outlines.corners.size();
  for (const render::BrushModelInstance& instance : input.scene().brush_models) {
    const world::Model& model = level.models[base::to_size(instance.model)];
    if (model.face_count == 0) {
      first_light_.push_back(0);
      continue;
    }
    const render::FaceOutline& first = outlines.faces[model.first_face];
    const render::FaceOutline& last = outlines.faces[model.first_face + model.face_count - 1];
    first_light_.push_back(static_cast<std::uint32_t>(next) - first.first_corner);
    next += last.first_corner + last.corner_count - first.first_corner;
  }
  const std::size_t before = table_.capacity();
  TRY_STATUS(table_.reserve(gl, next));
  if (table_.capacity() != before) keys_.assign(table_.capacity(), 0);
  // Faces of other models may have had the places of brush models.
  std::fill(keys_.begin() + static_cast<std::ptrdiff_t>(std::min(outlines.corners.size(), keys_.size())),
            keys_.end(), 0);
  return base::Ok{};
}

void VertexMethod::light_face(const FrameInput& input, const render::BlockRequest& request, std::size_t first,
                              const render::FaceOutline& outline) {
  const std::uint64_t key = find_light_key(request);
  if (keys_[first] == key) {
    ++counts_.hits;
    return;
  }
  keys_[first] = key;
  const world::Level& level = input.context.level();
  const world::Face& face = level.face(request.face);
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  packed_.clear();
  for (std::uint32_t i = 0; i < outline.corner_count; ++i) {
    const math::Vec3d at(input.level_data.outlines.corners[outline.first_corner + i].position);
    const double s = glm::dot(math::Vec3d(axes.s_axis), at) + double{axes.s_offset} - face.texture_mins[0];
    const double t = glm::dot(math::Vec3d(axes.t_axis), at) + double{axes.t_offset} - face.texture_mins[1];
    packed_.push_back(pack_light(find_light_at(level, request, s, t, scratch_).data()));
  }
  table_.set(first, packed_);
}

// Every tile of a face brings the light of all its corners up to date.
std::optional<TileRecord> VertexMethod::place(const Functions&, const FrameInput& input, std::uint32_t draw,
                                              BlockAtlas&) {
  const render::SurfaceDraw& drawn = input.record.surfaces.draws.all[draw];
  const std::uint32_t instance = input.record.edges.surfaces[base::to_size(drawn.surface)].instance;
  render::BlockRequest request = tiles_.request(draw);
  const render::FaceOutline& outline = input.level_data.outlines.faces[base::to_size(request.face)];
  const std::size_t first = outline.first_corner + first_light_[instance];
  if (first + outline.corner_count > table_.capacity()) return TileRecord{};  // hidden
  if (request.contents.light_view != render::LightView::kFullBright) {
    face_scratch_.reset();
    request.lights = find_face_lights(input, instance, request.face, face_scratch_);
    request.contents.lights = render::hash_lights(request.lights);
  }
  light_face(input, request, first, outline);
  return tiles_.make_record(input.context.level(), draw, 0);
}

void VertexMethod::end_portion(const Functions& gl, const FrameInput&, const BlockAtlas&) {
  table_.upload(gl, counts_);
}

void VertexMethod::use(const Functions& gl, const FaceProgram& program, const LitLook& look) const {
  LitMethod::use(gl, program, look);
  gl.ActiveTexture(GL_TEXTURE0 + face_units::kVertexLights);
  gl.BindTexture(GL_TEXTURE_2D, table_.texture());
}

void VertexMethod::use_instance(const Functions& gl, const FaceProgram& program,
                                std::uint32_t instance) const {
  gl.Uniform1ui(program.first_light, first_light_[instance]);
}

}  // namespace temblor::render_gl
