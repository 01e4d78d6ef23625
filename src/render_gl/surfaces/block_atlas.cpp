#include "render_gl/surfaces/block_atlas.h"

#include <algorithm>
#include <span>

#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// 2048 texels: the largest texture that is repeated, and the largest block of a texture with fine mip levels.
constexpr int kMaxLayerPower = 11, kMinLayerPower = 6;
// The sky's two images may fill two layers.
constexpr std::size_t kMinLayers = 2, kMaxLayers = 256;

std::size_t texel_bytes(TexelFormat format) {
  switch (format) {
    case TexelFormat::k8Bit:
      return 1;
    case TexelFormat::k16Bit:
      return 2;
    case TexelFormat::k32Bit:
    case TexelFormat::kLight:
      break;
  }
  return 4;
}

// For each format of texels.
struct CardFormat {
  GLenum stored, channels, type;
};
CardFormat card_format(TexelFormat format) {
  if (format == TexelFormat::k8Bit) return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
  if (format == TexelFormat::k16Bit) return {GL_RGB565, GL_RGB, GL_UNSIGNED_SHORT_5_6_5};
  if (format == TexelFormat::kLight) return {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

std::size_t layer_bytes(TexelFormat format, int power) {
  return (std::size_t{1} << 2 * power) * texel_bytes(format);
}

// Every 2^n-th texel of every 2^n-th row: `source` itself if that is all.
template <typename Texel>
const Texel* shrink_texels(const void* source, render::SurfaceShape from, render::SurfaceShape to,
                           std::vector<Texel>& out_texels) {
  const auto* texels = static_cast<const Texel*>(source);
  if (from.width == to.width && from.height == to.height) return texels;
  out_texels.resize(to.texels());
  const int step_x = from.width / to.width, step_y = from.height / to.height;
  auto out = out_texels.begin();
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x)
      *out++ = texels[std::ptrdiff_t{y} * step_y * from.width + std::ptrdiff_t{x} * step_x];
  return out_texels.data();
}

// The nearest color that has 5, 6, and 5 bits: v * 31 / 255 and v * 63 / 255, rounded. No color becomes
// kColorKey. Blue comes first, as in the frame.
constexpr std::uint16_t kColorKey = 0xf81f, kNextToColorKey = 0xf01f;
std::uint16_t pack_texel(std::uint32_t texel) {
  if (texel < 0x80000000u) return kColorKey;
  const std::uint32_t red = texel >> 16 & 255, green = texel >> 8 & 255, blue = texel & 255;
  const std::uint32_t packed =
      (blue * 249 + 1014) >> 11 << 11 | (green * 253 + 505) >> 10 << 5 | (red * 249 + 1014) >> 11;
  return static_cast<std::uint16_t>(packed == kColorKey ? kNextToColorKey : packed);
}

}  // namespace

BlockAtlas::BlockAtlas(Texture texture, TexelFormat format, int layer_power, int layers)
    : texture_(std::move(texture)),
      format_(format),
      layer_power_(layer_power),
      bytes_(layer_bytes(format, layer_power) * static_cast<std::size_t>(layers)),
      rectangles_(layer_power, layers) {}

base::Result<BlockAtlas> BlockAtlas::make(const Functions& gl, const CacheOptions& options) {
  const TextureLimits limits = find_texture_limits(gl);
  int power = kMaxLayerPower;
  while (power > kMinLayerPower &&
         (1 << power > limits.side || options.bytes < kMinLayers * layer_bytes(options.format, power)))
    --power;
  const std::size_t max_layers = std::clamp(static_cast<std::size_t>(limits.layers), kMinLayers, kMaxLayers);
  const std::size_t layers =
      std::clamp(options.bytes / layer_bytes(options.format, power), kMinLayers, max_layers);
  const int side = 1 << power;
  TRY(Texture texture,
      make_texture(gl, card_format(options.format).stored, {side, side, static_cast<int>(layers)}));
  if (options.format == TexelFormat::kLight) {
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  return BlockAtlas(std::move(texture), options.format, power, static_cast<int>(layers));
}

void BlockAtlas::begin_frame() {
  ++frame_;
  counts_ = {};
}

void BlockAtlas::begin_portion() {
  ++portion_;
  ++counts_.portions;
  earlier_.splice(earlier_.end(), of_portion_);
}

void BlockAtlas::clear() {
  earlier_.clear();
  of_portion_.clear();
  by_key_.clear();
  rectangles_.clear();
}

void BlockAtlas::invalidate(AtlasKey key) {
  const auto found = by_key_.find(key);
  if (found != by_key_.end()) found->second->changed = true;
}

render::SurfaceShape BlockAtlas::shrink(render::SurfaceShape shape) const {
  for (std::int32_t* side : {&shape.width, &shape.height})
    while (*side > 1 << layer_power_) *side /= 2;
  return shape;
}

void BlockAtlas::drop(Cells::iterator cell) {
  rectangles_.free(cell->rect.number);
  by_key_.erase(cell->key);
  (cell->portion == portion_ ? of_portion_ : earlier_).erase(cell);
}

// False: the portion must be drawn first, because the frame needs the other images sooner than those that the
// portion has. It has at least half of the images then: without that, a frame that finds little in the cache
// would have many small portions.
bool BlockAtlas::evict() {
  if (earlier_.empty()) return false;
  const bool has_old = earlier_.front().frame + 1 < frame_;
  const bool has_drawn = earlier_.back().frame == frame_;
  if (!has_old && !has_drawn && of_portion_.size() > earlier_.size()) return false;
  drop(has_old ? earlier_.begin() : std::prev(earlier_.end()));
  ++counts_.evicted;
  return true;
}

std::optional<RectAllocator::Rect> BlockAtlas::make_room(RectAllocator::Size size) {
  while (true) {
    const std::optional<RectAllocator::Rect> rect = rectangles_.allocate(size);
    if (rect || !evict()) return rect;
  }
}

void BlockAtlas::use(Cells::iterator cell) {
  if (cell->portion != portion_) of_portion_.splice(of_portion_.end(), earlier_, cell);
  cell->portion = portion_;
  cell->frame = frame_;
}

std::optional<StoredImage> BlockAtlas::reuse(AtlasKey key) {
  const auto found = by_key_.find(key);
  if (found == by_key_.end() || found->second->changed) return std::nullopt;
  counts_.hits += found->second->portion != portion_;
  use(found->second);
  return found->second->stored;
}

BlockAtlas::Cell* BlockAtlas::find_cell(AtlasKey key, render::SurfaceShape shape) {
  const RectAllocator::Size size = RectAllocator::fit(shape.width, shape.height);
  auto found = by_key_.find(key);
  // The CPU's cache may have reused the memory of a block for one of another size.
  if (found != by_key_.end() && found->second->size != size) {
    drop(found->second);
    found = by_key_.end();
  }
  if (found == by_key_.end()) {
    const std::optional<RectAllocator::Rect> rect = make_room(size);
    if (!rect) return nullptr;
    of_portion_.push_back({key, *rect, size, {rect->place, shape}, frame_, portion_, true});
    found = by_key_.emplace(key, std::prev(of_portion_.end())).first;
  } else {
    counts_.hits += !found->second->changed && found->second->portion != portion_;
    use(found->second);
  }
  found->second->stored.shape = shape;
  return &*found->second;
}

std::optional<StoredImage> BlockAtlas::place(const Functions& gl, const AtlasImage& image) {
  Cell* const cell = find_cell(image.key, shrink(image.shape));
  if (cell == nullptr) return std::nullopt;
  if (cell->changed) upload(gl, image, cell->stored);
  cell->changed = false;
  return cell->stored;
}

std::optional<StoredImage> BlockAtlas::reserve(AtlasKey key, render::SurfaceShape shape) {
  Cell* const cell = find_cell(key, shrink(shape));
  if (cell == nullptr) return std::nullopt;
  cell->changed = false;
  ++counts_.drawn;
  return cell->stored;
}

const void* BlockAtlas::convert(const AtlasImage& image, render::SurfaceShape stored) {
  if (format_ == TexelFormat::k8Bit) return shrink_texels(image.texels, image.shape, stored, shrunk_bytes_);
  const std::uint32_t* const texels = shrink_texels(image.texels, image.shape, stored, shrunk_);
  if (format_ != TexelFormat::k16Bit) return texels;
  packed_.resize(stored.texels());
  std::ranges::transform(std::span(texels, stored.texels()), packed_.begin(), pack_texel);
  return packed_.data();
}

void BlockAtlas::upload(const Functions& gl, const AtlasImage& image, const StoredImage& stored) {
  const render::SurfaceShape shape = stored.shape;
  const CardFormat card = card_format(format_);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, stored.place.x, stored.place.y, stored.place.layer, shape.width,
                   shape.height, 1, card.channels, card.type, convert(image, shape));
  ++counts_.uploads;
  counts_.bytes_uploaded += shape.texels() * texel_bytes(format_);
}

}  // namespace temblor::render_gl
