#include "render/models/draw_sprites.h"

#include <algorithm>
#include <cmath>

#include "render/colour/blend_tables.h"

namespace temblor::render {

namespace {

constexpr std::uint8_t kClear = 255;
constexpr int kBandRows = 64;

struct PixelRange {
  int first, end;
};

// Pixels of a row whose centres the outline covers.
PixelRange pixels_of_row(const SpriteOutline& outline, int row, int width) {
  double left = width, right = 0;
  for (std::size_t i = 0; i < outline.count; ++i) {
    const math::Vec2d &from = outline.corners[i], &to = outline.corners[(i + 1) % outline.count];
    if ((from.y <= row) == (to.y <= row)) continue;
    const double x = from.x + (row - from.y) * ((to.x - from.x) / (to.y - from.y));
    left = std::min(left, x);
    right = std::max(right, x);
  }
  return {static_cast<int>(std::ceil(std::max(left, 0.0))),
          static_cast<int>(std::ceil(std::min<double>(right, width)))};
}

std::uint8_t* pixels_of(FrameBuffer& frame, std::uint8_t) {
  return frame.indexed().data();
}
std::uint32_t* pixels_of(FrameBuffer& frame, std::uint32_t) {
  return frame.rgb().data();
}

// What a texel makes of a pixel.
struct Inks {
  const SpriteBlend& blend;
  const ColourTables& tables;

  template <bool kOpaque>
  std::uint8_t over(std::uint8_t texel, std::uint8_t under) const {
    return kOpaque ? texel : blend.table[texel * 256 + under];
  }
  template <bool kOpaque>
  std::uint32_t over(std::uint8_t texel, std::uint32_t under) const {
    const std::uint32_t colour = tables.rgb[texel];
    return kOpaque ? colour : blend_rgb(colour, under, blend.opacity_256);
  }
};

// A linear function along a row. Pixel i is base + i * step, whichever band draws it.
struct RowLine {
  float base, step;
  RowLine(const ScreenPlane& plane, int x, int y)
      : base(static_cast<float>(plane.at(x, y))), step(static_cast<float>(plane.dx)) {}
  float at(int i) const { return base + static_cast<float>(i) * step; }
};

std::size_t texel_number(float coordinate, float last) {
  return static_cast<std::size_t>(std::min(std::max(coordinate, 0.0f), last));
}

template <typename Pixel, bool kAffine, bool kOpaque>
void draw_row(const SpriteQuad& quad, int row, PixelRange range, const Inks& inks, FrameBuffer& io_frame) {
  const formats::SprPicture& picture = *quad.picture;
  const RowLine own_depth(quad.depth, range.first, row);
  const RowLine s(quad.s, range.first, row), t(quad.t, range.first, row);
  const float last_s = static_cast<float>(picture.width - 1), last_t = static_cast<float>(picture.height - 1);
  const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(io_frame.width()) +
                            static_cast<std::size_t>(range.first);
  Pixel* const pixels = pixels_of(io_frame, Pixel{}) + first;
  float* const depth = io_frame.depth().data() + first;
  for (int i = 0; i < range.end - range.first; ++i) {
    const float nearness = own_depth.at(i);
    if (!(nearness >= depth[i])) continue;
    const float distance = kAffine ? 1.0f : 1.0f / nearness;
    const std::uint8_t texel = picture.texels[texel_number(t.at(i) * distance, last_t) * picture.width +
                                              texel_number(s.at(i) * distance, last_s)];
    if (texel == kClear) continue;
    pixels[i] = inks.over<kOpaque>(texel, pixels[i]);
    if (kOpaque) depth[i] = nearness;
  }
}

template <typename Pixel, bool kAffine, bool kOpaque>
void draw_rows(const SpriteQuad& quad, const Inks& inks, RowRange rows, FrameBuffer& io_frame) {
  const int end = std::min(quad.end_row, rows.end);
  for (int row = std::max(quad.first_row, rows.first); row < end; ++row)
    draw_row<Pixel, kAffine, kOpaque>(quad, row, pixels_of_row(quad.outline, row, io_frame.width()), inks,
                                      io_frame);
}

template <typename Pixel>
void draw_quad(const SpriteQuad& quad, const Inks& inks, RowRange rows, FrameBuffer& io_frame) {
  const bool opaque = inks.blend.is_opaque(io_frame.format());
  if (quad.affine)
    opaque ? draw_rows<Pixel, true, true>(quad, inks, rows, io_frame)
           : draw_rows<Pixel, true, false>(quad, inks, rows, io_frame);
  else
    opaque ? draw_rows<Pixel, false, true>(quad, inks, rows, io_frame)
           : draw_rows<Pixel, false, false>(quad, inks, rows, io_frame);
}

}  // namespace

void draw_sprite_instance(const SpriteQuad& quad, const SpriteBlend& blend, const ColourTables& tables,
                          RowRange rows, FrameBuffer& io_frame) {
  const Inks inks{blend, tables};
  if (io_frame.format() == PixelFormat::kIndexed)
    draw_quad<std::uint8_t>(quad, inks, rows, io_frame);
  else
    draw_quad<std::uint32_t>(quad, inks, rows, io_frame);
}

void draw_sprites(const Scene& scene, const ViewFrame& view, const ColourTables& tables, base::Jobs& jobs,
                  base::Arena& arena, FrameBuffer& io_frame) {
  base::ArenaVector<SpriteQuad> quads(arena, scene.sprites.size());
  for (const SpriteInstance& sprite : scene.sprites) {
    if (sprite.alpha < 1) continue;
    if (const std::optional<SpriteQuad> quad = make_sprite_quad(view, sprite)) quads.push_back(*quad);
  }
  if (quads.empty()) return;
  const int bands = (view.height + kBandRows - 1) / kBandRows;
  jobs.parallel_for(static_cast<std::size_t>(bands), [&](std::size_t number) {
    const int first_row = static_cast<int>(number) * kBandRows;
    const RowRange rows{first_row, std::min(first_row + kBandRows, view.height)};
    for (const SpriteQuad& quad : quads) draw_sprite_instance(quad, {}, tables, rows, io_frame);
  });
}

}  // namespace temblor::render
