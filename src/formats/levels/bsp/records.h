// The layout of each record of a level, written once for both directions: fields(io, record) names the fields
// in file order, with their widths in version 29 and in the two larger versions; an Io reads, writes or
// counts them.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// The width of a field: in version 29, and in 2PSB and BSP2.
template <typename Small, typename Large = Small>
struct Width {};
inline constexpr Width<float> kF32;
inline constexpr Width<std::uint8_t> kU8;
inline constexpr Width<std::int32_t> kI32;
inline constexpr Width<std::int16_t, std::int32_t> kI16OrI32;
inline constexpr Width<std::uint16_t, std::int32_t> kU16OrI32;
inline constexpr Width<std::uint16_t, std::uint32_t> kU16OrU32;

// What the meaning of a 16-bit child depends on: those below the number of nodes are nodes, the rest
// negative.
struct TreeSizes {
  std::size_t nodes = 0, clipnodes = 0;
};

// T is Record, const or not.
template <typename T, typename Record>
concept Is = std::same_as<std::remove_const_t<T>, Record>;

template <typename Io>
void vec3(Io& io, const char* name, Is<math::Vec3> auto& value) {
  for (int axis = 0; axis < 3; ++axis) io.number(name, kF32, value[axis]);
}

template <typename Io>
void fields(Io& io, Is<BspPlane> auto& plane) {
  vec3(io, "normal", plane.normal);
  io.number("distance", kF32, plane.distance);
  io.number("type", kI32, plane.type);
}

template <typename Io>
void fields(Io& io, Is<math::Vec3> auto& vertex) {
  vec3(io, "position", vertex);
}

template <typename Io>
void fields(Io& io, Is<BspNode> auto& node) {
  io.number("plane", kI32, node.plane);
  for (auto& child : node.children) io.child("child", child, io.tree_sizes().nodes);
  io.bounds(node.mins, node.maxs);
  io.number("first face", kU16OrU32, node.first_face);
  io.number("face count", kU16OrU32, node.face_count);
}

template <typename Io>
void fields(Io& io, Is<BspTexinfo> auto& texinfo) {
  vec3(io, "s axis", texinfo.s_axis);
  io.number("s offset", kF32, texinfo.s_offset);
  vec3(io, "t axis", texinfo.t_axis);
  io.number("t offset", kF32, texinfo.t_offset);
  io.number("texture", kI32, texinfo.miptex);
  io.number("flags", kI32, texinfo.flags);
}

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

template <typename Io>
void fields(Io& io, Is<BspClipnode> auto& clipnode) {
  io.number("plane", kI32, clipnode.plane);
  for (auto& child : clipnode.children) io.child("child", child, io.tree_sizes().clipnodes);
}

template <typename Io>
void fields(Io& io, Is<BspLeaf> auto& leaf) {
  io.number("contents", kI32, leaf.contents);
  io.number("visibility offset", kI32, leaf.visibility_offset);
  io.bounds(leaf.mins, leaf.maxs);
  io.number("first marksurface", kU16OrU32, leaf.first_marksurface);
  io.number("marksurface count", kU16OrU32, leaf.marksurface_count);
  for (auto& level : leaf.ambient) io.number("ambient level", kU8, level);
}

template <typename Io>
void fields(Io& io, Is<std::uint32_t> auto& marksurface) {
  io.number("face", kU16OrU32, marksurface);
}

template <typename Io>
void fields(Io& io, Is<BspEdge> auto& edge) {
  for (auto& vertex : edge.vertices) io.number("vertex", kU16OrU32, vertex);
}

template <typename Io>
void fields(Io& io, Is<std::int32_t> auto& surfedge) {
  io.number("edge", kI32, surfedge);
}

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

// Counts a record's bytes.
class RecordSizer {
 public:
  explicit RecordSizer(BspVersion version) : version_(version) {}
  std::size_t bytes() const { return bytes_; }

  template <typename Small, typename Large, typename Value>
  void number(const char*, Width<Small, Large>, const Value&) {
    bytes_ += version_ == BspVersion::k29 ? sizeof(Small) : sizeof(Large);
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

template <typename Record>
std::size_t record_bytes(BspVersion version) {
  RecordSizer sizer(version);
  const Record record{};
  fields(sizer, record);
  return sizer.bytes();
}

}  // namespace temblor::formats::bsp_file
