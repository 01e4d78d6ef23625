// How numbers that are not whole are put into bytes: coordinates and angles as the dialect says, the rest
// alike in all of them.
#pragma once

#include <cstdint>

#include "net/protocol/protocol.h"

namespace temblor::net {

enum class CoordEncoding {
  kEighths16,     // i16 of eighths of a unit
  kWholeAnd255,   // i16 of whole units, u8 of 255ths
  kSixteenths32,  // i32 of sixteenths of a unit
  kFloat,
};
enum class AngleEncoding {
  kByte,   // 256ths of a turn
  kShort,  // 65536ths of a turn
  kFloat,  // degrees
};

// A wider encoding wins over a narrower one where flags name several: float, then 32 bits, then 24.
CoordEncoding coord_encoding(const Dialect& dialect);
AngleEncoding angle_encoding(const Dialect& dialect);

// Whether it has the longer forms of messages that FitzQuake added.
inline bool is_extended(const Dialect& dialect) {
  return dialect.protocol != Protocol::kNetQuake;
}

// Coordinates stay within this whatever the encoding: what the widest whole-number one can say.
constexpr float kMaxCoord = 1 << 27;

// Opacity: byte 0 says nothing (opaque), 1 is invisible, 255 opaque.
float alpha_of(std::uint8_t byte);
std::uint8_t alpha_byte(float alpha);  // the nearest, never 0

constexpr float kScaleSteps = 16;        // a byte of 16ths
constexpr float kAttenuationSteps = 64;  // a byte of 64ths
constexpr float kDirectionSteps = 16;    // a signed byte of 16ths
constexpr float kVelocityUnit = 16;      // a signed byte of steps of 16 units a second
constexpr float kNextThinkSteps = 255;   // a byte of 255ths of a second
constexpr float kFogSteps = 255;         // bytes of 255ths
constexpr float kFogTimeSteps = 100;     // hundredths of a second

// `value`, in steps of 1 / steps, to the nearest whole number in [low, high]; `low` for what is no number.
int nearest_step(double value, double steps, int low, int high);

}  // namespace temblor::net
