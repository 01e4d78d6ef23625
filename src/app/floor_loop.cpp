#include "app/floor_loop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::app {
namespace {

constexpr std::uint32_t kSide = 256;
constexpr std::uint32_t kStepS = 40000, kStepT = 3000;  // 16.16

template <typename Texel>
using Surface = std::array<Texel, std::size_t{kSide} * kSide>;

template <typename Texel>
constexpr Surface<Texel> make_surface() {
  Surface<Texel> surface{};
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    surface[i] = static_cast<Texel>(0xff000000u | (i * 0x010305u));
  return surface;
}

template <typename Texel>
void fill_rows(std::span<Texel> out, std::size_t width) {
  static constexpr Surface<Texel> kSurface = make_surface<Texel>();
  const std::size_t height = out.size() / width;
  for (std::size_t y = 0; y < height; ++y) {
    Texel* row = out.data() + y * width;
    std::uint32_t s = 0, t = static_cast<std::uint32_t>(y) << 16;
    for (std::size_t x = 0; x < width; ++x) {
      row[x] = kSurface[((t >> 16) & (kSide - 1)) * kSide + ((s >> 16) & (kSide - 1))];
      s += kStepS;
      t += kStepT;
    }
  }
}

}  // namespace

void fill_with_floor_loop(render::FrameBuffer& io_frame) {
  const auto width = static_cast<std::size_t>(io_frame.width());
  if (io_frame.format() == render::PixelFormat::kIndexed)
    fill_rows<std::uint8_t>(io_frame.indexed(), width);
  else
    fill_rows<std::uint32_t>(io_frame.rgb(), width);
}

}  // namespace temblor::app
