#include "render_gl/passes/polygon_method.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "render_gl/gl/projection.h"
#include "render_gl/world/face_view.h"

namespace temblor::render_gl {

namespace {

// Polygons lie on faces, whose corners they do not share. They must come nearer than rounding reaches, but
// stay behind brush models in the same plane. Without glClipControl, depth is too coarse for both, and such
// brush models get the light of the wall behind them, too.
float find_nearer(const Functions& gl) {
  return (gl.ClipControl != nullptr ? 0.5f : 4.5f) * kBrushModelNearer;
}

constexpr const char* kPolygonVertexShader = R"(
layout(location = 0) in vec4 position;  // in the world; how much nearer it comes
layout(location = 1) in vec3 light;

uniform vec3 eye;
uniform mat3 view_axes;  // from the world to right, up, forward

out vec3 half_light;

void main() {
  half_light = light;
  gl_Position = project_nearer(view_axes * (position.xyz - eye), position.w);
}
)";

constexpr const char* kPolygonFragmentShader = R"(
in vec3 half_light;
out vec4 color;

void main() { color = vec4(half_light, 1.0); }
)";

}  // namespace

PolygonMethod::PolygonMethod(const Functions& gl, LightGrids light, Program program)
    : GridMethod(std::move(light)),
      program_(gl, std::move(program)),
      buffer_(make_buffer(gl)),
      vertex_array_(make_vertex_array(gl)),
      nearer_(find_nearer(gl)) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  for (GLuint location = 0; location < 2; ++location) gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                         reinterpret_cast<const void*>(offsetof(Vertex, half_light)));
  gl.BindVertexArray(0);
}

base::Result<std::unique_ptr<LitMethod>> PolygonMethod::make(const Functions& gl) {
  TRY(Program program, make_program(gl, (std::string(kProjectionPart) + kPolygonVertexShader).c_str(),
                                    kPolygonFragmentShader));
  TRY(LightGrids light, LightGrids::make(gl));
  return std::unique_ptr<LitMethod>(new PolygonMethod(gl, std::move(light), std::move(program)));
}

void PolygonMethod::begin_frame() {
  GridMethod::begin_frame();
  polygon_counts_ = {};
}

// Deferred faces may be translucent, and keep theirs.
void PolygonMethod::take_lights(std::span<render::BlockRequest> io_requests, std::uint32_t first_deferred) {
  lights_.clear();
  for (render::BlockRequest& request : io_requests) {
    if (request.lights.empty() || request.draw >= first_deferred) continue;
    lights_.push_back({request.draw, request.lights});
    request.lights = {};
    request.contents.lights = 0;
  }
}

void PolygonMethod::begin_portion() {
  GridMethod::begin_portion();
  vertices_.clear();
}

void PolygonMethod::add_polygons(const FrameInput& input, std::uint32_t draw,
                                 const render::FaceLight& light) {
  // Half of the light, as LitPassKind::kLight: full light is nearly 1.
  constexpr float kHalfLight = 256.0f / 65536;
  const world::Level& level = input.context.level();
  const render::BlockRequest& request = tiles_.request(draw);
  const render::SurfaceIndex surface = input.record.surfaces.draws.all[draw].surface;
  const std::uint32_t instance = input.record.edges.surfaces[base::to_size(surface)].instance;
  const render::FaceOutlines& outlines = input.level_data.outlines;
  const render::FaceOutline& outline = outlines.faces[base::to_size(request.face)];
  corners_.clear();
  add_light_polygons({level, level.face(request.face),
                      std::span(outlines.corners).subspan(outline.first_corner, outline.corner_count),
                      request.tile_s, request.tile_t},
                     light, corners_);
  const render::ModelView& model = input.record.edges.model_views[instance];
  for (const LightCorner& corner : corners_) {
    const float half_light = corner.light * kHalfLight;
    vertices_.push_back(
        {math::Vec3(model.to_world(math::Vec3d(corner.position))),
         instance == 0 ? nearer_ : nearer_ + kBrushModelNearer,
         {half_light * light.color[2], half_light * light.color[1], half_light * light.color[0]}});
  }
}

// A face of several fragments comes once.
std::optional<TileRecord> PolygonMethod::place(const Functions& gl, const FrameInput& input,
                                               std::uint32_t draw, BlockAtlas& io_atlas) {
  const std::optional<TileRecord> record = GridMethod::place(gl, input, draw, io_atlas);
  const auto found = std::ranges::lower_bound(lights_, draw, {}, &DrawLights::draw);
  if (record && found != lights_.end() && found->draw == draw)
    for (const render::FaceLight& light : found->lights) add_polygons(input, draw, light);
  return record;
}

void PolygonMethod::end_portion(const Functions& gl, const FrameInput&, const BlockAtlas&) {
  if (vertices_.empty()) return;
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(),
                GL_STREAM_DRAW);
  ++polygon_counts_.uploads;
  polygon_counts_.bytes_uploaded += vertices_.size() * sizeof(Vertex);
}

void PolygonMethod::draw_polygons(const Functions& gl, const FrameInput& input) const {
  if (vertices_.empty()) return;
  use_face_program(gl, input, program_, false);
  gl.BindVertexArray(vertex_array_.name());
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
  gl.BindVertexArray(0);
}

CacheCounts PolygonMethod::light_counts() const {
  CacheCounts counts = GridMethod::light_counts();
  counts.uploads += polygon_counts_.uploads;
  counts.bytes_uploaded += polygon_counts_.bytes_uploaded;
  return counts;
}

}  // namespace temblor::render_gl
