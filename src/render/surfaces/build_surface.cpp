#include "render/surfaces/build_surface.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "render/color/own_colors.h"
#include "render/color/warped_rows.h"
#include "render/edges/edge_table.h"
#include "render/surfaces/build_kernels.h"
#include "render/surfaces/cutout_textures.h"
#include "render/surfaces/light/block_light.h"

namespace temblor::render {

namespace {

// Half a row of tint tables.
constexpr std::int16_t kRoundTint = 128;

// Visits a texture that repeats endlessly, row by row.
class TextureRows {
 public:
  // Starts at texel (s, t); both may be negative.
  TextureRows(const world::Texture& texture, int mip, std::int64_t s, std::int64_t t)
      : width_(std::max<std::size_t>(1, at_mip(texture.width, mip))),
        height_(std::max<std::size_t>(1, at_mip(texture.height, mip))),
        column_(wrapped(s, width_)),
        row_(wrapped(t, height_)) {}

  // Passes the row's first `count` texels to `each_run(position, texel, texel_count)`, in runs that do not
  // cross the edge of the texture. `texel` counts from the texture's first one.
  template <typename EachRun>
  void visit_row(std::size_t count, EachRun each_run) const {
    for (std::size_t done = 0, column = column_; done < count; column = 0) {
      const std::size_t run = std::min(count - done, width_ - column);
      each_run(done, row_ * width_ + column, run);
      done += run;
    }
  }
  void next_row() {
    if (++row_ == height_) row_ = 0;
  }

 private:
  static std::size_t wrapped(std::int64_t value, std::size_t size) {
    const auto period = static_cast<std::int64_t>(size);
    return static_cast<std::size_t>((value % period + period) % period);
  }
  std::size_t width_, height_, column_, row_;
};

std::int32_t interpolate(std::int32_t from, std::int32_t to, std::int32_t fraction_q15) {
  return from + (((to - from) * fraction_q15 + 16384) >> 15);
}

// Builds one block. Members are computed in the order of declaration and depend on earlier ones.
class Builder {
 public:
  Builder(const world::Level& level, const ColorTables& tables, const MarkTables* mark_tables,
          const BlockRequest& request, bool simd_kernels, base::Arena& scratch)
      : level_(level),
        tables_(tables),
        mark_tables_(mark_tables),
        request_(request),
        simd_(simd_kernels),
        scratch_(scratch),
        face_(level.face(request.face)),
        grids_(choose_block_grids(level, request)),
        grid_(grids_.shown),
        drawn_(request.texture != nullptr ? *request.texture : level.texture(request.contents.texture)),
        texture_(drawn_, request.mip, first_texel(0), first_texel(1)),
        indices_(drawn_.indices(request.mip).data()),
        own_(own_colors(drawn_, request.mip)),
        glow_(shows_only_light() ? nullptr : own_.glow),
        marks_(place_marks(level, face_, request.marks,
                           {request.tile_s, request.tile_t, request.mip, request.block.shape}, scratch)) {
    if (face_.kind == world::FaceKind::kLiquid)
      warped_.emplace(drawn_, request.mip, first_texel(0), first_texel(1), width(),
                      request.contents.warp_phase, scratch);
  }

  // Row by row: texels, marks on them, light for the row, then the kernel.
  void build_indexed() {
    const LightSums sums = sum_block_light(level_, request_, grids_, scratch_);
    const std::span<const std::int16_t> samples = make_dark_samples(sums, columns(), scratch_);
    const std::span<std::int16_t> row_light = row_samples(1);
    const Tint tint = sums.channels == 3 ? make_tint(sums) : Tint{};
    const std::span<std::int16_t> row_tint = row_samples(1);
    const std::span<std::uint8_t> texels = row_of_texels<std::uint8_t>();
    // Without marks, which must not cover holes.
    const std::span<std::uint8_t> unmarked = row_of_texels<std::uint8_t>();
    auto* out = reinterpret_cast<std::uint8_t*>(request_.block.texels);
    for (std::int32_t y = 0; y < request_.block.shape.height; ++y, out += request_.block.shape.width) {
      begin_row(y);
      copy_row(indices_, texels);
      if (shows_only_light()) replace_texels(texels, texels, tables_.gray);
      if (has_holes()) std::copy_n(texels.begin(), width(), unmarked.begin());
      if (!marks_.empty()) paint_marks(*mark_tables_, marks_, y, texels);
      interpolate_down(samples, 1, y, row_light);
      const IndexedRow row{texels.data(), row_light.data(),           tables_.colormap.rows.data(),
                           out,           request_.block.shape.width, texels_per_sample()};
      build_indexed_row(row);
      if (tint.rows != nullptr) {
        interpolate_down(tint.samples, 1, y, row_tint);
        // Both kernels read a texel before they write it, so the row can be replaced in place.
        build_indexed_row({out, row_tint.data(), tint.rows, out, row.count, row.texels_per_sample});
      }
      if (has_holes())
        for (std::size_t x = 0; x < width(); ++x)
          if (unmarked[x] == kClearIndex) out[x] = kClearIndex;
    }
  }

  void build_rgb() {
    const std::span<const std::int16_t> samples =
        make_rgb_samples(sum_block_light(level_, request_, grids_, scratch_), columns(), scratch_);
    const std::span<std::int16_t> row_light = row_samples(4);
    const std::span<std::uint32_t> colors = row_of_texels<std::uint32_t>();
    const std::span<std::uint8_t> indices = row_of_texels<std::uint8_t>();
    const std::span<std::uint32_t> glow = row_of_texels<std::uint32_t>();
    auto* out = reinterpret_cast<std::uint32_t*>(request_.block.texels);
    for (std::int32_t y = 0; y < request_.block.shape.height; ++y, out += request_.block.shape.width) {
      begin_row(y);
      if (own_.colors != nullptr)
        copy_row(own_.colors, colors);
      else
        copy_row(indices_, colors, [table = tables_.surface_rgb.data()](std::uint8_t i) { return table[i]; });
      if (has_holes()) copy_row(indices_, indices);
      if (glow_ != nullptr) copy_row(glow_, glow);
      if (shows_only_light()) replace_texels(indices, colors, tables_.surface_rgb[tables_.gray]);
      if (!marks_.empty()) paint_marks(*mark_tables_, marks_, y, colors);
      interpolate_down(samples, 4, y, row_light);
      const RgbRow row{colors.data(), row_light.data(), out, request_.block.shape.width, texels_per_sample()};
      simd_ ? build_rgb_row_simd(row) : build_rgb_row_scalar(row);
      if (glow_ != nullptr) add_glow(glow, y, out);
      if (has_holes())
        for (std::size_t x = 0; x < width(); ++x)
          if (indices[x] == kClearIndex) out[x] = 0;
    }
  }

 private:
  std::int32_t texels_per_sample() const { return at_mip(grid_.texels, request_.mip); }
  bool has_holes() const { return drawn_.kind == world::TextureKind::kCutout; }
  bool shows_only_light() const { return request_.contents.light_view == LightView::kLightOnly; }
  // Replaces all texels of a row except for holes.
  template <typename Texel>
  void replace_texels(std::span<const std::uint8_t> indices, std::span<Texel> io_texels, Texel color) const {
    for (std::size_t x = 0; x < width(); ++x)
      if (!has_holes() || indices[x] != kClearIndex) io_texels[x] = color;
  }

  // Adds row `y` of the glow to the lit texels. Marks cover it as they cover full-bright texels.
  void add_glow(std::span<std::uint32_t> io_glow, std::int32_t y, std::uint32_t* io_out) const {
    if (!marks_.empty()) {
      for (std::uint32_t& texel : io_glow.first(width()))
        if (texel == 0) texel = 0xff000000u;  // does not glow
      paint_marks(*mark_tables_, marks_, y, io_glow);
      for (std::uint32_t& texel : io_glow.first(width()))
        if (texel >> 24 != 0) texel = 0;
    }
    for (std::size_t x = 0; x < width(); ++x) io_out[x] = add_saturated(io_out[x], io_glow[x]);
  }

  // The tile's first texel along an axis. Faces start at multiples of 16 texels, so every mip level starts at
  // a whole texel.
  std::int64_t first_texel(std::size_t axis) const {
    const std::int64_t tile = axis == 0 ? request_.tile_s : request_.tile_t;
    return at_mip(face_.texture_mins[axis] + tile * kTileTexels, request_.mip);
  }
  // Goes to row y of the texture; row y - 1 was the last one.
  void begin_row(std::int32_t y) {
    if (warped_)
      warped_texels_ = warped_->row(y);
    else if (y > 0)
      texture_.next_row();
  }
  // Copies the row's values of an image with one value for each texel of the mip level.
  template <typename From, typename To, typename Convert = std::identity>
  void copy_row(const From* from, std::span<To> out, Convert convert = {}) const {
    for (std::size_t x = 0; x < warped_texels_.size(); ++x) out[x] = convert(from[warped_texels_[x]]);
    if (warped_) return;
    texture_.visit_row(width(), [&](std::size_t x, std::size_t texel, std::size_t count) {
      std::transform(from + texel, from + texel + count, &out[x], convert);
    });
  }

  std::size_t width() const { return static_cast<std::size_t>(request_.block.shape.width); }
  // Longer than a row, since kernels may read past its end.
  template <typename Texel>
  std::span<Texel> row_of_texels() {
    return scratch_.allocate<Texel>(width() + kBlockPadding);
  }

  void build_indexed_row(const IndexedRow& row) const {
    simd_ ? build_indexed_row_simd(row) : build_indexed_row_scalar(row);
  }

  // The color of the tile's strongest colored light, and how far it dominates each sample.
  struct Tint {
    const std::uint8_t* rows = nullptr;  // null: no colored light
    std::span<const std::int16_t>
        samples{};  // row of the table times 256, rounded when its high byte is taken
  };

  // White light w and a colored light a * color, whose largest channel is 1 and smallest m, sum to w + a in
  // the brightest channel and w + a * m in the darkest. The share a / (w + a) follows from these two.
  Tint make_tint(const LightSums& sums) {
    const FaceLight* strongest = nullptr;
    for (const FaceLight& light : request_.lights)
      if (has_color(light) && (strongest == nullptr || light.at_nearest > strongest->at_nearest))
        strongest = &light;
    if (strongest == nullptr) return {};
    const auto [smallest, largest] = std::minmax_element(strongest->color.begin(), strongest->color.end());
    const float full_difference = 1 - *smallest / *largest;
    const std::size_t count = sums.values.size() / sums.channels;
    const std::span<std::int16_t> samples =
        scratch_.allocate_filled<std::int16_t>(count + columns(), kRoundTint);
    for (std::size_t sample = 0; sample < count; ++sample) {
      const std::uint32_t* sum = &sums.values[sample * sums.channels];
      const auto [least, most] = std::minmax_element(sum, sum + sums.channels);
      if (*most == 0) continue;
      const float share = static_cast<float>(*most - *least) / (static_cast<float>(*most) * full_difference);
      samples[sample] =
          static_cast<std::int16_t>(std::min(share, 1.0f) * float{(kTintRows - 1) * 256} + kRoundTint);
    }
    return {tables_.tints.rows_for(strongest->color), samples};
  }

  std::size_t columns() const { return static_cast<std::size_t>(grid_.columns); }
  std::span<std::int16_t> row_samples(std::size_t channels) {
    return scratch_.allocate_filled<std::int16_t>((columns() + 1) * channels, 0);
  }
  // The light of the sample columns at row y of the block.
  void interpolate_down(std::span<const std::int16_t> samples, std::size_t channels, std::int32_t y,
                        std::span<std::int16_t> out) {
    const std::size_t row_values = columns() * channels;
    const std::int16_t* above =
        samples.data() + static_cast<std::size_t>(y / texels_per_sample()) * row_values;
    const std::int32_t fraction = y % texels_per_sample() * (32768 / texels_per_sample());
    for (std::size_t i = 0; i < row_values; ++i)
      out[i] = static_cast<std::int16_t>(interpolate(above[i], above[i + row_values], fraction));
  }

  const world::Level& level_;
  const ColorTables& tables_;
  const MarkTables* const mark_tables_;
  const BlockRequest& request_;
  const bool simd_;
  base::Arena& scratch_;
  const world::Face& face_;
  const BlockGrids grids_;
  const SampleGrid& grid_;  // the samples of the block
  const world::Texture& drawn_;
  TextureRows texture_;
  const std::uint8_t* const indices_;  // of the whole mip level
  const OwnColors own_;
  const std::uint32_t* const glow_;   // null if it is not shown
  std::optional<WarpedRows> warped_;  // liquids only
  std::span<const std::int32_t> warped_texels_{};
  const std::span<const PlacedMark> marks_;
};

}  // namespace

SurfaceShape surface_shape(const world::Face& face, int tile_s, int tile_t, int mip) {
  const auto size = [&](std::int32_t extent, int tile) {
    return std::max(1, at_mip(std::min(extent - tile * kTileTexels, kTileTexels), mip));
  };
  return {size(face.texture_extents[0], tile_s), size(face.texture_extents[1], tile_t)};
}

void build_surface(const world::Level& level, const ColorTables& tables, const MarkTables* mark_tables,
                   const BlockRequest& request, PixelFormat format, bool simd_kernels, base::Arena& scratch) {
  scratch.reset();
  Builder builder(level, tables, mark_tables, request, simd_kernels, scratch);
  format == PixelFormat::kIndexed ? builder.build_indexed() : builder.build_rgb();
}

}  // namespace temblor::render
