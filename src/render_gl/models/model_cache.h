// The alias models that are on the graphics card. A model is uploaded when it is first drawn.
//
// Scenes refer to models by address, and a model may be freed and another one made at the same address, so
// models are distinguished by their identity (AliasIdentity). The cache keeps identities, not models. A model
// is dropped when nothing else keeps its identity, as the caller has freed the model then, or when it was not
// drawn for many frames. So a change of the level drops what the new level does not use.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "render_gl/models/card_model.h"

namespace temblor::render_gl {

class ModelCache {
 public:
  // Frames without being drawn after which a model is dropped: half a minute or less, usually.
  static constexpr std::uint32_t kIdleFrames = 2000;

  // Drops models, which invalidates the results of find().
  void begin_frame();
  // The model on the card, after uploading it if it is missing. Fails as CardModel::make does.
  base::Result<const CardModel*> find(const Functions& gl, const render::AliasModel& model);

  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::shared_ptr<const render::AliasIdentity> identity;
    CardModel model;
    std::uint32_t last_frame;
  };
  std::unordered_map<const render::AliasIdentity*, Entry> entries_;
  std::uint32_t frame_ = 0;
};

}  // namespace temblor::render_gl
