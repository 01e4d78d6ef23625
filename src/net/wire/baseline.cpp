#include "net/wire/baseline.h"

namespace temblor::net {
namespace {

enum Flags : std::uint32_t { kLargeModel = 1, kLargeFrame = 2, kAlpha = 4, kScale = 8 };
constexpr std::uint32_t kAllFlags = kLargeModel | kLargeFrame | kAlpha | kScale;

void read_place(Baseline& out_baseline, FieldReader& io_fields) {
  out_baseline.colormap = io_fields.u8();
  out_baseline.skin = io_fields.u8();
  for (int axis = 0; axis < 3; ++axis) {
    out_baseline.origin[axis] = io_fields.coord();
    out_baseline.angles_deg[axis] = io_fields.angle_deg();
  }
}

std::uint32_t flags_of(const Baseline& baseline, const Dialect& dialect) {
  if (!is_extended(dialect)) return 0;
  std::uint32_t flags = 0;
  if (baseline.model > 255) flags |= kLargeModel;
  if (baseline.frame > 255) flags |= kLargeFrame;
  if (alpha_byte(baseline.alpha) != alpha_byte(1)) flags |= kAlpha;
  if (baseline.scale != 1) flags |= kScale;
  return flags;
}

// Behind the entity's number, where there is one.
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
  if (flags & kAlpha) io_fields.u8(alpha_byte(baseline.alpha));
  if (flags & kScale) io_fields.steps8(baseline.scale, kScaleSteps);
}

}  // namespace

Baseline read_baseline(FieldReader& io_fields) {
  Baseline baseline;
  baseline.model = io_fields.u8();
  baseline.frame = io_fields.u8();
  read_place(baseline, io_fields);
  return baseline;
}

Baseline read_baseline2(FieldReader& io_fields) {
  const std::uint32_t flags = io_fields.u8();
  io_fields.check_flags(flags, kAllFlags);
  Baseline baseline;
  baseline.model = flags & kLargeModel ? io_fields.u16() : io_fields.u8();
  baseline.frame = flags & kLargeFrame ? io_fields.u16() : io_fields.u8();
  read_place(baseline, io_fields);
  if (flags & kAlpha) baseline.alpha = alpha_of(io_fields.u8());
  if (flags & kScale) baseline.scale = static_cast<float>(io_fields.u8()) / kScaleSteps;
  return baseline;
}

void write_spawn_static(const SpawnStatic& message, FieldWriter& io_fields) {
  const std::uint32_t flags = flags_of(message.entity, io_fields.dialect());
  io_fields.id(flags != 0 ? MessageId::kSpawnStatic2 : MessageId::kSpawnStatic);
  write_baseline(message.entity, flags, io_fields);
}

void write_spawn_baseline(const SpawnBaseline& message, FieldWriter& io_fields) {
  const std::uint32_t flags = flags_of(message.entity, io_fields.dialect());
  io_fields.id(flags != 0 ? MessageId::kSpawnBaseline2 : MessageId::kSpawnBaseline);
  io_fields.entity(message.number);
  write_baseline(message.entity, flags, io_fields);
}

}  // namespace temblor::net
