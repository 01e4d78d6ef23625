#include "net/wire/entity_update.h"

#include <array>

namespace temblor::net {
namespace {

using namespace entity_flag;

constexpr std::uint32_t kProtocol15UpdateFlags = kExtend1 - 1;
constexpr std::uint32_t kProtocol666UpdateFlags =
    kProtocol15UpdateFlags | kExtend1 | kAlpha | kFrame2 | kModel2 | kLerpFinish | kScale | kExtend2;

std::uint32_t read_flags(std::uint8_t id, FieldReader& io_fields) {
  const bool extended = is_extended(io_fields.dialect());
  std::uint32_t flags = id;
  if (flags & kMoreBits) flags |= std::uint32_t{io_fields.u8()} << 8;
  if (extended && (flags & kExtend1)) flags |= std::uint32_t{io_fields.u8()} << 16;
  if (extended && (flags & kExtend2)) flags |= std::uint32_t{io_fields.u8()} << 24;
  io_fields.check_flags(flags, extended ? kProtocol666UpdateFlags : kProtocol15UpdateFlags);
  return flags;
}

// Reads the high byte of a field whose low byte came earlier. A high byte alone is an error: the low byte
// would be the baseline's, which a message reader does not know.
void read_high_byte(std::optional<std::uint16_t>& io_field, const char* what, FieldReader& io_fields) {
  const std::uint8_t high = io_fields.u8();
  if (io_field)
    *io_field = static_cast<std::uint16_t>(*io_field | high << 8);
  else
    io_fields.fail(base::ErrorCode::kMalformed, "{} has a high byte but no low byte", what);
}

// Flags for the fields that the update has. Our fields need three bytes of flags at most, so kExtend2 is
// never set.
std::uint32_t compute_flags(const EntityUpdate& update, bool extended) {
  std::uint32_t flags = kSignal;
  if (update.step) flags |= kStep;
  if (update.model) flags |= kModel;
  if (update.frame) flags |= kFrame;
  if (update.colormap) flags |= kColormap;
  if (update.skin) flags |= kSkin;
  if (update.effects) flags |= kEffects;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (update.origin[axis]) flags |= kOrigin[axis];
    if (update.angles_deg[axis]) flags |= kAngle[axis];
  }
  if (update.number > 255) flags |= kLongEntity;
  if (extended) {
    if (update.alpha) flags |= kAlpha;
    if (update.scale) flags |= kScale;
    if (update.frame.value_or(0) > 255) flags |= kFrame2;
    if (update.model.value_or(0) > 255) flags |= kModel2;
    if (update.next_think_s) flags |= kLerpFinish;
  }
  if (flags >> 16) flags |= kExtend1;
  if (flags >> 8) flags |= kMoreBits;
  return flags;
}

}  // namespace

EntityUpdate read_entity_update(std::uint8_t id, FieldReader& io_fields) {
  const std::uint32_t flags = read_flags(id, io_fields);
  EntityUpdate update;
  update.step = flags & kStep;
  update.number = io_fields.entity(flags & kLongEntity ? io_fields.u16() : io_fields.u8());
  if (flags & kModel) update.model = io_fields.u8();
  if (flags & kFrame) update.frame = io_fields.u8();
  if (flags & kColormap) update.colormap = io_fields.u8();
  if (flags & kSkin) update.skin = io_fields.u8();
  if (flags & kEffects) update.effects = io_fields.u8();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (flags & kOrigin[axis]) update.origin[axis] = io_fields.coord();
    if (flags & kAngle[axis]) update.angles_deg[axis] = io_fields.angle_deg();
  }
  if (flags & kAlpha) update.alpha = decode_alpha(io_fields.u8());
  if (flags & kScale) update.scale = static_cast<float>(io_fields.u8()) / kScaleSteps;
  if (flags & kFrame2) read_high_byte(update.frame, "frame", io_fields);
  if (flags & kModel2) read_high_byte(update.model, "model", io_fields);
  if (flags & kLerpFinish) update.next_think_s = static_cast<float>(io_fields.u8()) / kNextThinkSteps;
  return update;
}

void write_entity_update(const EntityUpdate& update, FieldWriter& io_fields) {
  const std::uint32_t flags = compute_flags(update, is_extended(io_fields.dialect()));
  io_fields.u8(static_cast<std::uint8_t>(flags));
  if (flags & kMoreBits) io_fields.u8(static_cast<std::uint8_t>(flags >> 8));
  if (flags & kExtend1) io_fields.u8(static_cast<std::uint8_t>(flags >> 16));
  if (flags & kLongEntity)
    io_fields.entity(update.number);
  else
    io_fields.u8(static_cast<std::uint8_t>(update.number));
  if (update.model) io_fields.low_byte(*update.model, flags & kModel2, "model");
  if (update.frame) io_fields.low_byte(*update.frame, flags & kFrame2, "frame");
  if (update.colormap) io_fields.u8(*update.colormap);
  if (update.skin) io_fields.u8(*update.skin);
  if (update.effects) io_fields.u8(*update.effects);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (update.origin[axis]) io_fields.coord(*update.origin[axis]);
    if (update.angles_deg[axis]) io_fields.angle_deg(*update.angles_deg[axis]);
  }
  if (flags & kAlpha) io_fields.u8(encode_alpha(*update.alpha));
  if (flags & kScale) io_fields.steps8(*update.scale, kScaleSteps);
  if (flags & kFrame2) io_fields.u8(static_cast<std::uint8_t>(*update.frame >> 8));
  if (flags & kModel2) io_fields.u8(static_cast<std::uint8_t>(*update.model >> 8));
  if (flags & kLerpFinish) io_fields.steps8(*update.next_think_s, kNextThinkSteps);
}

}  // namespace temblor::net
