// Layout, little-endian:
//   u32 "TLCH", u32 version, u64 geometry, u64 dirt, u64 sky
//   u32 number of lights, for each three f32
//   u32 number of light maps, for each
//     u32 bytes of shadows, the bytes; u32 values of dirt, f32 each
//     u8 layers of sky, for each u8 style, u8 kind, u32 samples, for each three f32
//   u32 number of bounce rays, u32 each
//   u64 hash of all bytes before
#include "compiler/light/light_cache.h"

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "base/hash.h"

namespace temblor::compiler {
namespace {

constexpr std::uint32_t kLightCacheMagic = 0x48434c54;
// Raise this if the layout changes, or if light is measured in another way.
constexpr std::uint32_t kLightCacheVersion = 3;
constexpr std::size_t kStartBytes = 8, kHashBytes = 8;

static_assert(sizeof(math::Vec3) == 3 * sizeof(float));

template <typename T>
void write_all(const std::vector<T>& values, base::ByteWriter& io_writer) {
  io_writer.u32(static_cast<std::uint32_t>(values.size()));
  io_writer.bytes(std::as_bytes(std::span(values)));
}

// Reads a counted list. Returns nothing, and fails the reader, if fewer bytes are left than the count says.
template <typename T>
std::vector<T> read_all(base::ByteReader& io_reader) {
  static_assert(std::is_trivially_copyable_v<T>);
  const base::Bytes bytes = io_reader.take(std::size_t{io_reader.u32()} * sizeof(T));
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

void write_map(const LightCache::Map& map, base::ByteWriter& io_writer) {
  write_all(map.shadows, io_writer);
  write_all(map.dirt, io_writer);
  io_writer.u8(static_cast<std::uint8_t>(map.sky.size()));
  for (const LightLayer& layer : map.sky) {
    io_writer.u8(layer.style);
    io_writer.u8(static_cast<std::uint8_t>(layer.kind));
    write_all(layer.samples, io_writer);
  }
}

base::Result<LightCache::Map> read_map(base::ByteReader& io_reader) {
  LightCache::Map map;
  map.shadows = read_all<std::byte>(io_reader);
  map.dirt = read_all<float>(io_reader);
  const std::size_t layers = io_reader.u8();
  for (std::size_t i = 0; i < layers && io_reader.ok(); ++i) {
    LightLayer layer;
    layer.style = io_reader.u8();
    const std::uint8_t kind = io_reader.u8();
    if (kind > static_cast<std::uint8_t>(kLastLayerKind))
      return base::malformed("light cache: unknown kind {} of light at offset {}", kind, io_reader.offset());
    layer.kind = static_cast<LayerKind>(kind);
    layer.samples = read_all<math::Vec3>(io_reader);
    map.sky.push_back(std::move(layer));
  }
  if (!io_reader.ok())
    return base::malformed("light cache: it ends within a light map at offset {}", io_reader.offset());
  return map;
}

}  // namespace

base::ByteVector write_light_cache(const LightCache& cache) {
  base::ByteWriter writer;
  writer.u32(kLightCacheMagic);
  writer.u32(kLightCacheVersion);
  for (const std::uint64_t hash : {cache.geometry, cache.dirt, cache.sky}) writer.write(hash);
  write_all(cache.lights, writer);
  writer.u32(static_cast<std::uint32_t>(cache.maps.size()));
  for (const LightCache::Map& map : cache.maps) write_map(map, writer);
  write_all(cache.bounces, writer);
  writer.write(base::hash_bytes(writer.view()));
  return std::move(writer).take();
}

base::Result<LightCache> read_light_cache(base::Bytes bytes) {
  if (bytes.size() < kStartBytes + kHashBytes)
    return base::malformed("light cache: {} bytes are too short", bytes.size());
  base::ByteReader reader(bytes.first(bytes.size() - kHashBytes)), end(bytes.last(kHashBytes));
  if (reader.u32() != kLightCacheMagic) return base::malformed("light cache: it does not begin with TLCH");
  if (const std::uint32_t version = reader.u32(); version != kLightCacheVersion)
    return base::error(base::ErrorCode::kUnsupported,
                       "light cache: version {} is not supported, only version {}", version,
                       kLightCacheVersion);
  if (end.read<std::uint64_t>() != base::hash_bytes(bytes.first(bytes.size() - kHashBytes)))
    return base::malformed("light cache: it is damaged (wrong hash)");
  LightCache cache;
  for (std::uint64_t* hash : {&cache.geometry, &cache.dirt, &cache.sky}) *hash = reader.read<std::uint64_t>();
  cache.lights = read_all<math::Vec3>(reader);
  const std::uint32_t maps = reader.u32();
  for (std::uint32_t i = 0; i < maps && reader.ok(); ++i) {
    TRY(LightCache::Map map, read_map(reader));
    cache.maps.push_back(std::move(map));
  }
  cache.bounces = read_all<std::uint32_t>(reader);
  if (!reader.ok() || reader.remaining() > 0)
    return base::malformed("light cache: its {} bytes do not fit its {} light maps", bytes.size(), maps);
  return cache;
}

}  // namespace temblor::compiler
