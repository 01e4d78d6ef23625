#include "render_gl/models/model_cache.h"

namespace temblor::render_gl {

void ModelCache::begin_frame() {
  ++frame_;
  std::erase_if(entries_, [&](const auto& element) {
    const Entry& entry = element.second;
    return entry.identity.use_count() == 1 || frame_ - entry.last_frame > kIdleFrames;
  });
}

base::Result<const CardModel*> ModelCache::find(const Functions& gl, const render::AliasModel& model) {
  auto found = entries_.find(model.identity.get());
  if (found == entries_.end()) {
    TRY(CardModel card, CardModel::make(gl, model));
    found = entries_.emplace(model.identity.get(), Entry{model.identity, std::move(card), frame_}).first;
  }
  found->second.last_frame = frame_;
  return &found->second.model;
}

}  // namespace temblor::render_gl
