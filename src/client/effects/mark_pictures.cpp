#include "client/effects/mark_pictures.h"

#include <fmt/format.h>

namespace temblor::client {

namespace {

constexpr std::string_view kFolder = "gfx/marks/", kSuffix = ".png";

}  // namespace

MarkPictures MarkPictures::load(const assets::Library& library, std::vector<std::string>& io_notes) {
  MarkPictures loaded;
  for (const std::string& file : library.files().list(kFolder, kSuffix)) {
    if (loaded.pictures_.size() == kMaxPictures) {
      io_notes.push_back(fmt::format("{} and later files: only {} pictures of marks are loaded",
                                     library.files().describe(file), kMaxPictures));
      break;
    }
    const base::Result<formats::Image> image = library.image(file);
    if (!image.ok()) {
      io_notes.push_back(image.error().message());
      continue;
    }
    constexpr std::uint32_t kMaxSide = render::MarkPicture::kMaxSide;
    if (image->width > kMaxSide || image->height > kMaxSide) {
      io_notes.push_back(fmt::format("{}: {} x {} pixels; a mark has at most {} x {}",
                                     library.files().describe(file), image->width, image->height, kMaxSide,
                                     kMaxSide));
      continue;
    }
    const std::string name = file.substr(kFolder.size(), file.size() - kFolder.size() - kSuffix.size());
    loaded.pictures_.emplace(name, std::make_shared<const render::MarkPicture>(*image));
  }
  return loaded;
}

std::shared_ptr<const render::MarkPicture> MarkPictures::find(std::string_view name) const {
  const auto found = pictures_.find(name);
  return found == pictures_.end() ? nullptr : found->second;
}

}  // namespace temblor::client
