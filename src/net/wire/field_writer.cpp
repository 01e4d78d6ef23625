#include "net/wire/field_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "net/protocol/server_message.h"

namespace temblor::net {

void FieldWriter::low_byte(unsigned value, bool high_byte_follows, const char* what) {
  if (value > 255 && !high_byte_follows)
    fail("{} {} exceeds 255, the limit of protocol {}", what, value, static_cast<int>(dialect_.protocol));
  u8(static_cast<std::uint8_t>(value));
}

void FieldWriter::finite(float value, const char* what) {
  if (!std::isfinite(value)) fail("{} {} is not finite", what, value);
  bytes_.f32(value);
}

void FieldWriter::text(std::string_view text) {
  if (text.find('\0') != std::string_view::npos) fail("text contains a zero byte");
  bytes_.bytes(base::as_bytes(text));
  u8(0);
}

void FieldWriter::entity(std::uint16_t number) {
  if (number >= kMaxEntities) fail("entity {} exceeds {}", number, kMaxEntities - 1);
  u16(number);
}

// An error is recorded for a value out of range, and 0 is written in its place: the message keeps its length,
// so the fields after it stay in place until the caller drops the message.
void FieldWriter::coord(float value) {
  const auto within = [&](double low, double high) {
    if (value >= low && value <= high) return static_cast<double>(value);
    fail("coordinate {} is outside of [{}, {}]", value, low, high);
    return 0.0;
  };
  switch (coord_encoding_) {
    case CoordEncoding::kEighths16:
      return i16(static_cast<std::int16_t>(nearest_step(within(-4096, 32767 / 8.0), 8, -32768, 32767)));
    case CoordEncoding::kWholeAnd255: {
      const double units = within(-32768, 32768);
      const double whole = std::min(std::floor(units), 32767.0);
      i16(static_cast<std::int16_t>(whole));
      return u8(static_cast<std::uint8_t>(nearest_step(units - whole, 255, 0, 255)));
    }
    case CoordEncoding::kSixteenths32: {
      using Limits = std::numeric_limits<std::int32_t>;
      return i32(nearest_step(within(-kMaxCoord, kMaxCoord), 16, Limits::min(), Limits::max()));
    }
    case CoordEncoding::kFloat:
      return bytes_.f32(static_cast<float>(within(-kMaxCoord, kMaxCoord)));
  }
}

void FieldWriter::coords(const math::Vec3& value) {
  for (int axis = 0; axis < 3; ++axis) coord(value[axis]);
}

void FieldWriter::angle_deg(float value) {
  if (angle_encoding_ == AngleEncoding::kFloat) return finite(value, "angle");
  if (!std::isfinite(value)) fail("angle {} is not finite", value);
  // Wrapped to half a turn either way, so that the number of steps fits. Exactly half a turn may round to
  // either end of the range, which are the same angle.
  const double turn = std::remainder(static_cast<double>(value), 360.0) / 360;
  if (angle_encoding_ == AngleEncoding::kByte)
    u8(static_cast<std::uint8_t>(nearest_step(turn, 256, -128, 128)));
  else
    u16(static_cast<std::uint16_t>(nearest_step(turn, 65536, -32768, 32768)));
}

void FieldWriter::angles_deg(const math::Vec3& value) {
  for (int axis = 0; axis < 3; ++axis) angle_deg(value[axis]);
}

}  // namespace temblor::net
