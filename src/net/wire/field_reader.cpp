#include "net/wire/field_reader.h"

#include <cmath>

#include "net/protocol/server_message.h"

namespace temblor::net {

using base::ErrorCode;

float FieldReader::finite(const char* what) {
  const float value = number<float>();
  if (std::isfinite(value)) return value;
  fail(ErrorCode::kMalformed, "{} is {}", what, value);
  return 0;
}

std::string_view FieldReader::text(const char* what) {
  ++bytes_needed_;
  if (!ok()) return {};
  const std::optional<std::string_view> text = bytes_.text();
  // Report the missing zero byte, not a missing number of bytes.
  if (!text) error_ = base::malformed("{} has no terminating zero", what);
  return text.value_or(std::string_view{});
}

bool FieldReader::next_is(std::string_view text) const {
  base::ByteReader ahead = bytes_;
  return base::as_text(ahead.take(text.size())) == text;
}

std::uint16_t FieldReader::entity() {
  return entity(u16());
}

std::uint16_t FieldReader::entity(unsigned number) {
  if (number < kMaxEntities) return static_cast<std::uint16_t>(number);
  fail(ErrorCode::kTooLarge, "entity {} exceeds {}", number, kMaxEntities - 1);
  return 0;
}

float FieldReader::coord() {
  switch (coord_encoding_) {
    case CoordEncoding::kEighths16:
      return static_cast<float>(i16()) / 8;
    case CoordEncoding::kWholeAnd255: {
      const auto whole = static_cast<float>(i16());
      return whole + static_cast<float>(u8()) / 255;
    }
    case CoordEncoding::kSixteenths32:
      return static_cast<float>(i32() / 16.0);
    case CoordEncoding::kFloat:
      break;
  }
  const float value = finite("coordinate");
  if (std::abs(value) <= kMaxCoord) return value;
  fail(ErrorCode::kTooLarge, "coordinate {} exceeds {}", value, static_cast<int>(kMaxCoord));
  return 0;
}

// Bytes and shorts are signed here, so these angles are in [-180, 180).
float FieldReader::angle_deg() {
  switch (angle_encoding_) {
    case AngleEncoding::kByte:
      return static_cast<float>(i8()) * (360.0f / 256);
    case AngleEncoding::kShort:
      return static_cast<float>(i16()) * (360.0f / 65536);
    case AngleEncoding::kFloat:
      break;
  }
  return finite("angle");
}

void FieldReader::check_flags(std::uint32_t flags, std::uint32_t known) {
  if (const std::uint32_t unknown = flags & ~known; unknown != 0)
    fail(ErrorCode::kUnsupported, "protocol {} does not define flags {:#x}",
         static_cast<int>(dialect_.protocol), unknown);
}

}  // namespace temblor::net
