// Bits in as much room as they surprise: binary arithmetic coding. Each bit narrows an interval in proportion
// to how probable it was; what is written is any number within the last one. (Ian Witten, Radford Neal and
// John Cleary, "Arithmetic coding for data compression", 1987; here with intervals of 32 bits, moved on by
// bytes.)
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"

namespace temblor::net {

// How probable a bit of one kind is, learnt from those that came.
class BitModel {
 public:
  // Of 65536; never none, never all.
  std::uint32_t probability_of_one() const { return probability_; }
  void learn(bool bit) {
    const std::uint32_t step = bit ? (65535u - probability_) >> kSlowness : probability_ >> kSlowness;
    probability_ = static_cast<std::uint16_t>(bit ? probability_ + step : probability_ - step);
  }

 private:
  static constexpr int kSlowness = 5;
  std::uint16_t probability_ = 32768;
};

// Both have the same members, so that what is said and what is understood is one text (differences.cpp).
class BitEncoder {
 public:
  explicit BitEncoder(base::ByteWriter& io_bytes) : bytes_(io_bytes) {}

  bool bit(BitModel& io_model, bool value) {
    narrow(io_model.probability_of_one(), value);
    io_model.learn(value);
    return value;
  }
  // `count` bits, the highest first, of which nothing is known; up to 32.
  std::uint32_t plain(std::uint32_t value, int count) {
    for (int i = count - 1; i >= 0; --i) narrow(32768, (value >> i & 1) != 0);
    return value;
  }
  // Writes as many bytes as tell the interval; a reader takes those behind the end for zeros.
  void finish() {
    for (int count = 0; count <= 4; ++count) {
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

// Reads any bytes as some bits or other, and behind their end without one: what is read must be bounded.
// is_past_end() says for certain that no encoder has written so many bits.
class BitDecoder {
 public:
  explicit BitDecoder(base::Bytes bytes) : bytes_(bytes) {
    for (std::size_t i = 0; i < kAhead; ++i) value_ = value_ << 8 | next();
  }

  bool bit(BitModel& io_model, bool) {
    const bool value = narrow(io_model.probability_of_one());
    io_model.learn(value);
    return value;
  }
  std::uint32_t plain(std::uint32_t, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 1 | (narrow(32768) ? 1u : 0u);
    return value;
  }
  bool is_past_end() const { return offset_ > bytes_.size() + kAhead; }

 private:
  static constexpr std::size_t kAhead = 4;  // bytes that are read before they are needed

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
