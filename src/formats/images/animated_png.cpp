#include "formats/images/animated_png.h"

#include <zlib.h>

#include <string_view>
#include <utility>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kSignatureBytes = 8;

// Numbers of PNG are big endian.
void write_u32(std::uint32_t value, base::ByteWriter& io_writer) {
  for (int shift = 24; shift >= 0; shift -= 8) io_writer.u8(static_cast<std::uint8_t>(value >> shift));
}
void write_u16(std::uint16_t value, base::ByteWriter& io_writer) {
  io_writer.u8(static_cast<std::uint8_t>(value >> 8));
  io_writer.u8(static_cast<std::uint8_t>(value));
}
std::uint32_t read_u32(base::ByteReader& io_reader) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | io_reader.u8();
  return value;
}

void write_chunk(std::string_view type, base::Bytes content, base::ByteWriter& io_writer) {
  write_u32(static_cast<std::uint32_t>(content.size()), io_writer);
  const std::size_t checked_from = io_writer.size();
  io_writer.bytes(base::as_bytes(type));
  io_writer.bytes(content);
  const base::Bytes checked = base::Bytes(io_writer.view()).subspan(checked_from);
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  write_u32(static_cast<std::uint32_t>(crc), io_writer);
}

struct Chunk {
  std::string_view type;
  base::Bytes content;
};

// Nothing at the end of the file.
bool read_chunk(base::ByteReader& io_reader, Chunk& out_chunk) {
  if (io_reader.remaining() == 0) return false;
  const std::uint32_t size = read_u32(io_reader);
  out_chunk.type = base::as_text(io_reader.take(4));
  out_chunk.content = io_reader.take(size);
  io_reader.take(4);  // the checksum
  CHECK(io_reader.ok(), "a frame is not a PNG file");
  return true;
}

// Joins the frame chunks with fcTL (how long and where a frame is shown) before each frame. Pixels of later
// frames are fdAT chunks: a number, then what IDAT has. Fields of acTL: frames, 0: forever.
class Film {
 public:
  Film(std::size_t frames, int frames_per_second) : frames_(frames), rate_(frames_per_second) {}

  void add(base::Bytes png) {
    base::ByteReader reader(png);
    const base::Bytes signature = reader.take(kSignatureBytes);
    if (added_ == 0) out_.bytes(signature);
    bool has_control = false;
    for (Chunk chunk; read_chunk(reader, chunk);) {
      if (chunk.type == "IDAT") {
        if (!std::exchange(has_control, true)) write_control();
        write_pixels(chunk.content);
      } else if (added_ == 0 && chunk.type != "IEND") {
        write_chunk(chunk.type, chunk.content, out_);
        if (chunk.type == "IHDR") begin(chunk.content);
      }
    }
    ++added_;
  }

  base::ByteVector finish() {
    write_chunk("IEND", {}, out_);
    return out_.view();
  }

 private:
  void begin(base::Bytes header) {
    base::ByteReader reader(header);
    width_ = read_u32(reader);
    height_ = read_u32(reader);
    base::ByteWriter control;
    write_u32(static_cast<std::uint32_t>(frames_), control);
    write_u32(0, control);
    write_chunk("acTL", control.view(), out_);
  }

  void write_control() {
    base::ByteWriter control;
    write_u32(sequence_++, control);
    write_u32(width_, control);
    write_u32(height_, control);
    write_u32(0, control);  // the frame's place
    write_u32(0, control);
    write_u16(1, control);
    write_u16(static_cast<std::uint16_t>(rate_), control);
    control.u8(0);  // the next frame replaces this one, and does not blend with it
    control.u8(0);
    write_chunk("fcTL", control.view(), out_);
  }

  void write_pixels(base::Bytes pixels) {
    if (added_ == 0) return write_chunk("IDAT", pixels, out_);
    base::ByteWriter data;
    write_u32(sequence_++, data);
    data.bytes(pixels);
    write_chunk("fdAT", data.view(), out_);
  }

  std::size_t frames_, added_ = 0;
  int rate_;
  std::uint32_t width_ = 0, height_ = 0, sequence_ = 0;
  base::ByteWriter out_;
};

}  // namespace

base::ByteVector join_png_frames(std::span<const base::ByteVector> frames, int frames_per_second) {
  CHECK(!frames.empty() && frames_per_second > 0);
  Film film(frames.size(), frames_per_second);
  for (const base::ByteVector& frame : frames) film.add(frame);
  return film.finish();
}

}  // namespace temblor::formats
