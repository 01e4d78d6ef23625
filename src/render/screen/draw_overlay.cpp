// Draws row by row: a pixel of a picture becomes a run of `scale` pixels, clipped at the sides of the frame.
// The other rows of an opaque picture's pixel are copies of the first.
#include "render/screen/draw_overlay.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "render/screen/overlay_geometry.h"

namespace temblor::render {

namespace {

constexpr std::uint8_t kClear = 255;

// The rows [first, end) of the frame, drawn by one job.
struct Rows {
  std::int64_t first, end;
};

OverlayClip clip_to_rows(const DrawCommand& command, const FrameBuffer& frame, const Rows& rows) {
  return clip_command(command, {0, frame.width(), rows.first, rows.end});
}

// The product of each channel, as a share of 255, times a factor; up to 255.
constexpr std::uint8_t multiply_channel(std::uint32_t a, std::uint32_t b, std::uint32_t factor) {
  return static_cast<std::uint8_t>(std::min((a * b * factor + 127) / 255, 255u));
}
formats::Rgb multiply_colors(const formats::Rgb& a, const formats::Rgb& b, std::uint32_t factor) {
  return {multiply_channel(a.r, b.r, factor), multiply_channel(a.g, b.g, factor),
          multiply_channel(a.b, b.b, factor)};
}
std::uint32_t multiply_rgb(std::uint32_t a, std::uint32_t b, std::uint32_t factor) {
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8)
    out |= std::uint32_t{multiply_channel(a >> shift & 255, b >> shift & 255, factor)} << shift;
  return out;
}
// 0: the mode does not multiply.
constexpr std::uint32_t product_factor(DrawMode mode) {
  return mode == DrawMode::kMultiply ? 1 : mode == DrawMode::kMultiplyTwice ? 2 : 0;
}

// The opacity of 0xAARRGGBB. An alpha of 255 is opaque.
constexpr int find_alpha_256(std::uint32_t color) {
  return static_cast<int>((color >> 24) + (color >> 31));
}

// Writes runs of a palette index to the frame: opaque, blended, added, or multiplied.
class IndexedPaint {
 public:
  IndexedPaint(const DrawCommand& command, const ColorTables& tables)
      : tables_(tables),
        opacity_256_(opacity_256(command.opacity)),
        adds_(command.mode == DrawMode::kAdd),
        factor_(product_factor(command.mode)),
        table_(choose_table(command, tables.blends)),
        translation_(command.tint != nullptr ? &command.tint->indices : command.translation) {}

  // Whether nothing under the picture shows through.
  bool is_opaque() const { return factor_ == 0 && table_ == nullptr; }

  static std::uint8_t* row(FrameBuffer& frame, std::int64_t y) {
    return frame.indexed().data() + y * frame.width();
  }
  void fill(std::uint8_t index, std::uint8_t* first, std::uint8_t* end) const {
    if (translation_ != nullptr) index = (*translation_)[index];
    if (factor_ != 0)
      for (; first != end; ++first) *first = multiply(index, *first, opacity_256_);
    else if (table_ == nullptr)
      std::fill(first, end, index);
    else  // `table_` could change with each pixel that is written, a local pointer cannot
      for (const std::uint8_t* const blends = table_ + index * 256; first != end; ++first)
        *first = blends[*first];
  }
  // The texel's own opacity counts, too.
  void put_detail(const formats::PictureDetail& detail, std::size_t texel, std::uint8_t* pixel) const {
    const std::uint8_t index = detail.indices[texel];
    if (index == kClear) return;
    const int share_256 = find_alpha_256(detail.colors[texel]) * opacity_256_ / kOpaque256;
    if (detail.colors[texel] >> 24 == 255)
      fill(index, pixel, pixel + 1);
    else
      *pixel = combine(translation_ != nullptr ? (*translation_)[index] : index, *pixel, share_256);
  }

 private:
  static const std::uint8_t* choose_table(const DrawCommand& command, const BlendTables& blends) {
    if (command.mode == DrawMode::kAdd) return blends.sums();
    return command.opacity < 1 ? blends.table_for(command.opacity) : nullptr;
  }
  // The nearest palette entry. No light changes it later, so full-bright ones may be used.
  std::uint8_t multiply(std::uint8_t over, std::uint8_t under, int share_256) const {
    const formats::Rgb& below = tables_.palette[under];
    const formats::Rgb product = multiply_colors(tables_.palette[over], below, factor_);
    return tables_.match(blend_colors(product, below, share_256), true);
  }
  std::uint8_t blend(std::uint8_t over, std::uint8_t under, int share_256) const {
    constexpr int kHalfStep = kOpaque256 / BlendTables::kSteps / 2;
    if (share_256 < kHalfStep) return under;
    if (share_256 >= kOpaque256 - kHalfStep) return over;
    const float opacity = static_cast<float>(share_256) / kOpaque256;
    return tables_.blends.table_for(opacity)[over * 256 + under];
  }
  std::uint8_t combine(std::uint8_t over, std::uint8_t under, int share_256) const {
    if (factor_ != 0) return multiply(over, under, share_256);
    if (adds_) return table_[blend(over, tables_.black, share_256) * 256 + under];
    return blend(over, under, share_256);
  }

  const ColorTables& tables_;
  int opacity_256_;
  bool adds_;
  std::uint32_t factor_;       // of products; 0: none
  const std::uint8_t* table_;  // null: opaque
  const ColorTranslation* translation_;
};

class RgbPaint {
 public:
  RgbPaint(const DrawCommand& command, const ColorTables& tables)
      : opacity_256_(opacity_256(command.opacity)),
        mode_(command.mode),
        tint_(command.tint != nullptr ? to_rgb(command.tint->factor) : kWhite),
        colors_(command.tint != nullptr ? command.tint->rgb : tables.rgb),
        translation_(command.tint == nullptr ? command.translation : nullptr) {}

  bool is_opaque() const { return mode_ == DrawMode::kBlend && opacity_256_ == kOpaque256; }

  static std::uint32_t* row(FrameBuffer& frame, std::int64_t y) {
    return frame.rgb().data() + y * frame.width();
  }
  void fill(std::uint8_t index, std::uint32_t* first, std::uint32_t* end) const {
    const std::uint32_t color = colors_[translation_ != nullptr ? (*translation_)[index] : index];
    const int share_256 = opacity_256_;  // local, like `blends` above
    if (mode_ != DrawMode::kBlend)
      for (; first != end; ++first) *first = combine(color, *first, share_256);
    else if (share_256 == kOpaque256)
      std::fill(first, end, color);
    else
      for (; first != end; ++first) *first = blend_rgb(color, *first, share_256);
  }
  void put_detail(const formats::PictureDetail& detail, std::size_t texel, std::uint32_t* pixel) const {
    const std::uint32_t color = detail.colors[texel];
    const std::uint32_t tinted = tint_ == kWhite ? color : multiply_rgb(color, tint_, 1);
    *pixel = combine(tinted, *pixel, find_alpha_256(color) * opacity_256_ / kOpaque256);
  }

 private:
  static constexpr std::uint32_t kWhite = 0xffffffffu, kBlack = 0xff000000u;

  std::uint32_t combine(std::uint32_t over, std::uint32_t under, int share_256) const {
    switch (mode_) {
      case DrawMode::kAdd:
        return add_rgb(blend_rgb(over, kBlack, share_256), under);
      case DrawMode::kMultiply:
      case DrawMode::kMultiplyTwice:
        return blend_rgb(multiply_rgb(over, under, product_factor(mode_)), under, share_256);
      case DrawMode::kBlend:
        break;
    }
    return blend_rgb(over, under, share_256);
  }

  int opacity_256_;
  DrawMode mode_;
  std::uint32_t tint_;
  const std::array<std::uint32_t, 256>& colors_;
  const ColorTranslation* translation_;
};

template <typename Paint>
void fill_rectangle(const DrawCommand& command, const OverlayClip& clip, const Paint& paint,
                    FrameBuffer& io_frame) {
  for (std::int64_t y = clip.y_first; y < clip.y_end; ++y) {
    auto* const row = Paint::row(io_frame, y);
    paint.fill(command.fill, row + clip.x_first, row + clip.x_end);
  }
}

// Copies the opaque pixels of [x_first, x_end) from the row above, which shows the same pixels of the
// picture. `source` is the one at x_first, which is shown up to `run_end`.
template <typename Pixel>
void copy_row_above(const std::uint8_t* source, std::int64_t run_end, const OverlayClip& clip,
                    std::int64_t scale, const Pixel* above, Pixel* io_row) {
  std::int64_t opaque_first = clip.x_first;
  const auto copy_up_to = [&](std::int64_t x) {
    if (opaque_first < x) std::copy(above + opaque_first, above + x, io_row + opaque_first);
  };
  for (std::int64_t x = clip.x_first; x < clip.x_end; x = run_end, run_end += scale, ++source) {
    if (*source != kClear) continue;
    copy_up_to(x);
    opaque_first = run_end;
  }
  copy_up_to(clip.x_end);
}

template <typename Paint>
void draw_picture(const DrawCommand& command, const OverlayClip& clip, const Paint& paint,
                  FrameBuffer& io_frame) {
  const formats::Picture& picture = *command.picture;
  const std::int64_t left = command.area.x, top = command.area.y, scale = command.scale;
  // The first run may begin left of the frame, so it may be shorter than `scale`.
  const std::int64_t first_column = (clip.x_first - left) / scale;
  const std::int64_t first_run_end = left + (first_column + 1) * scale;
  for (std::int64_t y = clip.y_first; y < clip.y_end; ++y) {
    const std::uint8_t* source = picture.pixels.data() +
                                 (command.part_y + (y - top) / scale) * std::int64_t{picture.width} +
                                 command.part_x + first_column;
    auto* const row = Paint::row(io_frame, y);
    const bool begins_texel = (y - top) % scale == 0 || y == clip.y_first;
    if (!begins_texel && paint.is_opaque()) {
      copy_row_above(source, first_run_end, clip, scale, Paint::row(io_frame, y - 1), row);
      continue;
    }
    std::int64_t run_end = first_run_end;
    for (std::int64_t x = clip.x_first; x < clip.x_end; x = run_end, run_end += scale, ++source) {
      if (*source == kClear) continue;
      paint.fill(*source, row + x, row + std::min(run_end, clip.x_end));
    }
  }
}

// Each pixel shows the pixel of the part that is under its center.
template <typename Paint>
void draw_stretched(const DrawCommand& command, const OverlayClip& clip, const Paint& paint,
                    FrameBuffer& io_frame) {
  const formats::Picture& picture = *command.picture;
  const auto find_source = [](std::int64_t offset, std::int64_t part, std::int64_t size) {
    return (2 * offset + 1) * part / (2 * size);
  };
  for (std::int64_t y = clip.y_first; y < clip.y_end; ++y) {
    const std::int64_t source_y =
        command.part_y + find_source(y - command.area.y, command.part_height, command.area.height);
    const std::uint8_t* const source =
        picture.pixels.data() + source_y * std::int64_t{picture.width} + command.part_x;
    auto* const row = Paint::row(io_frame, y);
    for (std::int64_t x = clip.x_first; x < clip.x_end; ++x) {
      const std::uint8_t index =
          source[find_source(x - command.area.x, command.part_width, command.area.width)];
      if (index != kClear) paint.fill(index, row + x, row + x + 1);
    }
  }
}

// The texel of the detail under each pixel's center.
template <typename Paint>
void draw_detail(const DrawCommand& command, const OverlayClip& clip, const Paint& paint,
                 FrameBuffer& io_frame) {
  const formats::Picture& picture = *command.picture;
  const formats::PictureDetail& detail = *picture.detail;
  const OverlayPart shown = find_part(command);
  const auto find_texel = [](std::int64_t offset, std::int64_t first, std::int64_t part, std::int64_t size,
                             std::int64_t picture_side, std::int64_t detail_side) {
    return ((2 * offset + 1) * part + 2 * size * first) * detail_side / (2 * size * picture_side);
  };
  for (std::int64_t y = clip.y_first; y < clip.y_end; ++y) {
    const std::int64_t row_texel = find_texel(y - command.area.y, command.part_y, shown.height,
                                              command.area.height, picture.height, detail.height);
    auto* const row = Paint::row(io_frame, y);
    for (std::int64_t x = clip.x_first; x < clip.x_end; ++x) {
      const std::int64_t texel =
          row_texel * detail.width + find_texel(x - command.area.x, command.part_x, shown.width,
                                                command.area.width, picture.width, detail.width);
      paint.put_detail(detail, static_cast<std::size_t>(texel), row + x);
    }
  }
}

template <typename Paint>
void draw_rows(const DrawList& list, const ColorTables& tables, const Rows& rows, FrameBuffer& io_frame) {
  for (const DrawCommand& command : list.commands) {
    const OverlayClip clip = clip_to_rows(command, io_frame, rows);
    if (clip.is_empty() || !(command.opacity > 0)) continue;
    const Paint paint(command, tables);
    if (shows_detail(command))
      draw_detail(command, clip, paint, io_frame);
    else if (command.picture != nullptr && is_stretched(command))
      draw_stretched(command, clip, paint, io_frame);
    else if (command.picture != nullptr)
      draw_picture(command, clip, paint, io_frame);
    else
      fill_rectangle(command, clip, paint, io_frame);
  }
}

}  // namespace

void draw_overlay(const DrawList& list, const ColorTables& tables, base::Jobs* jobs, FrameBuffer& io_frame) {
  check_commands(list);
  const auto draw =
      io_frame.format() == PixelFormat::kIndexed ? draw_rows<IndexedPaint> : draw_rows<RgbPaint>;
  const std::int64_t height = io_frame.height();
  if (jobs == nullptr) return draw(list, tables, {0, height}, io_frame);
  // Many bands, because most of an overlay lies in a few rows: the status bar's.
  const auto bands = std::min<std::int64_t>(height, std::int64_t{jobs->threads()} * 16);
  jobs->parallel_for(static_cast<std::size_t>(bands), [&](std::size_t i) {
    const auto band = static_cast<std::int64_t>(i);
    draw(list, tables, {height * band / bands, height * (band + 1) / bands}, io_frame);
  });
}

}  // namespace temblor::render
