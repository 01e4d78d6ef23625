#include "render/surfaces/build_surface.h"

#include <algorithm>
#include <cstring>

#include "render/edges/edge_table.h"
#include "render/surfaces/build_kernels.h"

namespace temblor::render {

namespace {

constexpr std::int32_t kTexelsASample = 16;  // at mip 0

// The part of a face's light map that a tile needs.
struct TileLight {
  std::int32_t first_column, first_row, columns, rows;
};

TileLight tile_light(const world::Face& face, const BlockRequest& request) {
  const std::int32_t s = request.tile_s * (kTileTexels / kTexelsASample);
  const std::int32_t t = request.tile_t * (kTileTexels / kTexelsASample);
  const std::int32_t most = kTileTexels / kTexelsASample + 1;
  return {s, t, std::min(face.light_width() - s, most), std::min(face.light_height() - t, most)};
}

// Sum of sample x style value. Channel 0..2 of the coloured light, or the grey light.
std::uint32_t light_sum(const world::Level& level, const world::Face& face, const BlockContents& contents,
                        std::size_t sample, int channel) {
  const std::size_t plane =
      static_cast<std::size_t>(face.light_width()) * static_cast<std::size_t>(face.light_height());
  std::uint32_t sum = 0;
  for (std::size_t style = 0; style < face.style_count; ++style) {
    const std::size_t position = face.light + style * plane + sample;
    const std::uint8_t value = contents.coloured
                                   ? level.light_rgb[position * 3 + static_cast<std::size_t>(channel)]
                                   : level.light[position];
    sum += std::uint32_t{value} * contents.style_values[style];
  }
  return sum;
}

// One row of texels out of a texture that repeats without end, `count` from (s, t) on.
void copy_texture_row(const world::Texture& texture, int mip, std::int64_t s, std::int64_t t,
                      std::span<std::uint8_t> out) {
  const std::int64_t width = std::max<std::int64_t>(1, texture.width >> mip);
  const std::int64_t height = std::max<std::int64_t>(1, texture.height >> mip);
  const auto wrap = [](std::int64_t value, std::int64_t size) { return (value % size + size) % size; };
  const std::uint8_t* row = texture.mips[static_cast<std::size_t>(mip)].data() + wrap(t, height) * width;
  std::size_t at = static_cast<std::size_t>(wrap(s, width));
  for (std::size_t done = 0; done < out.size();) {
    const std::size_t run = std::min(out.size() - done, static_cast<std::size_t>(width) - at);
    std::memcpy(out.data() + done, row + at, run);
    done += run;
    at = 0;
  }
}

std::int32_t interpolate(std::int32_t from, std::int32_t to, std::int32_t fraction_q15) {
  return from + (((to - from) * fraction_q15 + 16384) >> 15);
}

class Builder {
 public:
  Builder(const world::Level& level, const BuildTables& tables, const BlockRequest& request,
          bool vector_kernels, base::Arena& scratch)
      : level_(level),
        tables_(tables),
        request_(request),
        vector_(vector_kernels),
        scratch_(scratch),
        face_(level.face(request.face)),
        light_(tile_light(face_, request)),
        texture_row_(scratch.allocate<std::uint8_t>(static_cast<std::size_t>(request.block.shape.width) +
                                                    kBlockPadding)) {}

  void build_indexed() {
    const std::span<const std::int16_t> samples = sum_samples(1, [](std::uint32_t sum) {
      return static_cast<std::int16_t>(std::max((65280 - static_cast<std::int32_t>(sum)) >> 2, 64));
    });
    const std::span<std::int16_t> row_light = row_samples(1);
    auto* out = reinterpret_cast<std::uint8_t*>(request_.block.texels);
    for (std::int32_t y = 0; y < request_.block.shape.height; ++y, out += request_.block.shape.width) {
      read_texture_row(y);
      interpolate_down(samples, 1, y, row_light);
      const IndexedRow row{texture_row_.data(),        row_light.data(), tables_.colormap.rows.data(), out,
                           request_.block.shape.width, texels_a_sample()};
      vector_ ? build_indexed_row_vector(row) : build_indexed_row_plain(row);
    }
  }

  void build_rgb() {
    const std::span<const std::int16_t> samples = sum_samples(4, [](std::uint32_t sum) {
      return static_cast<std::int16_t>(std::min<std::uint32_t>(sum, 65280) >> 1);
    });
    const std::span<std::int16_t> row_light = row_samples(4);
    const std::span<std::uint32_t> colours = scratch_.allocate<std::uint32_t>(
        static_cast<std::size_t>(request_.block.shape.width) + kBlockPadding);
    auto* out = reinterpret_cast<std::uint32_t*>(request_.block.texels);
    for (std::int32_t y = 0; y < request_.block.shape.height; ++y, out += request_.block.shape.width) {
      read_texture_row(y);
      for (std::size_t x = 0; x < static_cast<std::size_t>(request_.block.shape.width); ++x) {
        const std::uint8_t index = texture_row_[x];
        colours[x] = index >= tables_.first_fullbright ? tables_.rgb[index] & 0xffffffu : tables_.rgb[index];
      }
      interpolate_down(samples, 4, y, row_light);
      const RgbRow row{colours.data(), row_light.data(), out, request_.block.shape.width, texels_a_sample()};
      vector_ ? build_rgb_row_vector(row) : build_rgb_row_plain(row);
    }
  }

 private:
  std::int32_t texels_a_sample() const { return kTexelsASample >> request_.mip; }

  // What `convert` makes of the light sum, for every sample of the tile, row by row. Of four channels, three
  // are blue, green, red and the last is 0; of one, the grey light.
  // One row more than there is, so that every row of texels has a sample above and below.
  template <typename Convert>
  std::span<const std::int16_t> sum_samples(std::size_t channels, Convert convert) {
    const std::span<std::int16_t> samples = scratch_.allocate_filled<std::int16_t>(
        columns() * (static_cast<std::size_t>(light_.rows) + 1) * channels, 0);
    std::int16_t* out = samples.data();
    for (std::int32_t row = light_.first_row; row < light_.first_row + light_.rows; ++row)
      for (std::int32_t column = light_.first_column; column < light_.first_column + light_.columns;
           ++column) {
        const std::size_t sample =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(face_.light_width()) +
            static_cast<std::size_t>(column);
        if (channels == 1) {
          *out++ = convert(light_sum(level_, face_, request_.contents, sample, 0));
          continue;
        }
        for (int channel = 2; channel >= 0; --channel)
          *out++ = convert(light_sum(level_, face_, request_.contents, sample, channel));
        ++out;
      }
    return samples;
  }

  void read_texture_row(std::int32_t y) {
    // Faces start at multiples of 16 texels, so every mip level starts at a whole one.
    const std::int64_t s =
        (std::int64_t{face_.texture_mins[0]} + request_.tile_s * kTileTexels) >> request_.mip;
    const std::int64_t t =
        (std::int64_t{face_.texture_mins[1]} + request_.tile_t * kTileTexels) >> request_.mip;
    copy_texture_row(level_.texture(request_.contents.texture), request_.mip, s, t + y,
                     texture_row_.first(static_cast<std::size_t>(request_.block.shape.width)));
  }

  std::size_t columns() const { return static_cast<std::size_t>(light_.columns); }
  std::span<std::int16_t> row_samples(std::size_t channels) {
    return scratch_.allocate_filled<std::int16_t>((columns() + 1) * channels, 0);
  }
  void interpolate_down(std::span<const std::int16_t> samples, std::size_t channels, std::int32_t y,
                        std::span<std::int16_t> out) {
    const std::size_t width = columns() * channels;
    const std::int16_t* above = samples.data() + static_cast<std::size_t>(y / texels_a_sample()) * width;
    const std::int32_t fraction = y % texels_a_sample() * (32768 / texels_a_sample());
    for (std::size_t i = 0; i < width; ++i)
      out[i] = static_cast<std::int16_t>(interpolate(above[i], above[i + width], fraction));
  }

  const world::Level& level_;
  const BuildTables& tables_;
  const BlockRequest& request_;
  const bool vector_;
  base::Arena& scratch_;
  const world::Face& face_;
  const TileLight light_;
  std::span<std::uint8_t> texture_row_;
};

}  // namespace

BuildTables make_build_tables(const formats::Palette& palette, const formats::Colormap& colormap) {
  BuildTables tables{colormap, {}, 256 - colormap.fullbrights};
  for (std::size_t i = 0; i < palette.size(); ++i) tables.rgb[i] = to_rgb(palette[i]);
  return tables;
}

SurfaceShape surface_shape(const world::Face& face, int tile_s, int tile_t, int mip) {
  const auto size = [&](std::int32_t extent, int tile) {
    return std::max(1, std::min(extent - tile * kTileTexels, kTileTexels) >> mip);
  };
  return {size(face.texture_extents[0], tile_s), size(face.texture_extents[1], tile_t)};
}

void build_surface(const world::Level& level, const BuildTables& tables, const BlockRequest& request,
                   PixelFormat format, bool vector_kernels, base::Arena& scratch) {
  scratch.reset();
  Builder builder(level, tables, request, vector_kernels, scratch);
  format == PixelFormat::kIndexed ? builder.build_indexed() : builder.build_rgb();
}

}  // namespace temblor::render
