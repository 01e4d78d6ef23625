// Layout, little-endian:
//   "TLSH", u32 version, u64 level, u32 index, u32 count
//   for each light map of the shard, in order:
//     u8 1 if it is lit; then u16 layers, u8 1 if there is dirt; the dirt, f32 for each luxel;
//     for each layer u8 style, u8 kind, three f32 for each luxel
//   for each face of the shard, if light bounces:
//     u8 1 if it is traced; then u32 for each of its rays
// Floats are stored exactly, so merged light equals that of one process.
#include "compiler/light/shard_file.h"

#include <span>

namespace temblor::compiler {
namespace {

constexpr std::uint32_t kShardMagic = 0x48534c54, kShardVersion = 3;

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
      return base::malformed("light shard: it ends within a light map at offset {}", io_reader.offset());
    for (std::size_t i = 0; i < luxels; ++i) light.dirt.push_back(io_reader.f32());
  }
  for (std::size_t i = 0; i < layers; ++i) {
    LightLayer layer;
    layer.style = io_reader.u8();
    const std::uint8_t kind = io_reader.u8();
    if (!io_reader.ok() || luxels * kSampleBytes > io_reader.remaining() ||
        kind > static_cast<std::uint8_t>(kLastLayerKind))
      return base::malformed("light shard: no valid layer of {} samples at offset {}", luxels,
                             io_reader.offset());
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

base::Status read_rays(base::ByteReader& io_reader, std::span<std::uint32_t> out_seen) {
  if (out_seen.size_bytes() > io_reader.remaining())
    return base::malformed("light shard: it ends within the rays of a face at offset {}", io_reader.offset());
  for (std::uint32_t& node : out_seen) node = io_reader.u32();
  return base::Ok{};
}

std::span<std::uint32_t> face_rays(BounceRays& io_rays, std::size_t face) {
  const std::size_t begin = io_rays.begin_of_face[face];
  return std::span(io_rays.seen).subspan(begin, io_rays.begin_of_face[face + 1] - begin);
}

base::Result<ShardHeader> read_header(base::ByteReader& io_reader) {
  const std::uint32_t magic = io_reader.u32(), version = io_reader.u32();
  ShardHeader header;
  header.level = io_reader.read<std::uint64_t>();
  header.index = io_reader.u32();
  header.count = io_reader.u32();
  if (!io_reader.ok() || magic != kShardMagic) return base::malformed("this is not a light shard");
  if (version != kShardVersion)
    return base::error(base::ErrorCode::kUnsupported,
                       "light shard: version {} is not supported, only version {}", version, kShardVersion);
  if (header.count == 0 || header.index >= header.count)
    return base::malformed("light shard: its number {} is not below its count {}", header.index,
                           header.count);
  return header;
}

}  // namespace

LightWork begin_light(const LitLevel& lit, bool bounces) {
  LightWork work;
  work.light.resize(lit.maps.size());
  work.is_lit.resize(lit.maps.size());
  if (bounces) work.bounces = begin_bounces(lit);
  return work;
}

std::vector<std::uint32_t> list_share(const ShardHeader& shard, std::size_t total) {
  std::vector<std::uint32_t> share;
  for (std::size_t i = shard.index; i < total; i += shard.count)
    share.push_back(static_cast<std::uint32_t>(i));
  return share;
}

base::ByteVector write_shard(const ShardHeader& header, const LightWork& work) {
  base::ByteWriter writer;
  writer.u32(kShardMagic);
  writer.u32(kShardVersion);
  writer.write(header.level);
  writer.u32(header.index);
  writer.u32(header.count);
  for (const std::uint32_t map : list_share(header, work.light.size())) {
    writer.u8(work.is_lit[map]);
    if (work.is_lit[map] == 0) continue;
    const FaceLight& light = work.light[map];
    writer.write(static_cast<std::uint16_t>(light.layers.size()));
    writer.u8(light.dirt.empty() ? 0 : 1);
    for (const float share : light.dirt) writer.f32(share);
    for (const LightLayer& layer : light.layers) write_layer(layer, writer);
  }
  const BounceRays& rays = work.bounces;
  for (const std::uint32_t face : list_share(header, rays.is_traced.size())) {
    writer.u8(rays.is_traced[face]);
    if (rays.is_traced[face] == 0) continue;
    for (std::size_t i = rays.begin_of_face[face]; i < rays.begin_of_face[face + 1]; ++i)
      writer.u32(rays.seen[i]);
  }
  return std::move(writer).take();
}

// The number of luxels comes from the level, and every list must fit into the remaining bytes, so damaged
// bytes cannot ask for much memory.
base::Result<ReadShard> read_shard(base::Bytes bytes, const std::vector<std::size_t>& luxels_of_map,
                                   LightWork& io_work) {
  base::ByteReader reader(bytes);
  ReadShard shard;
  shard.is_finished = true;
  TRY(shard.header, read_header(reader));
  for (const std::uint32_t map : list_share(shard.header, luxels_of_map.size())) {
    io_work.is_lit[map] = reader.u8() != 0 ? 1 : 0;
    shard.is_finished &= io_work.is_lit[map] != 0;
    if (io_work.is_lit[map] == 0) continue;
    TRY(io_work.light[map], read_map(reader, luxels_of_map[map]));
  }
  BounceRays& rays = io_work.bounces;
  for (const std::uint32_t face : list_share(shard.header, rays.is_traced.size())) {
    rays.is_traced[face] = reader.u8() != 0 ? 1 : 0;
    shard.is_finished &= rays.is_traced[face] != 0;
    if (rays.is_traced[face] != 0) TRY_STATUS(read_rays(reader, face_rays(rays, face)));
  }
  if (!reader.ok() || reader.remaining() > 0)
    return base::malformed("light shard: its contents end at offset {} of {} bytes", reader.offset(),
                           bytes.size());
  return shard;
}

}  // namespace temblor::compiler
