#include "app/demo/film.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "app/files/atomic_write.h"
#include "app/files/picture_file.h"
#include "base/text.h"
#include "render/present.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

std::uint8_t to_byte(std::int32_t value_q16) {
  return static_cast<std::uint8_t>((value_q16 + 32768) >> 16);
}

// Converts 0xRRGGBB by ITU-R BT.601 in studio range, in 16.16 fixed point: luma has 219 steps from 16, the
// color differences 224 around 128.
struct Yuv {
  std::uint8_t y, u, v;
};
Yuv to_yuv(std::uint32_t color) {
  const auto r = static_cast<std::int32_t>(color >> 16 & 255),
             g = static_cast<std::int32_t>(color >> 8 & 255), b = static_cast<std::int32_t>(color & 255);
  return {to_byte((16 << 16) + 16829 * r + 33039 * g + 6416 * b),
          to_byte((128 << 16) - 9714 * r - 19071 * g + 28785 * b),
          to_byte((128 << 16) + 28785 * r - 24103 * g - 4682 * b)};
}

}  // namespace

base::Result<OutputKind> find_output_kind(const std::string& name) {
  const std::string lower = base::to_lower(name);
  if (lower.ends_with(".mp4")) return OutputKind::kMp4;
  if (lower.ends_with(".y4m")) return OutputKind::kY4m;
  if (lower.ends_with(".wav")) return OutputKind::kSound;
  if (!lower.ends_with(".png"))
    return base::error(ErrorCode::kUsage,
                       "-o {}: the name must end in .png (a picture; with %05d, one per frame), .mp4 or .y4m "
                       "(a film), or .wav "
                       "(a demo's sound)",
                       name);
  TRY_STATUS(numbered_name(name, 0));
  return is_numbered(name) ? OutputKind::kNumberedPictures : OutputKind::kPicture;
}

base::Result<Film> Film::open(const std::string& name, const FilmOptions& options,
                              const formats::Palette& palette) {
  TRY(const OutputKind kind, find_output_kind(name));
  CHECK(kind != OutputKind::kSound, "{}", name);
  Film film(name, kind, options, palette);
  if (kind == OutputKind::kMp4) TRY_STATUS(film.start_ffmpeg());
  if (kind == OutputKind::kY4m) TRY_STATUS(film.start_y4m());
  return film;
}

// Frames arrive at ffmpeg's standard input as raw pixels: "bgr0" is 0x00RRGGBB in little-endian order. -crf
// 18 is visually lossless; +faststart lets browsers play the film while they load it.
base::Status Film::start_ffmpeg() {
  std::vector<std::string> words = {"ffmpeg",
                                    "-y",
                                    "-loglevel",
                                    "error",
                                    "-f",
                                    "rawvideo",
                                    "-pixel_format",
                                    "bgr0",
                                    "-video_size",
                                    fmt::format("{}x{}", options_.size.width, options_.size.height),
                                    "-framerate",
                                    std::to_string(options_.frames_per_second),
                                    "-i",
                                    "pipe:0"};
  if (!options_.sound_path.empty())
    words.insert(words.end(),
                 {"-i", fmt::format("file:{}", options_.sound_path), "-c:a", "aac", "-b:a", "192k"});
  // yuv420p shares one color among 2 x 2 pixels, so both sides must be even.
  words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf", "18",
                             "-movflags", "+faststart", fmt::format("file:{}", name_)});
  base::Result<ChildProcess> process = ChildProcess::start(words);
  if (!process.ok()) {
    base::Error error = process.error();
    error.file = name_;
    error.what += "; install ffmpeg, or write a .y4m film or numbered pictures (x-%05d.png) instead";
    return error;
  }
  ffmpeg_.emplace(std::move(process).value());
  return base::Ok{};
}

// The header of YUV4MPEG2: size, frame rate, progressive, square pixels, no chroma subsampling.
base::Status Film::start_y4m() {
  errno = 0;
  y4m_.open(name_, std::ios::binary);
  y4m_ << fmt::format("YUV4MPEG2 W{} H{} F{}:1 Ip A1:1 C444\n", options_.size.width, options_.size.height,
                      options_.frames_per_second);
  if (!y4m_) return cannot_write();
  return base::Ok{};
}

base::Error Film::cannot_write() const {
  return make_write_error(name_, std::generic_category().message(errno), Remedy::kOtherOutput);
}

std::span<const std::uint32_t> Film::expand_colors(const render::FrameBuffer& frame) {
  if (frame.format() == render::PixelFormat::kRgb) return frame.rgb();
  expanded_.resize(frame.pixel_count());
  render::present(frame, render::shown_palette(frame, palette_), true, jobs_, expanded_);
  return expanded_;
}

// Each frame is a line "FRAME" and then three planes, Y, U, and V, of one byte per pixel.
base::Status Film::write_y4m_frame(std::span<const std::uint32_t> colors) {
  planes_.resize(colors.size() * 3);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Yuv yuv = to_yuv(colors[i]);
    planes_[i] = yuv.y;
    planes_[colors.size() + i] = yuv.u;
    planes_[2 * colors.size() + i] = yuv.v;
  }
  y4m_ << "FRAME\n";
  y4m_.write(reinterpret_cast<const char*>(planes_.data()), static_cast<std::streamsize>(planes_.size()));
  if (!y4m_) return cannot_write();
  return base::Ok{};
}

base::Status Film::add(const render::FrameBuffer& frame) {
  if (kind_ == OutputKind::kY4m) return write_y4m_frame(expand_colors(frame));
  if (kind_ == OutputKind::kMp4) {
    base::Status written = ffmpeg_->write(std::as_bytes(expand_colors(frame)));
    return std::move(written).with_file(name_);
  }
  TRY(const std::string path, numbered_name(name_, options_.first_number + frames_++));
  return write_picture_file(path, frame, palette_);
}

base::Status Film::finish() {
  if (kind_ == OutputKind::kMp4) {
    base::Status finished = ffmpeg_->finish();
    return std::move(finished).with_file(name_);
  }
  if (kind_ == OutputKind::kY4m) {
    y4m_.close();
    if (!y4m_) return cannot_write();
  }
  return base::Ok{};
}

}  // namespace temblor::app
