#include "platform/headless/window.h"

namespace temblor::platform::headless {

void HeadlessWindow::put_at(const What& what, double time_s) {
  events_.push_back({time_s, what});
}

void HeadlessWindow::poll(std::vector<InputEvent>& io_events) {
  const double now = now_s();
  for (const InputEvent& event : events_)
    if (event.time_s <= now) io_events.push_back(event);
  std::erase_if(events_, [&](const InputEvent& event) { return event.time_s <= now; });
}

}  // namespace temblor::platform::headless
