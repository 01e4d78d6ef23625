#include "formats/models/spr.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/check.h"
#include "formats/models/model_bytes.h"

namespace temblor::formats {
namespace {

constexpr FileKind kSprFile{"sprite", "IDSP", 1};
constexpr std::size_t kSprHeaderBytes = 36, kFrameHeaderBytes = 16;
constexpr auto kLastOrientation = static_cast<std::uint32_t>(SprOrientation::kParallelOriented);

bool is_sprite_side(std::uint32_t side) {
  return side >= 1 && side <= kMaxSprSide;
}

bool is_valid_offset(const SprPicture& picture) {
  return std::min(picture.left, picture.up) >= -kMaxSprOffset &&
         std::max(picture.left, picture.up) <= kMaxSprOffset;
}

// Returns the number of frames, and stores all other fields in out_spr.
base::Result<std::uint32_t> read_header(base::ByteReader& io_reader, Spr& out_spr) {
  TRY_STATUS(read_file_kind(io_reader, kSprFile, kSprHeaderBytes));
  const std::uint32_t orientation = io_reader.u32();
  out_spr.orientation =
      orientation <= kLastOrientation ? static_cast<SprOrientation>(orientation) : SprOrientation::kParallel;
  out_spr.bounding_radius = read_unused_number(io_reader);
  out_spr.max_width = io_reader.u32();
  out_spr.max_height = io_reader.u32();
  const std::size_t frames_offset = io_reader.offset();
  const std::uint32_t frames = io_reader.u32();
  out_spr.beam_length = read_unused_number(io_reader);
  out_spr.random_phase = io_reader.i32() != 0;
  if (frames == 0) return base::malformed("header at offset {:#x}: no frames", frames_offset);
  if (frames > kMaxSprPictures)
    return base::error(base::ErrorCode::kTooLarge, "header at offset {:#x}: {} frames, the limit is {}",
                       frames_offset, frames, kMaxSprPictures);
  return frames;
}

base::Result<SprPicture> read_sprite_picture(base::ByteReader& io_reader, std::string_view part) {
  const std::size_t offset = io_reader.offset();
  TRY_STATUS(need_bytes(io_reader, kFrameHeaderBytes, part));
  SprPicture picture;
  picture.left = io_reader.i32();
  picture.up = io_reader.i32();
  picture.width = io_reader.u32();
  picture.height = io_reader.u32();
  if (!is_sprite_side(picture.width) || !is_sprite_side(picture.height))
    return base::malformed("{} at offset {:#x}: {} x {} texels, sides are 1 to {}", part, offset,
                           picture.width, picture.height, kMaxSprSide);
  if (!is_valid_offset(picture))
    return base::error(base::ErrorCode::kTooLarge, "{} at offset {:#x}: {} left, {} up, the limit is {}",
                       part, offset, picture.left, picture.up, kMaxSprOffset);
  const std::size_t texels = std::size_t{picture.width} * picture.height;
  TRY_STATUS(need_bytes(io_reader, texels, part));
  const auto bytes = base::as_u8(io_reader.take(texels));
  picture.texels.assign(bytes.begin(), bytes.end());
  return picture;
}

base::Result<SprFrame> read_frame(base::ByteReader& io_reader, std::string_view part) {
  SprFrame frame;
  TRY(const std::uint32_t members, read_group_members(io_reader, part));
  if (members > 0) {
    TRY(frame.end_times_s, read_group_times(io_reader, members, part));
  }
  for (std::uint32_t i = 0; i < std::max(members, 1u); ++i) {
    TRY(SprPicture picture, read_sprite_picture(io_reader, member_name(part, "picture", i, members)));
    frame.pictures.push_back(std::move(picture));
  }
  return frame;
}

void check_picture(const SprPicture& picture) {
  CHECK(is_sprite_side(picture.width) && is_sprite_side(picture.height), "{} x {}", picture.width,
        picture.height);
  CHECK(is_valid_offset(picture), "{} left, {} up", picture.left, picture.up);
  CHECK(picture.texels.size() == std::size_t{picture.width} * picture.height, "{}", picture.texels.size());
}

void write_frame(base::ByteWriter& io_writer, const SprFrame& frame) {
  CHECK(!frame.pictures.empty());
  CHECK(frame.end_times_s.size() == (frame.end_times_s.empty() ? 0 : frame.pictures.size()));
  CHECK(!frame.end_times_s.empty() || frame.pictures.size() == 1);
  write_group_members(io_writer, frame.end_times_s.size());
  write_group_times(io_writer, frame.end_times_s);
  for (const SprPicture& picture : frame.pictures) {
    check_picture(picture);
    io_writer.i32(picture.left);
    io_writer.i32(picture.up);
    io_writer.u32(picture.width);
    io_writer.u32(picture.height);
    io_writer.bytes(std::as_bytes(std::span(picture.texels)));
  }
}

std::size_t picture_count(const Spr& spr) {
  std::size_t pictures = 0;
  for (const SprFrame& frame : spr.frames) pictures += frame.pictures.size();
  return pictures;
}

}  // namespace

base::Result<Spr> read_spr(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  Spr spr;
  TRY(const std::uint32_t frames, read_header(reader, spr));
  std::size_t pictures = 0;
  for (std::uint32_t i = 0; i < frames; ++i) {
    const std::size_t offset = reader.offset();
    TRY(SprFrame frame, read_frame(reader, fmt::format("frame {}", i)));
    pictures += frame.pictures.size();
    if (pictures > kMaxSprPictures)
      return base::error(base::ErrorCode::kTooLarge,
                         "frame {} at offset {:#x}: brings the sprite to {} pictures, the limit is {}", i,
                         offset, pictures, kMaxSprPictures);
    spr.frames.push_back(std::move(frame));
  }
  return spr;
}

base::ByteVector write_spr(const Spr& spr) {
  const std::size_t pictures = picture_count(spr);
  CHECK(pictures >= 1 && pictures <= kMaxSprPictures, "{}", pictures);
  CHECK(std::isfinite(spr.bounding_radius) && std::isfinite(spr.beam_length));
  base::ByteWriter writer;
  write_file_kind(writer, kSprFile);
  writer.u32(static_cast<std::uint32_t>(spr.orientation));
  writer.f32(spr.bounding_radius);
  writer.u32(spr.max_width);
  writer.u32(spr.max_height);
  writer.u32(static_cast<std::uint32_t>(spr.frames.size()));
  writer.f32(spr.beam_length);
  writer.i32(spr.random_phase ? 1 : 0);
  for (const SprFrame& frame : spr.frames) write_frame(writer, frame);
  return std::move(writer).take();
}

}  // namespace temblor::formats
