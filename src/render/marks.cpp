#include "render/marks.h"

#include "base/check.h"
#include "base/hash.h"

namespace temblor::render {

namespace {

// Not 0, which stands for "no marks".
std::uint64_t hash_marks(std::span<const Mark> marks) {
  std::uint64_t hash = marks.size();
  for (const Mark& mark : marks) {
    hash = base::hash_with(hash, static_cast<std::uint64_t>(mark.kind) << 32 | mark.seed);
    hash = base::hash_with(
        hash, base::float_bits(mark.position_model.x) << 32 | base::float_bits(mark.position_model.y));
    hash =
        base::hash_with(hash, base::float_bits(mark.position_model.z) << 32 | base::float_bits(mark.radius));
  }
  return hash == 0 ? 1 : hash;
}

}  // namespace

void MarkSet::add(world::FaceIndex face, const Mark& mark) {
  // The new mark is appended even when the face is full: the oldest one is removed first, so `marks` never
  // grows beyond its first allocation.
  DCHECK(mark.radius >= 0.5f && mark.radius <= 128.0f);
  FaceMarks& on_face = faces_[static_cast<std::uint32_t>(face)];
  if (on_face.marks.empty()) on_face.marks.reserve(kMarksPerFace);
  if (on_face.marks.size() == kMarksPerFace) {
    on_face.marks.erase(on_face.marks.begin());
    --size_;
  }
  on_face.marks.push_back(mark);
  ++size_;
  on_face.revision = hash_marks(on_face.marks);
}

void MarkSet::clear() {
  faces_.clear();
  size_ = 0;
}

std::span<const Mark> MarkSet::marks_on_face(world::FaceIndex face) const {
  const auto found = faces_.find(static_cast<std::uint32_t>(face));
  if (found == faces_.end()) return {};
  return found->second.marks;
}

std::uint64_t MarkSet::revision(world::FaceIndex face) const {
  const auto found = faces_.find(static_cast<std::uint32_t>(face));
  return found == faces_.end() ? 0 : found->second.revision;
}

}  // namespace temblor::render
