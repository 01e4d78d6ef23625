#include "host/menus/thumbnails.h"

#include <chrono>
#include <filesystem>

#include "formats/images/image.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr std::uint64_t kMaxPictureBytes = 1 << 22;

}  // namespace

Thumbnails::Thumbnails(const GameData& data) : data_(data), colors_(data.look.palette, 0, 255) {}

Thumbnails::~Thumbnails() {
  if (drawing_.valid()) drawing_.wait();
}

std::filesystem::path Thumbnails::save_picture_file(const std::string& name) const {
  return data_.write_folder / (name + ".png");
}

const formats::Picture* Thumbnails::save_picture(const std::string& name) {
  const auto [entry, is_new] = saves_.try_emplace(name);
  std::optional<formats::Picture>& picture = entry->second;
  if (is_new) {
    const base::Result<base::ByteVector> bytes =
        vfs::read_disk_file(save_picture_file(name), kMaxPictureBytes);
    if (bytes.ok())
      if (const base::Result<formats::Image> image = formats::read_png(*bytes); image.ok())
        picture = make_thumbnail(image->pixels, static_cast<int>(image->width),
                                 static_cast<int>(image->height), colors_);
  }
  return picture ? &*picture : nullptr;
}

const LevelPictures* Thumbnails::level_pictures(const std::string& name) {
  // Fetch the pictures of the previous level, if it is ready. Only one level is drawn at a time, so scrolling
  // through a long list does not start hundreds of threads.
  if (drawing_.valid() && drawing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    levels_[drawn_level_] = drawing_.get();
  const auto found = levels_.find(name);
  if (found != levels_.end()) return found->second ? &*found->second : nullptr;
  if (!drawing_.valid()) {
    drawn_level_ = name;
    drawing_ =
        std::async(std::launch::async, [this, name] { return draw_level_pictures(data_, name, colors_); });
  }
  return nullptr;
}

}  // namespace temblor::host
