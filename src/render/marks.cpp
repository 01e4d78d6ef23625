#include "render/marks.h"

#include <bit>

#include "base/check.h"

namespace temblor::render {

namespace {

// The last step of splitmix64 (Steele, Lea, Flood, 2014): every bit of the input changes half of the
// output's.
std::uint64_t mixed(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

std::uint64_t after(std::uint64_t hash, std::uint64_t value) {
  return mixed((hash ^ value) + 0x9e3779b97f4a7c15u);
}

// Adding zero makes -0 and 0, which are equal, one pattern of bits.
std::uint64_t bits(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0f);
}

std::uint64_t hash_of(std::span<const Mark> marks) {
  std::uint64_t hash = marks.size();
  for (const Mark& mark : marks) {
    hash = after(hash, static_cast<std::uint64_t>(mark.kind) << 32 | mark.seed);
    hash = after(hash, bits(mark.position_model.x) << 32 | bits(mark.position_model.y));
    hash = after(hash, bits(mark.position_model.z) << 32 | bits(mark.radius));
  }
  return hash == 0 ? 1 : hash;
}

}  // namespace

void MarkSet::add(world::FaceIndex face, const Mark& mark) {
  DCHECK(mark.radius >= 0.5f && mark.radius <= 128.0f);
  FaceMarks& on_face = faces_[static_cast<std::uint32_t>(face)];
  if (on_face.marks.empty()) on_face.marks.reserve(kMarksAFace);
  if (on_face.marks.size() == kMarksAFace) {
    on_face.marks.erase(on_face.marks.begin());
    --size_;
  }
  on_face.marks.push_back(mark);
  ++size_;
  on_face.revision = hash_of(on_face.marks);
}

void MarkSet::clear() {
  faces_.clear();
  size_ = 0;
}

std::span<const Mark> MarkSet::of_face(world::FaceIndex face) const {
  const auto found = faces_.find(static_cast<std::uint32_t>(face));
  if (found == faces_.end()) return {};
  return found->second.marks;
}

std::uint64_t MarkSet::revision(world::FaceIndex face) const {
  const auto found = faces_.find(static_cast<std::uint32_t>(face));
  return found == faces_.end() ? 0 : found->second.revision;
}

}  // namespace temblor::render
