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
constexpr std::size_t kNameChars = 15;  // what a level has room for
constexpr std::int32_t kMaxSide = 256;
constexpr std::int32_t kSideMultiple = 16;

const formats::MipColors& mip_colors() {
  static const formats::MipColors colors(make_palette());
  return colors;
}

struct Head {
  std::string name;
  std::int32_t width = 16, height = 16;
  std::int32_t frames = 1;
  std::uint64_t seed = 0;
};

base::Result<Head> read_head(const ScriptLine& thing, std::int32_t usual_frames, std::int32_t most_frames) {
  Arguments arguments(thing);
  Head head;
  head.name = arguments.text();
  std::tie(head.width, head.height) = arguments.size(kMaxSide);
  if (head.width % kSideMultiple != 0 || head.height % kSideMultiple != 0)
    arguments.complain(
        fmt::format("{}x{}: sides are multiples of {}", head.width, head.height, kSideMultiple));
  if (head.name.empty() || head.name.size() + (most_frames > 1 ? 2 : 0) > kNameChars)
    arguments.complain(fmt::format("'{}': a name in a level has 1 to {} characters", head.name, kNameChars));
  if (most_frames > 1) head.frames = arguments.integer("frames", usual_frames, 1, most_frames);
  head.seed = base::hash_with(base::hash_of_bytes(base::as_bytes(head.name)),
                              static_cast<std::uint64_t>(arguments.integer("seed", 0, 0, 1 << 30)));
  TRY_STATUS(arguments.finish());
  return head;
}

base::Result<ArtPart> make_part(const Head& head, const std::string& name,
                                std::span<const ScriptLine> layers) {
  Surface surface(head.width, head.height);
  const bool has_holes = name.starts_with('{');
  for (Texel& texel : surface.cells) texel.hole = has_holes;
  TRY_STATUS(paint_layers(layers, head.seed, surface));
  formats::WadTexture texture{
      name, static_cast<std::uint32_t>(head.width), static_cast<std::uint32_t>(head.height),
      formats::build_mips(indices_of(surface), static_cast<std::uint32_t>(head.width),
                          static_cast<std::uint32_t>(head.height), has_holes, mip_colors())};
  TRY(base::ByteVector bytes, formats::write_wad_texture(texture));
  return ArtPart{std::string(kWad), std::move(bytes), name, formats::kWadTexture};
}

// The values between slashes that a frame has.
std::string value_in_frame(std::string_view value, std::int32_t frame) {
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

std::vector<ScriptLine> lines_in_frame(std::span<const ScriptLine> lines, std::int32_t frame) {
  std::vector<ScriptLine> frame_lines(lines.begin(), lines.end());
  for (ScriptLine& line : frame_lines) {
    for (std::string& value : line.values) value = value_in_frame(value, frame);
    for (auto& [name, value] : line.settings) value = value_in_frame(value, frame);
    line.below = lines_in_frame(line.below, frame);
  }
  return frame_lines;
}

}  // namespace

base::Result<std::vector<ArtPart>> make_texture(const ScriptLine& thing) {
  TRY(const Head head, read_head(thing, 1, 1));
  TRY(ArtPart part, make_part(head, head.name, thing.below));
  std::vector<ArtPart> parts;
  parts.push_back(std::move(part));
  return parts;
}

base::Result<std::vector<ArtPart>> make_animation(const ScriptLine& thing) {
  TRY(const Head head, read_head(thing, 4, 10));
  std::vector<ArtPart> parts;
  for (std::int32_t frame = 0; frame < head.frames; ++frame) {
    const std::vector<ScriptLine> lines = lines_in_frame(thing.below, frame);
    TRY(ArtPart part, make_part(head, fmt::format("+{}{}", frame, head.name), lines));
    parts.push_back(std::move(part));
  }
  return parts;
}

base::Result<std::vector<ArtPart>> make_switch(const ScriptLine& thing) {
  TRY(const Head head, read_head(thing, 1, 5));
  std::vector<ArtPart> parts;
  for (std::int32_t frame = 0; frame < 2 * head.frames; ++frame) {
    const bool is_pressed = frame >= head.frames;
    const std::string mark(1, static_cast<char>((is_pressed ? 'a' : '0') + frame % head.frames));
    const std::vector<ScriptLine> lines = lines_in_frame(thing.below, frame);
    TRY(ArtPart part, make_part(head, fmt::format("+{}{}", mark, head.name), lines));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace temblor::artgen
