// Fixed-point encodings of messages. Coordinates and angles depend on the dialect; alpha, scale, attenuation,
// and the like are the same in all dialects.
#pragma once

#include <cstdint>

#include "net/protocol/protocol.h"

namespace temblor::net {

// Coordinates, in map units.
enum class CoordEncoding {
  kEighths16,  // i16 of eighths of a unit; the range is about +-4096
  // i16 of whole units, rounded down, then u8 of 255ths to add. The fraction 255 is a whole unit, so the top
  // of the range is 32768.
  kWholeAnd255,
  kSixteenths32,  // i32 of sixteenths of a unit
  kFloat,         // f32
};
enum class AngleEncoding {
  kByte,   // u8, 256ths of a turn
  kShort,  // u16, 65536ths of a turn
  kFloat,  // f32, degrees
};

// If several flags are set, the widest encoding wins: float, then 32 bits, then 24.
CoordEncoding coord_encoding(const Dialect& dialect);
AngleEncoding angle_encoding(const Dialect& dialect);

// True if the dialect has FitzQuake's extended messages.
inline bool is_extended(const Dialect& dialect) {
  return dialect.protocol != Protocol::kNetQuake;
}

// Limit of coordinates in all encodings: the range of kSixteenths32.
constexpr float kMaxCoord = 1 << 27;

// Alpha from 0 to 1 as a byte: 0 means default (opaque), 1 invisible, 255 opaque.
float decode_alpha(std::uint8_t byte);
std::uint8_t encode_alpha(float alpha);  // rounds; never returns 0

constexpr float kScaleSteps = 16;        // a byte of 16ths
constexpr float kAttenuationSteps = 64;  // a byte of 64ths
constexpr float kDirectionSteps = 16;    // a signed byte of 16ths
constexpr float kVelocityUnit = 16;      // a signed byte of steps of 16 units a second
constexpr float kNextThinkSteps = 255;   // a byte of 255ths of a second
constexpr float kFogSteps = 255;         // bytes of 255ths
constexpr float kFogTimeSteps = 100;     // hundredths of a second

// Returns value * steps, rounded to the nearest integer and clamped to [low, high]. NaN gives `low`.
int nearest_step(double value, double steps, int low, int high);

}  // namespace temblor::net
