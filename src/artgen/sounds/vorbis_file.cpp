#include "artgen/sounds/vorbis_file.h"

#include <ogg/ogg.h>
#include <vorbis/vorbisenc.h>

#include <algorithm>

namespace temblor::artgen {
namespace {

// Owns the library's objects. They are cleared in the reverse order of their initialization.
class Encoder {
 public:
  Encoder() { vorbis_info_init(&info_); }
  ~Encoder() {
    if (started_) {
      ogg_stream_clear(&stream_);
      vorbis_block_clear(&block_);
      vorbis_dsp_clear(&state_);
    }
    vorbis_info_clear(&info_);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  bool start(std::size_t channels, const VorbisSettings& settings) {
    if (vorbis_encode_init_vbr(&info_, static_cast<long>(channels), settings.frames_per_second,
                               settings.quality) != 0)
      return false;
    if (vorbis_analysis_init(&state_, &info_) != 0) return false;
    vorbis_block_init(&state_, &block_);
    ogg_stream_init(&stream_, settings.serial);
    started_ = true;
    return true;
  }

  // The three header packets of Vorbis: identification, comments, and codebooks.
  void write_headers() {
    vorbis_comment comment;
    vorbis_comment_init(&comment);
    ogg_packet identification, comments, codebooks;
    vorbis_analysis_headerout(&state_, &comment, &identification, &comments, &codebooks);
    for (ogg_packet* packet : {&identification, &comments, &codebooks}) ogg_stream_packetin(&stream_, packet);
    vorbis_comment_clear(&comment);
    ogg_page page;
    // The specification demands that audio starts on a new page.
    while (ogg_stream_flush(&stream_, &page) != 0) add(page);
  }

  // Encodes samples from `start`. A count of 0 marks the end of the stream.
  void write_samples(std::span<const Signal> channels, std::size_t start, std::size_t count) {
    if (count > 0) {
      float** const buffer = vorbis_analysis_buffer(&state_, static_cast<int>(count));
      for (std::size_t channel = 0; channel < channels.size(); ++channel)
        std::transform(channels[channel].begin() + static_cast<std::ptrdiff_t>(start),
                       channels[channel].begin() + static_cast<std::ptrdiff_t>(start + count),
                       buffer[channel], [](double sample) { return static_cast<float>(sample); });
    }
    vorbis_analysis_wrote(&state_, static_cast<int>(count));
    while (vorbis_analysis_blockout(&state_, &block_) == 1) {
      vorbis_analysis(&block_, nullptr);
      vorbis_bitrate_addblock(&block_);
      ogg_packet packet;
      while (vorbis_bitrate_flushpacket(&state_, &packet) != 0) {
        ogg_stream_packetin(&stream_, &packet);
        ogg_page page;
        while (ogg_stream_pageout(&stream_, &page) != 0) add(page);
      }
    }
  }

  // Flushes the last page and returns the file.
  base::ByteVector take() {
    ogg_page page;
    while (ogg_stream_flush(&stream_, &page) != 0) add(page);
    return std::move(bytes_);
  }

 private:
  void add(const ogg_page& page) {
    const auto append = [this](const unsigned char* data, long size) {
      const auto* const begin = reinterpret_cast<const std::byte*>(data);
      bytes_.insert(bytes_.end(), begin, begin + size);
    };
    append(page.header, page.header_len);
    append(page.body, page.body_len);
  }

  vorbis_info info_{};
  vorbis_dsp_state state_{};
  vorbis_block block_{};
  ogg_stream_state stream_{};
  bool started_ = false;
  base::ByteVector bytes_;
};

}  // namespace

base::Result<base::ByteVector> write_vorbis(std::span<const Signal> channels,
                                            const VorbisSettings& settings) {
  CHECK(!channels.empty() && channels.front().size() == channels.back().size(), "{}", channels.size());
  Encoder encoder;
  if (!encoder.start(channels.size(), settings))
    return base::error(
        base::ErrorCode::kUnsupported,
        "the Vorbis encoder does not support {} channels with {} frames per second at quality {}",
        channels.size(), settings.frames_per_second, settings.quality);
  encoder.write_headers();
  // The size of the encoder's input buffer; the result does not depend on it.
  constexpr std::size_t kPiece = 4096;
  for (std::size_t start = 0; start < channels[0].size(); start += kPiece)
    encoder.write_samples(channels, start, std::min(kPiece, channels[0].size() - start));
  encoder.write_samples(channels, 0, 0);
  return encoder.take();
}

}  // namespace temblor::artgen
