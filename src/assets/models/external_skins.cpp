#include "assets/models/external_skins.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "assets/assets.h"
#include "assets/image_files.h"
#include "base/text.h"
#include "formats/images/nearest_color.h"
#include "formats/images/resample.h"

namespace temblor::assets {
namespace {

constexpr std::uint32_t kMaxFactor = 8;

struct ExternalSkin {
  std::size_t number = 0;
  formats::Image image;
};

std::vector<ExternalSkin> load_external_skins(const vfs::FileSystem& files, const std::string& path,
                                              std::size_t count, std::vector<std::string>& io_notes) {
  const std::string stem = path.substr(0, path.rfind('.'));
  std::vector<ExternalSkin> skins;
  for (std::size_t number = 0; number < count; ++number) {
    std::string file = find_image_file(files, fmt::format("{}_{}", path, number));
    if (file.empty()) file = find_image_file(files, fmt::format("{}_{}", stem, number));
    if (file.empty() || files.find_game(file) < files.find_game(path)) continue;
    base::Result<formats::Image> image = read_image_file(files, file);
    if (image.ok())
      skins.push_back({number, std::move(image).value()});
    else
      io_notes.push_back(fmt::format("{}; the model's own skin is drawn", image.error().message()));
  }
  return skins;
}

// The largest factor at which a picture has all texels of the enlarged skin.
std::uint32_t choose_factor(const std::vector<ExternalSkin>& skins, const formats::Mdl& mdl) {
  const std::uint32_t most =
      std::min(kMaxFactor, formats::kMaxMdlSkinSide / std::max(mdl.skin_width, mdl.skin_height));
  std::uint32_t factor = 1;
  for (const ExternalSkin& skin : skins)
    factor =
        std::max(factor, std::min(skin.image.width / mdl.skin_width, skin.image.height / mdl.skin_height));
  return std::clamp(factor, 1u, most);
}

// Coordinates of texels keep their place, to half a texel of the enlarged skin.
void enlarge_skins(std::uint32_t factor, formats::Mdl& io_mdl) {
  const std::size_t width = io_mdl.skin_width, height = io_mdl.skin_height;
  for (formats::MdlSkin& skin : io_mdl.skins)
    for (std::vector<std::uint8_t>& picture : skin.pictures) {
      std::vector<std::uint8_t> enlarged;
      enlarged.reserve(picture.size() * factor * factor);
      for (std::size_t y = 0; y < height * factor; ++y)
        for (std::size_t x = 0; x < width * factor; ++x)
          enlarged.push_back(picture[y / factor * width + x / factor]);
      picture = std::move(enlarged);
    }
  const auto scale = [factor](std::int32_t texel) {
    const auto f = static_cast<std::int32_t>(factor);
    return std::clamp(texel * f + f / 2, -formats::kMaxMdlTexel, formats::kMaxMdlTexel);
  };
  for (formats::MdlTexel& texel : io_mdl.texels) {
    texel.s = scale(texel.s);
    texel.t = scale(texel.t);
  }
  io_mdl.skin_width *= factor;
  io_mdl.skin_height *= factor;
}

std::vector<std::uint8_t> match_skin(formats::Image image, const formats::Mdl& mdl,
                                     const formats::NearestColor& colors) {
  // Transparency is ignored: alias models have none.
  for (std::uint32_t& pixel : image.pixels) pixel |= 0xff000000u;
  const formats::Image fitted = formats::resample(std::move(image), mdl.skin_width, mdl.skin_height);
  std::vector<std::uint8_t> indices;
  indices.reserve(fitted.pixels.size());
  for (const std::uint32_t pixel : fitted.pixels)
    indices.push_back(
        colors.find({static_cast<std::uint8_t>(pixel >> 16 & 255),
                     static_cast<std::uint8_t>(pixel >> 8 & 255), static_cast<std::uint8_t>(pixel & 255)}));
  return indices;
}

}  // namespace

void replace_skins(const vfs::FileSystem& files, std::string_view model_path, formats::Mdl& io_mdl,
                   std::vector<std::string>& io_notes) {
  std::vector<ExternalSkin> skins =
      load_external_skins(files, base::to_lower(model_path), io_mdl.skins.size(), io_notes);
  if (skins.empty()) return;
  const base::Result<Look> look = load_look(files);
  if (!look.ok()) return;
  const formats::NearestColor colors(look->palette, 0, formats::kFirstFullbright);
  if (const std::uint32_t factor = choose_factor(skins, io_mdl); factor > 1) enlarge_skins(factor, io_mdl);
  for (ExternalSkin& skin : skins) {
    const std::vector<std::uint8_t> indices = match_skin(std::move(skin.image), io_mdl, colors);
    for (std::vector<std::uint8_t>& picture : io_mdl.skins[skin.number].pictures) picture = indices;
  }
}

}  // namespace temblor::assets
