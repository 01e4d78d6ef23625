// Adaptive binary arithmetic coding: a bit of probability p costs -log2(p) bits. Each bit narrows an interval
// in proportion to its probability, and the output is the shortest number inside of the final interval. (Ian
// Witten, Radford Neal, and John Cleary, "Arithmetic coding for data compression", 1987; here with 32-bit
// intervals, and a byte is output as soon as the top bytes of both bounds agree.)
//
//        low            middle                    high
//         |---- bit 1 ----|--------- bit 0 ---------|
//         <- probability ->
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"

namespace temblor::net {

// Adaptive probability of one kind of bit. Encoder and decoder must update it with the same bits.
class BitModel {
 public:
  // In 65536ths; never 0 or 65536.
  std::uint32_t probability_of_one() const { return probability_; }
  // Moves the probability toward the bit by 1/32 of the distance.
  void update(bool bit) {
    const std::uint32_t step =
        bit ? (65535u - probability_) >> kAdaptationShift : probability_ >> kAdaptationShift;
    probability_ = static_cast<std::uint16_t>(bit ? probability_ + step : probability_ - step);
  }

 private:
  static constexpr int kAdaptationShift = 5;
  std::uint16_t probability_ = 32768;
};

// Encodes bits. Encoder and decoder have the same members, so that one template describes the format for both
// directions (delta.cpp). Appends to a borrowed writer.
class BitEncoder {
 public:
  explicit BitEncoder(base::ByteWriter& io_bytes) : bytes_(io_bytes) {}

  // Encodes `value`, updates the model, and returns `value`.
  bool bit(BitModel& io_model, bool value) {
    narrow(io_model.probability_of_one(), value);
    io_model.update(value);
    return value;
  }
  // Encodes the low `count` bits (0 to 32) of `value` at one bit each, highest first.
  std::uint32_t raw_bits(std::uint32_t value, int count) {
    for (int i = count - 1; i >= 0; --i) narrow(32768, (value >> i & 1) != 0);
    return value;
  }
  // Writes the shortest number (0 to 4 bytes) inside of the interval. The decoder reads zeros past the end.
  void finish() {
    for (int count = 0; count <= 4; ++count) {
      // The upper bound, truncated to `count` bytes.
      const std::uint32_t within = count == 0 ? 0 : high_ >> (32 - 8 * count) << (32 - 8 * count);
      if (within < low_) continue;
      for (int i = 0; i < count; ++i) bytes_.u8(static_cast<std::uint8_t>(within >> (24 - 8 * i)));
      return;
    }
  }

 private:
  void narrow(std::uint32_t probability, bool bit) {
    const std::uint32_t middle =
        low_ + static_cast<std::uint32_t>(std::uint64_t{high_ - low_} * probability >> 16);
    if (bit)
      high_ = middle;
    else
      low_ = middle + 1;
    for (; (low_ ^ high_) >> 24 == 0; low_ <<= 8, high_ = high_ << 8 | 255)
      bytes_.u8(static_cast<std::uint8_t>(high_ >> 24));
  }

  base::ByteWriter& bytes_;
  std::uint32_t low_ = 0, high_ = 0xffffffff;
};

// Decodes bits. Any input decodes to some bits, and the end of the input is not detected exactly: the caller
// must bound what it reads. If is_past_end() returns true, no encoder wrote so many bits.
class BitDecoder {
 public:
  explicit BitDecoder(base::Bytes bytes) : bytes_(bytes) {
    for (std::size_t i = 0; i < kPreloadBytes; ++i) value_ = value_ << 8 | next();
  }

  // The second parameter exists for symmetry with BitEncoder and is ignored.
  bool bit(BitModel& io_model, bool) {
    const bool value = narrow(io_model.probability_of_one());
    io_model.update(value);
    return value;
  }
  std::uint32_t raw_bits(std::uint32_t, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 1 | (narrow(32768) ? 1u : 0u);
    return value;
  }
  bool is_past_end() const { return offset_ > bytes_.size() + kPreloadBytes; }

 private:
  static constexpr std::size_t kPreloadBytes = 4;  // value_ holds this many bytes

  std::uint8_t next() {
    const std::size_t at = offset_++;
    return at < bytes_.size() ? std::to_integer<std::uint8_t>(bytes_[at]) : std::uint8_t{0};
  }
  bool narrow(std::uint32_t probability) {
    const std::uint32_t middle =
        low_ + static_cast<std::uint32_t>(std::uint64_t{high_ - low_} * probability >> 16);
    const bool bit = value_ <= middle;
    if (bit)
      high_ = middle;
    else
      low_ = middle + 1;
    for (; (low_ ^ high_) >> 24 == 0; low_ <<= 8, high_ = high_ << 8 | 255) value_ = value_ << 8 | next();
    return bit;
  }

  base::Bytes bytes_;
  std::size_t offset_ = 0;
  std::uint32_t low_ = 0, high_ = 0xffffffff, value_ = 0;
};

}  // namespace temblor::net
