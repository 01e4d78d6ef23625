#include "host/menus/thumbnails.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "formats/images/image.h"
#include "render/renderer.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr int kSamples = 4;  // drawn per pixel of a level's picture, in each direction
constexpr std::uint64_t kMaxPictureBytes = 1 << 22;

int brightness(std::uint32_t rgb) {
  return static_cast<int>((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 3;
}

// Brightens a dark picture like a camera's exposure: nine tenths of the visible pixels get no brighter than
// kTarget. Black pixels, outside the level, are not counted, and a bright picture is never darkened.
void expose(std::span<std::uint32_t> io_rgb) {
  constexpr int kTarget = 150, kMaxGain = 8, kMaxBlack = 2;
  std::vector<int> visible;
  for (const std::uint32_t pixel : io_rgb)
    if (brightness(pixel) > kMaxBlack) visible.push_back(brightness(pixel));
  if (visible.empty()) return;
  const auto ninth_decile = visible.begin() + static_cast<std::ptrdiff_t>(visible.size() * 9 / 10);
  std::nth_element(visible.begin(), ninth_decile, visible.end());
  const float gain =
      std::clamp(static_cast<float>(kTarget) / static_cast<float>(*ninth_decile), 1.0f, float{kMaxGain});
  for (std::uint32_t& pixel : io_rgb) {
    std::uint32_t brighter = 0;
    for (const int shift : {16, 8, 0})
      brighter |=
          static_cast<std::uint32_t>(std::min(255.0f, static_cast<float>(pixel >> shift & 255) * gain))
          << shift;
    pixel = brighter;
  }
}

// Draws the whole level from above. Ceilings do not hide the rooms: the camera sees their back sides, which
// are culled. The sky stays black.
formats::Picture draw_level(const world::Level& level, const assets::Look& look,
                            const formats::NearestColor& colors) {
  const math::Bounds& bounds = level.world().bounds;
  const math::Vec3 size = bounds.maxs - bounds.mins;
  render::Scene scene;
  scene.level = &level;
  scene.camera.origin_world = (bounds.mins + bounds.maxs) * 0.5f + math::Vec3(0, 0, glm::length(size));
  scene.camera.angles_deg = {90, 0, 0};
  scene.camera.projection = render::Projection::kOrthographic;
  const render::Skybox empty;
  scene.skybox = &empty;
  render::FrameBuffer frame(kSamples * kThumbnailWidth, kSamples * kThumbnailHeight,
                            render::PixelFormat::kRgb);
  render::Renderer renderer(look.palette, look.colormap);
  renderer.render(scene, {}, frame);
  expose(frame.rgb());
  return make_thumbnail(frame.rgb(), frame.width(), frame.height(), colors);
}

std::optional<formats::Picture> try_draw_level(const GameData& data, const std::string& name,
                                               const formats::NearestColor& colors) {
  const base::Result<assets::LoadedLevel> loaded = assets::load_level(data.library.files(), name);
  if (!loaded.ok()) return std::nullopt;
  return draw_level(*loaded->level, data.look, colors);
}

}  // namespace

formats::Picture make_thumbnail(std::span<const std::uint32_t> rgb, int width, int height,
                                const formats::NearestColor& colors) {
  formats::Picture picture{kThumbnailWidth, kThumbnailHeight, {}};
  picture.pixels.reserve(kThumbnailWidth * kThumbnailHeight);
  for (int y = 0; y < kThumbnailHeight; ++y) {
    const int top = y * height / kThumbnailHeight,
              bottom = std::max((y + 1) * height / kThumbnailHeight, top + 1);
    for (int x = 0; x < kThumbnailWidth; ++x) {
      const int left = x * width / kThumbnailWidth,
                right = std::max((x + 1) * width / kThumbnailWidth, left + 1);
      std::uint64_t red = 0, green = 0, blue = 0;
      for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
          const std::uint32_t pixel = rgb[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(column)];
          red += pixel >> 16 & 255;
          green += pixel >> 8 & 255;
          blue += pixel & 255;
        }
      const auto count = static_cast<std::uint64_t>(bottom - top) * static_cast<std::uint64_t>(right - left);
      picture.pixels.push_back(
          colors.find({static_cast<std::uint8_t>(red / count), static_cast<std::uint8_t>(green / count),
                       static_cast<std::uint8_t>(blue / count)}));
    }
  }
  return picture;
}

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

const formats::Picture* Thumbnails::level_picture(const std::string& name) {
  // Fetch the picture of the previous level, if it is ready. Only one level is drawn at a time, so scrolling
  // through a long list does not start hundreds of threads.
  if (drawing_.valid() && drawing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    levels_[drawn_level_] = drawing_.get();
  const auto found = levels_.find(name);
  if (found != levels_.end()) return found->second ? &*found->second : nullptr;
  if (!drawing_.valid()) {
    drawn_level_ = name;
    drawing_ = std::async(std::launch::async, [this, name] { return try_draw_level(data_, name, colors_); });
  }
  return nullptr;
}

}  // namespace temblor::host
