#include "platform/headless/window.h"

#include <algorithm>
#include <cstddef>

namespace temblor::platform::headless {

void HeadlessWindow::put_at(const What& what, double time_s) {
  events_.push_back({time_s, what});
}

void HeadlessWindow::poll(std::vector<InputEvent>& io_events) {
  // Read the clock once, so that both loops agree on which events are due.
  const double now = now_s();
  for (const InputEvent& event : events_)
    if (event.time_s <= now) io_events.push_back(event);
  std::erase_if(events_, [&](const InputEvent& event) { return event.time_s <= now; });
}

base::Status HeadlessWindow::present(const Picture& picture, base::Jobs& jobs) {
  if (!can_present_) return base::error(base::ErrorCode::kIo, "the window is lost");
  // Copy as a window would, so that benchmarks include the cost of it.
  const std::size_t pixels = picture.pixels.size();
  shown_.resize(pixels);
  const auto slices = static_cast<std::size_t>(jobs.threads());
  jobs.parallel_for(slices, [&](std::size_t slice) {
    const std::size_t first = pixels * slice / slices, end = pixels * (slice + 1) / slices;
    std::copy(picture.pixels.data() + first, picture.pixels.data() + end, shown_.data() + first);
  });
  shown_size_ = picture.size;
  ++pictures_;
  return base::Ok{};
}

}  // namespace temblor::platform::headless
