// The record layouts of a level, defined once for reading and writing: fields(io, record) visits the fields
// in file order, with their widths in versions 29 and 30 and in the two wide versions. The Io type reads,
// writes, or counts them.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// The type of a field in the file: in versions 29 and 30, and in 2PSB and BSP2.
template <typename Small, typename Large = Small>
struct Width {};
inline bool has_small_fields(BspVersion version) {
  return version == BspVersion::k29 || version == BspVersion::k30;
}

inline constexpr Width<float> kF32;
inline constexpr Width<std::uint8_t> kU8;
inline constexpr Width<std::int32_t> kI32;
inline constexpr Width<std::int16_t, std::int32_t> kI16OrI32;
inline constexpr Width<std::uint16_t, std::int32_t> kU16OrI32;
inline constexpr Width<std::uint16_t, std::uint32_t> kU16OrU32;

// In versions 29 and 30, a 16-bit child is a node if it is below the number of nodes, and negative otherwise;
// so large levels can use more than 32767 nodes.
struct TreeSizes {
  std::size_t nodes = 0, clipnodes = 0;
};

// Matches Record and const Record.
template <typename T, typename Record>
concept Is = std::same_as<std::remove_const_t<T>, Record>;

template <typename Io>
void vec3(Io& io, const char* name, Is<math::Vec3> auto& value) {
  for (int axis = 0; axis < 3; ++axis) io.number(name, kF32, value[axis]);
}

// plane, 20 bytes:   0 normal f32 x3 | 12 distance f32 | 16 type i32
template <typename Io>
void fields(Io& io, Is<BspPlane> auto& plane) {
  vec3(io, "normal", plane.normal);
  io.number("distance", kF32, plane.distance);
  io.number("type", kI32, plane.type);
}

// vertex, 12 bytes:  0 x f32 | 4 y f32 | 8 z f32
template <typename Io>
void fields(Io& io, Is<math::Vec3> auto& vertex) {
  vec3(io, "position", vertex);
}

// node      version 29, 24 bytes    2PSB, 32 bytes      BSP2, 44 bytes
// plane             0 i32               0 i32               0 i32
// front, back       4 i16 x2            4 i32 x2            4 i32 x2     node, or -(leaf + 1)
// mins, maxs        8 i16 x6           12 i16 x6           12 f32 x6     whole numbers except in BSP2
// first face       20 u16              24 u32              36 u32
// face count       22 u16              28 u32              40 u32
template <typename Io>
void fields(Io& io, Is<BspNode> auto& node) {
  io.number("plane", kI32, node.plane);
  for (auto& child : node.children) io.child("child", child, io.tree_sizes().nodes);
  io.bounds(node.mins, node.maxs);
  io.number("first face", kU16OrU32, node.first_face);
  io.number("face count", kU16OrU32, node.face_count);
}

// texinfo, 40 bytes: 0 s axis f32 x3, s offset f32 | 16 t axis f32 x3, t offset f32 |
//                   32 texture i32 | 36 flags i32
template <typename Io>
void fields(Io& io, Is<BspTexinfo> auto& texinfo) {
  vec3(io, "s axis", texinfo.s_axis);
  io.number("s offset", kF32, texinfo.s_offset);
  vec3(io, "t axis", texinfo.t_axis);
  io.number("t offset", kF32, texinfo.t_offset);
  io.number("texture", kI32, texinfo.miptex);
  io.number("flags", kI32, texinfo.flags);
}

// face      version 29, 20 bytes    2PSB and BSP2, 28 bytes
// plane             0 u16               0 i32
// side              2 i16               4 i32            1: the face points against the plane's normal
// first surfedge    4 i32               8 i32
// surfedge count    8 u16              12 i32
// texinfo          10 u16              16 i32
// light styles     12 u8 x4            20 u8 x4          255: unused
// light offset     16 i32              24 i32            bytes into the lighting; -1: none
template <typename Io>
void fields(Io& io, Is<BspFace> auto& face) {
  io.number("plane", kU16OrI32, face.plane);
  io.number("side", kI16OrI32, face.side);
  io.number("first surfedge", kI32, face.first_surfedge);
  io.number("surfedge count", kU16OrI32, face.surfedge_count);
  io.number("texinfo", kU16OrI32, face.texinfo);
  for (auto& style : face.styles) io.number("style", kU8, style);
  io.number("light offset", kI32, face.light_offset);
}

// clipnode  version 29, 8 bytes     2PSB and BSP2, 12 bytes
// plane             0 i32               0 i32
// front, back       4 i16 x2            4 i32 x2         clipnode, or contents if negative
template <typename Io>
void fields(Io& io, Is<BspClipnode> auto& clipnode) {
  io.number("plane", kI32, clipnode.plane);
  for (auto& child : clipnode.children) io.child("child", child, io.tree_sizes().clipnodes);
}

// leaf      version 29, 28 bytes    2PSB, 32 bytes      BSP2, 44 bytes
// contents          0 i32               0 i32               0 i32
// visibility        4 i32               4 i32               4 i32        offset of its row; -1: none
// mins, maxs        8 i16 x6            8 i16 x6            8 f32 x6
// marksurfaces     20 u16 x2           20 u32 x2           32 u32 x2     first, count
// ambient levels   24 u8 x4            28 u8 x4            40 u8 x4      water, sky, slime, lava
template <typename Io>
void fields(Io& io, Is<BspLeaf> auto& leaf) {
  io.number("contents", kI32, leaf.contents);
  io.number("visibility offset", kI32, leaf.visibility_offset);
  io.bounds(leaf.mins, leaf.maxs);
  io.number("first marksurface", kU16OrU32, leaf.first_marksurface);
  io.number("marksurface count", kU16OrU32, leaf.marksurface_count);
  for (auto& level : leaf.ambient) io.number("ambient level", kU8, level);
}

// marksurface:  face u16, or u32 in 2PSB and BSP2
template <typename Io>
void fields(Io& io, Is<std::uint32_t> auto& marksurface) {
  io.number("face", kU16OrU32, marksurface);
}

// edge:         start, end vertex u16 x2, or u32 x2 in 2PSB and BSP2
template <typename Io>
void fields(Io& io, Is<BspEdge> auto& edge) {
  for (auto& vertex : edge.vertices) io.number("vertex", kU16OrU32, vertex);
}

// surfedge:     edge i32; negative: edge -value from end to start
template <typename Io>
void fields(Io& io, Is<std::int32_t> auto& surfedge) {
  io.number("edge", kI32, surfedge);
}

// model, 64 bytes:  0 mins f32 x3 | 12 maxs f32 x3 | 24 origin f32 x3 | 36 head nodes i32 x4 |
//                  52 visible leaves i32 | 56 first face i32 | 60 face count i32
template <typename Io>
void fields(Io& io, Is<BspModel> auto& model) {
  vec3(io, "mins", model.mins);
  vec3(io, "maxs", model.maxs);
  vec3(io, "origin", model.origin);
  for (auto& head : model.head_nodes) io.number("head node", kI32, head);
  io.number("visible leaves", kI32, model.visible_leaves);
  io.number("first face", kI32, model.first_face);
  io.number("face count", kI32, model.face_count);
}

// An Io that counts the bytes of a record.
class RecordSizer {
 public:
  explicit RecordSizer(BspVersion version) : version_(version) {}
  std::size_t bytes() const { return bytes_; }

  template <typename Small, typename Large, typename Value>
  void number(const char*, Width<Small, Large>, const Value&) {
    bytes_ += has_small_fields(version_) ? sizeof(Small) : sizeof(Large);
  }
  void child(const char* name, const std::int32_t& value, std::size_t) { number(name, kI16OrI32, value); }
  void bounds(const math::Vec3&, const math::Vec3&) {
    bytes_ += 6 * (version_ == BspVersion::kBsp2 ? sizeof(float) : sizeof(std::int16_t));
  }
  TreeSizes tree_sizes() const { return {}; }

 private:
  BspVersion version_;
  std::size_t bytes_ = 0;
};

// Returns the size of a record in the file.
template <typename Record>
std::size_t record_bytes(BspVersion version) {
  RecordSizer sizer(version);
  const Record record{};
  fields(sizer, record);
  return sizer.bytes();
}

}  // namespace temblor::formats::bsp_file
