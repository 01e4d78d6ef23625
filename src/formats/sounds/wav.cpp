#include "formats/sounds/wav.h"

#include <algorithm>
#include <string_view>

namespace temblor::formats {
namespace {

using base::ByteReader;
using base::ErrorCode;

constexpr std::uint16_t kPcm = 1, kExtensible = 0xfffe;
constexpr std::size_t kChunkHeaderBytes = 8, kFormatBytes = 16, kCuePointBytes = 24;
// Offset of the 16-byte subformat in the extended header; its first two bytes are the format number.
constexpr std::size_t kExtendedFormatAt = 24, kExtendedFormatBytes = 40;

struct Chunk {
  std::string_view name;
  std::size_t offset = 0;  // of its id in the file
  base::Bytes bytes;       // those that are present
};

struct CuePoint {
  std::uint32_t number = 0, frame = 0;
};
struct Mark {
  std::uint32_t cue_number = 0, frames = 0;
};

struct Chunks {
  std::optional<Chunk> format, data;
  std::optional<CuePoint> cue;
  std::vector<Mark> marks;
};

// Reads the next chunk; nullopt if no whole header is left. Chunks start at even offsets.
std::optional<Chunk> next_chunk(ByteReader& io_reader) {
  if (io_reader.remaining() < kChunkHeaderBytes) return std::nullopt;
  Chunk chunk;
  chunk.offset = io_reader.offset();
  chunk.name = base::as_text(io_reader.take(4));
  const std::size_t size = io_reader.u32();
  chunk.bytes = io_reader.take(std::min(size, io_reader.remaining()));
  if (size % 2 == 1 && io_reader.remaining() > 0) io_reader.u8();
  return chunk;
}

// Reads the first cue point; nullopt if there is none.
std::optional<CuePoint> read_cue(base::Bytes bytes) {
  ByteReader reader(bytes);
  if (reader.u32() == 0 || reader.remaining() < kCuePointBytes) return std::nullopt;
  CuePoint point;
  point.number = reader.u32();
  reader.take(16);
  point.frame = reader.u32();
  return point;
}

// Finds the `mark` texts in a LIST chunk.
void read_marks(base::Bytes bytes, std::vector<Mark>& io_marks) {
  ByteReader reader(bytes);
  if (base::as_text(reader.take(4)) != "adtl") return;
  while (const std::optional<Chunk> part = next_chunk(reader)) {
    if (part->name != "ltxt") continue;
    ByteReader text(part->bytes);
    Mark mark;
    mark.cue_number = text.u32();
    mark.frames = text.u32();
    if (base::as_text(text.take(4)) == "mark") io_marks.push_back(mark);
  }
}

// Collects the chunks in any order. The first of each kind counts, except that every LIST may have marks.
Chunks find_chunks(ByteReader& io_reader) {
  Chunks chunks;
  while (const std::optional<Chunk> chunk = next_chunk(io_reader)) {
    if (chunk->name == "fmt " && !chunks.format) chunks.format = chunk;
    if (chunk->name == "data" && !chunks.data) chunks.data = chunk;
    if (chunk->name == "cue " && !chunks.cue) chunks.cue = read_cue(chunk->bytes);
    if (chunk->name == "LIST") read_marks(chunk->bytes, chunks.marks);
  }
  return chunks;
}

base::Status read_format(const Chunk& chunk, Wav& out_wav) {
  if (chunk.bytes.size() < kFormatBytes)
    return base::malformed("fmt chunk at offset {:#x}: {} bytes, expected at least {}", chunk.offset,
                           chunk.bytes.size(), kFormatBytes);
  ByteReader reader(chunk.bytes);
  std::uint16_t kind = reader.u16();
  out_wav.channels = reader.u16();
  out_wav.frames_per_second = reader.u32();
  reader.u32();  // bytes per second and per frame: redundant
  reader.u16();
  out_wav.bits = reader.u16();
  if (kind == kExtensible && chunk.bytes.size() >= kExtendedFormatBytes) {
    reader.seek(kExtendedFormatAt);
    kind = reader.u16();
  }
  if (kind != kPcm || (out_wav.bits != 8 && out_wav.bits != 16))
    return base::error(ErrorCode::kUnsupported,
                       "fmt chunk at offset {:#x}: format {} of {} bits; convert it to PCM of 8 or 16 bits",
                       chunk.offset, kind, out_wav.bits);
  if (out_wav.channels < 1 || out_wav.channels > kMaxWavChannels)
    return base::malformed("fmt chunk at offset {:#x}: {} channels, expected 1 to {}", chunk.offset,
                           out_wav.channels, kMaxWavChannels);
  if (out_wav.frames_per_second < kMinWavRate || out_wav.frames_per_second > kMaxWavRate)
    return base::malformed("fmt chunk at offset {:#x}: {} frames per second, expected {} to {}", chunk.offset,
                           out_wav.frames_per_second, kMinWavRate, kMaxWavRate);
  return base::Ok{};
}

// Converts 8-bit samples, which are unsigned, to signed ones. Drops an incomplete frame at the end. Many
// editors write a wrong size, so a file that ends early is played up to there.
void read_samples(const Chunk& chunk, Wav& io_wav) {
  const std::size_t frame_bytes = std::size_t{io_wav.channels} * io_wav.bits / 8;
  const std::size_t count = chunk.bytes.size() / frame_bytes * io_wav.channels;
  io_wav.samples.reserve(count);
  ByteReader reader(chunk.bytes);
  for (std::size_t i = 0; i < count; ++i)
    io_wav.samples.push_back(io_wav.bits == 8 ? static_cast<std::int16_t>(reader.u8() - 128) : reader.i16());
}

// The last mark of the cue point counts. A mark that reaches past the end of the sound is ignored.
std::optional<WavLoop> find_loop(const Chunks& chunks, std::size_t frame_count) {
  if (!chunks.cue || chunks.cue->frame >= frame_count) return std::nullopt;
  const auto frames = static_cast<std::uint32_t>(frame_count);
  WavLoop loop{chunks.cue->frame, frames};
  for (const Mark& mark : chunks.marks)
    if (mark.cue_number == chunks.cue->number && mark.frames > 0 && mark.frames <= frames - loop.start)
      loop.end = loop.start + mark.frames;
  return loop;
}

void write_chunk_header(base::ByteWriter& io_writer, std::string_view name, std::size_t size) {
  io_writer.bytes(base::as_bytes(name));
  io_writer.u32(static_cast<std::uint32_t>(size));
}

void write_format(base::ByteWriter& io_writer, std::uint32_t frames_per_second, std::uint16_t channels,
                  std::uint16_t bits) {
  const std::uint32_t frame_bytes = std::uint32_t{channels} * bits / 8;
  write_chunk_header(io_writer, "fmt ", kFormatBytes);
  io_writer.u16(kPcm);
  io_writer.u16(channels);
  io_writer.u32(frames_per_second);
  io_writer.u32(frames_per_second * frame_bytes);
  io_writer.u16(static_cast<std::uint16_t>(frame_bytes));
  io_writer.u16(bits);
}

// Writes a loop as the stock sounds have it: a cue point, and its length as a `mark` in a LIST chunk.
void write_loop(base::ByteWriter& io_writer, const WavLoop& loop) {
  constexpr std::uint32_t kNumber = 1;
  write_chunk_header(io_writer, "cue ", 4 + kCuePointBytes);
  io_writer.u32(1);
  io_writer.u32(kNumber);
  io_writer.u32(loop.start);
  io_writer.bytes(base::as_bytes("data"));
  io_writer.u32(0);
  io_writer.u32(0);
  io_writer.u32(loop.start);
  constexpr std::size_t kTextBytes = 20;
  write_chunk_header(io_writer, "LIST", 4 + kChunkHeaderBytes + kTextBytes);
  io_writer.bytes(base::as_bytes("adtl"));
  write_chunk_header(io_writer, "ltxt", kTextBytes);
  io_writer.u32(kNumber);
  io_writer.u32(loop.end - loop.start);
  io_writer.bytes(base::as_bytes("mark"));
  io_writer.u32(0);  // country and language
  io_writer.u32(0);
}

}  // namespace

base::Result<Wav> read_wav(base::Bytes bytes) {
  ByteReader reader(bytes);
  const bool is_riff = base::as_text(reader.take(4)) == "RIFF";
  reader.u32();  // file size: often wrong, and not needed
  if (!is_riff || base::as_text(reader.take(4)) != "WAVE")
    return base::malformed("not a WAV file: it does not start with RIFF and WAVE");
  const Chunks chunks = find_chunks(reader);
  if (!chunks.format) return base::malformed("no fmt chunk in {} bytes", bytes.size());
  Wav wav;
  TRY_STATUS(read_format(*chunks.format, wav));
  if (!chunks.data) return base::malformed("no data chunk in {} bytes", bytes.size());
  read_samples(*chunks.data, wav);
  wav.loop = find_loop(chunks, wav.frame_count());
  return wav;
}

base::ByteVector write_wav(const Wav& wav) {
  CHECK(wav.channels >= 1 && wav.channels <= kMaxWavChannels, "{}", wav.channels);
  CHECK(wav.bits == 8 || wav.bits == 16, "{}", wav.bits);
  CHECK(wav.samples.size() % wav.channels == 0, "{}", wav.samples.size());
  CHECK(!wav.loop || (wav.loop->start < wav.loop->end && wav.loop->end <= wav.frame_count()));
  base::ByteWriter writer;
  write_chunk_header(writer, "RIFF", 0);
  writer.bytes(base::as_bytes("WAVE"));
  write_format(writer, wav.frames_per_second, wav.channels, wav.bits);
  write_chunk_header(writer, "data", wav.samples.size() * wav.bits / 8);
  for (const std::int16_t sample : wav.samples) {
    if (wav.bits == 8)
      writer.u8(static_cast<std::uint8_t>(sample + 128));
    else
      writer.i16(sample);
  }
  writer.align(2);
  if (wav.loop) write_loop(writer, *wav.loop);
  writer.patch(4, static_cast<std::uint32_t>(writer.size() - kChunkHeaderBytes));
  return std::move(writer).take();
}

base::ByteVector make_wav_header(std::uint32_t frames_per_second, std::uint16_t channels,
                                 std::uint32_t sample_bytes) {
  constexpr std::uint32_t kHeaderBytes = 44;
  base::ByteWriter writer;
  write_chunk_header(writer, "RIFF", kHeaderBytes - kChunkHeaderBytes + sample_bytes);
  writer.bytes(base::as_bytes("WAVE"));
  write_format(writer, frames_per_second, channels, 16);
  write_chunk_header(writer, "data", sample_bytes);
  CHECK(writer.size() == kHeaderBytes, "{}", writer.size());
  return std::move(writer).take();
}

}  // namespace temblor::formats
