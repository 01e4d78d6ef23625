#include "net/protocol/clamped_fields.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "net/wire/field_writer.h"

namespace temblor::net {
namespace {

// Range of values that FieldWriter::coord() accepts.
struct Range {
  float low, high;
};
Range find_coord_range(CoordEncoding encoding) {
  switch (encoding) {
    case CoordEncoding::kEighths16:
      return {-4096, 32767 / 8.0f};
    case CoordEncoding::kWholeAnd255:
      return {-32768, 32768};
    case CoordEncoding::kSixteenths32:
    case CoordEncoding::kFloat:
      break;
  }
  return {-kMaxCoord, kMaxCoord};
}

}  // namespace

void write_coord(float value, const Dialect& dialect, base::ByteWriter& io_writer) {
  const Range range = find_coord_range(coord_encoding(dialect));
  FieldWriter fields(io_writer, dialect);
  fields.coord(std::isnan(value) ? 0.0f : std::clamp(value, range.low, range.high));
  CHECK(!fields.error(), "{}", value);
}

void write_angle_deg(float value, const Dialect& dialect, base::ByteWriter& io_writer) {
  FieldWriter fields(io_writer, dialect);
  fields.angle_deg(std::isfinite(value) ? value : 0.0f);
  CHECK(!fields.error(), "{}", value);
}

}  // namespace temblor::net
