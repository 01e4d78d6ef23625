// Layout, little-endian: "TLSH", u32 version, u64 level, u32 index, u32 count; then for each light map of the
// shard in order: u16 layers, u8 1 when there is dirt; the dirt, a float a luxel; for each layer u8 style, u8
// kind and three floats a luxel. Floats are kept to the last bit, so that merged light is that of one
// process.
#include "compiler/light/shard_file.h"

namespace temblor::compiler {
namespace {

constexpr std::uint32_t kMagic = 0x48534c54, kVersion = 1;

void write_layer(const LightLayer& layer, base::ByteWriter& io_writer) {
  io_writer.u8(layer.style);
  io_writer.u8(static_cast<std::uint8_t>(layer.kind));
  for (const math::Vec3& sample : layer.samples)
    for (int channel = 0; channel < 3; ++channel) io_writer.f32(sample[channel]);
}

base::Result<FaceLight> read_map(base::ByteReader& io_reader, std::size_t luxels) {
  FaceLight light;
  const std::size_t layers = io_reader.u16();
  const bool has_dirt = io_reader.u8() != 0;
  constexpr std::size_t kSampleBytes = 3 * sizeof(float);
  if (has_dirt) {
    if (luxels * sizeof(float) > io_reader.remaining())
      return base::malformed("light shard: ends within a light map at {}", io_reader.offset());
    for (std::size_t i = 0; i < luxels; ++i) light.dirt.push_back(io_reader.f32());
  }
  for (std::size_t i = 0; i < layers; ++i) {
    LightLayer layer;
    layer.style = io_reader.u8();
    const std::uint8_t kind = io_reader.u8();
    if (!io_reader.ok() || luxels * kSampleBytes > io_reader.remaining() ||
        kind > static_cast<std::uint8_t>(LayerKind::kSubtract))
      return base::malformed("light shard: no layer of {} samples at {}", luxels, io_reader.offset());
    layer.kind = static_cast<LayerKind>(kind);
    layer.samples.reserve(luxels);
    for (std::size_t k = 0; k < luxels; ++k) {
      const float r = io_reader.f32(), g = io_reader.f32(), b = io_reader.f32();
      layer.samples.emplace_back(r, g, b);
    }
    light.layers.push_back(std::move(layer));
  }
  return light;
}

}  // namespace

base::ByteVector write_shard(const ShardHeader& header, const std::vector<FaceLight>& light) {
  base::ByteWriter writer;
  writer.u32(kMagic);
  writer.u32(kVersion);
  writer.write(header.level);
  writer.u32(header.index);
  writer.u32(header.count);
  for (std::size_t map = header.index; map < light.size(); map += header.count) {
    writer.write(static_cast<std::uint16_t>(light[map].layers.size()));
    writer.u8(light[map].dirt.empty() ? 0 : 1);
    for (const float share : light[map].dirt) writer.f32(share);
    for (const LightLayer& layer : light[map].layers) write_layer(layer, writer);
  }
  return std::move(writer).take();
}

base::Result<Shard> read_shard(base::Bytes bytes, const std::vector<std::size_t>& luxels_of_map) {
  base::ByteReader reader(bytes);
  const std::uint32_t magic = reader.u32(), version = reader.u32();
  Shard shard;
  shard.header.level = reader.read<std::uint64_t>();
  shard.header.index = reader.u32();
  shard.header.count = reader.u32();
  if (!reader.ok() || magic != kMagic) return base::malformed("not a light shard");
  if (version != kVersion)
    return base::error(base::ErrorCode::kUnsupported, "light shard of version {}, not {}", version, kVersion);
  if (shard.header.count == 0 || shard.header.index >= shard.header.count)
    return base::malformed("light shard {} of {}", shard.header.index, shard.header.count);
  for (std::size_t map = shard.header.index; map < luxels_of_map.size(); map += shard.header.count) {
    TRY(FaceLight light, read_map(reader, luxels_of_map[map]));
    shard.maps.emplace_back(static_cast<std::uint32_t>(map), std::move(light));
  }
  if (!reader.ok() || reader.remaining() > 0)
    return base::malformed("light shard: its light maps end at {} of {} bytes", reader.offset(),
                           bytes.size());
  return shard;
}

}  // namespace temblor::compiler
