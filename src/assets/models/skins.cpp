#include "assets/models/skins.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "assets/assets.h"
#include "assets/image_files.h"
#include "base/text.h"
#include "formats/images/image.h"
#include "formats/images/nearest_color.h"

namespace temblor::assets {
namespace {

// In the order of precedence within a game folder.
constexpr std::array<std::string_view, 4> kExtensions = {".tga", ".png", ".jpg", ".lmp"};
// The members of an animated skin last as long as in most models.
constexpr float kSkinPicture_s = 0.1f;

std::string find_folder(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? std::string() : std::string(path.substr(0, slash + 1));
}

std::string remove_extension(std::string_view path) {
  const std::size_t dot = path.rfind('.'), slash = path.find_last_of("/\\");
  const bool has_extension =
      dot != std::string_view::npos && (slash == std::string_view::npos || dot > slash);
  return std::string(has_extension ? path.substr(0, dot) : path);
}

// Finds and reads the pictures of one model.
class SkinLoader {
 public:
  SkinLoader(const vfs::FileSystem& files, std::string_view model_path)
      : files_(files), model_path_(model_path) {}

  // Returns the path of a picture of this skin, if there is one.
  std::optional<std::string> find(const formats::PosedMesh& mesh, std::size_t skin,
                                  std::size_t member) const {
    const std::string name = mesh.skins.empty() ? remove_extension(model_path_)
                                                : mesh.skins[std::min(skin, mesh.skins.size() - 1)];
    const std::string stem = remove_extension(name);
    const std::string number = fmt::format("_{:02}_{:02}", skin, member);
    if (auto found = find_picture(stem + number)) return found;
    const bool has_own_name = skin < std::max<std::size_t>(mesh.skins.size(), 1) && member == 0;
    return has_own_name ? find_picture(stem) : std::nullopt;
  }

  base::Result<formats::Picture> read(const std::string& path) {
    if (is_image_file(path)) {
      TRY(const formats::Image image, read_image_file(files_, path));
      return match_to_palette(image);
    }
    TRY(const base::ByteVector bytes, files_.read(path));
    return formats::read_picture(bytes).with_file(files_.describe(path));
  }

 private:
  // Looks in the folder of the name, then in that of the model.
  std::optional<std::string> find_picture(const std::string& stem) const {
    const std::string base_name = stem.substr(find_folder(stem).size());
    for (const std::string& place : {stem, find_folder(model_path_) + base_name}) {
      std::optional<std::string> best;
      for (const std::string_view extension : kExtensions) {
        const std::string path = fmt::format("{}{}", place, extension);
        if (files_.contains(path) && (!best || files_.find_game(path) > files_.find_game(*best))) best = path;
      }
      if (best) return best;
    }
    return std::nullopt;
  }

  // Transparency is ignored: alias models have none.
  base::Result<formats::Picture> match_to_palette(const formats::Image& image) {
    if (!colors_) {
      TRY(const Look look, load_look(files_));
      colors_.emplace(look.palette, 0, formats::kFirstFullbright);
    }
    formats::Picture picture{image.width, image.height, {}};
    picture.pixels.reserve(image.pixels.size());
    for (const std::uint32_t pixel : image.pixels)
      picture.pixels.push_back(colors_->find({static_cast<std::uint8_t>(pixel >> 16 & 255),
                                              static_cast<std::uint8_t>(pixel >> 8 & 255),
                                              static_cast<std::uint8_t>(pixel & 255)}));
    return picture;
  }

  const vfs::FileSystem& files_;
  const std::string model_path_;
  std::optional<formats::NearestColor> colors_;  // made for the first picture that needs it
};

// A checkerboard of the two ends of the palette's first row.
formats::Picture make_missing_skin() {
  constexpr std::uint32_t kSide = 64, kCheck = 8;
  constexpr std::uint8_t kDark = 0, kLight = 15;
  formats::Picture picture{kSide, kSide, {}};
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    picture.pixels.push_back((i % kSide / kCheck + i / kSide / kCheck) % 2 == 0 ? kDark : kLight);
  return picture;
}

// Returns the mesh's picture for the skin if there is a usable one, otherwise that of the first skin.
formats::Picture load_picture(SkinLoader& io_loader, const formats::PosedMesh& mesh, std::size_t skin,
                              std::size_t member, std::vector<std::string>& io_problems) {
  std::optional<std::string> path = io_loader.find(mesh, skin, member);
  if (!path) path = io_loader.find(mesh, skin, 0);
  if (!path) path = io_loader.find(mesh, 0, 0);
  if (!path) {
    const std::string name = mesh.skins.empty() ? "of a mesh without a name" : mesh.skins.front();
    io_problems.push_back(
        fmt::format("its skin {} is missing (NAME_00_00.lmp, NAME.tga, or NAME.png)", base::printable(name)));
    return make_missing_skin();
  }
  base::Result<formats::Picture> picture = io_loader.read(*path);
  if (picture.ok()) return std::move(picture).value();
  io_problems.push_back(picture.error().message());
  return make_missing_skin();
}

bool has_picture(const SkinLoader& loader, const std::vector<formats::PosedMesh>& meshes, std::size_t skin,
                 std::size_t member) {
  return std::ranges::any_of(
      meshes, [&](const formats::PosedMesh& mesh) { return loader.find(mesh, skin, member).has_value(); });
}

}  // namespace

std::vector<formats::PosedSkin> load_skins(const vfs::FileSystem& files, std::string_view model_path,
                                           const std::vector<formats::PosedMesh>& meshes,
                                           std::vector<std::string>& io_problems) {
  SkinLoader loader(files, model_path);
  std::vector<formats::PosedSkin> skins;
  for (std::size_t number = 0; number < kMaxSkins; ++number) {
    if (number > 0 && !has_picture(loader, meshes, number, 0)) break;
    formats::PosedSkin& skin = skins.emplace_back();
    for (std::size_t member = 0; member < kMaxSkinPictures; ++member) {
      if (member > 0 && !has_picture(loader, meshes, number, member)) break;
      std::vector<formats::Picture>& pictures = skin.pictures.emplace_back();
      for (const formats::PosedMesh& mesh : meshes)
        pictures.push_back(load_picture(loader, mesh, number, member, io_problems));
      skin.end_times_s.push_back(kSkinPicture_s * static_cast<float>(member + 1));
    }
    if (skin.pictures.size() == 1) skin.end_times_s.clear();
  }
  return skins;
}

}  // namespace temblor::assets
