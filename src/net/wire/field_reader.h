// Reads the fields of one message from untrusted bytes. Every read is bounds-checked, and errors are sticky:
// reading past the end returns zeros or empty texts, so message readers need no check after each field. Call
// ok() once at the end of the message.
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
  // A float that is not finite is an error, and so is a text without a zero byte. `what` names the field in
  // the error: "text".
  float finite(const char* what);
  std::string_view text(const char* what);
  // Whether the next bytes are those of `text`. Reads nothing.
  bool next_is(std::string_view text) const;
  // An entity number below kMaxEntities; other numbers are errors.
  std::uint16_t entity();
  std::uint16_t entity(unsigned number);
  // In the dialect's encoding.
  float coord();
  math::Vec3 coords() { return {coord(), coord(), coord()}; }
  float angle_deg();
  math::Vec3 angles_deg() { return {angle_deg(), angle_deg(), angle_deg()}; }
  // Fails if `flags` has bits other than `known`: the fields of unknown flags, and so the length of the
  // message, are unknown.
  void check_flags(std::uint32_t flags, std::uint32_t known);

  const Dialect& dialect() const { return dialect_; }
  bool ok() const { return bytes_.ok() && !error_; }

  // Records an error; only the first one is kept.
  template <typename... Args>
  void fail(base::ErrorCode code, fmt::format_string<Args...> format, Args&&... args) {
    if (ok()) error_ = base::error(code, format, std::forward<Args>(args)...);
  }
  // The first error of a field; nullopt if there was none, or if the bytes just ended too early.
  const std::optional<base::Error>& error() const { return error_; }
  // Total size of the fields that were requested, present or not.
  std::size_t bytes_needed() const { return bytes_needed_; }

 private:
  template <typename T>
  T number() {
    bytes_needed_ += sizeof(T);
    return bytes_.read<T>();
  }

  base::ByteReader& bytes_;
  Dialect dialect_;
  CoordEncoding coord_encoding_;
  AngleEncoding angle_encoding_;
  std::optional<base::Error> error_;
  std::size_t bytes_needed_ = 0;
};

}  // namespace temblor::net
