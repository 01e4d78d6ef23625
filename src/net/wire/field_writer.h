// The fields of one message, written.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"
#include "net/wire/encoding.h"
#include "net/wire/message_id.h"

namespace temblor::net {

// Fields are written without asking whether they fit; what does not is refused, and the first refusal is
// kept. What was written of a refused message is for its caller to take back.
class FieldWriter {
 public:
  FieldWriter(base::ByteWriter& io_bytes, const Dialect& dialect)
      : bytes_(io_bytes),
        dialect_(dialect),
        coord_encoding_(coord_encoding(dialect)),
        angle_encoding_(angle_encoding(dialect)) {}

  void id(MessageId id) { u8(static_cast<std::uint8_t>(id)); }
  void u8(std::uint8_t value) { bytes_.u8(value); }
  void i8(std::int8_t value) { bytes_.write(value); }
  void u16(std::uint16_t value) { bytes_.u16(value); }
  void i16(std::int16_t value) { bytes_.i16(value); }
  void u32(std::uint32_t value) { bytes_.u32(value); }
  void i32(std::int32_t value) { bytes_.i32(value); }
  void finite(float value, const char* what);
  // The low byte of `value`; refuses one over 255 unless its high byte is going to follow.
  void low_byte(unsigned value, bool high_byte_follows, const char* what);
  // Refuses a text with a zero in it.
  void text(std::string_view text);
  void entity(std::uint16_t number);
  // Refuses what lies outside of the encoding's range.
  void coord(float value);
  void coords(const math::Vec3& value);
  void angle_deg(float value);
  void angles_deg(const math::Vec3& value);
  // To the nearest whole number of steps of 1 / `steps` that fits.
  void steps8(float value, float steps) { u8(static_cast<std::uint8_t>(nearest_step(value, steps, 0, 255))); }

  const Dialect& dialect() const { return dialect_; }

  template <typename... Args>
  void refuse(fmt::format_string<Args...> format, Args&&... args) {
    if (!refusal_) refusal_ = base::error(base::ErrorCode::kTooLarge, format, std::forward<Args>(args)...);
  }
  const std::optional<base::Error>& refusal() const { return refusal_; }

 private:
  base::ByteWriter& bytes_;
  Dialect dialect_;
  CoordEncoding coord_encoding_;
  AngleEncoding angle_encoding_;
  std::optional<base::Error> refusal_;
};

}  // namespace temblor::net
