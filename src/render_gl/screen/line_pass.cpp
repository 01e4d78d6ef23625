#include "render_gl/screen/line_pass.h"

#include <array>
#include <cstddef>

#include "render/screen/draw_lines.h"
#include "render/screen/painter.h"
#include "render_gl/frame/target.h"

namespace temblor::render_gl {

namespace {

constexpr const char* kLineVertexShader = R"(
layout(location = 0) in vec2 pixel;
// The same at all corners of a line.
layout(location = 1) in vec3 kind;   // the first pixel along the line; 1 if it is steep; 1 if it is tested
layout(location = 2) in vec4 steps;  // the place across and the depth of that pixel, each before its slope
layout(location = 3) in vec4 color;

flat out vec3 line_kind;
flat out vec4 line_steps, line_color;

void main() {
  line_kind = kind;
  line_steps = steps;
  line_color = color;
  gl_Position = vec4(at_pixel(pixel, 0.0).xy, 0.5, 1.0);
}
)";

// A line in the middle between two pixels takes the later one, as on the CPU, also if it is moved a little by
// rounding. A line without a test is as near as anything can be. The slack of depth is kLineDepthSlack.
constexpr const char* kLineFragmentShader = R"(
flat in vec3 line_kind;
flat in vec4 line_steps, line_color;
out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool is_steep = line_kind.y > 0.5;
  float number = float(is_steep ? pixel.y : pixel.x) - line_kind.x;
  float across = floor(line_steps.x + number * line_steps.y + 0.5 + 0.0005);
  if (across != float(is_steep ? pixel.x : pixel.y)) discard;
  color = line_color;
  float depth = line_steps.z + number * line_steps.w;
  gl_FragDepth = line_kind.z > 0.5 ? min(find_card_depth(depth + abs(depth) / 256.0), 1.0) : 1.0;
}
)";
static_assert(render::kLineDepthSlack == 1.0 / 256);

}  // namespace

LinePass::LinePass(const Functions& gl, ScreenProgram program)
    : program_(std::move(program)), vertex_array_(make_vertex_array(gl)), buffer_(make_buffer(gl)) {
  constexpr GLsizei kStride = sizeof(Corner);
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  const auto set = [&](GLuint location, GLint size, GLenum type, std::size_t offset) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, size, type, type == GL_UNSIGNED_BYTE, kStride,
                           reinterpret_cast<const void*>(offset));
  };
  set(0, 2, GL_FLOAT, offsetof(Corner, x));
  set(1, 3, GL_FLOAT, offsetof(Corner, first));
  set(2, 4, GL_FLOAT, offsetof(Corner, across));
  set(3, 4, GL_UNSIGNED_BYTE, offsetof(Corner, color));
  gl.BindVertexArray(0);
}

base::Result<LinePass> LinePass::make(const Functions& gl) {
  TRY(ScreenProgram program, ScreenProgram::make(gl, kLineVertexShader, kLineFragmentShader));
  return LinePass(gl, std::move(program));
}

// Half a pixel beyond the first and last pixel, and one pixel to either side.
void LinePass::add_line(const render::Line& line, const render::ViewFrame& view, std::uint32_t color) {
  const auto piece = render::project_line(line, view);
  if (!piece) return;
  const render::LineSteps steps = render::find_line_steps(*piece, view);
  const math::Vec3d start = steps.at(steps.first);
  Corner corner{.x = 0,
                .y = 0,
                .first = static_cast<float>(steps.first),
                .is_steep = static_cast<float>(steps.along),
                .is_tested = line.is_depth_tested ? 1.0f : 0.0f,
                .across = static_cast<float>(start[steps.across]),
                .across_slope = static_cast<float>(steps.slope[steps.across]),
                .depth = static_cast<float>(start.z),
                .depth_slope = static_cast<float>(steps.slope.z),
                .color = color};
  const auto add = [&](double i, double aside) {
    math::Vec3d at = steps.at(i);
    at[steps.along] = i;
    at[steps.across] += aside;
    corner.x = static_cast<float>(at.x);
    corner.y = static_cast<float>(at.y);
    corners_.push_back(corner);
  };
  const double first = steps.first - 0.5, last = steps.last + 0.5;
  for (const double aside : {-1.0, 1.0}) {  // two triangles
    add(first, -1);
    add(last, 1);
    add(aside < 0 ? last : first, aside);
  }
}

base::Status LinePass::draw(const Functions& gl, const FrameInput& input) {
  const render::FrameContext& context = input.context;
  corners_.clear();
  if (context.scene.lines.empty()) return base::Ok{};
  // A picture of one pixel, to find the color that the CPU paints.
  render::FrameBuffer sample(1, 1, context.format);
  render::Painter painter(context.colors.palette, sample);
  for (const render::Line& line : context.scene.lines) {
    painter.put(0, line.color);
    add_line(line, input.record.view, context.is_indexed() ? sample.indexed()[0] : sample.rgb()[0]);
  }
  if (corners_.empty()) return base::Ok{};
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)), corners_.data(),
                GL_STREAM_DRAW);
  program_.use(gl, input.record.view, context.scene.fog, nullptr);
  gl.BindVertexArray(vertex_array_.name());
  gl.DepthFunc(GL_GEQUAL);
  gl.DepthRangef(0, 1);
  gl.DepthMask(GL_FALSE);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
  gl.DepthMask(GL_TRUE);
  gl.DepthRangef(0, kWorldDepthEnd);
  gl.DepthFunc(GL_GREATER);
  gl.BindVertexArray(0);
  return gl.check("drawing lines");
}

}  // namespace temblor::render_gl
