#include "lab/models/model_sprites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "lab/models/draw_before_others.h"
#include "lab/models/model_jobs.h"
#include "lab/models/sprite_kernels.h"
#include "render/alias/fill_alias.h"
#include "render/alias_model.h"

namespace temblor::lab {

namespace {

// Elements after the last pixel that kernels may touch.
constexpr std::size_t kSpare = 64;

// A picture may be larger than the screen by this factor.
constexpr double kMaxSizes = 2;

struct Middle {
  math::Vec2d screen{0.0};
  double nearness = 0;  // 1/z
};

struct Sprite {
  const render::AliasModel* model = nullptr;
  std::vector<std::uint8_t> indexed;  // one of the two is empty
  std::vector<std::uint32_t> rgb;
  std::vector<float> depth;
  int left = 0, top = 0, width = 0, height = 0;  // where it was drawn
  Middle made, now;
  std::uint64_t used_frame = 0;

  void* pixels() { return rgb.empty() ? static_cast<void*>(indexed.data()) : rgb.data(); }
};

Middle find_middle(const render::ViewFrame& view, const render::AliasPlacement& placement) {
  const render::AliasInstance& instance = *placement.instance;
  const math::Bounds& bounds = render::model_bounds(*instance.model);
  const math::Vec3d middle = math::Vec3d(bounds.mins + bounds.maxs) * (0.5 * double{instance.scale});
  const math::Vec3d at_view = view.to_view(math::Vec3d(instance.origin_world) + placement.x_axis * middle.x +
                                           placement.y_axis * middle.y + placement.z_axis * middle.z);
  return {view.to_screen(at_view), 1 / at_view.z};
}

class ModelSprites {
 public:
  explicit ModelSprites(int frames) : frames_(static_cast<std::uint64_t>(frames)) {}

  std::span<const render::PreparedAlias> prepare(const render::FrameContext& context,
                                                 const render::ViewFrame& view);
  // One thread or several, for different rows.
  void draw(bool simd_kernels, render::RowRange rows, render::FrameBuffer& io_frame);
  std::size_t used_bytes() const;

 private:
  // Pictures also depend on these.
  struct Conditions {
    int width = 0, height = 0;
    double pixels_per_unit = 0;
    render::PixelFormat format{};
    bool operator==(const Conditions&) const = default;
  };

  Sprite* find_sprite(const render::FrameContext& context, const render::ViewFrame& view,
                      const render::AliasPlacement& placement);
  bool is_usable(const Sprite& sprite, const render::AliasPlacement& placement, std::size_t number) const;
  void make_pictures(const render::FrameContext& context, std::span<const render::AliasPlacement> placements,
                     std::span<const render::PreparedAlias> prepared, std::span<Sprite* const> sprites);
  void make_picture(const render::FrameContext& context, const render::AliasPlacement& placement,
                    const render::PreparedAlias& prepared, base::Arena& scratch, Sprite& io_sprite);

  const std::uint64_t frames_;
  std::uint64_t frame_ = 0;
  Conditions conditions_;
  std::vector<Sprite> sprites_;      // by number of the instance
  std::vector<base::Arena> arenas_;  // by job
  std::span<Sprite* const> drawn_;   // in this frame
};

bool ModelSprites::is_usable(const Sprite& sprite, const render::AliasPlacement& placement,
                             std::size_t number) const {
  const bool is_its_turn = (frame_ + number) % frames_ == 0;
  return sprite.model == placement.instance->model && sprite.used_frame + 1 == frame_ && !is_its_turn;
}

// Null: the model is drawn as triangles.
Sprite* ModelSprites::find_sprite(const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::AliasPlacement& placement) {
  if (placement.instance == context.scene.view_weapon || placement.needs_clipping || !view.perspective)
    return nullptr;
  const render::AliasInstance& instance = *placement.instance;
  const math::Bounds& bounds = render::model_bounds(*instance.model);
  const double size_px = glm::length(math::Vec3d(bounds.maxs - bounds.mins)) * double{instance.scale} *
                         placement.largest_pixels_per_unit;
  if (!(size_px < kMaxSizes * view.width)) return nullptr;
  return &sprites_[static_cast<std::size_t>(placement.instance - context.scene.alias_models.data())];
}

// The picture encloses the vertices, also those outside of the screen. The model is moved to the picture's
// corner, so that rows are as short as the picture's.
void ModelSprites::make_picture(const render::FrameContext& context, const render::AliasPlacement& placement,
                                const render::PreparedAlias& prepared, base::Arena& scratch,
                                Sprite& io_sprite) {
  const std::span<const render::ScreenVertex> vertices(prepared.job.vertices, prepared.job.vertex_count);
  const auto [left, right] = std::ranges::minmax(vertices, {}, &render::ScreenVertex::x);
  const auto [top, bottom] = std::ranges::minmax(vertices, {}, &render::ScreenVertex::y);
  io_sprite.model = placement.instance->model;
  io_sprite.made = io_sprite.now;
  io_sprite.left = (left.x >> 8) - 1;
  io_sprite.top = (top.y >> 8) - 1;
  io_sprite.width = (right.x >> 8) + 2 - io_sprite.left;
  io_sprite.height = (bottom.y >> 8) + 2 - io_sprite.top;
  const std::size_t pixels =
      static_cast<std::size_t>(io_sprite.width) * static_cast<std::size_t>(io_sprite.height) + kSpare;
  io_sprite.indexed.resize(context.is_indexed() ? pixels : 0);
  io_sprite.rgb.resize(context.is_indexed() ? 0 : pixels);
  io_sprite.depth.assign(pixels, -std::numeric_limits<float>::infinity());
  const std::span<render::ScreenVertex> moved = scratch.allocate<render::ScreenVertex>(vertices.size());
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = vertices[i];
    moved[i].x -= io_sprite.left * render::kSubpixels;
    moved[i].y -= io_sprite.top * render::kSubpixels;
  }
  render::PreparedAlias alone = prepared;
  alone.job.vertices = moved.data();
  if (context.settings.simd_kernels && !alone.by_subdivision) {
    const std::size_t room = alone.job.triangle_count + render::kFrontsSpare;
    alone.job.fronts.numbers = scratch.allocate<std::uint32_t>(room).data();
    alone.job.fronts.rows = scratch.allocate<render::TriangleRows>(room).data();
    render::find_front_triangles_simd(alone.job, alone.job.fronts);
  }
  render::fill_alias(alone, context.format, context.settings.simd_kernels,
                     {io_sprite.pixels(), io_sprite.depth.data(), io_sprite.width, 0, 0, io_sprite.height});
}

void ModelSprites::make_pictures(const render::FrameContext& context,
                                 std::span<const render::AliasPlacement> placements,
                                 std::span<const render::PreparedAlias> prepared,
                                 std::span<Sprite* const> sprites) {
  for_each_model(context, prepared.size(), arenas_, [&](std::size_t i, base::Arena& io_arena) {
    if (sprites[i] != nullptr) make_picture(context, placements[i], prepared[i], io_arena, *sprites[i]);
  });
}

// Prepares only the models that are drawn as triangles, into the frame or into a picture.
std::span<const render::PreparedAlias> ModelSprites::prepare(const render::FrameContext& context,
                                                             const render::ViewFrame& view) {
  base::Arena& arena = context.arena();
  const Conditions conditions{view.width, view.height, view.pixels_per_unit, context.format};
  frame_ += conditions == conditions_ ? 1 : 2;  // pictures of the frame before last are not usable
  conditions_ = conditions;
  if (sprites_.size() < context.scene.alias_models.size()) sprites_.resize(context.scene.alias_models.size());
  const std::span<const render::AliasPlacement> all = render::place_alias_models(context.scene, view, arena);
  base::ArenaVector<render::AliasPlacement> placements(arena, all.size() + 1);
  base::ArenaVector<Sprite*> made(arena, all.size() + 1), drawn(arena, all.size() + 1);
  for (const render::AliasPlacement& placement : all) {
    Sprite* const sprite = find_sprite(context, view, placement);
    bool is_old = false;
    if (sprite != nullptr) {
      sprite->now = find_middle(view, placement);
      is_old = is_usable(*sprite, placement, static_cast<std::size_t>(sprite - sprites_.data()));
      sprite->used_frame = frame_;
      drawn.push_back(sprite);
    }
    if (is_old) continue;
    placements.push_back(placement);
    made.push_back(sprite);
  }
  drawn_ = drawn.view();
  const std::span<const render::PreparedAlias> prepared =
      render::prepare_placed_models(context, view, placements.view());
  make_pictures(context, placements.view(), prepared, made.view());
  base::ArenaVector<render::PreparedAlias> direct(arena, prepared.size() + 1);
  for (std::size_t i = 0; i < prepared.size(); ++i)
    if (made[i] == nullptr) direct.push_back(prepared[i]);
  return direct.view();
}

void ModelSprites::draw(bool simd_kernels, render::RowRange rows, render::FrameBuffer& io_frame) {
  const bool is_indexed = io_frame.format() == render::PixelFormat::kIndexed;
  const std::int64_t width = io_frame.width();
  for (Sprite* const sprite : drawn_) {
    const math::Vec2d move = sprite->now.screen - sprite->made.screen;
    const int left = sprite->left + static_cast<int>(std::lround(move.x));
    const int top = sprite->top + static_cast<int>(std::lround(move.y));
    const int first_x = std::max(left, 0), end_x = std::min(left + sprite->width, io_frame.width());
    const int first_y = std::max(top, rows.first), end_y = std::min(top + sprite->height, rows.end);
    if (first_x >= end_x || first_y >= end_y) continue;
    const std::int64_t from = std::int64_t{first_y - top} * sprite->width + (first_x - left);
    const std::int64_t to = first_y * width + first_x;
    SpriteRows job{};
    job.depth = sprite->depth.data() + from;
    job.depth_scale = static_cast<float>(sprite->now.nearness / sprite->made.nearness);
    job.out_depth = io_frame.depth().data() + to;
    job.stride = sprite->width;
    job.out_stride = width;
    job.width = end_x - first_x;
    job.height = end_y - first_y;
    if (is_indexed) {
      job.pixels = sprite->indexed.data() + from;
      job.out_pixels = io_frame.indexed().data() + to;
      simd_kernels ? draw_sprite_u8_simd(job) : draw_sprite_u8_scalar(job);
    } else {
      job.pixels = sprite->rgb.data() + from;
      job.out_pixels = io_frame.rgb().data() + to;
      simd_kernels ? draw_sprite_u32_simd(job) : draw_sprite_u32_scalar(job);
    }
  }
}

std::size_t ModelSprites::used_bytes() const {
  std::size_t bytes = 0;
  for (const Sprite* const sprite : drawn_)
    bytes += sprite->indexed.size() + sizeof(std::uint32_t) * sprite->rgb.size() +
             sizeof(float) * sprite->depth.size();
  return bytes;
}

}  // namespace

render::FrameStages make_model_sprites(std::span<const double> values, Counter* counter) {
  return draw_before_others(std::make_shared<ModelSprites>(static_cast<int>(values[0])), counter);
}

}  // namespace temblor::lab
