#include "server/debug_shapes.h"

#include <utility>

namespace temblor::server {

void DebugShapes::add(const DebugLine& line, const DebugLook& look) {
  if (lines_.size() < kMaxLines) lines_.push_back({line, look});
}

void DebugShapes::add(DebugText text, const DebugLook& look) {
  if (texts_.size() >= kMaxTexts) return;
  if (text.text.size() > kMaxTextChars) text.text.resize(kMaxTextChars);
  texts_.push_back({std::move(text), look});
}

void DebugShapes::drop_ended(double time_s) {
  const auto has_ended = [time_s](const auto& shown) { return shown.look.end_time_s < time_s; };
  std::erase_if(lines_, has_ended);
  std::erase_if(texts_, has_ended);
}

}  // namespace temblor::server
