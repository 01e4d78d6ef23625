#include "render_gl/world/world_pass.h"

#include <array>
#include <cmath>
#include <string>

#include "render/color/blend_tables.h"
#include "render/color/warped_rows.h"
#include "render_gl/world/block_shaders.h"
#include "render_gl/world/world_shaders.h"

namespace temblor::render_gl {

namespace {

using render::SurfaceDraw;
using render::SurfaceKind;

constexpr GLenum kRecordsUnit = 0, kAtlasUnit = 1, kSkyboxUnit = 2;

// Addresses are below 2^63, so textures are numbered from there.
enum class TexturePart : std::uint64_t { kWhole, kClouds, kBackground };
AtlasKey texture_key(const SurfaceDraw& draw, TexturePart part) {
  const auto texture = static_cast<std::uint64_t>(draw.texture_index);
  const auto mip = static_cast<std::uint64_t>(draw.mip + 8);
  return std::uint64_t{1} << 63 | texture << 24 | mip << 16 | std::uint64_t{draw.light_row} << 8 |
         static_cast<std::uint64_t>(part);
}
AtlasKey block_key(const render::SurfaceBlock& block) {
  return reinterpret_cast<std::uintptr_t>(block.texels);
}

std::uint32_t pack(std::uint32_t low, std::uint32_t high) {
  return low | high << 16;
}

void set_image(TileKind kind, AtlasPlace place, render::SurfaceShape shape, TileRecord& out_record) {
  out_record.place = pack(place.x, place.y);
  out_record.size = pack(static_cast<std::uint32_t>(shape.width), static_cast<std::uint32_t>(shape.height));
  out_record.flags = std::uint32_t{place.layer} | static_cast<std::uint32_t>(kind) << 16 | 0xff000000u;
}

// Moves texture coordinates from the face's first texel to where a repeating texture begins; a liquid also
// to where its waves do.
float repeat_origin(std::int32_t first, std::uint32_t texels) {
  const std::int64_t period = std::int64_t{texels} * static_cast<std::int64_t>(render::kTurn_texels);
  return static_cast<float>(first % period);
}

void set_opacity(const render::FaceOpacity& opacity, TileRecord& io_record) {
  const auto alpha = static_cast<std::uint32_t>(std::lround(opacity.opacity * 255.0f));
  io_record.flags = (io_record.flags & 0x00ffffffu) | alpha << 24;
  if (opacity.has_holes) io_record.flags |= kHasHoles;
  if (opacity.is_additive) io_record.flags |= kHasNoFog;
  if (opacity.color) {
    io_record.flags |= kHasColor;
    io_record.second_place = render::to_rgb(*opacity.color) & 0xffffffu;
  }
}

std::array<float, 9> columns(const math::Vec3d& x, const math::Vec3d& y, const math::Vec3d& z) {
  const math::Vec3 a(x), b(y), c(z);
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

}  // namespace

WorldPass::Shader::Shader(const Functions& gl, Program linked) : program(std::move(linked)) {
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program.name(), name); };
  model_axes = find("model_axes");
  model_origin = find("model_origin");
  first_record = find("first_record");
  eye = find("eye");
  view_axes = find("view_axes");
  projection = find("projection");
  full_range = find("full_range");
  records = find("records");
  atlas = find("atlas");
  skybox = find("skybox");
  liquid_phase = find("liquid_phase");
  sky_scroll = find("sky_scroll");
  fog_density = find("fog_density");
  fog_color = find("fog_color");
}

WorldPass::WorldPass(const Functions& gl, Shader any_face, Shader block, Shader fogged_block,
                     BlockAtlas atlas)
    : any_face_(std::move(any_face)),
      block_(std::move(block)),
      fogged_block_(std::move(fogged_block)),
      atlas_(std::move(atlas)),
      index_buffer_(make_buffer(gl)) {}

base::Result<WorldPass> WorldPass::make(const Functions& gl, render::PixelFormat format,
                                        std::size_t atlas_bytes) {
  TRY(Program any_face, make_program(gl, kWorldVertexShader, kWorldFragmentShader));
  TRY(Program block, make_program(gl, kBlockVertexShader, kBlockFragmentShader));
  const std::string with_fog = std::string("#define FOG\n") + kBlockFragmentShader;
  TRY(Program fogged_block, make_program(gl, kBlockVertexShader, with_fog.c_str()));
  TRY(BlockAtlas atlas, BlockAtlas::make(gl, format, atlas_bytes));
  return WorldPass(gl, Shader(gl, std::move(any_face)), Shader(gl, std::move(block)),
                   Shader(gl, std::move(fogged_block)), std::move(atlas));
}

base::Status WorldPass::prepare(const Functions& gl, const FrameInput& input) {
  TRY_STATUS(set_level(gl, input));
  TRY_STATUS(number_instances(gl, input));
  TRY_STATUS(skybox_.update(gl, input.sources));
  atlas_.begin_frame();
  if (!place_images(gl, input)) {
    atlas_.clear();
    if (!place_images(gl, input))
      return base::error(base::ErrorCode::kTooLarge,
                         "the surfaces of one frame do not fit the graphics card's cache");
  }
  set_records(input);
  table_.upload(gl);
  collect_triangles(gl, input);
  return gl.check("loading surfaces");
}

base::Status WorldPass::set_level(const Functions& gl, const FrameInput& input) {
  const world::Level& level = input.context.level();
  if (level_ == level.identity) return base::Ok{};
  TRY(mesh_, LevelMesh::make(gl, level, input.level_data.outlines));
  atlas_.clear();
  level_ = level.identity;
  return base::Ok{};
}

// A brush model's records follow those of the level's faces, and those of earlier instances.
base::Status WorldPass::number_instances(const Functions& gl, const FrameInput& input) {
  const world::Level& level = input.context.level();
  record_offset_.assign(1, 0);
  std::uint32_t next = mesh_.tile_count();
  for (const render::BrushModelInstance& instance : input.scene().brush_models) {
    const world::Model& model = level.models[base::to_size(instance.model)];
    const auto first_face = base::to_index<world::FaceIndex>(model.first_face);
    record_offset_.push_back(model.face_count == 0 ? 0 : next - mesh_.first_tile(first_face));
    next += mesh_.tile_count(model);
  }
  return table_.reserve(gl, next);
}

// First the blocks that were built for this frame. False: the atlas is full.
bool WorldPass::place_images(const Functions& gl, const FrameInput& input) {
  const render::SurfaceDraws& draws = input.record.surfaces.draws;
  draw_records_.assign(draws.all.size(), TileRecord{});
  for (const render::BlockRequest& built : input.record.surfaces.missing)
    if (!atlas_.place(gl, {block_key(built.block), built.block.texels, built.block.shape, true}))
      return false;
  for (std::uint32_t draw = 1; draw < draws.all.size(); ++draw)
    if (!place_draw(gl, input, draw)) return false;
  return true;
}

bool WorldPass::place_draw(const Functions& gl, const FrameInput& input, std::uint32_t number) {
  const SurfaceDraw& draw = input.record.surfaces.draws.all[number];
  TileRecord& record = draw_records_[number];
  if (draw.kind == SurfaceKind::kHidden || draw.kind == SurfaceKind::kNothing) return true;
  const render::ScreenSurface& surface = input.record.edges.surfaces[base::to_size(draw.surface)];
  const world::Face& face = input.context.level().face(surface.face);
  if (draw.kind == SurfaceKind::kBlock) {
    const auto place = atlas_.place(gl, {block_key(draw.block), draw.block.texels, draw.block.shape});
    if (!place) return false;
    set_image(TileKind::kBlock, *place, draw.block.shape, record);
    const std::uint32_t tile = number - surface.first_draw;
    record.origin_s = -static_cast<float>(tile % surface.tiles.s * render::kTileTexels);
    record.origin_t = -static_cast<float>(tile / surface.tiles.s * render::kTileTexels);
    record.scale_s = record.scale_t = static_cast<float>(std::ldexp(1.0, -draw.mip));
    return true;
  }
  if (draw.kind == SurfaceKind::kSky) {
    if (input.sources.skybox) {
      const std::int32_t size = input.sources.skybox->size;
      set_image(TileKind::kSkybox, {}, {size, size}, record);
      return true;
    }
    const render::SkySpans& sky = *input.sources.skies[number];
    const render::SurfaceShape shape{sky.width, sky.height};
    const auto clouds = atlas_.place(gl, {texture_key(draw, TexturePart::kClouds), sky.clouds, shape});
    const auto back = atlas_.place(gl, {texture_key(draw, TexturePart::kBackground), sky.back, shape});
    if (!clouds || !back) return false;
    set_image(TileKind::kSky, *clouds, shape, record);
    record.second_place = back->x / 8u | back->y / 8u << 8 | std::uint32_t{back->layer} << 16;
    return true;
  }
  const render::RepeatSpans& repeat = *input.sources.repeating[number];
  const render::SurfaceShape shape{repeat.width, repeat.height};
  const auto place = atlas_.place(gl, {texture_key(draw, TexturePart::kWhole), repeat.texels, shape});
  if (!place) return false;
  const bool is_liquid = draw.kind == SurfaceKind::kLiquid;
  set_image(is_liquid ? TileKind::kLiquid : TileKind::kRepeat, *place, shape, record);
  record.origin_s = repeat_origin(face.texture_mins[0], draw.texture->width);
  record.origin_t = repeat_origin(face.texture_mins[1], draw.texture->height);
  record.scale_s = static_cast<float>(repeat.width) / static_cast<float>(draw.texture->width);
  record.scale_t = static_cast<float>(repeat.height) / static_cast<float>(draw.texture->height);
  return true;
}

// A brush model's face may have several fragments, which share its records: a tile is hidden only if all of
// them hide it.
void WorldPass::set_records(const FrameInput& input) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  for (const std::span<const render::DeferredFace> faces :
       {input.order.faces.opaque, input.order.faces.translucent})
    for (const render::DeferredFace& face : faces) {
      const render::ScreenSurface& surface = surfaces[base::to_size(face.surface)];
      for (std::uint32_t tile = 0; tile < std::uint32_t{surface.tiles.s} * surface.tiles.t; ++tile)
        if (draw_records_[surface.first_draw + tile].flags != 0)
          set_opacity(face.opacity, draw_records_[surface.first_draw + tile]);
    }
  const render::ScreenSurface* previous = nullptr;
  for (const render::ScreenSurface& surface : surfaces.subspan(1)) {
    const bool same_face =
        previous != nullptr && previous->face == surface.face && previous->instance == surface.instance;
    const std::uint32_t first = mesh_.first_tile(surface.face) + record_offset_[surface.instance];
    for (std::uint32_t tile = 0; tile < std::uint32_t{surface.tiles.s} * surface.tiles.t; ++tile) {
      const TileRecord& record = draw_records_[surface.first_draw + tile];
      if (!same_face || record.flags != 0) table_.set(first + tile, record);
    }
    previous = &surface;
  }
}

void WorldPass::collect_triangles(const Functions& gl, const FrameInput& input) {
  const render::EdgeTable& edges = input.record.edges;
  for (std::vector<Batch>* batches : {&blocks_, &others_, &with_holes_, &translucent_}) batches->clear();
  indices_.clear();
  // Batches are consecutive in the list of vertices, so one kind of face comes after the other.
  const auto has_one_block = [&](const render::ScreenSurface& surface) {
    return surface.tiles.s == 1 && surface.tiles.t == 1 &&
           render::has_surface(input.context.level().face(surface.face));
  };
  for (const bool of_one_block : {true, false})
    for (std::size_t i = 1; i < edges.first_deferred(); ++i)
      if (has_one_block(edges.surfaces[i]) == of_one_block)
        add_surface(input, base::to_index<render::SurfaceIndex>(i), of_one_block ? blocks_ : others_);
  for (const render::DeferredFace& face : input.order.faces.opaque)
    add_surface(input, face.surface, with_holes_);
  for (const render::DeferredFace& face : input.order.faces.translucent) {
    std::vector<Batch> one;
    add_surface(input, face.surface, one);
    translucent_.push_back(one.empty() ? Batch{0, 0, 0} : one.front());
  }
  gl.BindVertexArray(mesh_.vertex_array());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_.name());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices_.size() * sizeof(std::uint32_t)),
                indices_.data(), GL_STREAM_DRAW);
  gl.BindVertexArray(0);
}

// Fragments of one face are adjacent, and draw it once.
void WorldPass::add_surface(const FrameInput& input, render::SurfaceIndex number,
                            std::vector<Batch>& io_batches) {
  const std::span<const render::ScreenSurface> surfaces = input.record.edges.surfaces;
  const std::size_t index = base::to_size(number);
  const render::ScreenSurface& surface = surfaces[index];
  const auto same_face = [&](const render::ScreenSurface& other) {
    return other.face == surface.face && other.instance == surface.instance;
  };
  const std::size_t tiles = std::size_t{surface.tiles.s} * surface.tiles.t;
  const auto is_seen = [&](const render::ScreenSurface& fragment) {
    for (std::size_t tile = 0; tile < tiles; ++tile)
      if (draw_records_[fragment.first_draw + tile].flags != 0) return true;
    return false;
  };
  if (index > 1 && same_face(surfaces[index - 1])) return;
  bool seen = false;
  for (std::size_t i = index; i < surfaces.size() && same_face(surfaces[i]) && !seen; ++i)
    seen = is_seen(surfaces[i]);
  if (!seen) return;
  if (io_batches.empty() || io_batches.back().instance != surface.instance)
    io_batches.push_back({surface.instance, indices_.size(), 0});
  LevelMesh::add_triangles(input.level_data.outlines.faces[base::to_size(surface.face)], indices_);
  io_batches.back().index_count = indices_.size() - io_batches.back().first_index;
}

void WorldPass::begin_draw(const Functions& gl, const FrameInput& input, const Shader& shader) const {
  const render::ViewFrame& view = input.record.view;
  const render::Fog& fog = input.scene().fog;
  gl.UseProgram(shader.program.name());
  gl.ActiveTexture(GL_TEXTURE0 + kRecordsUnit);
  gl.BindTexture(GL_TEXTURE_2D, table_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + kAtlasUnit);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, atlas_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + kSkyboxUnit);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, skybox_.texture());
  gl.Uniform1i(shader.records, kRecordsUnit);
  gl.Uniform1i(shader.atlas, kAtlasUnit);
  gl.Uniform1i(shader.skybox, kSkyboxUnit);
  const math::Vec3 eye(view.eye_world);
  gl.Uniform3f(shader.eye, eye.x, eye.y, eye.z);
  const std::array<float, 9> axes = columns(view.axes.right, view.axes.up, view.axes.forward);
  gl.UniformMatrix3fv(shader.view_axes, 1, GL_TRUE, axes.data());
  gl.Uniform4f(shader.projection, static_cast<float>(2 * view.pixels_per_unit / view.width),
               static_cast<float>(2 * view.pixels_per_unit / view.height), static_cast<float>(view.near_z),
               view.perspective ? 1.0f : 0.0f);
  gl.Uniform1i(shader.full_range, gl.ClipControl == nullptr);
  const double time_s = input.scene().time_s;
  gl.Uniform1f(shader.liquid_phase, static_cast<float>(render::compute_turbulence_phase(time_s)));
  // Stock Quake's speeds. After 64 layers, every layer is where it began.
  constexpr double kPeriod_texels = 128 * 64, kClouds_texels_s = 16, kBackground_texels_s = 8;
  gl.Uniform2f(shader.sky_scroll, static_cast<float>(std::fmod(time_s * kClouds_texels_s, kPeriod_texels)),
               static_cast<float>(std::fmod(time_s * kBackground_texels_s, kPeriod_texels)));
  const formats::Rgb fog_color = render::to_bytes(fog.color);
  gl.Uniform1f(shader.fog_density, fog.density);
  gl.Uniform3f(shader.fog_color, static_cast<float>(fog_color.b) / 255, static_cast<float>(fog_color.g) / 255,
               static_cast<float>(fog_color.r) / 255);
  gl.BindVertexArray(mesh_.vertex_array());
}

void WorldPass::draw_batch(const Functions& gl, const FrameInput& input, const Shader& shader,
                           const Batch& batch) const {
  if (batch.index_count == 0) return;
  const render::ModelView& model = input.record.edges.model_views[batch.instance];
  const std::array<float, 9> axes = columns(model.x_axis, model.y_axis, model.z_axis);
  const math::Vec3 origin(model.origin_world);
  gl.UniformMatrix3fv(shader.model_axes, 1, GL_FALSE, axes.data());
  gl.Uniform3f(shader.model_origin, origin.x, origin.y, origin.z);
  gl.Uniform1ui(shader.first_record, record_offset_[batch.instance]);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.index_count), GL_UNSIGNED_INT,
                  reinterpret_cast<const void*>(batch.first_index * sizeof(std::uint32_t)));
}

void WorldPass::draw_opaque(const Functions& gl, const FrameInput& input) const {
  const bool has_fog = input.scene().fog.density > 0;
  const Shader& block = !has_fog ? block_ : input.record.view.perspective ? fogged_block_ : any_face_;
  begin_draw(gl, input, block);
  for (const Batch& batch : blocks_) draw_batch(gl, input, block, batch);
  begin_draw(gl, input, any_face_);
  for (const std::vector<Batch>* batches : {&others_, &with_holes_})
    for (const Batch& batch : *batches) draw_batch(gl, input, any_face_, batch);
  gl.BindVertexArray(0);
}

void WorldPass::draw_translucent(const Functions& gl, const FrameInput& input, std::uint32_t face) const {
  begin_draw(gl, input, any_face_);
  const bool is_additive = input.order.faces.translucent[face].opacity.is_additive;
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, is_additive ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
  gl.DepthMask(GL_FALSE);
  draw_batch(gl, input, any_face_, translucent_[face]);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.BindVertexArray(0);
}

}  // namespace temblor::render_gl
