#include "net/wire/sound.h"

namespace temblor::net {
namespace {

enum SoundFlags : std::uint32_t {
  kVolume = 1,
  kAttenuation = 2,
  kLargeEntity = 8,
  kLargeSound = 16,
};
constexpr std::uint32_t kProtocol15SoundFlags = kVolume | kAttenuation;
constexpr std::uint32_t kProtocol666SoundFlags = kProtocol15SoundFlags | kLargeEntity | kLargeSound;
constexpr std::uint32_t kLocalSoundFlags = kLargeSound;

// Packed form: the entity in the upper 13 bits, the channel in the lower 3.
constexpr unsigned kChannelBits = 3;
constexpr unsigned kMaxPackedEntity = 0xffff >> kChannelBits;
constexpr unsigned kMaxPackedChannel = (1u << kChannelBits) - 1;

// True if the values fit the packed form.
bool fits_packed(std::uint16_t entity, std::uint8_t channel) {
  return entity <= kMaxPackedEntity && channel <= kMaxPackedChannel;
}

// Values that do not fit are errors. The channel is masked, so that it cannot change the entity.
void write_packed(std::uint16_t entity, std::uint8_t channel, FieldWriter& io_fields) {
  if (!fits_packed(entity, channel))
    io_fields.fail("sound of entity {}, channel {} exceeds entity {}, channel {}", entity, channel,
                   kMaxPackedEntity, kMaxPackedChannel);
  io_fields.u16(static_cast<std::uint16_t>(unsigned{entity} << kChannelBits | (channel & kMaxPackedChannel)));
}

std::uint8_t encode_attenuation(float attenuation) {
  return static_cast<std::uint8_t>(nearest_step(attenuation, kAttenuationSteps, 0, 255));
}

}  // namespace

Sound read_sound(FieldReader& io_fields) {
  const std::uint32_t flags = io_fields.u8();
  io_fields.check_flags(flags,
                        is_extended(io_fields.dialect()) ? kProtocol666SoundFlags : kProtocol15SoundFlags);
  Sound sound;
  if (flags & kVolume) sound.volume = io_fields.u8();
  if (flags & kAttenuation) sound.attenuation = static_cast<float>(io_fields.u8()) / kAttenuationSteps;
  if (flags & kLargeEntity) {
    sound.entity = io_fields.entity();
    sound.channel = io_fields.u8();
  } else {
    const std::uint16_t packed = io_fields.u16();
    sound.entity = io_fields.entity(packed >> kChannelBits);
    sound.channel = static_cast<std::uint8_t>(packed & kMaxPackedChannel);
  }
  sound.sound = flags & kLargeSound ? io_fields.u16() : io_fields.u8();
  sound.origin = io_fields.coords();
  return sound;
}

StopSound read_stop_sound(FieldReader& io_fields) {
  const std::uint16_t packed = io_fields.u16();
  return {io_fields.entity(packed >> kChannelBits), static_cast<std::uint8_t>(packed & kMaxPackedChannel)};
}

SpawnStaticSound read_static_sound(bool wide, FieldReader& io_fields) {
  SpawnStaticSound sound;
  sound.origin = io_fields.coords();
  sound.sound = wide ? io_fields.u16() : io_fields.u8();
  sound.volume = io_fields.u8();
  sound.attenuation = static_cast<float>(io_fields.u8()) / kAttenuationSteps;
  return sound;
}

Sound read_local_sound(FieldReader& io_fields) {
  const std::uint32_t flags = io_fields.u8();
  io_fields.check_flags(flags, kLocalSoundFlags);
  Sound sound;
  sound.attenuation = 0;
  sound.sound = flags & kLargeSound ? io_fields.u16() : io_fields.u8();
  return sound;
}

// Volume and attenuation are omitted if their bytes are those of the defaults. The wide forms are used only
// if they are needed: the others are shorter, and protocol 15 has no wide ones.
void write_sound(const Sound& message, FieldWriter& io_fields) {
  const std::uint8_t attenuation = encode_attenuation(message.attenuation);
  std::uint32_t flags = 0;
  if (message.volume != Sound{}.volume) flags |= kVolume;
  if (attenuation != encode_attenuation(Sound{}.attenuation)) flags |= kAttenuation;
  if (is_extended(io_fields.dialect())) {
    if (!fits_packed(message.entity, message.channel)) flags |= kLargeEntity;
    if (message.sound > 255) flags |= kLargeSound;
  }
  io_fields.id(MessageId::kSound);
  io_fields.u8(static_cast<std::uint8_t>(flags));
  if (flags & kVolume) io_fields.u8(message.volume);
  if (flags & kAttenuation) io_fields.u8(attenuation);
  if (flags & kLargeEntity) {
    io_fields.entity(message.entity);
    io_fields.u8(message.channel);
  } else {
    write_packed(message.entity, message.channel, io_fields);
  }
  if (flags & kLargeSound)
    io_fields.u16(message.sound);
  else
    io_fields.low_byte(message.sound, false, "sound");
  io_fields.coords(message.origin);
}

void write_stop_sound(const StopSound& message, FieldWriter& io_fields) {
  io_fields.id(MessageId::kStopSound);
  write_packed(message.entity, message.channel, io_fields);
}

void write_static_sound(const SpawnStaticSound& message, FieldWriter& io_fields) {
  const bool wide = is_extended(io_fields.dialect()) && message.sound > 255;
  io_fields.id(wide ? MessageId::kSpawnStaticSound2 : MessageId::kSpawnStaticSound);
  io_fields.coords(message.origin);
  if (wide)
    io_fields.u16(message.sound);
  else
    io_fields.low_byte(message.sound, false, "sound");
  io_fields.u8(message.volume);
  io_fields.u8(encode_attenuation(message.attenuation));
}

}  // namespace temblor::net
