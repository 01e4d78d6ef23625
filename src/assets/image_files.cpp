#include "assets/image_files.h"

#include <algorithm>

namespace temblor::assets {
namespace {

struct ImageKind {
  std::string_view extension;
  base::Result<formats::Image> (*read)(base::Bytes bytes);
};
constexpr ImageKind kImageKinds[] = {
    {".tga", formats::read_tga}, {".png", formats::read_png}, {".jpg", formats::read_jpeg}};

const ImageKind* find_kind(std::string_view name) {
  const auto* const found = std::ranges::find_if(
      kImageKinds, [name](const ImageKind& kind) { return name.ends_with(kind.extension); });
  return found == std::end(kImageKinds) ? nullptr : found;
}

}  // namespace

std::string find_image_file(const vfs::FileSystem& files, const std::string& stem) {
  std::string best;
  for (const ImageKind& kind : kImageKinds) {
    std::string name = stem + std::string(kind.extension);
    if (files.contains(name) && (best.empty() || files.find_game(name) > files.find_game(best)))
      best = std::move(name);
  }
  return best;
}

bool is_image_file(std::string_view name) {
  return find_kind(name) != nullptr;
}

base::Result<formats::Image> read_image_file(const vfs::FileSystem& files, std::string_view name) {
  TRY(const base::ByteVector bytes, files.read(name));
  const ImageKind* const kind = find_kind(name);
  const auto read = kind != nullptr ? kind->read : formats::read_png;
  return read(bytes).with_file(files.describe(name));
}

}  // namespace temblor::assets
