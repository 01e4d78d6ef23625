#include "assets/images/external_pictures.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "assets/assets.h"
#include "assets/image_files.h"
#include "formats/images/nearest_color.h"
#include "formats/images/visible_alpha.h"

namespace temblor::assets {
namespace {

constexpr std::string_view kPictureFolder = "gfx/", kPictureWad = "gfx.wad";

// The names without extensions of all picture files, each once.
std::set<std::string> list_stems(const vfs::FileSystem& files) {
  std::set<std::string> stems;
  for (const std::string& name : files.list(kPictureFolder, ""))
    if (is_image_file(name)) stems.insert(name.substr(0, name.rfind('.')));
  return stems;
}

std::shared_ptr<const formats::PictureDetail> make_detail(formats::Image image,
                                                          const formats::NearestColor& nearest) {
  auto detail = std::make_shared<formats::PictureDetail>();
  detail->width = image.width;
  detail->height = image.height;
  detail->colors = std::move(image.pixels);
  detail->indices.reserve(detail->colors.size());
  for (const std::uint32_t color : detail->colors)
    detail->indices.push_back(color >> 24 < formats::kMinVisibleAlpha
                                  ? formats::kTransparentIndex
                                  : nearest.find({static_cast<std::uint8_t>(color >> 16 & 255),
                                                  static_cast<std::uint8_t>(color >> 8 & 255),
                                                  static_cast<std::uint8_t>(color & 255)}));
  return detail;
}

}  // namespace

std::vector<std::string> add_details(const vfs::FileSystem& files,
                                     const std::function<formats::Picture*(std::string_view name)>& find,
                                     std::vector<std::string>& io_bad) {
  std::vector<std::string> replaced;
  std::optional<formats::NearestColor> nearest;  // made for the first picture that needs it
  for (const std::string& stem : list_stems(files)) {
    const std::string lump = stem.substr(kPictureFolder.size()), file = stem + ".lmp";
    formats::Picture* const in_wad = find(lump);
    formats::Picture* const picture = in_wad != nullptr ? in_wad : find(file);
    if (picture == nullptr) continue;
    const std::string image_file = find_image_file(files, stem);
    if (files.find_game(image_file) < files.find_game(in_wad != nullptr ? kPictureWad : file)) continue;
    base::Result<formats::Image> image = read_image_file(files, image_file);
    if (!image.ok() || image->pixels.size() > kMaxExternalPicturePixels) {
      io_bad.push_back(image.ok() ? fmt::format("{}: {} x {} pixels are too many", files.describe(image_file),
                                                image->width, image->height)
                                  : image.error().message());
      continue;
    }
    if (!nearest) {
      const base::Result<Look> look = load_look(files);
      if (!look.ok()) return replaced;
      nearest.emplace(look->palette, 0, formats::kTransparentIndex);
    }
    picture->detail = make_detail(std::move(image).value(), *nearest);
    replaced.push_back(in_wad != nullptr ? lump : file);
  }
  return replaced;
}

}  // namespace temblor::assets
