#include "render_gl/world/world_pass.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "render_gl/world/face_blend.h"
#include "render_gl/world/face_view.h"
#include "render_gl/world/tile_images.h"

namespace temblor::render_gl {

WorldPass::WorldPass(const Functions& gl, FacePrograms programs, BlockAtlas atlas)
    : programs_(std::move(programs)), atlas_(std::move(atlas)), index_buffer_(make_buffer(gl)) {}

base::Result<WorldPass> WorldPass::make(const Functions& gl, const CacheOptions& asked,
                                        render::PixelFormat format) {
  CacheOptions cache = asked;
  if (format == render::PixelFormat::kIndexed)
    cache = {.bytes = asked.bytes / sizeof(std::uint32_t), .format = TexelFormat::k8Bit};
  TRY(FacePrograms programs, FacePrograms::make(gl, {}, format));
  TRY(BlockAtlas atlas, BlockAtlas::make(gl, cache));
  return WorldPass(gl, std::move(programs), std::move(atlas));
}

CacheCounts WorldPass::counts() const {
  CacheCounts counts = atlas_.counts();
  if (!method_) return counts;
  const CacheCounts light = method_->light_counts();
  counts.hits += light.hits;
  counts.uploads += light.uploads;
  counts.evicted += light.evicted;
  counts.bytes_uploaded += light.bytes_uploaded;
  return counts;
}

base::Status WorldPass::set_options(const Functions& gl, const DrawOptions& options,
                                    render::PixelFormat format) {
  if (options == options_) return base::Ok{};
  // All of them are made before one is replaced: if that fails, the old options go on.
  TRY(FacePrograms programs, FacePrograms::make(gl, options, format));
  if (options.method != options_.method) {
    TRY(method_, make_lit_method(gl, options.method, atlas_));
  }
  if (method_) method_->set_filter(gl, options.filter);
  programs_ = std::move(programs);
  options_ = options;
  return base::Ok{};
}

base::Status WorldPass::take_lit_tiles(const Functions& gl, const render::FrameContext& context,
                                       const DrawOptions& options, render::SurfaceRequests& io_requests) {
  TRY_STATUS(set_options(gl, options, context.format));
  return method_ ? method_->take(gl, context, io_requests) : base::Ok{};
}

base::Status WorldPass::prepare(const Functions& gl, const FrameInput& input) {
  TRY_STATUS(set_level(gl, input));
  TRY_STATUS(number_instances(gl, input));
  TRY_STATUS(skybox_.update(gl, input.sources));
  if (method_) TRY_STATUS(method_->prepare(gl, input));
  atlas_.begin_frame();
  for (const render::BlockRequest& built : input.record.surfaces.missing)
    atlas_.invalidate(block_key(built.block));
  const LitMethod* const lit_faces = method_ && method_->has_lit_faces() ? method_.get() : nullptr;
  faces_.collect(input, lit_faces, [this](const render::ScreenSurface& surface) {
    return mesh_.first_tile(surface.face) + record_offset_[surface.instance] +
               std::uint32_t{surface.tiles.s} * surface.tiles.t <=
           table_.capacity();
  });
  gl.BindVertexArray(mesh_.vertex_array());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_.name());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(faces_.indices().size() * sizeof(std::uint32_t)),
                faces_.indices().data(), GL_STREAM_DRAW);
  gl.BindVertexArray(0);
  portion_ = {};
  begin_portion(gl, input);
  const base::Status loaded = gl.check("loading surfaces");
  if (!loaded.ok()) {  // texels and light may be missing
    atlas_.clear();
    if (method_) method_->clear_light();
  }
  return loaded;
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

// The next portion begins with the face that the last one ended in. Tiles of a face that is in several
// portions are hidden in all but one of them.
void WorldPass::begin_portion(const Functions& gl, const FrameInput& input) {
  const std::vector<QueuedFace>& faces = faces_.faces();
  atlas_.begin_portion();
  if (method_) method_->begin_portion();
  portion_.begin = portion_.next_tile > 0 ? portion_.end - 1 : portion_.end;
  bool is_full = false;
  for (portion_.end = portion_.begin; portion_.end < faces.size() && !is_full; ++portion_.end)
    is_full = !place_face(gl, input, faces[portion_.end]);
  // A face without tiles here comes with the next portion.
  if (is_full && portion_.next_tile == 0) --portion_.end;
  CHECK(!is_full || portion_.end > portion_.begin, "an empty portion has no room for a tile");
  table_.upload(gl);
  if (method_) method_->end_portion(gl, input, atlas_);
}

std::optional<TileRecord> WorldPass::place_draw(const Functions& gl, const FrameInput& input,
                                                std::uint32_t draw) {
  if (!method_ || !method_->has_tile(input, draw)) return place_tile(gl, input, draw, atlas_);
  return method_->place(gl, input, draw, atlas_);
}

// Begins at tile portion_.next_tile. False: the portion is full, and the other tiles must wait for the next
// one, from portion_.next_tile on.
bool WorldPass::place_face(const Functions& gl, const FrameInput& input, const QueuedFace& face) {
  const std::uint32_t first = mesh_.first_tile(face.face) + record_offset_[face.instance];
  const std::uint32_t begin = std::exchange(portion_.next_tile, 0);
  bool is_full = false;
  for (std::uint32_t tile = 0; tile < face.tiles; ++tile) {
    TileRecord record;
    const std::optional<std::uint32_t> draw = find_seen_draw(input, face, tile);
    if (draw && tile >= begin && !is_full) {
      const std::optional<TileRecord> placed = place_draw(gl, input, *draw);
      is_full = !placed;
      if (is_full)
        portion_.next_tile = tile;
      else
        record = *placed;
      if (placed && face.opacity != nullptr) set_opacity(input.context, *face.opacity, record);
    }
    if (face.fragments > 0) table_.set(first + tile, record);
  }
  return !is_full;
}

const FaceProgram& WorldPass::begin_draw(const Functions& gl, const FrameInput& input, const QueuedFace& face,
                                         LitPassKind pass) const {
  using enum FaceProgramKind;
  FaceProgramKind kind = face.program;
  const bool has_fog = input.scene().fog.density > 0;
  // The programs of one tile take the distance of fog from 1/w, which parallel projection lacks.
  if (has_fog && !input.record.view.perspective) kind = without_one_tile(kind);
  const bool is_translucent = face.opacity != nullptr && face.opacity->is_translucent();
  const FaceProgram& shader =
      programs_.get(kind, has_fog, is_translucent, is_lit(kind) ? pass : LitPassKind::kWhole);
  use_face_program(gl, input, shader, atlas_.format() == TexelFormat::k16Bit);
  gl.ActiveTexture(GL_TEXTURE0 + face_units::kRecords);
  gl.BindTexture(GL_TEXTURE_2D, table_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + face_units::kAtlas);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, atlas_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + face_units::kSkybox);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, skybox_.texture());
  if (is_lit(kind)) method_->use(gl, shader, face.look);
  gl.BindVertexArray(mesh_.vertex_array());
  return shader;
}

// Draws consecutive faces of one instance with one program.
void WorldPass::draw_faces(const Functions& gl, const FrameInput& input, const FaceProgram& program,
                           std::span<const QueuedFace> faces) const {
  if (faces.empty() || faces.front().index_count == 0) return;
  const std::uint32_t instance = faces.front().instance, first_index = faces.front().first_index;
  set_face_instance(gl, input, program, instance);
  gl.Uniform1ui(program.first_record, record_offset_[instance]);
  if (is_lit(faces.front().program)) method_->use_instance(gl, program, instance);
  const std::uint32_t end_index = faces.back().first_index + faces.back().index_count;
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(end_index - first_index), GL_UNSIGNED_INT,
                  reinterpret_cast<const void*>(std::size_t{first_index} * sizeof(std::uint32_t)));
}

// Faces with the same program and texture array follow one another.
void WorldPass::draw_lit_pass(const Functions& gl, const FrameInput& input, const LitPass& pass) const {
  const std::size_t end = std::min(portion_.end, faces_.first_translucent());
  const std::span<const QueuedFace> faces(faces_.faces());
  const FaceProgram* bound = nullptr;
  const QueuedFace* before = nullptr;
  const auto has_same_textures = [](const QueuedFace& a, const QueuedFace& b) {
    return a.program == b.program && a.look == b.look;
  };
  const auto is_in_pass = [&](const QueuedFace& face) {
    if (!is_lit(face.program)) return pass.is_first;
    return pass.kind != LitPassKind::kBright || face.has_bright;
  };
  for (std::size_t begin = portion_.begin, i = begin; begin < end; begin = i) {
    const QueuedFace& first = faces[begin];
    while (i < end && faces[i].instance == first.instance && has_same_textures(faces[i], first) &&
           is_in_pass(faces[i]) == is_in_pass(first))
      ++i;
    if (!is_in_pass(first)) continue;
    if (before == nullptr || !has_same_textures(*before, first))
      bound = &begin_draw(gl, input, first, pass.kind);
    before = &first;
    draw_faces(gl, input, *bound, faces.subspan(begin, i - begin));
  }
  gl.BindVertexArray(0);
}

void WorldPass::draw_opaque_portion(const Functions& gl, const FrameInput& input) const {
  for (const LitPass& pass : find_lit_passes(options_.method)) {
    if (pass.kind == LitPassKind::kFog && !(input.scene().fog.density > 0)) continue;
    begin_lit_pass(gl, pass);
    if (pass.kind == LitPassKind::kPolygons)
      method_->draw_polygons(gl, input);
    else
      draw_lit_pass(gl, input, pass);
  }
  end_lit_passes(gl);
}

void WorldPass::draw_opaque(const Functions& gl, const FrameInput& input, const Target& target) {
  draw_opaque_portion(gl, input);
  while (!portion_.has_all_before(faces_.first_translucent())) {
    begin_portion(gl, input);
    target.bind(gl);
    draw_opaque_portion(gl, input);
  }
}

base::Status WorldPass::draw_translucent_portion(const Functions& gl, const FrameInput& input,
                                                 std::size_t number, Target& io_target) const {
  const QueuedFace& face = faces_.faces()[number];
  const std::optional<PixelRect> rect =
      input.index_tables != nullptr ? find_face_rect(input, face) : std::nullopt;
  if (face.index_count == 0 || (input.index_tables != nullptr && !rect)) return base::Ok{};
  const FaceProgram& program = begin_draw(gl, input, face, LitPassKind::kWhole);
  if (input.index_tables != nullptr) {
    const IndexBlend blend = choose_blend(input.context.colors, *face.opacity);
    TRY_STATUS(input.index_tables->use_blend(gl, program.index, blend, *rect, io_target));
  } else {
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, face.opacity->is_additive ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
  }
  gl.DepthMask(GL_FALSE);
  draw_faces(gl, input, program, {&face, 1});
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.BindVertexArray(0);
  return base::Ok{};
}

base::Status WorldPass::draw_translucent(const Functions& gl, const FrameInput& input, std::uint32_t face,
                                         Target& io_target) {
  const std::size_t number = faces_.first_translucent() + face;
  if (portion_.contains(number)) TRY_STATUS(draw_translucent_portion(gl, input, number, io_target));
  while (!portion_.has_all_before(number + 1)) {
    begin_portion(gl, input);
    io_target.bind(gl);
    if (portion_.contains(number)) TRY_STATUS(draw_translucent_portion(gl, input, number, io_target));
  }
  return base::Ok{};
}

}  // namespace temblor::render_gl
