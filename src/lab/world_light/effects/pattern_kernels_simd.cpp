// Hot loop. The SIMD versions of pattern_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/world_light/effects/pattern_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/world_light/effects/pattern_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void ChangeRowU8(const PatternRow& row, uint8_t* io_texels) {
  change_row_u8_scalar(row, io_texels);
}
void ChangeRowU32(const PatternRow& row, uint32_t* io_texels) {
  change_row_u32_scalar(row, io_texels);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<int32_t, 16>;
using DU = hn::RebindToUnsigned<DI>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;

// An octave at the texels from x on. The nodes of all lanes lie within two vectors.
HWY_INLINE VI FindOctave(const OctaveRow& octave, int32_t x) {
  const DI d;
  const int32_t first = octave.first + x;
  const VI at = hn::Iota(d, first);
  const int32_t first_node = first >> octave.shift;
  const auto lane =
      hn::IndicesFromVec(d, hn::Sub(hn::ShiftRightSame(at, octave.shift), hn::Set(d, first_node)));
  const VI from = hn::TableLookupLanes(hn::LoadU(d, octave.nodes + first_node), lane);
  const VI to = hn::TableLookupLanes(hn::LoadU(d, octave.nodes + first_node + 1), lane);
  const VI fraction = hn::And(at, hn::Set(d, (1 << octave.shift) - 1));
  return hn::Add(from, hn::ShiftRightSame(hn::Mul(hn::Sub(to, from), fraction), octave.shift));
}

// The pattern at the texels from x on.
HWY_INLINE VI FindPattern(const PatternRow& row, int32_t x) {
  const DI d;
  VI sum = FindOctave(row.octaves[0], x);
  for (int32_t i = 1; i < kPatternOctaves; ++i) sum = hn::Add(sum, FindOctave(row.octaves[i], x));
  const VI bias = hn::ShiftRight<12>(
      hn::Add(hn::Set(d, row.bias_first), hn::Mul(hn::Iota(d, x), hn::Set(d, row.bias_step))));
  return hn::Min(hn::Max(hn::Add(hn::ShiftRight<7>(sum), bias), hn::Zero(d)), hn::Set(d, 255));
}

HWY_INLINE VU ChangeColors(VU colors, VI pattern, const PatternRow& row) {
  const DU d;
  const hn::Repartition<uint8_t, DU> d8;
  const VU ink = hn::GatherIndex(d, row.inks, pattern);
  const VU keep = hn::Add(hn::ShiftRight<24>(ink), hn::Set(d, 1u));
  const VU red_blue = hn::And(colors, hn::Set(d, 0x00ff00ffu)), green = hn::And(colors, hn::Set(d, 0xff00u));
  const VU kept = hn::Or(hn::And(hn::ShiftRight<8>(hn::Mul(red_blue, keep)), hn::Set(d, 0x00ff00ffu)),
                         hn::And(hn::ShiftRight<8>(hn::Mul(green, keep)), hn::Set(d, 0xff00u)));
  const VU add = hn::And(ink, hn::Set(d, 0x00ffffffu));
  const VU sum = hn::BitCast(d, hn::SaturatedAdd(hn::BitCast(d8, kept), hn::BitCast(d8, add)));
  const VU alpha = hn::And(colors, hn::Set(d, 0xff000000u));
  return hn::IfThenElse(hn::Eq(alpha, hn::Zero(d)), colors, hn::Or(sum, alpha));
}

HWY_INLINE VU ChangeIndices(VU indices, VI pattern, const PatternRow& row) {
  const DU d;
  const DI di;
  const VI table_row = hn::ShiftRight<3>(pattern);
  static_assert(kIndexedPatterns == 256 >> 3);
  const VI at = hn::Or(hn::ShiftLeft<8>(table_row), hn::BitCast(di, indices));
  const VI found = hn::GatherOffset(di, reinterpret_cast<const int32_t*>(row.indices), at);
  const VU changed = hn::And(hn::BitCast(d, found), hn::Set(d, 255));
  return hn::IfThenElse(hn::Eq(indices, hn::Set(d, static_cast<uint32_t>(row.clear))), indices, changed);
}

void ChangeRowU8(const PatternRow& row, uint8_t* io_texels) {
  const DU d;
  const hn::Rebind<uint8_t, DU> narrow;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  uint8_t rest[16] = {};
  for (int32_t x = 0; x < row.count; x += lanes) {
    const int32_t left = row.count - x;
    const bool is_whole = left >= lanes;
    for (int32_t i = 0; !is_whole && i < left; ++i) rest[i] = io_texels[x + i];
    uint8_t* const texels = is_whole ? io_texels + x : rest;
    const VU changed = ChangeIndices(hn::PromoteTo(d, hn::LoadU(narrow, texels)), FindPattern(row, x), row);
    hn::StoreU(hn::DemoteTo(narrow, hn::BitCast(DI(), changed)), narrow, texels);
    for (int32_t i = 0; !is_whole && i < left; ++i) io_texels[x + i] = rest[i];
  }
}

void ChangeRowU32(const PatternRow& row, uint32_t* io_texels) {
  const DU d;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  int32_t x = 0;
  for (; x + lanes <= row.count; x += lanes)
    hn::StoreU(ChangeColors(hn::LoadU(d, io_texels + x), FindPattern(row, x), row), d, io_texels + x);
  if (x == row.count) return;
  const auto rest = hn::FirstN(d, static_cast<size_t>(row.count - x));
  const VU colors = hn::MaskedLoad(rest, d, io_texels + x);
  hn::BlendedStore(ChangeColors(colors, FindPattern(row, x), row), rest, d, io_texels + x);
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::lab {

HWY_EXPORT(ChangeRowU8);
HWY_EXPORT(ChangeRowU32);

void change_row_u8_simd(const PatternRow& row, std::uint8_t* io_texels) {
  HWY_DYNAMIC_DISPATCH(ChangeRowU8)(row, io_texels);
}
void change_row_u32_simd(const PatternRow& row, std::uint32_t* io_texels) {
  HWY_DYNAMIC_DISPATCH(ChangeRowU32)(row, io_texels);
}

}  // namespace temblor::lab
#endif
