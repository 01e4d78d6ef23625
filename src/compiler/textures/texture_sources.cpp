#include "compiler/textures/texture_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "formats/images/wad_texture.h"

namespace temblor::compiler {
namespace {

// A texture's name as the level stores it, in the source's case.
std::string make_level_name(std::string_view name) {
  return std::string(name.substr(0, kLevelNameChars));
}

}  // namespace

std::string texture_key(std::string_view name) {
  return base::to_lower(name.substr(0, kLevelNameChars));
}

base::Result<TextureSources::Source> TextureSources::open(const TextureSource& source) const {
  Source opened;
  opened.name = source.name;
  if (base::as_text(source.bytes).starts_with("WAD")) {
    opened.is_wad3 = formats::is_wad3(source.bytes);
    TRY(opened.lumps, formats::read_wad(source.bytes));
  } else {
    TRY(formats::Bsp bsp, formats::read_bsp(source.bytes));
    opened.miptexes = std::move(bsp.miptexes);
  }
  return opened;
}

// The first source that has a name keeps it: later try_emplace() calls change nothing.
TextureSources::TextureSources(std::span<const TextureSource> sources, const formats::Palette& palette,
                               Warnings& io_warnings)
    : palette_(palette) {
  for (const TextureSource& source : sources) {
    auto opened = open(source);
    if (!opened.ok()) {
      io_warnings.push_back(
          {"texture source cannot be read", fmt::format("{}: {}", source.name, opened.error().what)});
      continue;
    }
    const std::uint8_t texture_type = opened->is_wad3 ? formats::kWad3Texture : formats::kWadTexture;
    for (std::size_t i = 0; i < opened->lumps.size(); ++i)
      if (opened->lumps[i].type == texture_type)
        places_.try_emplace(texture_key(opened->lumps[i].name), Place{sources_.size(), i});
    for (std::size_t i = 0; i < opened->miptexes.size(); ++i)
      if (!opened->miptexes[i].mips[0].empty())
        places_.try_emplace(texture_key(opened->miptexes[i].name), Place{sources_.size(), i});
    sources_.push_back(std::move(opened).value());
  }
}

formats::WadTexture TextureSources::convert(const formats::Wad3Texture& texture) {
  if (!dull_colors_) dull_colors_.emplace(palette_, 0, formats::kFirstFullbright);
  return formats::convert_to_palette(texture, palette_, *dull_colors_);
}

formats::BspMiptex TextureSources::read(const formats::BspMiptex& miptex) {
  if (miptex.palette.empty()) return miptex;
  formats::Wad3Texture own{{miptex.name, miptex.width, miptex.height, miptex.mips}, {}};
  std::ranges::copy(miptex.palette, own.palette.begin());
  formats::BspMiptex converted = miptex;
  converted.mips = convert(own).mips;
  converted.palette.clear();
  return converted;
}

base::Result<formats::BspMiptex> TextureSources::read(const Source& source, const formats::WadLump& lump) {
  formats::WadTexture texture;
  if (source.is_wad3) {
    TRY(formats::Wad3Texture wad3_texture, formats::read_wad3_texture(lump.data));
    wad3_texture.texture.name = lump.name;  // says whether it has holes
    texture = convert(wad3_texture);
  } else {
    TRY(texture, formats::read_wad_texture(lump.data));
  }
  return formats::BspMiptex{true, make_level_name(lump.name), texture.width, texture.height,
                            std::move(texture.mips)};
}

std::optional<formats::BspMiptex> TextureSources::take(const std::string& key, Warnings& io_warnings) {
  const auto found = places_.find(key);
  if (found == places_.end()) return std::nullopt;
  Source& source = sources_[found->second.source];
  if (!source.miptexes.empty()) return read(source.miptexes[found->second.item]);
  const formats::WadLump& lump = source.lumps[found->second.item];
  auto miptex = read(source, lump);
  if (miptex.ok()) return std::move(miptex).value();
  io_warnings.push_back(
      {"texture cannot be read",
       fmt::format("{}: \"{}\": {}", source.name, base::printable(lump.name), miptex.error().what)});
  return std::nullopt;
}

}  // namespace temblor::compiler
