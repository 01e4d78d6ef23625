// Writes the fields of one message. Errors are sticky, as in FieldReader: a value that the dialect cannot
// represent records an error, and writing continues. The caller checks error() at the end and truncates the
// failed message.
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
  // Fails if the value is not finite. `what` names the field in the error.
  void finite(float value, const char* what);
  // Writes the low byte of `value`. Fails for values over 255 unless the high byte follows later.
  void low_byte(unsigned value, bool high_byte_follows, const char* what);
  // Writes the text and a zero byte. Fails if the text contains a zero byte.
  void text(std::string_view text);
  void entity(std::uint16_t number);
  // Fails if the value is outside of the encoding's range.
  void coord(float value);
  void coords(const math::Vec3& value);
  void angle_deg(float value);
  void angles_deg(const math::Vec3& value);
  // Writes value * steps as a byte, rounded and clamped.
  void steps8(float value, float steps) { u8(static_cast<std::uint8_t>(nearest_step(value, steps, 0, 255))); }

  const Dialect& dialect() const { return dialect_; }

  // Records a kTooLarge error; only the first one is kept.
  template <typename... Args>
  void fail(fmt::format_string<Args...> format, Args&&... args) {
    if (!error_) error_ = base::error(base::ErrorCode::kTooLarge, format, std::forward<Args>(args)...);
  }
  const std::optional<base::Error>& error() const { return error_; }

 private:
  base::ByteWriter& bytes_;
  Dialect dialect_;
  CoordEncoding coord_encoding_;
  AngleEncoding angle_encoding_;
  std::optional<base::Error> error_;
};

}  // namespace temblor::net
