#include "formats/bspx/hdr_light.h"

#include <algorithm>
#include <cmath>

#include "base/bytes.h"

namespace temblor::formats {
namespace {

constexpr int kMantissaBits = 9, kMaxMantissa = (1 << kMantissaBits) - 1, kExponentBias = 24,
              kMaxExponent = 31;
constexpr float kLargest = 65408;  // kMaxMantissa * 2^(kMaxExponent - kExponentBias)

}  // namespace

// The exponent is the smallest with which the brightest channel fits its bits after rounding.
std::uint32_t pack_e5bgr9(const math::Vec3& light) {
  const math::Vec3 limited = glm::clamp(light, math::Vec3(0.0f), math::Vec3(kLargest));
  const float brightest = std::max({limited.x, limited.y, limited.z});
  int exponent = 0;
  if (brightest > 0) {
    std::frexp(brightest, &exponent);  // brightest < 2^exponent
    exponent = std::clamp(exponent - kMantissaBits + kExponentBias, 0, kMaxExponent);
    if (std::lround(std::ldexp(brightest, kExponentBias - exponent)) > kMaxMantissa) ++exponent;
  }
  std::uint32_t packed = static_cast<std::uint32_t>(exponent) << (3 * kMantissaBits);
  for (int channel = 0; channel < 3; ++channel) {
    const long number = std::lround(std::ldexp(limited[channel], kExponentBias - exponent));
    packed |= static_cast<std::uint32_t>(number) << (channel * kMantissaBits);
  }
  return packed;
}

math::Vec3 unpack_e5bgr9(std::uint32_t packed) {
  const int exponent = static_cast<int>(packed >> (3 * kMantissaBits));
  math::Vec3 light;
  for (int channel = 0; channel < 3; ++channel)
    light[channel] = std::ldexp(static_cast<float>(packed >> (channel * kMantissaBits) & kMaxMantissa),
                                exponent - kExponentBias);
  return light;
}

base::Result<std::vector<std::uint32_t>> read_hdr_light(const Bsp& bsp) {
  std::vector<std::uint32_t> samples;
  const BspxLump* const lump = bsp.find_bspx(kHdrLightLump);
  if (lump == nullptr) return samples;
  if (lump->data.size() != bsp.lighting.size() * sizeof(std::uint32_t))
    return base::malformed("lump {}: {} bytes, but {} samples need {}", lump->name, lump->data.size(),
                           bsp.lighting.size(), bsp.lighting.size() * sizeof(std::uint32_t));
  base::ByteReader reader(lump->data);
  samples.resize(bsp.lighting.size());
  for (std::uint32_t& sample : samples) sample = reader.u32();
  return samples;
}

void set_hdr_light(std::span<const std::uint32_t> samples, Bsp& io_bsp) {
  std::erase_if(io_bsp.bspx, [](const BspxLump& lump) { return lump.name == kHdrLightLump; });
  if (samples.empty()) return;
  base::ByteWriter writer;
  for (const std::uint32_t sample : samples) writer.u32(sample);
  io_bsp.bspx.push_back({kHdrLightLump, std::move(writer).take()});
}

}  // namespace temblor::formats
