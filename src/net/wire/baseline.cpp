#include "net/wire/baseline.h"

namespace temblor::net {
namespace {

// Flags of FitzQuake's form. Each one announces a wider or an additional field.
enum BaselineFlags : std::uint32_t { kLargeModel = 1, kLargeFrame = 2, kHasAlpha = 4, kHasScale = 8 };
constexpr std::uint32_t kAllFlags = kLargeModel | kLargeFrame | kHasAlpha | kHasScale;

// The fields that both forms share.
void read_common_fields(Baseline& out_baseline, FieldReader& io_fields) {
  out_baseline.colormap = io_fields.u8();
  out_baseline.skin = io_fields.u8();
  for (int axis = 0; axis < 3; ++axis) {
    out_baseline.origin[axis] = io_fields.coord();
    out_baseline.angles_deg[axis] = io_fields.angle_deg();
  }
}

// Returns 0 if the original form can hold the baseline, or if the dialect has no other form. Alpha is
// compared as a byte, so a difference that rounding removes takes no space.
std::uint32_t compute_flags(const Baseline& baseline, const Dialect& dialect) {
  if (!is_extended(dialect)) return 0;
  std::uint32_t flags = 0;
  if (baseline.model > 255) flags |= kLargeModel;
  if (baseline.frame > 255) flags |= kLargeFrame;
  if (encode_alpha(baseline.alpha) != encode_alpha(1)) flags |= kHasAlpha;
  if (baseline.scale != 1) flags |= kHasScale;
  return flags;
}

// Writes the fields after the entity number. Without flags, this is the original form, in which numbers
// over 255 are errors.
void write_baseline(const Baseline& baseline, std::uint32_t flags, FieldWriter& io_fields) {
  if (flags != 0) io_fields.u8(static_cast<std::uint8_t>(flags));
  if (flags & kLargeModel)
    io_fields.u16(baseline.model);
  else
    io_fields.low_byte(baseline.model, false, "model");
  if (flags & kLargeFrame)
    io_fields.u16(baseline.frame);
  else
    io_fields.low_byte(baseline.frame, false, "frame");
  io_fields.u8(baseline.colormap);
  io_fields.u8(baseline.skin);
  for (int axis = 0; axis < 3; ++axis) {
    io_fields.coord(baseline.origin[axis]);
    io_fields.angle_deg(baseline.angles_deg[axis]);
  }
  if (flags & kHasAlpha) io_fields.u8(encode_alpha(baseline.alpha));
  if (flags & kHasScale) io_fields.steps8(baseline.scale, kScaleSteps);
}

}  // namespace

Baseline read_baseline(FieldReader& io_fields) {
  Baseline baseline;
  baseline.model = io_fields.u8();
  baseline.frame = io_fields.u8();
  read_common_fields(baseline, io_fields);
  return baseline;
}

Baseline read_baseline2(FieldReader& io_fields) {
  const std::uint32_t flags = io_fields.u8();
  io_fields.check_flags(flags, kAllFlags);
  Baseline baseline;
  baseline.model = flags & kLargeModel ? io_fields.u16() : io_fields.u8();
  baseline.frame = flags & kLargeFrame ? io_fields.u16() : io_fields.u8();
  read_common_fields(baseline, io_fields);
  if (flags & kHasAlpha) baseline.alpha = decode_alpha(io_fields.u8());
  if (flags & kHasScale) baseline.scale = static_cast<float>(io_fields.u8()) / kScaleSteps;
  return baseline;
}

void write_spawn_static(const SpawnStatic& message, FieldWriter& io_fields) {
  const std::uint32_t flags = compute_flags(message.entity, io_fields.dialect());
  io_fields.id(flags != 0 ? MessageId::kSpawnStatic2 : MessageId::kSpawnStatic);
  write_baseline(message.entity, flags, io_fields);
}

void write_spawn_baseline(const SpawnBaseline& message, FieldWriter& io_fields) {
  const std::uint32_t flags = compute_flags(message.entity, io_fields.dialect());
  io_fields.id(flags != 0 ? MessageId::kSpawnBaseline2 : MessageId::kSpawnBaseline);
  io_fields.entity(message.number);
  write_baseline(message.entity, flags, io_fields);
}

}  // namespace temblor::net
