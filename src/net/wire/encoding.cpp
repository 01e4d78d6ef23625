#include "net/wire/encoding.h"

#include <cmath>

namespace temblor::net {

CoordEncoding coord_encoding(const Dialect& dialect) {
  if (dialect.protocol != Protocol::kRmq) return CoordEncoding::kEighths16;
  if (dialect.flags & kFloatCoord) return CoordEncoding::kFloat;
  if (dialect.flags & kInt32Coord) return CoordEncoding::kSixteenths32;
  if (dialect.flags & k24BitCoord) return CoordEncoding::kWholeAnd255;
  return CoordEncoding::kEighths16;
}

AngleEncoding angle_encoding(const Dialect& dialect) {
  if (dialect.protocol != Protocol::kRmq) return AngleEncoding::kByte;
  if (dialect.flags & kFloatAngle) return AngleEncoding::kFloat;
  if (dialect.flags & kShortAngle) return AngleEncoding::kShort;
  return AngleEncoding::kByte;
}

float decode_alpha(std::uint8_t byte) {
  return byte == 0 ? 1.0f : static_cast<float>(byte - 1) / 254.0f;
}

std::uint8_t encode_alpha(float alpha) {
  return static_cast<std::uint8_t>(1 + nearest_step(alpha, 254, 0, 254));
}

int nearest_step(double value, double steps, int low, int high) {
  const double scaled = std::round(value * steps);
  if (!(scaled > low)) return low;
  return scaled < high ? static_cast<int>(scaled) : high;
}

}  // namespace temblor::net
