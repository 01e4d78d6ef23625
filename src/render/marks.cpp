#include "render/marks.h"

#include <algorithm>

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
    if (mark.kind != MarkKind::kPicture) continue;
    hash = base::hash_with(hash, mark.picture->hash());
    hash = base::hash_with(hash, base::float_bits(mark.up_model.x) << 32 | base::float_bits(mark.up_model.y));
    hash = base::hash_with(hash, base::float_bits(mark.up_model.z));
  }
  return hash == 0 ? 1 : hash;
}

}  // namespace

void MarkSet::add(world::FaceIndex face, const Mark& mark) {
  // When the face is full, a mark is removed before the new one is appended, so `marks` never grows beyond
  // its first allocation.
  DCHECK(mark.radius >= 0.5f && mark.radius <= 128.0f);
  DCHECK((mark.kind == MarkKind::kPicture) == (mark.picture != nullptr));
  FaceMarks& on_face = faces_[static_cast<std::uint32_t>(face)];
  if (on_face.marks.empty()) on_face.marks.reserve(kMarksPerFace);
  if (on_face.marks.size() == kMarksPerFace) {
    auto removed = std::find_if(on_face.marks.begin(), on_face.marks.end(),
                                [](const Mark& old) { return !old.is_lasting; });
    if (removed == on_face.marks.end()) {
      if (!mark.is_lasting) return;
      removed = on_face.marks.begin();
    }
    on_face.marks.erase(removed);
    --size_;
  }
  on_face.marks.push_back(mark);
  ++size_;
  on_face.revision = hash_marks(on_face.marks);
}

void MarkSet::remove_shots() {
  size_ = 0;
  for (auto face = faces_.begin(); face != faces_.end();) {
    FaceMarks& on_face = face->second;
    std::erase_if(on_face.marks, [](const Mark& mark) { return !mark.is_lasting; });
    if (on_face.marks.empty()) {
      face = faces_.erase(face);
      continue;
    }
    on_face.revision = hash_marks(on_face.marks);
    size_ += on_face.marks.size();
    ++face;
  }
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
