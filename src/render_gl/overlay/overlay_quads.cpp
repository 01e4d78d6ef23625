#include "render_gl/overlay/overlay_quads.h"

#include <algorithm>
#include <numeric>

namespace temblor::render_gl {

namespace {

// Frames have at most 2^14 pixels on a side. So (2 * pixel + 1) * factor + start stays below 2^31.
constexpr std::int64_t kMaxFactor = std::int64_t{1} << 15, kMaxDivisor = std::int64_t{1} << 30;

}  // namespace

TexelAxis make_texel_axis(const OverlaySide& side) {
  // Sizes are at most 2^14 for pictures and 2^31 for areas, so the products fit 64 bits.
  std::int64_t factor = side.part_size * side.texels;
  std::int64_t divisor = 2 * side.size * side.picture_size;
  const std::int64_t skipped = side.first_pixel - side.begin;
  // first = (2 * skipped * factor + 2 * size * part_first * texels) / divisor, in parts without overflow.
  const std::int64_t whole = side.part_first * side.texels / side.picture_size;
  const std::int64_t rest = side.part_first * side.texels % side.picture_size;
  const std::int64_t start = 2 * (skipped * factor + side.size * rest);
  TexelAxis axis;
  axis.first = static_cast<std::int32_t>(whole + start / divisor);
  std::int64_t remainder = start % divisor;
  const std::int64_t common = std::gcd(std::gcd(factor, divisor), remainder);
  factor /= common;
  divisor /= common;
  remainder /= common;
  // Borders of texels may move by less than a pixel, in areas of thousands of pixels with odd sizes.
  while (factor >= kMaxFactor || divisor >= kMaxDivisor) {
    factor /= 2;
    divisor = (divisor + 1) / 2;
    remainder /= 2;
  }
  axis.factor = static_cast<std::int32_t>(factor);
  axis.divisor = static_cast<std::int32_t>(divisor);
  axis.start = static_cast<std::int32_t>(remainder);
  return axis;
}

void OverlayColors::begin(const render::ColorTables& tables, render::PixelFormat format) {
  tables_ = &tables;
  is_indexed_ = format == render::PixelFormat::kIndexed;
  sources_.clear();
  texels_.clear();
  find_row({});
}

std::int32_t OverlayColors::find_row(const render::DrawCommand& command) {
  const Source source{command.tint == nullptr ? command.translation : nullptr, command.tint};
  const auto found = std::ranges::find(sources_, source);
  if (found != sources_.end()) return static_cast<std::int32_t>(found - sources_.begin());
  if (sources_.size() == kMaxRows) return -1;
  const render::ColorTranslation* const indices =
      source.tint != nullptr ? &source.tint->indices : source.translation;
  for (std::size_t i = 0; i < 256; ++i) {
    const std::size_t index = indices != nullptr ? (*indices)[i] : i;
    if (is_indexed_)
      texels_.push_back(static_cast<std::uint32_t>(index));
    else
      texels_.push_back(source.tint != nullptr ? source.tint->rgb[i] : tables_->rgb[index]);
  }
  sources_.push_back(source);
  return static_cast<std::int32_t>(sources_.size() - 1);
}

}  // namespace temblor::render_gl
