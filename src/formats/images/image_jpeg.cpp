// Reads JPEG images with libjpeg-turbo, with limits against files that unpack to far more than they contain.
// Files that end early are errors, as with PNG; other damage only shows in the picture.
#include <csetjmp>
#include <cstddef>
#include <cstdio>
// Needs the two above.
#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <memory>
#include <string>

#include "formats/images/image.h"

namespace temblor::formats {
namespace {

// A block of 8 x 8 pixels takes more than a bit, also with arithmetic coding.
constexpr std::uint64_t kMaxJpegPixelsPerByte = 4096;
// Progressive files are unpacked to 6 bytes for each pixel before the first row is complete.
constexpr std::uint64_t kMaxJpegPixels = std::uint64_t{1} << 24;
// Each scan of a progressive file passes over all pixels, and a scan of a few bytes may do so. Usual files
// have at most 10 scans.
constexpr std::uint64_t kMaxJpegScans = 64, kMaxJpegScannedPixels = std::uint64_t{1} << 28;

// The library's state. It returns from errors with longjmp(), so it runs only in steps, which have no objects
// to destroy.
struct JpegDecoder {
  jpeg_decompress_struct state{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf after_error{};
  bool ends_early = false, has_too_many_scans = false;
  base::Bytes bytes{};
  std::uint32_t* row = nullptr;  // where the next row goes

  ~JpegDecoder() { jpeg_destroy_decompress(&state); }
  static JpegDecoder& from(j_common_ptr state) { return *static_cast<JpegDecoder*>(state->client_data); }
};

std::uint64_t count_pixels(const jpeg_decompress_struct& state) {
  return std::uint64_t{state.image_width} * state.image_height;
}

[[noreturn]] void leave_step(j_common_ptr state) {
  std::longjmp(JpegDecoder::from(state).after_error, 1);
}

void note_warning(j_common_ptr state, int level) {
  if (level < 0 && state->err->msg_code == JWRN_JPEG_EOF) JpegDecoder::from(state).ends_early = true;
}

void limit_scans(j_common_ptr state) {
  const jpeg_decompress_struct& decompress = JpegDecoder::from(state).state;
  const auto scans = static_cast<std::uint64_t>(decompress.input_scan_number);
  if (scans <= std::min(kMaxJpegScans, kMaxJpegScannedPixels / count_pixels(decompress))) return;
  JpegDecoder::from(state).has_too_many_scans = true;
  leave_step(state);
}

void read_jpeg_header(JpegDecoder& io_decoder) {
  jpeg_create_decompress(&io_decoder.state);
  io_decoder.state.progress = &io_decoder.progress;
  jpeg_mem_src(&io_decoder.state, reinterpret_cast<const unsigned char*>(io_decoder.bytes.data()),
               static_cast<unsigned long>(io_decoder.bytes.size()));
  jpeg_read_header(&io_decoder.state, TRUE);
}

// Bytes B, G, R, A are 0xAARRGGBB.
void read_jpeg_rows(JpegDecoder& io_decoder) {
  jpeg_decompress_struct& state = io_decoder.state;
  state.out_color_space = JCS_EXT_BGRA;
  jpeg_start_decompress(&state);
  while (state.output_scanline < state.output_height) {
    JSAMPROW row = reinterpret_cast<JSAMPROW>(io_decoder.row);
    io_decoder.row += jpeg_read_scanlines(&state, &row, 1) * state.output_width;
  }
}

base::Status run(JpegDecoder& io_decoder, void (*step)(JpegDecoder&)) {
  if (setjmp(io_decoder.after_error) == 0) {
    step(io_decoder);
  } else if (io_decoder.has_too_many_scans) {
    return base::error(
        base::ErrorCode::kTooLarge,
        "JPEG of {} x {} pixels: too many scans, the limits are {} scans and {} pixels in all scans",
        io_decoder.state.image_width, io_decoder.state.image_height, kMaxJpegScans, kMaxJpegScannedPixels);
  } else {
    char text[JMSG_LENGTH_MAX] = {};
    (*io_decoder.errors.format_message)(reinterpret_cast<j_common_ptr>(&io_decoder.state), text);
    return base::malformed("JPEG: {}", text);
  }
  if (io_decoder.ends_early) return base::malformed("JPEG: the file ends early");
  return base::Ok{};
}

}  // namespace

base::Result<Image> read_jpeg(base::Bytes bytes) {
  // Empty sources end the program in some versions of the library.
  if (bytes.empty()) return base::malformed("JPEG: the file is empty");
  const auto decoder = std::make_unique<JpegDecoder>();
  decoder->bytes = bytes;
  decoder->state.err = jpeg_std_error(&decoder->errors);
  decoder->state.client_data = decoder.get();
  decoder->errors.error_exit = leave_step;
  decoder->errors.emit_message = note_warning;
  decoder->progress.progress_monitor = limit_scans;
  TRY_STATUS(run(*decoder, read_jpeg_header));
  const std::uint32_t width = decoder->state.image_width, height = decoder->state.image_height;
  const std::uint64_t pixels = count_pixels(decoder->state);
  if (width > kMaxImageSide || height > kMaxImageSide || pixels > kMaxJpegPixels)
    return base::error(base::ErrorCode::kTooLarge,
                       "JPEG of {} x {} pixels, the limits are {} for a side and {} in all", width, height,
                       kMaxImageSide, kMaxJpegPixels);
  if (pixels > bytes.size() * kMaxJpegPixelsPerByte)
    return base::malformed("JPEG of {} x {} pixels: {} bytes cannot hold them", width, height, bytes.size());
  Image image{width, height, std::vector<std::uint32_t>(pixels)};
  decoder->row = image.pixels.data();
  TRY_STATUS(run(*decoder, read_jpeg_rows));
  return image;
}

}  // namespace temblor::formats
