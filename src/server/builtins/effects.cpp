// Built-in functions for what clients hear and see besides entities: sounds, particles, light styles.
#include <algorithm>

#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// Three bits in the message.
constexpr int kMaxChannel = 7;
constexpr std::size_t kMaxPatternChars = 63;  // the limit of stock clients

// The volume and attenuation in parameters i and i + 1.
struct Loudness {
  std::uint8_t volume;
  float attenuation;
};
base::Result<Loudness> loudness(Call& io_call, int i) {
  const float volume = io_call.number(i), attenuation = io_call.number(i + 1);
  if (!(volume >= 0 && volume <= 1)) return io_call.error("volume {} is not between 0 and 1", volume);
  if (!(attenuation >= 0 && attenuation <= 4))
    return io_call.error("attenuation {} is not between 0 and 4", attenuation);
  return Loudness{static_cast<std::uint8_t>(to_whole(volume * 255)), attenuation};
}

// sound(entity, channel, sample, volume, attenuation): plays a sound from the middle of the entity's box.
base::Status sound(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  const float channel = io_call.number(1);
  if (!(channel >= 0 && channel < kMaxChannel + 1))
    return io_call.error("channel {} is not between 0 and {}", channel, kMaxChannel);
  TRY(const Loudness loud, loudness(io_call, 3));
  const std::optional<std::uint16_t> number = io_call.sound_number(io_call.text(2));
  if (!number) return base::Ok{};
  const Edict edict = io_call.world.edicts[entity];
  const math::Vec3 middle = edict[field::kOrigin] + (edict[field::kMins] + edict[field::kMaxs]) * 0.5f;
  io_call.game.outbox.write_sound({.volume = loud.volume,
                                   .attenuation = loud.attenuation,
                                   .entity = static_cast<std::uint16_t>(entity),
                                   .channel = static_cast<std::uint8_t>(to_whole(channel)),
                                   .sound = *number,
                                   .origin = middle});
  return base::Ok{};
}

// pointsound(place, sample, volume, attenuation): plays a sound at a place.
base::Status pointsound(Call& io_call) {
  TRY(const Loudness loud, loudness(io_call, 2));
  const std::optional<std::uint16_t> number = io_call.sound_number(io_call.text(1));
  if (!number) return base::Ok{};
  io_call.game.outbox.write_sound({.volume = loud.volume,
                                   .attenuation = loud.attenuation,
                                   .entity = 0,
                                   .channel = 0,
                                   .sound = *number,
                                   .origin = io_call.vector(0)});
  return base::Ok{};
}

// ambientsound(place, sample, volume, attenuation): plays a loop for as long as the level lasts. It is part
// of the signon, so players who are in the level already do not get it.
base::Status ambientsound(Call& io_call) {
  TRY(const Loudness loud, loudness(io_call, 2));
  const std::optional<std::uint16_t> number = io_call.sound_number(io_call.text(1));
  if (!number) return base::Ok{};
  io_call.game.outbox.write(net::SpawnStaticSound{io_call.vector(0), *number, loud.volume, loud.attenuation},
                            io_call.game.outbox.signon());
  return base::Ok{};
}

// The message has one byte for the count. Its largest value stands for the 1024 particles of an explosion.
std::uint16_t particle_count(int count) {
  if (count == 255 || count == 1024) return 1024;
  return static_cast<std::uint16_t>(std::clamp(count, 0, 254));
}

// particle(place, direction, color, count): throws particles of a palette color.
base::Status particle(Call& io_call) {
  const math::Vec3 place = io_call.vector(0);
  io_call.game.outbox.write_at_place(
      net::Particles{.origin = place,
                     .direction = io_call.vector(1),
                     .count = particle_count(io_call.whole(3)),
                     .color = static_cast<std::uint8_t>(io_call.whole(2) & 0xff)},
      place);
  return base::Ok{};
}

// lightstyle(style, pattern): sets a flicker pattern ("mmamm", a dark to z bright). Players get it now; those
// who join later get it then.
base::Status lightstyle(Call& io_call) {
  const float style = io_call.number(0);
  if (!(style >= 0 && style < static_cast<float>(world::kLightStyles)))
    return io_call.error("style {} is not between 0 and {}", style, world::kLightStyles - 1);
  const auto number = static_cast<std::uint8_t>(to_whole(style));
  std::string& pattern = io_call.game.light_styles[number];
  pattern = io_call.text(1).substr(0, kMaxPatternChars);
  io_call.game.outbox.write(net::LightStyle{number, pattern}, io_call.game.outbox.reliable());
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> effect_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {8, "sound", sound},
      {35, "lightstyle", lightstyle},
      {48, "particle", particle},
      {74, "ambientsound", ambientsound},
      {483, "pointsound", pointsound},
  };
  return kEntries;
}

}  // namespace temblor::server
