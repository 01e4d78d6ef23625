#include "client/menu/page_view.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "client/menu/lettering.h"

namespace temblor::client {

PageView::PageView(Page page) : page_(std::move(page)) {
  list_rows();
  select_first_choice();
}

void PageView::replace(Page page) {
  const std::size_t row = selected_ ? shown_[*selected_] : 0;
  const std::string label = selected_ ? std::string(row_at(*selected_).label()) : std::string();
  const bool had_selection = selected_.has_value();
  let_go();
  spots_.clear();
  page_ = std::move(page);
  list_rows();
  if (!had_selection) return select_first_choice();
  // The nearest row of the same name; without one, what stands in its place.
  std::optional<std::size_t> same;
  const auto distance = [&](std::size_t position) {
    const std::size_t number = shown_[position];
    return number > row ? number - row : row - number;
  };
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (row_at(i).label() == label && (!same || distance(i) < distance(*same))) same = i;
  const auto place = std::lower_bound(shown_.begin(), shown_.end(), row) - shown_.begin();
  selected_ = nearest(same.value_or(static_cast<std::size_t>(place)), 1);
}

void PageView::list_rows() {
  shown_.clear();
  for (std::size_t i = 0; i < page_.rows.size(); ++i) {
    const Row& row = *page_.rows[i];
    if (search_.empty() || (row.can_be_selected() && holds(row.search_text(), search_))) shown_.push_back(i);
  }
  has_help_ = page_.style == PageStyle::kRows &&
              std::any_of(page_.rows.begin(), page_.rows.end(),
                          [](const std::unique_ptr<Row>& row) { return !row->help().empty(); });
  selected_.reset();
  lines_ = shown_.size();
}

void PageView::select_first_choice() {
  selected_ = nearest(page_.first_choice, 1);
  keep_selected_visible();
}

Row* PageView::selected_row() {
  return selected_ ? page_.rows[shown_[*selected_]].get() : nullptr;
}

std::optional<std::size_t> PageView::nearest(std::size_t position, int direction) const {
  if (shown_.empty()) return std::nullopt;
  const auto from = static_cast<std::ptrdiff_t>(std::min(position, shown_.size() - 1));
  const auto end = static_cast<std::ptrdiff_t>(shown_.size());
  for (const int way : {direction, -direction})
    for (std::ptrdiff_t i = from; i >= 0 && i < end; i += way)
      if (row_at(static_cast<std::size_t>(i)).can_be_selected()) return static_cast<std::size_t>(i);
  return std::nullopt;
}

bool PageView::select(std::size_t position) {
  const bool changes = selected_ != position;
  if (changes) let_go();
  selected_ = position;
  keep_selected_visible();
  return changes;
}

void PageView::keep_selected_visible() {
  if (selected_) {
    // Headings above the first row that can be selected come into sight with it.
    const bool is_topmost = nearest(0, 1) == selected_ && *selected_ < room_;
    first_ = is_topmost ? 0 : std::min(first_, *selected_);
    if (*selected_ >= first_ + room_) first_ = *selected_ + 1 - room_;
  }
  first_ = std::min(first_, last_first());
}

void PageView::set_lines(std::size_t lines, std::size_t room) {
  lines_ = lines;
  room_ = std::max<std::size_t>(room, 1);
  keep_selected_visible();
}

bool PageView::move(int steps) {
  if (!selected_) {
    const std::size_t before = first_;
    scroll(steps);
    return first_ != before;
  }
  const auto count = static_cast<std::ptrdiff_t>(shown_.size());
  auto position = static_cast<std::ptrdiff_t>(*selected_);
  for (std::ptrdiff_t passed = 0; passed < count; ++passed) {
    position = (position + steps + count) % count;
    if (row_at(static_cast<std::size_t>(position)).can_be_selected()) break;
  }
  return select(static_cast<std::size_t>(position));
}

bool PageView::move_pages(int pages) {
  const auto lines = static_cast<std::ptrdiff_t>(std::max<std::size_t>(room_, 2) - 1) * pages;
  if (!selected_) {
    const std::size_t before = first_;
    scroll(static_cast<int>(lines));
    return first_ != before;
  }
  const auto last = static_cast<std::ptrdiff_t>(shown_.size()) - 1;
  const auto to = std::clamp(static_cast<std::ptrdiff_t>(*selected_) + lines, std::ptrdiff_t{0}, last);
  return select(*nearest(static_cast<std::size_t>(to), pages));
}

bool PageView::go_to_begin() {
  first_ = 0;
  return selected_ && select(*nearest(0, 1));
}

bool PageView::go_to_end() {
  first_ = last_first();
  return selected_ && select(*nearest(shown_.size() - 1, -1));
}

void PageView::scroll(int lines) {
  const auto to = static_cast<std::ptrdiff_t>(first_) + lines;
  first_ =
      static_cast<std::size_t>(std::clamp(to, std::ptrdiff_t{0}, static_cast<std::ptrdiff_t>(last_first())));
  if (!selected_) return;
  const std::size_t last = std::min(first_ + room_, shown_.size()) - 1;
  selected_ = nearest(std::clamp(*selected_, first_, last), *selected_ < first_ ? 1 : -1);
  keep_selected_visible();
}

void PageView::set_search(std::string search) {
  search_ = std::move(search);
  let_go();
  spots_.clear();
  list_rows();
  first_ = 0;
  selected_ = nearest(search_.empty() ? page_.first_choice : 0, 1);
  keep_selected_visible();
}

const PageView::Spot* PageView::spot_at(int x, int y) const {
  const auto found =
      std::find_if(spots_.begin(), spots_.end(), [&](const Spot& spot) { return spot.row.contains(x, y); });
  return found == spots_.end() ? nullptr : &*found;
}

bool PageView::point_at(int x, int y) {
  const Spot* const spot = spot_at(x, y);
  if (spot == nullptr || !row_at(spot->position).can_be_selected()) return false;
  return select(spot->position);
}

PageView::Pressed PageView::press(int x, int y) {
  if (scroll_bar_.contains(x, y)) {
    bar_slides_ = true;
    slide_to(x, y);
    return Pressed::kSlider;
  }
  const Spot* const spot = spot_at(x, y);
  if (spot == nullptr || !row_at(spot->position).can_be_selected()) return Pressed::kNothing;
  select(spot->position);
  if (spot->slide.width <= 0 || !spot->value.contains(x, y)) return Pressed::kRow;
  sliding_ = selected_row();
  sliding_box_ = spot->slide;
  slide_to(x, y);
  return Pressed::kSlider;
}

void PageView::slide_to(int x, int y) {
  const auto fraction_of = [](int at, int from, int size) {
    return std::clamp(static_cast<double>(at - from) / std::max(size, 1), 0.0, 1.0);
  };
  if (sliding_ != nullptr) sliding_->slide(fraction_of(x, sliding_box_.x, sliding_box_.width));
  if (!bar_slides_) return;
  const double fraction = fraction_of(y, scroll_bar_.y, scroll_bar_.height);
  const auto wanted = static_cast<int>(fraction * static_cast<double>(last_first()) + 0.5);
  scroll(wanted - static_cast<int>(first_));
}

void PageView::let_go() {
  sliding_ = nullptr;
  bar_slides_ = false;
}

}  // namespace temblor::client
