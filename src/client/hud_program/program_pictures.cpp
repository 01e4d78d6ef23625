#include "client/hud_program/program_pictures.h"

#include <memory>
#include <utility>

#include "assets/image_files.h"
#include "base/text.h"
#include "formats/images/visible_alpha.h"

namespace temblor::client {
namespace {

formats::Picture to_picture(formats::Image image, const formats::NearestColor& nearest) {
  formats::Picture picture{image.width, image.height, {}};
  picture.pixels.reserve(image.pixels.size());
  for (const std::uint32_t pixel : image.pixels)
    picture.pixels.push_back(
        pixel >> 24 < formats::kMinVisibleAlpha
            ? formats::kTransparentIndex
            : nearest.find({static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
                            static_cast<std::uint8_t>(pixel)}));
  picture.detail = std::make_shared<const formats::PictureDetail>(
      formats::PictureDetail{image.width, image.height, std::move(image.pixels), picture.pixels});
  return picture;
}

std::string without_extension(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || name.find('/', dot) != std::string::npos ? name : name.substr(0, dot);
}

}  // namespace

ProgramPictures::ProgramPictures(const assets::Library& library, const assets::Pictures& pictures,
                                 const formats::Palette& palette)
    : library_(library), pictures_(pictures), nearest_(palette, 0, formats::kTransparentIndex) {}

const formats::Picture* ProgramPictures::find_lump(std::string_view name) const {
  for (const std::string& candidate :
       {std::string(name), fmt::format("{}.lmp", name), fmt::format("gfx/{}.lmp", name)})
    if (const formats::Picture* const picture = pictures_.find_real(candidate)) return picture;
  return nullptr;
}

// The original's pictures come first: a program that names "gfx/face.lmp" may find a PNG file in its place.
const formats::Picture* ProgramPictures::load_file(const std::string& name) {
  const vfs::FileSystem& files = library_.files();
  if (files_.size() >= kMaxFiles) return nullptr;
  for (const std::string& base : {name, without_extension(name)})
    for (const char* const extension : {"", ".png", ".tga", ".jpg"}) {
      const std::string file = base + extension;
      if (!assets::is_image_file(file) || !files.contains(file)) continue;
      base::Result<formats::Image> image = assets::read_image_file(files, file);
      if (!image.ok() || image->width > kMaxSide || image->height > kMaxSide) continue;
      if (image->pixels.size() > kMaxPixels - file_pixels_) continue;
      file_pixels_ += image->pixels.size();
      return &files_.insert_or_assign(file, to_picture(*std::move(image), nearest_)).first->second;
    }
  return nullptr;
}

// A name that was not found is remembered, so that a program may ask in each frame.
const formats::Picture* ProgramPictures::find(std::string_view name) {
  constexpr std::size_t kMaxNames = 8192, kMaxNameChars = 128;
  if (name.empty() || name.size() > kMaxNameChars) return nullptr;
  const std::string lower = base::to_lower(name);
  if (const auto known = found_.find(lower); known != found_.end()) return known->second;
  if (found_.size() >= kMaxNames) return nullptr;
  const formats::Picture* picture = find_lump(lower);
  if (picture == nullptr) picture = load_file(lower);
  found_.emplace(lower, picture);
  return picture;
}

}  // namespace temblor::client
