#include "net/wire/particles.h"

#include <algorithm>

namespace temblor::net {
namespace {

constexpr std::uint8_t kExplosionCount = 255;  // on the wire; stands for kExplosionParticles
constexpr std::uint16_t kExplosionParticles = 1024;

}  // namespace

// A byte cannot hold the 1024 particles of an explosion, so stock servers send 255 instead.
Particles read_particles(FieldReader& io_fields) {
  Particles particles;
  particles.origin = io_fields.coords();
  for (int axis = 0; axis < 3; ++axis)
    particles.direction[axis] = static_cast<float>(io_fields.i8()) / kDirectionSteps;
  const std::uint8_t count = io_fields.u8();
  particles.count = count == kExplosionCount ? kExplosionParticles : count;
  particles.color = io_fields.u8();
  return particles;
}

Fog read_fog(FieldReader& io_fields) {
  Fog fog;
  fog.density = static_cast<float>(io_fields.u8()) / kFogSteps;
  for (int channel = 0; channel < 3; ++channel)
    fog.color[channel] = static_cast<float>(io_fields.u8()) / kFogSteps;
  fog.fade_s = static_cast<float>(std::max<std::int16_t>(io_fields.i16(), 0)) / kFogTimeSteps;
  return fog;
}

void write_particles(const Particles& message, FieldWriter& io_fields) {
  io_fields.id(MessageId::kParticles);
  io_fields.coords(message.origin);
  for (int axis = 0; axis < 3; ++axis)
    io_fields.i8(static_cast<std::int8_t>(nearest_step(message.direction[axis], kDirectionSteps, -128, 127)));
  const bool explosion = message.count == kExplosionParticles;
  if (message.count >= kExplosionCount && !explosion)
    io_fields.fail("{} particles: the count must be at most {}, or {}", message.count, kExplosionCount - 1,
                   kExplosionParticles);
  io_fields.u8(explosion ? kExplosionCount : static_cast<std::uint8_t>(message.count));
  io_fields.u8(message.color);
}

void write_fog(const Fog& message, FieldWriter& io_fields) {
  io_fields.id(MessageId::kFog);
  io_fields.steps8(message.density, kFogSteps);
  for (int channel = 0; channel < 3; ++channel) io_fields.steps8(message.color[channel], kFogSteps);
  io_fields.i16(static_cast<std::int16_t>(nearest_step(message.fade_s, kFogTimeSteps, 0, 32767)));
}

}  // namespace temblor::net
