#include "support/pictures/picture_file.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/check.h"
#include "render/present.h"

namespace temblor::test {

void show_picture(const std::string& name, const render::FrameBuffer& frame,
                  const formats::Palette& palette) {
  const char* const folder = std::getenv("TEMBLOR_PICTURES");
  if (folder == nullptr) return;
  const std::filesystem::path path = std::filesystem::path(folder) / (name + ".ppm");
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << frame.width() << ' ' << frame.height() << "\n255\n";
  const formats::Palette shown = render::shown_palette(frame, palette);
  for (std::size_t i = 0; i < frame.pixel_count(); ++i) {
    const std::uint32_t color = frame.format() == render::PixelFormat::kIndexed
                                    ? render::to_rgb(shown[frame.indexed()[i]])
                                    : frame.rgb()[i];
    for (const int shift : {16, 8, 0}) file.put(static_cast<char>(color >> shift));
  }
  CHECK(file.good(), "{} cannot be written", path.string());
}

}  // namespace temblor::test
