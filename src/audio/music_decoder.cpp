#include "audio/music_decoder.h"

#include <samplerate.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "audio/sound.h"

namespace temblor::audio {
namespace {

constexpr int kMaxChannels = 8, kMinRate = 4000, kMaxRate = 384000;
constexpr sf_count_t kDecoded_frames = 1024;

// A file in memory. The functions below give libsndfile access to it (SF_VIRTUAL_IO).
struct MemoryFile {
  base::ByteVector bytes;
  sf_count_t at = 0;
  sf_count_t size() const { return static_cast<sf_count_t>(bytes.size()); }
};

MemoryFile& as_memory_file(void* data) {
  return *static_cast<MemoryFile*>(data);
}

sf_count_t get_size(void* data) {
  return as_memory_file(data).size();
}

sf_count_t seek(sf_count_t offset, int from, void* data) {
  MemoryFile& file = as_memory_file(data);
  const sf_count_t base = from == SEEK_SET ? 0 : from == SEEK_CUR ? file.at : file.size();
  // A damaged file may seek anywhere. Clamping the offset before the addition avoids an integer overflow.
  file.at = base + std::clamp<sf_count_t>(offset, -base, file.size() - base);
  return file.at;
}

sf_count_t read_bytes(void* out, sf_count_t count, void* data) {
  MemoryFile& file = as_memory_file(data);
  count = std::clamp<sf_count_t>(count, 0, file.size() - file.at);
  std::copy_n(file.bytes.begin() + file.at, count, static_cast<std::byte*>(out));
  file.at += count;
  return count;
}

sf_count_t write_bytes(const void*, sf_count_t, void*) {
  return 0;
}

sf_count_t tell(void* data) {
  return as_memory_file(data).at;
}

struct CloseSound {
  void operator()(SNDFILE* sound) const { sf_close(sound); }
};
struct DeleteResampler {
  void operator()(SRC_STATE* state) const { src_delete(state); }
};

// Floating-point files may contain any value, NaN included. Leaves room above full scale for the limiter.
float clamp_sample(float sample) {
  return std::isfinite(sample) ? std::clamp(sample, -4.0f, 4.0f) : 0;
}

}  // namespace

struct MusicDecoder::State {
  MemoryFile file;  // outlives `sound`
  SF_VIRTUAL_IO access{get_size, seek, read_bytes, write_bytes, tell};
  std::unique_ptr<SNDFILE, CloseSound> sound;
  std::unique_ptr<SRC_STATE, DeleteResampler> resampler;  // null if the file has the mixer's rate
  int channels = 2;
  double ratio = 1;
  bool has_failed = false;
  std::vector<float> piece;  // decoded frames at the file's rate
  std::vector<float> stereo = std::vector<float>(2 * kDecoded_frames);
  std::size_t stereo_at = 0, stereo_frames = 0;  // the unused part of `stereo`

  void decode_piece();
  std::size_t produce(std::span<float> out_samples);
};

// Decodes the next frames into `stereo`, from the beginning again after the end. Sets has_failed if there are
// none even then, so that an empty or damaged file does not loop forever.
void MusicDecoder::State::decode_piece() {
  sf_count_t count = sf_readf_float(sound.get(), piece.data(), kDecoded_frames);
  if (count <= 0 && sf_seek(sound.get(), 0, SEEK_SET) >= 0)
    count = sf_readf_float(sound.get(), piece.data(), kDecoded_frames);
  has_failed = count <= 0;
  stereo_at = 0;
  stereo_frames = static_cast<std::size_t>(std::max<sf_count_t>(count, 0));
  const auto step = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < stereo_frames; ++i) {
    stereo[2 * i] = clamp_sample(piece[i * step]);
    stereo[2 * i + 1] = clamp_sample(piece[i * step + (channels > 1 ? 1 : 0)]);
  }
}

// Copies or resamples decoded frames and returns the number of output frames. It may be
// 0 while the resampler fills its filter; the caller then decodes more.
std::size_t MusicDecoder::State::produce(std::span<float> out_samples) {
  const std::size_t wanted = out_samples.size() / 2;
  const float* const from = stereo.data() + 2 * stereo_at;
  if (!resampler) {
    const std::size_t count = std::min(wanted, stereo_frames);
    std::copy_n(from, 2 * count, out_samples.begin());
    stereo_at += count;
    stereo_frames -= count;
    return count;
  }
  SRC_DATA job{};
  job.data_in = from;
  job.data_out = out_samples.data();
  job.input_frames = static_cast<long>(stereo_frames);
  job.output_frames = static_cast<long>(wanted);
  job.src_ratio = ratio;
  if (src_process(resampler.get(), &job) != 0) has_failed = true;
  stereo_at += static_cast<std::size_t>(job.input_frames_used);
  stereo_frames -= static_cast<std::size_t>(job.input_frames_used);
  return static_cast<std::size_t>(job.output_frames_gen);
}

base::Result<MusicDecoder> MusicDecoder::open(base::ByteVector bytes) {
  auto state = std::make_unique<State>();
  state->file.bytes = std::move(bytes);
  SF_INFO info{};
  state->sound.reset(sf_open_virtual(&state->access, SFM_READ, &info, &state->file));
  if (!state->sound) return base::malformed("not a playable music file: {}", sf_strerror(nullptr));
  if (info.channels < 1 || info.channels > kMaxChannels || info.samplerate < kMinRate ||
      info.samplerate > kMaxRate)
    return base::error(base::ErrorCode::kUnsupported, "{} channels at {} Hz are not supported", info.channels,
                       info.samplerate);
  state->channels = info.channels;
  state->piece.resize(static_cast<std::size_t>(kDecoded_frames * info.channels));
  state->ratio = static_cast<double>(kFramesPerSecond) / info.samplerate;
  if (info.samplerate != kFramesPerSecond) {
    int failure = 0;
    state->resampler.reset(src_new(SRC_SINC_MEDIUM_QUALITY, 2, &failure));
    if (!state->resampler)
      return base::error(base::ErrorCode::kUnsupported, "the music cannot be resampled: {}",
                         src_strerror(failure));
  }
  return MusicDecoder(std::move(state));
}

MusicDecoder::MusicDecoder(std::unique_ptr<State> state) : state_(std::move(state)) {}
MusicDecoder::~MusicDecoder() = default;
MusicDecoder::MusicDecoder(MusicDecoder&&) noexcept = default;
MusicDecoder& MusicDecoder::operator=(MusicDecoder&&) noexcept = default;

void MusicDecoder::read(std::span<float> out_samples) {
  while (!out_samples.empty()) {
    if (state_->stereo_frames == 0 && !state_->has_failed) state_->decode_piece();
    if (state_->has_failed) {
      std::fill(out_samples.begin(), out_samples.end(), 0.0f);
      return;
    }
    out_samples = out_samples.subspan(2 * state_->produce(out_samples));
  }
}

bool MusicDecoder::has_failed() const {
  return state_->has_failed;
}

}  // namespace temblor::audio
