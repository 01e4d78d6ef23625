#include "render/screen/present_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/screen/present_kernels_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void ExpandPalette(const uint8_t* HWY_RESTRICT indices, size_t count, const uint32_t* HWY_RESTRICT colours,
                   uint32_t* HWY_RESTRICT out) {
  const hn::CappedTag<uint32_t, 16> d;
  const hn::Rebind<int32_t, decltype(d)> di;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  const size_t lanes = hn::Lanes(d);
  size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto positions = hn::PromoteTo(di, hn::LoadU(d8, indices + i));
    hn::StoreU(hn::GatherIndex(d, colours, positions), d, out + i);
  }
  for (; i < count; ++i) out[i] = colours[indices[i]];
}

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(ExpandPalette);

void expand_palette_vector(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colours,
                           std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(ExpandPalette)(indices, count, colours, out);
}

}  // namespace temblor::render
#endif
