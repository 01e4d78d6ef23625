// Bounds-checked reading and writing of little-endian bytes. All parsers of binary files and messages use
// ByteReader.
//
// A ByteReader never reads outside of its span. A read past the end returns zero, moves to the end, and makes
// ok() false permanently, so a parser may check once per record instead of after each field:
//
//   plane.distance = reader.f32(), plane.type = reader.i32();
//   if (!reader.ok()) return base::malformed("truncated");
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace temblor::base {

static_assert(std::endian::native == std::endian::little, "readers and writers copy bytes without swapping");

using Bytes = std::span<const std::byte>;
using ByteVector = std::vector<std::byte>;

inline Bytes as_bytes(std::string_view text) {
  return std::as_bytes(std::span(text));
}
inline std::string_view as_text(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
// Views bytes as unsigned numbers (texels, light samples), without a copy.
inline std::span<const std::uint8_t> as_u8(Bytes bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

// Reads borrowed bytes. A copy of a reader keeps its own position.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  bool ok() const { return ok_; }
  std::size_t offset() const { return offset_; }
  std::size_t remaining() const { return bytes_.size() - offset_; }

  // Reads a number of type T. The bytes need not be aligned.
  template <typename T>
  T read() {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    if (Bytes bytes = take(sizeof(T)); !bytes.empty()) std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }
  std::uint8_t u8() { return read<std::uint8_t>(); }
  std::int16_t i16() { return read<std::int16_t>(); }
  std::uint16_t u16() { return read<std::uint16_t>(); }
  std::int32_t i32() { return read<std::int32_t>(); }
  std::uint32_t u32() { return read<std::uint32_t>(); }
  float f32() { return read<float>(); }

  // Returns the next `count` bytes; empty and !ok() if fewer remain.
  Bytes take(std::size_t count) {
    if (count > remaining()) {
      ok_ = false;
      offset_ = bytes_.size();
      return {};
    }
    Bytes bytes = bytes_.subspan(offset_, count);
    offset_ += count;
    return bytes;
  }
  // Reads a text field of fixed width, up to its first zero.
  std::string fixed_text(std::size_t width) {
    std::string_view text = as_text(take(width));
    return std::string(text.substr(0, text.find('\0')));
  }
  // Reads text up to the next zero and skips the zero. Returns nullopt and becomes !ok() if there is none.
  std::optional<std::string_view> text() {
    const std::string_view rest = as_text(bytes_.subspan(offset_));
    const std::size_t size = rest.find('\0');
    if (size == std::string_view::npos) {
      ok_ = false;
      offset_ = bytes_.size();
      return std::nullopt;
    }
    offset_ += size + 1;
    return rest.substr(0, size);
  }
  // Moves to an absolute offset; !ok() past the end.
  void seek(std::size_t offset) {
    ok_ = ok_ && offset <= bytes_.size();
    offset_ = ok_ ? offset : bytes_.size();
  }

 private:
  Bytes bytes_;
  std::size_t offset_ = 0;
  bool ok_ = true;
};

// Appends numbers, bytes, and text to a growing buffer. Owns the buffer until take().
class ByteWriter {
 public:
  template <typename T>
  void write(T value) {
    static_assert(std::is_arithmetic_v<T>);
    if (bytes_.capacity() - bytes_.size() < sizeof(T)) grow();
    if constexpr (sizeof(T) == 1) {
      bytes_.push_back(std::bit_cast<std::byte>(value));
    } else {
      const std::size_t at = bytes_.size();
      bytes_.resize(at + sizeof(T));
      std::memcpy(bytes_.data() + at, &value, sizeof(T));
    }
  }
  void u8(std::uint8_t value) { write(value); }
  void i16(std::int16_t value) { write(value); }
  void u16(std::uint16_t value) { write(value); }
  void i32(std::int32_t value) { write(value); }
  void u32(std::uint32_t value) { write(value); }
  void f32(float value) { write(value); }
  void bytes(Bytes bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  // Writes text, truncated or zero-padded to `width` bytes.
  void fixed_text(std::string_view text, std::size_t width) {
    text = text.substr(0, width);
    bytes(as_bytes(text));
    bytes_.resize(bytes_.size() + width - text.size());
  }
  // Pads with zeros to a multiple of `alignment`.
  void align(std::size_t alignment) {
    bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
  }
  // Overwrites a number written earlier, such as a size that is known only at the end. The caller must keep
  // `offset` + sizeof(T) within size().
  template <typename T>
  void patch(std::size_t offset, T value) {
    static_assert(std::is_arithmetic_v<T>);
    std::memcpy(bytes_.data() + offset, &value, sizeof(T));
  }

  // Removes everything after the first `size` bytes.
  void truncate(std::size_t size) { bytes_.resize(std::min(size, bytes_.size())); }

  std::size_t size() const { return bytes_.size(); }
  ByteVector take() && { return std::move(bytes_); }
  const ByteVector& view() const { return bytes_; }

 private:
  // A vector would begin with a few bytes, and a message would move them six times.
  void grow() {
    constexpr std::size_t kFirst = 64;
    bytes_.reserve(std::max(kFirst, 2 * bytes_.size()));
  }

  ByteVector bytes_;
};

}  // namespace temblor::base
