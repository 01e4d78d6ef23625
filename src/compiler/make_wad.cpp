#include "compiler/make_wad.h"

#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "base/text.h"
#include "compiler/textures/texture_from_image.h"
#include "compiler/textures/texture_sources.h"
#include "formats/archives/wad.h"
#include "formats/images/image.h"

namespace temblor::compiler {
namespace {

// Reads a PNG and writes it as a miptex with four mip levels.
base::Result<base::ByteVector> make_lump(std::string_view name, base::Bytes png,
                                         const formats::MipColors& colors) {
  if (name.empty() || name.size() > kLevelNameChars)
    return base::error(base::ErrorCode::kUsage, "\"{}\": texture names have 1 to {} characters",
                       base::printable(name), kLevelNameChars);
  TRY(const formats::Image image, formats::read_png(png));
  TRY(const formats::WadTexture texture, texture_from_image(name, image, colors));
  return formats::write_wad_texture(texture);
}

}  // namespace

std::string texture_name_from_file(std::string_view file_name) {
  std::string name = std::filesystem::path(file_name).stem().string();
  if (name.starts_with('#')) name[0] = '*';
  return name;
}

base::Result<base::ByteVector> make_wad(std::span<const PngFile> files, const formats::Palette& palette) {
  const formats::MipColors colors(palette);
  std::map<std::string, std::string> file_of_name;
  std::vector<base::ByteVector> contents;
  contents.reserve(files.size());
  std::vector<formats::WadLump> lumps;
  for (const PngFile& file : files) {
    std::string name = texture_name_from_file(file.name);
    const auto [first, is_new] = file_of_name.try_emplace(texture_key(name), file.name);
    if (!is_new)
      return base::Error{base::ErrorCode::kUsage, "has the same texture name as " + first->second, file.name};
    TRY(base::ByteVector lump, make_lump(name, file.bytes, colors).with_file(file.name));
    contents.push_back(std::move(lump));
    lumps.push_back({std::move(name), formats::kWadTexture, contents.back()});
  }
  return formats::write_wad(lumps);
}

}  // namespace temblor::compiler
