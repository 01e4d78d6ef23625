#include "artgen/textures/texture.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "artgen/palette.h"
#include "artgen/textures/layer.h"
#include "base/bytes.h"
#include "base/hash.h"
#include "formats/archives/wad.h"
#include "formats/images/build_mips.h"
#include "formats/images/wad_texture.h"

namespace temblor::artgen {
namespace {

constexpr std::string_view kWad = "textures.wad";
// The BSP and WAD formats have room for 15 characters and a terminating zero.
constexpr std::size_t kNameChars = 15;
constexpr std::int32_t kMaxSide = 256;
// Quake's mip levels need sides that are multiples of 16.
constexpr std::int32_t kSideMultiple = 16;

// The color lookup tables are expensive to build and are shared by all threads.
const formats::MipColors& mip_colors() {
  static const formats::MipColors colors(make_palette());
  return colors;
}

// The settings of a texture's first line.
struct TextureHeader {
  std::string name;
  std::int32_t width = 16, height = 16;
  std::int32_t frames = 1;
  // Computed from the name and the setting `seed`, so that each texture has its own random parts.
  std::uint64_t seed = 0;
};

// With more than one frame, the name needs room for the prefix "+0".
base::Result<TextureHeader> read_header(const ScriptLine& asset, std::int32_t default_frames,
                                        std::int32_t max_frames) {
  Arguments arguments(asset);
  TextureHeader header;
  header.name = arguments.text();
  std::tie(header.width, header.height) = arguments.size(kMaxSide);
  if (header.width % kSideMultiple != 0 || header.height % kSideMultiple != 0)
    arguments.set_error(
        fmt::format("{}x{}: sides must be multiples of {}", header.width, header.height, kSideMultiple));
  if (header.name.empty() || header.name.size() + (max_frames > 1 ? 2 : 0) > kNameChars)
    arguments.set_error(
        fmt::format("'{}': a texture's name has 1 to {} characters", header.name, kNameChars));
  if (max_frames > 1) header.frames = arguments.integer("frames", default_frames, 1, max_frames);
  header.seed = base::hash_with(base::hash_bytes(base::as_bytes(header.name)),
                                static_cast<std::uint64_t>(arguments.integer("seed", 0, 0, 1 << 30)));
  TRY_STATUS(arguments.finish());
  return header;
}

// Paints one texture; `name` includes the prefix of its frame. All frames use the same seed, so they differ
// only where their settings do.
base::Result<ArtPart> make_part(const TextureHeader& header, const std::string& name,
                                std::span<const ScriptLine> layers) {
  Surface surface(header.width, header.height);
  const bool has_holes = name.starts_with('{');
  for (Texel& texel : surface.cells) texel.hole = has_holes;
  TRY_STATUS(paint_layers(layers, header.seed, surface));
  formats::WadTexture texture{
      name, static_cast<std::uint32_t>(header.width), static_cast<std::uint32_t>(header.height),
      formats::build_mips(to_palette_indices(surface), static_cast<std::uint32_t>(header.width),
                          static_cast<std::uint32_t>(header.height), has_holes, mip_colors())};
  TRY(base::ByteVector bytes, formats::write_wad_texture(texture));
  return ArtPart{std::string(kWad), std::move(bytes), name, formats::kWadTexture};
}

// The frame's value from a list with slashes. Shorter lists repeat.
std::string pick_frame_value(std::string_view value, std::int32_t frame) {
  if (value.find('/') == std::string_view::npos) return std::string(value);
  std::vector<std::string_view> values;
  while (true) {
    const std::size_t end = value.find('/');
    values.push_back(value.substr(0, end));
    if (end == std::string_view::npos) break;
    value.remove_prefix(end + 1);
  }
  return std::string(values[static_cast<std::size_t>(frame) % values.size()]);
}

// The layers of one frame, recursively.
std::vector<ScriptLine> pick_frame_lines(std::span<const ScriptLine> lines, std::int32_t frame) {
  std::vector<ScriptLine> frame_lines(lines.begin(), lines.end());
  for (ScriptLine& line : frame_lines) {
    for (std::string& value : line.values) value = pick_frame_value(value, frame);
    for (auto& [name, value] : line.settings) value = pick_frame_value(value, frame);
    line.below = pick_frame_lines(line.below, frame);
  }
  return frame_lines;
}

}  // namespace

base::Result<std::vector<ArtPart>> make_texture(const ScriptLine& asset) {
  TRY(const TextureHeader header, read_header(asset, 1, 1));
  TRY(ArtPart part, make_part(header, header.name, asset.below));
  std::vector<ArtPart> parts;
  parts.push_back(std::move(part));
  return parts;
}

base::Result<std::vector<ArtPart>> make_animation(const ScriptLine& asset) {
  TRY(const TextureHeader header, read_header(asset, 4, 10));
  std::vector<ArtPart> parts;
  for (std::int32_t frame = 0; frame < header.frames; ++frame) {
    const std::vector<ScriptLine> lines = pick_frame_lines(asset.below, frame);
    TRY(ArtPart part, make_part(header, fmt::format("+{}{}", frame, header.name), lines));
    parts.push_back(std::move(part));
  }
  return parts;
}

base::Result<std::vector<ArtPart>> make_switch(const ScriptLine& asset) {
  TRY(const TextureHeader header, read_header(asset, 1, 5));
  std::vector<ArtPart> parts;
  for (std::int32_t frame = 0; frame < 2 * header.frames; ++frame) {
    const bool is_pressed = frame >= header.frames;
    const std::string mark(1, static_cast<char>((is_pressed ? 'a' : '0') + frame % header.frames));
    const std::vector<ScriptLine> lines = pick_frame_lines(asset.below, frame);
    TRY(ArtPart part, make_part(header, fmt::format("+{}{}", mark, header.name), lines));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace temblor::artgen
