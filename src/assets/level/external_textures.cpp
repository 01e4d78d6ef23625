#include "assets/level/external_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "assets/assets.h"
#include "assets/image_files.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "formats/images/colored_texture.h"
#include "formats/images/image.h"

namespace temblor::assets {
namespace {

// Pictures that are decoded at the same time. Fixed, because the number of threads must not decide which
// pictures fit into the memory.
constexpr std::size_t kBatch = 16;

// A texture that has a picture.
struct Replacement {
  std::size_t miptex;         // index
  std::string picture, glow;  // names of files; glow may be empty
};

// The result of loading one.
struct Loaded {
  std::optional<formats::ColoredTexture> texture;
  std::vector<std::string> notes;
};

std::string find_glow(const vfs::FileSystem& files, std::string_view picture) {
  const std::string stem(picture.substr(0, picture.rfind('.')));
  std::string glow = find_image_file(files, stem + "_glow");
  return glow.empty() ? find_image_file(files, stem + "_luma") : glow;
}

std::vector<Replacement> find_replacements(const vfs::FileSystem& files, std::string_view map_name,
                                           const formats::Bsp& bsp) {
  const auto level_game = files.find_game(fmt::format("maps/{}.bsp", map_name));
  std::vector<Replacement> found;
  for (std::size_t i = 0; i < bsp.miptexes.size(); ++i) {
    const formats::BspMiptex& miptex = bsp.miptexes[i];
    if (!miptex.present || miptex.width == 0 || miptex.height == 0 || miptex.name.empty()) continue;
    std::string name = base::to_lower(miptex.name);
    std::ranges::replace(name, '*', '#');
    std::string picture = find_image_file(files, fmt::format("textures/{}/{}", map_name, name));
    // A picture in a lower game folder is for the level that this one hides.
    if (!picture.empty() && files.find_game(picture) < level_game) picture.clear();
    if (picture.empty()) picture = find_image_file(files, fmt::format("textures/{}", name));
    if (picture.empty()) continue;
    std::string glow = find_glow(files, picture);
    found.push_back({i, std::move(picture), std::move(glow)});
  }
  return found;
}

base::Result<formats::Image> read_picture_file(const vfs::FileSystem& files, const std::string& name) {
  TRY(formats::Image image, read_image_file(files, name));
  if (image.pixels.size() > kMaxExternalTexturePixels) {
    base::Error error =
        base::error(base::ErrorCode::kTooLarge, "{} x {} pixels, but textures have at most {}", image.width,
                    image.height, kMaxExternalTexturePixels);
    error.file = files.describe(name);
    return error;
  }
  return image;
}

Loaded load_replacement(const vfs::FileSystem& files, const Replacement& replacement,
                        const formats::BspMiptex& miptex, const formats::MipColors& colors) {
  Loaded loaded;
  base::Result<formats::Image> picture = read_picture_file(files, replacement.picture);
  if (!picture.ok()) {
    loaded.notes.push_back(fmt::format("{}; the level's own texture is drawn", picture.error().message()));
    return loaded;
  }
  formats::Image glow;
  if (!replacement.glow.empty()) {
    base::Result<formats::Image> read = read_picture_file(files, replacement.glow);
    if (read.ok())
      glow = std::move(read).value();
    else
      loaded.notes.push_back(fmt::format("{}; the texture does not glow", read.error().message()));
  }
  const formats::TextureFrame frame{miptex.width, miptex.height, miptex.name.starts_with('{')};
  loaded.texture = formats::make_colored_texture(frame, std::move(picture).value(), glow, colors);
  return loaded;
}

}  // namespace

// In batches, so that pictures beyond the memory limit are never decoded.
world::ColoredTextures load_external_textures(const vfs::FileSystem& files, std::string_view map_name,
                                              const formats::Bsp& bsp, std::vector<std::string>& io_notes) {
  const std::vector<Replacement> replacements = find_replacements(files, map_name, bsp);
  if (replacements.empty()) return {};
  const base::Result<Look> look = load_look(files);
  if (!look.ok()) return {};
  const formats::MipColors colors(look->palette);
  base::Jobs jobs(std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  world::ColoredTextures textures(bsp.miptexes.size());
  std::size_t bytes = 0;
  for (std::size_t first = 0; first < replacements.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, replacements.size() - first);
    std::array<Loaded, kBatch> batch;
    jobs.parallel_for(count, [&](std::size_t i) {
      const Replacement& replacement = replacements[first + i];
      batch[i] = load_replacement(files, replacement, bsp.miptexes[replacement.miptex], colors);
    });
    for (std::size_t i = 0; i < count; ++i) {
      const Replacement& replacement = replacements[first + i];
      io_notes.insert(io_notes.end(), batch[i].notes.begin(), batch[i].notes.end());
      if (!batch[i].texture) continue;
      bytes += formats::count_bytes(*batch[i].texture);
      if (bytes > kMaxExternalTextureBytes) {
        io_notes.push_back(
            fmt::format("{}: this level's pictures need more than {} MiB; the level's own textures are drawn "
                        "from here on",
                        files.describe(replacement.picture), kMaxExternalTextureBytes >> 20));
        return textures;
      }
      textures[replacement.miptex] = std::move(batch[i].texture);
    }
  }
  return textures;
}

}  // namespace temblor::assets
