// The fields of one message, read from bytes that anybody may have sent.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"
#include "net/wire/encoding.h"

namespace temblor::net {

// Fields are read without asking whether they are there: past the end they are zero or empty, and what is
// wrong with the message as a whole is asked once, at its end. A field that makes no sense is refused; the
// first refusal is kept.
class FieldReader {
 public:
  FieldReader(base::ByteReader& io_bytes, const Dialect& dialect)
      : bytes_(io_bytes),
        dialect_(dialect),
        coord_encoding_(coord_encoding(dialect)),
        angle_encoding_(angle_encoding(dialect)) {}

  std::uint8_t u8() { return number<std::uint8_t>(); }
  std::int8_t i8() { return number<std::int8_t>(); }
  std::uint16_t u16() { return number<std::uint16_t>(); }
  std::int16_t i16() { return number<std::int16_t>(); }
  std::uint32_t u32() { return number<std::uint32_t>(); }
  std::int32_t i32() { return number<std::int32_t>(); }
  // `what` names the field where it is refused, with its article: "the text".
  float finite(const char* what);
  std::string_view text(const char* what);
  // Below kMaxEntities.
  std::uint16_t entity();
  std::uint16_t entity(unsigned number);
  float coord();
  math::Vec3 coords() { return {coord(), coord(), coord()}; }
  float angle_deg();
  math::Vec3 angles_deg() { return {angle_deg(), angle_deg(), angle_deg()}; }
  // Refuses a set of flags that holds others than `known`: nobody knows what fields they would bring.
  void check_flags(std::uint32_t flags, std::uint32_t known);

  const Dialect& dialect() const { return dialect_; }
  bool ok() const { return bytes_.ok() && !refusal_; }

  template <typename... Args>
  void refuse(base::ErrorCode code, fmt::format_string<Args...> format, Args&&... args) {
    if (ok()) refusal_ = base::error(code, format, std::forward<Args>(args)...);
  }
  // Nothing when all was fine, or when the bytes ended too soon.
  const std::optional<base::Error>& refusal() const { return refusal_; }
  // How many bytes the fields have that were asked for, whether they were there or not.
  std::size_t bytes_wanted() const { return bytes_wanted_; }

 private:
  template <typename T>
  T number() {
    bytes_wanted_ += sizeof(T);
    return bytes_.read<T>();
  }

  base::ByteReader& bytes_;
  Dialect dialect_;
  CoordEncoding coord_encoding_;
  AngleEncoding angle_encoding_;
  std::optional<base::Error> refusal_;
  std::size_t bytes_wanted_ = 0;
};

}  // namespace temblor::net
