#include "world/loading/textures.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "base/text.h"
#include "formats/images/nearest_color.h"

namespace temblor::world {
namespace {

constexpr std::uint32_t kCheckerSize = 64;
constexpr std::uint32_t kCheckerSquare = 8;
// Black and the brightest red of the stock palette, which nobody mistakes for a real texture.
constexpr std::uint8_t kCheckerColors[2] = {0, 251};

// Textures that only tell a compiler or the game about a brush. Half-Life's levels may contain faces of them,
// which are never drawn.
bool is_clear(std::string_view name, NameRules names) {
  constexpr std::array<std::string_view, 6> kTools = {"aaatrigger", "clip", "origin", "null", "skip", "hint"};
  return names == NameRules::kHalfLife && std::ranges::any_of(kTools, [&](std::string_view tool) {
           return base::equal_ignoring_case(name, tool);
         });
}

TextureKind parse_texture_kind(std::string_view name, NameRules names) {
  if (base::equal_ignoring_case(name.substr(0, 3), "sky")) return TextureKind::kSky;
  if (name.starts_with('*')) return TextureKind::kLiquid;
  if (names == NameRules::kHalfLife && name.starts_with('!')) return TextureKind::kLiquid;
  if (name.starts_with('{')) return TextureKind::kCutout;
  return TextureKind::kOpaque;
}

std::uint32_t mip_size(std::uint32_t size, unsigned mip) {
  return std::max(1u, size >> mip);
}

// A level has no palette, so a missing mip level is sampled from mip 0, not averaged.
std::vector<std::uint8_t> sample_mip(const Texture& texture, unsigned mip) {
  const std::uint32_t width = mip_size(texture.width, mip);
  const std::uint32_t height = mip_size(texture.height, mip);
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t{width} * height);
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::size_t row = std::size_t{y << mip} * texture.width;
    for (std::uint32_t x = 0; x < width; ++x) texels.push_back(texture.mips[0][row + (x << mip)]);
  }
  return texels;
}

// Adds mip levels that are missing or have the wrong size.
void complete_mips(Texture& io_texture) {
  for (unsigned mip = 1; mip < io_texture.mips.size(); ++mip) {
    const std::size_t texels =
        std::size_t{mip_size(io_texture.width, mip)} * mip_size(io_texture.height, mip);
    if (io_texture.mips[mip].size() != texels) io_texture.mips[mip] = sample_mip(io_texture, mip);
  }
}

Texture make_missing_texture(std::string name, NameRules names) {
  Texture texture{};
  texture.kind = parse_texture_kind(name, names);
  texture.name = std::move(name);
  texture.missing = true;
  texture.width = texture.height = kCheckerSize;
  for (std::uint32_t y = 0; y < kCheckerSize; ++y)
    for (std::uint32_t x = 0; x < kCheckerSize; ++x)
      texture.mips[0].push_back(kCheckerColors[(x / kCheckerSquare + y / kCheckerSquare) % 2]);
  complete_mips(texture);
  return texture;
}

// One that shows nothing: a cutout of which every texel is clear.
Texture make_clear_texture(std::string name) {
  Texture texture{};
  texture.kind = TextureKind::kCutout;
  texture.name = std::move(name);
  texture.width = texture.height = kCheckerSize;
  texture.mips[0].assign(std::size_t{kCheckerSize} * kCheckerSize, formats::kTransparentIndex);
  complete_mips(texture);
  return texture;
}

Texture make_texture(formats::BspMiptex& io_miptex, NameRules names) {
  if (is_clear(io_miptex.name, names)) return make_clear_texture(std::move(io_miptex.name));
  const std::size_t texels = std::size_t{io_miptex.width} * io_miptex.height;
  if (!io_miptex.present || texels == 0 || io_miptex.mips[0].size() != texels)
    return make_missing_texture(std::move(io_miptex.name), names);
  Texture texture{};
  texture.kind = parse_texture_kind(io_miptex.name, names);
  texture.name = std::move(io_miptex.name);
  texture.width = io_miptex.width;
  texture.height = io_miptex.height;
  texture.mips = std::move(io_miptex.mips);
  complete_mips(texture);
  return texture;
}

void set_colors(formats::ColoredTexture colored, Texture& io_texture) {
  CHECK(colored.mips[0].size() == io_texture.mips[0].size(), "{}: colors of another size", io_texture.name);
  io_texture.mips = std::move(colored.mips);
  io_texture.colors = std::make_shared<const formats::TextureColors>(std::move(colored.colors));
}

constexpr std::size_t kMaxFrames = 10;

// The place of "+3name" or "+cname" in its sequence.
struct AnimationFrame {
  bool alternate;  // part of +a..+j, not +0..+9
  std::size_t position;
};

std::optional<AnimationFrame> parse_animation_frame(std::string_view name) {
  if (name.size() < 2 || name[0] != '+') return std::nullopt;
  const char letter = base::to_lower(name[1]);
  if (letter >= '0' && letter <= '9') return AnimationFrame{false, static_cast<std::size_t>(letter - '0')};
  if (letter >= 'a' && letter <= 'j') return AnimationFrame{true, static_cast<std::size_t>(letter - 'a')};
  return std::nullopt;
}

using Slots = std::array<std::optional<TextureIndex>, kMaxFrames>;

// The two sequences of one name, by position.
struct Sequences {
  Slots main, alternate;
};

// Returns the frames up to the last one. Empty if a frame before it is missing, because the sequence cannot
// play then.
std::vector<TextureIndex> list_frames(const Slots& slots) {
  std::vector<TextureIndex> frames;
  bool ended = false;
  for (const std::optional<TextureIndex>& slot : slots) {
    if (slot && ended) return {};
    if (slot)
      frames.push_back(*slot);
    else
      ended = true;
  }
  return frames;
}

// Links the textures that share a name after "+0" or "+a". If a level has the same frame twice, the first one
// counts.
void link_animations(std::vector<Texture>& io_textures) {
  std::map<std::string, Sequences> sequences_by_name;
  for (std::size_t i = 0; i < io_textures.size(); ++i) {
    const std::string& name = io_textures[i].name;
    const auto frame = parse_animation_frame(name);
    if (!frame) continue;
    Sequences& sequences = sequences_by_name[base::to_lower(name.substr(2))];
    auto& slot = (frame->alternate ? sequences.alternate : sequences.main)[frame->position];
    if (!slot) slot = base::to_index<TextureIndex>(i);
  }
  for (Texture& texture : io_textures) {
    const auto frame = parse_animation_frame(texture.name);
    if (!frame) continue;
    const Sequences& sequences = sequences_by_name[base::to_lower(texture.name.substr(2))];
    texture.frames = list_frames(frame->alternate ? sequences.alternate : sequences.main);
    texture.alternate_frames = list_frames(frame->alternate ? sequences.main : sequences.alternate);
  }
}

}  // namespace

std::vector<Texture> make_textures(std::vector<formats::BspMiptex>& io_miptexes, ColoredTextures& io_colored,
                                   NameRules names) {
  std::vector<Texture> textures;
  textures.reserve(io_miptexes.size() + 1);
  for (formats::BspMiptex& miptex : io_miptexes) textures.push_back(make_texture(miptex, names));
  for (std::size_t i = 0; i < std::min(textures.size(), io_colored.size()); ++i)
    if (io_colored[i] && !textures[i].missing && !is_clear(textures[i].name, names))
      set_colors(std::move(*io_colored[i]), textures[i]);
  textures.push_back(make_missing_texture("", names));
  link_animations(textures);
  return textures;
}

}  // namespace temblor::world
