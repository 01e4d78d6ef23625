// Values as the interpreter sees them: words, and vectors of three words. Internal to the machine.
#pragma once

#include <bit>
#include <cstdint>

namespace temblor::vm {

inline float as_float(std::uint32_t word) {
  return std::bit_cast<float>(word);
}
inline std::uint32_t as_word(float value) {
  return std::bit_cast<std::uint32_t>(value);
}
inline std::uint32_t truth(bool value) {
  return value ? as_word(1.0f) : 0;
}

// Truncates. NaN and values too large for 32 bits become the smallest integer, as on the original's
// processors.
inline std::int32_t as_int(std::uint32_t word) {
  const float value = as_float(word);
  return value >= -0x1p31f && value < 0x1p31f ? static_cast<std::int32_t>(value) : INT32_MIN;
}

inline bool same_vector(const std::uint32_t* a, const std::uint32_t* b) {
  return as_float(a[0]) == as_float(b[0]) && as_float(a[1]) == as_float(b[1]) &&
         as_float(a[2]) == as_float(b[2]);
}

inline void scale_vector(std::uint32_t* out, const std::uint32_t* vector, float scale) {
  const float x = as_float(vector[0]) * scale, y = as_float(vector[1]) * scale,
              z = as_float(vector[2]) * scale;
  out[0] = as_word(x);
  out[1] = as_word(y);
  out[2] = as_word(z);
}

// `sign`: 1 adds, -1 subtracts (adding the negated value gives the same bits).
inline void add_vectors(std::uint32_t* out, const std::uint32_t* a, const std::uint32_t* b, float sign) {
  const float x = as_float(a[0]) + sign * as_float(b[0]), y = as_float(a[1]) + sign * as_float(b[1]),
              z = as_float(a[2]) + sign * as_float(b[2]);
  out[0] = as_word(x);
  out[1] = as_word(y);
  out[2] = as_word(z);
}

inline void copy_vector(std::uint32_t* out, const std::uint32_t* in) {
  const std::uint32_t x = in[0], y = in[1], z = in[2];
  out[0] = x;
  out[1] = y;
  out[2] = z;
}

// The results of integers wrap around. A shift uses the low five bits of its distance.
inline std::uint32_t divide_integers(std::uint32_t a, std::uint32_t b) {
  return b == UINT32_MAX
             ? 0 - a
             : static_cast<std::uint32_t>(static_cast<std::int32_t>(a) / static_cast<std::int32_t>(b));
}
inline std::uint32_t shift_right(std::uint32_t a, std::uint32_t distance) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(a) >> (distance & 31));
}
inline float integer_as_float(std::uint32_t word) {
  return static_cast<float>(static_cast<std::int32_t>(word));
}

}  // namespace temblor::vm
