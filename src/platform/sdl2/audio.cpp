#include "platform/sdl2/audio.h"

#include <SDL.h>
#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace temblor::platform::sdl2 {
namespace {

// Keeps SDL's audio subsystem running. SDL counts its users and stops it after the last one.
class AudioSubsystem {
 public:
  AudioSubsystem() : begun_(SDL_InitSubSystem(SDL_INIT_AUDIO) == 0) {}
  ~AudioSubsystem() {
    if (begun_) SDL_QuitSubSystem(SDL_INIT_AUDIO);
  }
  AudioSubsystem(const AudioSubsystem&) = delete;
  AudioSubsystem& operator=(const AudioSubsystem&) = delete;
  bool has_begun() const { return begun_; }

 private:
  bool begun_;
};

class SdlAudioDevice : public AudioDevice {
 public:
  SdlAudioDevice(const AudioOptions& options, AudioFill fill) : options_(options), fill_(std::move(fill)) {}
  ~SdlAudioDevice() override {
    // Waits until the callback has returned, so that `fill_` is not called on a destroyed object.
    if (device_ != 0) SDL_CloseAudioDevice(device_);
  }
  SdlAudioDevice(const SdlAudioDevice&) = delete;
  SdlAudioDevice& operator=(const SdlAudioDevice&) = delete;

  base::Status open();

  int frames_per_second() const override { return options_.frames_per_second; }
  // One block is playing while the next one is mixed.
  int latency_frames() const override { return 2 * frames_at_a_time_; }
  // We never stop the device, so a stopped device means that SDL has lost it.
  bool is_lost() const override { return SDL_GetAudioDeviceStatus(device_) == SDL_AUDIO_STOPPED; }
  std::string describe() const override {
    return fmt::format("{}, {} frames a second, {} at a time", SDL_GetCurrentAudioDriver(),
                       options_.frames_per_second, frames_at_a_time_);
  }

 private:
  // SDL's callback, on SDL's audio thread. `device` is the SdlAudioDevice.
  static void SDLCALL call_fill(void* device, Uint8* bytes, int size);

  // Members are destroyed in reverse order: the subsystem outlives everything that uses it.
  AudioSubsystem subsystem_;
  AudioOptions options_;
  AudioFill fill_;
  int frames_at_a_time_ = 0;
  SDL_AudioDeviceID device_ = 0;
};

void SDLCALL SdlAudioDevice::call_fill(void* device, Uint8* bytes, int size) {
  auto* const samples = reinterpret_cast<float*>(bytes);
  static_cast<SdlAudioDevice*>(device)->fill_({samples, static_cast<std::size_t>(size) / sizeof(float)});
}

base::Error cannot_open() {
  return base::error(base::ErrorCode::kIo, "no sound device can be opened: {}", SDL_GetError());
}

base::Status SdlAudioDevice::open() {
  if (!subsystem_.has_begun()) return cannot_open();
  SDL_AudioSpec wanted{}, got{};
  wanted.freq = options_.frames_per_second;
  wanted.format = AUDIO_F32SYS;
  wanted.channels = 2;
  wanted.samples = static_cast<Uint16>(options_.frames_at_a_time);
  wanted.callback = call_fill;
  wanted.userdata = this;
  // Only the block size may differ from the request; SDL converts everything else.
  device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, &got, SDL_AUDIO_ALLOW_SAMPLES_CHANGE);
  if (device_ == 0) return cannot_open();
  frames_at_a_time_ = got.samples;
  SDL_PauseAudioDevice(device_, 0);
  return base::Ok{};
}

}  // namespace

base::Result<std::unique_ptr<AudioDevice>> open_audio(const AudioOptions& options, AudioFill fill) {
  auto device = std::make_unique<SdlAudioDevice>(options, std::move(fill));
  TRY_STATUS(device->open());
  return std::unique_ptr<AudioDevice>(std::move(device));
}

}  // namespace temblor::platform::sdl2
