#include "render/marks.h"

#include <bit>

#include "base/check.h"
#include "base/mixed_bits.h"

namespace temblor::render {

namespace {

// Adding zero makes -0 and 0, which are equal, one pattern of bits.
std::uint64_t bits(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0f);
}

std::uint64_t hash_of(std::span<const Mark> marks) {
  std::uint64_t hash = marks.size();
  for (const Mark& mark : marks) {
    hash = base::mixed_in(hash, static_cast<std::uint64_t>(mark.kind) << 32 | mark.seed);
    hash = base::mixed_in(hash, bits(mark.position_model.x) << 32 | bits(mark.position_model.y));
    hash = base::mixed_in(hash, bits(mark.position_model.z) << 32 | bits(mark.radius));
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
