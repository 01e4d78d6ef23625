#include "formats/bspx/light_directions.h"

#include <algorithm>
#include <cmath>

#include "formats/levels/lit.h"

namespace temblor::formats {
namespace {

constexpr float kDirectionScale = 127, kDirectionZero = 128;
constexpr std::size_t kBytesPerDirection = 3;

}  // namespace

std::array<std::uint8_t, 3> pack_direction(const math::Vec3& direction) {
  std::array<std::uint8_t, 3> packed{};
  for (int axis = 0; axis < 3; ++axis)
    packed[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(
        std::lround(std::clamp(direction[axis], -1.0f, 1.0f) * kDirectionScale + kDirectionZero));
  return packed;
}

math::Vec3 unpack_direction(std::span<const std::uint8_t, 3> packed) {
  return (math::Vec3(packed[0], packed[1], packed[2]) - kDirectionZero) / kDirectionScale;
}

base::Result<std::vector<std::uint8_t>> read_light_directions(const Bsp& bsp) {
  const BspxLump* const lump = bsp.find_bspx(kLightDirectionsLump);
  if (lump == nullptr) return std::vector<std::uint8_t>();
  if (lump->data.size() != bsp.lighting.size() * kBytesPerDirection)
    return base::malformed("lump {}: {} bytes, but {} samples need {}", lump->name, lump->data.size(),
                           bsp.lighting.size(), bsp.lighting.size() * kBytesPerDirection);
  const auto bytes = base::as_u8(lump->data);
  return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}

void set_light_directions(std::span<const std::uint8_t> samples, Bsp& io_bsp) {
  std::erase_if(io_bsp.bspx, [](const BspxLump& lump) { return lump.name == kLightDirectionsLump; });
  if (samples.empty()) return;
  const base::Bytes bytes = std::as_bytes(samples);
  io_bsp.bspx.push_back({kLightDirectionsLump, base::ByteVector(bytes.begin(), bytes.end())});
}

base::Result<std::vector<std::uint8_t>> read_lux(base::Bytes bytes) {
  return read_light_samples(bytes, "light directions");
}

base::ByteVector write_lux(std::span<const std::uint8_t> samples) {
  return write_light_samples(samples);
}

}  // namespace temblor::formats
