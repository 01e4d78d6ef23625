// Layout, little-endian:
//   u32 "TBLD", u32 version, u64 hash of the .bsp, u64 hash of the .lit
//   the level:
//     u64 brushes key, u64 solid occupants key, u64 light key, u32 textures of its own
//     u8 kind of visibility, f64 mean visible share or -1, u8 water is transparent
//     u32 brush entities, for each u8 is in the level, text model, text origin
//     u32 clusters, u32 leaves, for each u32 cluster
//     u32 portals, for each 4 times f64 normal and distance; 2 times u32 cluster;
//       u32 corners, for each 3 times f64
//     u32 surface keys, for each its fields (visit_fields()); u32 faces, for each u32 surface keys
//   u64 size of the light cache, then its bytes
//   u64 hash of all bytes before
// A text is u32 size and its bytes.
#include "compiler/build_file.h"

#include <array>
#include <span>

#include "base/hash.h"

namespace temblor::compiler {
namespace {

using base::ByteReader;
using base::ByteWriter;

constexpr std::uint32_t kBuildFileMagic = 0x444c4254;  // "TBLD"
// Raise this if the meaning of anything in the file changes.
constexpr std::uint32_t kBuildFileVersion = 9;
constexpr std::size_t kHashBytes = 8;
constexpr const char* kCutOff = "build file: it ends within the {}";

// Texts and lists are preceded by their number of bytes or entries.
void write_text(std::string_view text, ByteWriter& io_writer) {
  io_writer.u32(static_cast<std::uint32_t>(text.size()));
  io_writer.bytes(base::as_bytes(text));
}

std::string read_text(ByteReader& io_reader) {
  const std::uint32_t size = io_reader.u32();
  return std::string(base::as_text(io_reader.take(size)));
}

void write_block(base::Bytes bytes, ByteWriter& io_writer) {
  io_writer.write(std::uint64_t{bytes.size()});
  io_writer.bytes(bytes);
}

base::Bytes read_block(ByteReader& io_reader) {
  const auto size = io_reader.read<std::uint64_t>();
  return io_reader.take(size);
}

// Reads a count of records that take at least `min_bytes` each. Fails the reader if the rest of the file
// cannot hold them, so that damaged files never allocate more than they are large.
std::size_t read_count(ByteReader& io_reader, std::size_t min_bytes) {
  const std::uint32_t count = io_reader.u32();
  if (count <= io_reader.remaining() / min_bytes) return count;
  io_reader.seek(io_reader.offset() + io_reader.remaining() + 1);
  return 0;
}

void write_vector(const math::Vec3d& v, ByteWriter& io_writer) {
  for (int axis = 0; axis < 3; ++axis) io_writer.write(v[axis]);
}

math::Vec3d read_vector(ByteReader& io_reader) {
  math::Vec3d v(0.0);
  for (int axis = 0; axis < 3; ++axis) v[axis] = io_reader.read<double>();
  return v;
}

void write_portals(const PortalSet& set, ByteWriter& io_writer) {
  io_writer.u32(set.cluster_count);
  io_writer.u32(static_cast<std::uint32_t>(set.cluster_of_leaf.size()));
  for (const std::uint32_t cluster : set.cluster_of_leaf) io_writer.u32(cluster);
  io_writer.u32(static_cast<std::uint32_t>(set.portals.size()));
  for (const Portal& portal : set.portals) {
    write_vector(portal.normal, io_writer);
    io_writer.write(portal.distance);
    for (const std::uint32_t cluster : portal.clusters) io_writer.u32(cluster);
    io_writer.u32(static_cast<std::uint32_t>(portal.winding_world.size()));
    for (const math::Vec3d& corner : portal.winding_world) write_vector(corner, io_writer);
  }
}

// Checks every index, since the file may be damaged in ways that its hash does not show (another version of
// the compiler, for example).
base::Result<PortalSet> read_portals(std::size_t leaves, ByteReader& io_reader) {
  constexpr std::size_t kMinPortalBytes = 4 * 8 + 3 * 4;
  PortalSet set;
  set.cluster_count = io_reader.u32();
  const std::size_t leaf_count = read_count(io_reader, sizeof(std::uint32_t));
  for (std::size_t i = 0; i < leaf_count; ++i) set.cluster_of_leaf.push_back(io_reader.u32());
  set.portals.resize(read_count(io_reader, kMinPortalBytes));
  const auto exists = [&](std::uint32_t cluster) { return cluster < set.cluster_count; };
  for (Portal& portal : set.portals) {
    portal.normal = read_vector(io_reader);
    portal.distance = io_reader.read<double>();
    for (std::uint32_t& cluster : portal.clusters) cluster = io_reader.u32();
    portal.winding_world.resize(read_count(io_reader, 3 * sizeof(double)));
    for (math::Vec3d& corner : portal.winding_world) corner = read_vector(io_reader);
    if (!io_reader.ok()) return base::malformed(kCutOff, "portals");
    if (portal.winding_world.size() < 3 || !exists(portal.clusters[0]) || !exists(portal.clusters[1]))
      return base::malformed("build file: it has a portal with {} corners between clusters {} and {} of {}",
                             portal.winding_world.size(), portal.clusters[0], portal.clusters[1],
                             set.cluster_count);
  }
  if (!io_reader.ok()) return base::malformed(kCutOff, "portals");
  if (leaf_count != leaves || set.cluster_count > leaves)
    return base::malformed(
        "build file: its portals are for {} leaves in {} clusters, the level has {} leaves", leaf_count,
        set.cluster_count, leaves);
  for (const std::uint32_t cluster : set.cluster_of_leaf)
    if (cluster != kNoCluster && !exists(cluster))
      return base::malformed("build file: a leaf is in cluster {} of {}", cluster, set.cluster_count);
  return set;
}

void write_face_keys(const FaceKeys& face_keys, ByteWriter& io_writer) {
  io_writer.u32(static_cast<std::uint32_t>(face_keys.keys.size()));
  for (const SurfaceKeys& keys : face_keys.keys)
    visit_fields(keys, [&](const auto& field) { io_writer.write(field); });
  io_writer.u32(static_cast<std::uint32_t>(face_keys.of_face.size()));
  for (const std::uint32_t key : face_keys.of_face) io_writer.u32(key);
}

base::Result<FaceKeys> read_face_keys(std::size_t faces, ByteReader& io_reader) {
  FaceKeys face_keys;
  face_keys.keys.resize(read_count(io_reader, sizeof(SurfaceKeys::min_light_excludes)));
  const auto read_field = [&]<typename Field>(Field& field) {
    if constexpr (std::is_same_v<Field, bool>)
      field = io_reader.u8() != 0;
    else
      field = io_reader.read<Field>();
  };
  for (SurfaceKeys& keys : face_keys.keys) visit_fields(keys, read_field);
  const std::size_t count = read_count(io_reader, sizeof(std::uint32_t));
  for (std::size_t i = 0; i < count; ++i) face_keys.of_face.push_back(io_reader.u32());
  if (!io_reader.ok()) return base::malformed(kCutOff, "face keys");
  if (count != faces)
    return base::malformed("build file: it has keys for {} faces, the level has {} faces", count, faces);
  for (const std::uint32_t key : face_keys.of_face)
    if (key >= face_keys.keys.size())
      return base::malformed("build file: a face has keys number {} of {}", key, face_keys.keys.size());
  return face_keys;
}

void write_level_part(const Build& build, ByteWriter& io_writer) {
  io_writer.write(build.brushes_key);
  io_writer.write(build.solid_occupants_key);
  io_writer.write(build.light_key);
  io_writer.u32(static_cast<std::uint32_t>(build.own_textures));
  io_writer.u8(static_cast<std::uint8_t>(build.visibility));
  io_writer.write(build.mean_visible_share.value_or(-1));
  io_writer.u8(build.water_is_transparent ? 1 : 0);
  io_writer.u32(static_cast<std::uint32_t>(build.brush_entities.size()));
  for (const BrushEntity& entity : build.brush_entities) {
    io_writer.u8(entity.is_in_level ? 1 : 0);
    write_text(entity.model, io_writer);
    write_text(entity.origin, io_writer);
  }
  write_portals(build.portals, io_writer);
  write_face_keys(build.face_keys, io_writer);
  write_block(write_light_cache(build.light_cache), io_writer);
}

base::Status read_level_part(ByteReader& io_reader, Build& io_build) {
  io_build.brushes_key = io_reader.read<StageKey>();
  io_build.solid_occupants_key = io_reader.read<StageKey>();
  io_build.light_key = io_reader.read<StageKey>();
  io_build.own_textures = io_reader.u32();
  const std::uint8_t visibility = io_reader.u8();
  if (visibility > static_cast<std::uint8_t>(VisibilityKind::kFull) ||
      io_build.own_textures > io_build.bsp.miptexes.size())
    return base::malformed("build file: it has visibility of kind {} and {} textures", visibility,
                           io_build.own_textures);
  io_build.visibility = static_cast<VisibilityKind>(visibility);
  if (const double share = io_reader.read<double>(); share >= 0) io_build.mean_visible_share = share;
  io_build.water_is_transparent = io_reader.u8() != 0;
  io_build.brush_entities.resize(read_count(io_reader, 9));
  for (BrushEntity& entity : io_build.brush_entities) {
    entity.is_in_level = io_reader.u8() != 0;
    entity.model = read_text(io_reader);
    entity.origin = read_text(io_reader);
  }
  if (!io_reader.ok()) return base::malformed(kCutOff, "brush entities");
  TRY(io_build.portals, read_portals(io_build.bsp.leaves.size(), io_reader));
  TRY(io_build.face_keys, read_face_keys(io_build.bsp.faces.size(), io_reader));
  TRY(io_build.light_cache, read_light_cache(read_block(io_reader)));
  return base::Ok{};
}

}  // namespace

base::ByteVector write_build(const Build& build, const LevelFiles& files) {
  ByteWriter writer;
  const std::array<std::uint32_t, 2> start{kBuildFileMagic, kBuildFileVersion};
  const std::array<std::uint64_t, 2> hashes{base::hash_bytes(files.bsp), base::hash_bytes(files.lit)};
  writer.bytes(std::as_bytes(std::span(start)));
  writer.bytes(std::as_bytes(std::span(hashes)));
  write_level_part(build, writer);
  writer.write(base::hash_bytes(writer.view()));
  return std::move(writer).take();
}

// Checks the hash of the file first, so that damage is reported as damage and not as some strange value.
base::Result<Build> read_build(base::Bytes bytes, const LevelFiles& files) {
  ByteReader reader(bytes);
  if (reader.u32() != kBuildFileMagic) return base::malformed("build file: it does not begin with TBLD");
  if (const std::uint32_t version = reader.u32(); version != kBuildFileVersion)
    return base::error(base::ErrorCode::kUnsupported,
                       "build file: version {} is not supported, only version {}", version,
                       kBuildFileVersion);
  if (reader.remaining() < kHashBytes) return base::malformed(kCutOff, "hash");
  ByteReader end(bytes.last(kHashBytes));
  if (end.read<std::uint64_t>() != base::hash_bytes(bytes.first(bytes.size() - kHashBytes)))
    return base::malformed("build file: it is damaged (wrong hash)");

  Build build;
  const auto bsp_hash = reader.read<std::uint64_t>(), lit_hash = reader.read<std::uint64_t>();
  if (!reader.ok()) return base::malformed(kCutOff, "hashes");
  if (files.bsp.empty() || bsp_hash != base::hash_bytes(files.bsp) || lit_hash != base::hash_bytes(files.lit))
    return build;
  TRY(build.bsp, formats::read_bsp(files.bsp));
  if (!files.lit.empty()) {
    TRY(build.lit, formats::read_lit(files.lit));
  }
  TRY_STATUS(read_level_part(reader, build));
  if (reader.remaining() != kHashBytes)
    return base::malformed("build file: its {} bytes are more than its contents", bytes.size());
  return build;
}

}  // namespace temblor::compiler
