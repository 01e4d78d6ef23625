#include "client/menu/page_view.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "client/menu/lettering.h"

namespace temblor::client {

PageView::PageView(Page page) : page_(std::move(page)) {
  update_shown_rows();
  select_first_choice();
}

// A rebuilt page may have more, fewer or renamed rows, so the selection is found by label rather than by
// number.
void PageView::replace(Page page) {
  const std::size_t row = selected_ ? shown_[*selected_] : 0;
  const std::string label = selected_ ? std::string(row_at(*selected_).label()) : std::string();
  const bool had_selection = selected_.has_value();
  release();
  spots_.clear();
  page_ = std::move(page);
  update_shown_rows();
  if (!had_selection) return select_first_choice();
  // Selects the nearest row with the same label, or else the row at the same place.
  std::optional<std::size_t> same;
  const auto distance = [&](std::size_t position) {
    const std::size_t number = shown_[position];
    return number > row ? number - row : row - number;
  };
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (row_at(i).label() == label && (!same || distance(i) < distance(*same))) same = i;
  const auto place = std::lower_bound(shown_.begin(), shown_.end(), row) - shown_.begin();
  selected_ = find_nearest(same.value_or(static_cast<std::size_t>(place)), 1);
}

// Lists the rows that match the search. Headings match none.
void PageView::update_shown_rows() {
  shown_.clear();
  for (std::size_t i = 0; i < page_.rows.size(); ++i) {
    const Row& row = *page_.rows[i];
    if (search_.empty() || (row.can_be_selected() && contains_text(row.search_text(), search_)))
      shown_.push_back(i);
  }
  has_help_ = page_.style == PageStyle::kRows &&
              std::any_of(page_.rows.begin(), page_.rows.end(),
                          [](const std::unique_ptr<Row>& row) { return !row->help().empty(); });
  selected_.reset();
  lines_ = shown_.size();
}

void PageView::select_first_choice() {
  selected_ = find_nearest(page_.first_choice, 1);
  keep_selected_visible();
}

Row* PageView::selected_row() {
  return selected_ ? page_.rows[shown_[*selected_]].get() : nullptr;
}

// Searches in `direction` first, then back, so that a page of headings and rows always finds a row if there
// is one.
std::optional<std::size_t> PageView::find_nearest(std::size_t position, int direction) const {
  if (shown_.empty()) return std::nullopt;
  const auto from = static_cast<std::ptrdiff_t>(std::min(position, shown_.size() - 1));
  const auto end = static_cast<std::ptrdiff_t>(shown_.size());
  for (const int way : {direction, -direction})
    for (std::ptrdiff_t i = from; i >= 0 && i < end; i += way)
      if (row_at(static_cast<std::size_t>(i)).can_be_selected()) return static_cast<std::size_t>(i);
  return std::nullopt;
}

// A new selection ends the dragging of a slider.
bool PageView::select(std::size_t position) {
  const bool changes = selected_ != position;
  if (changes) release();
  selected_ = position;
  keep_selected_visible();
  return changes;
}

void PageView::keep_selected_visible() {
  if (selected_) {
    // Headings above the first selectable row become visible with it.
    const bool is_topmost = find_nearest(0, 1) == selected_ && *selected_ < room_;
    first_ = is_topmost ? 0 : std::min(first_, *selected_);
    if (*selected_ >= first_ + room_) first_ = *selected_ + 1 - room_;
  }
  first_ = std::min(first_, max_first());
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

// A page step keeps one row of the last page visible.
bool PageView::move_pages(int pages) {
  const auto lines = static_cast<std::ptrdiff_t>(std::max<std::size_t>(room_, 2) - 1) * pages;
  if (!selected_) {
    const std::size_t before = first_;
    scroll(static_cast<int>(lines));
    return first_ != before;
  }
  const auto last = static_cast<std::ptrdiff_t>(shown_.size()) - 1;
  const auto to = std::clamp(static_cast<std::ptrdiff_t>(*selected_) + lines, std::ptrdiff_t{0}, last);
  return select(*find_nearest(static_cast<std::size_t>(to), pages));
}

bool PageView::go_to_start() {
  first_ = 0;
  return selected_ && select(*find_nearest(0, 1));
}

bool PageView::go_to_end() {
  first_ = max_first();
  return selected_ && select(*find_nearest(shown_.size() - 1, -1));
}

// Moves the selection only as far as needed.
void PageView::scroll(int lines) {
  const auto to = static_cast<std::ptrdiff_t>(first_) + lines;
  first_ =
      static_cast<std::size_t>(std::clamp(to, std::ptrdiff_t{0}, static_cast<std::ptrdiff_t>(max_first())));
  if (!selected_) return;
  const std::size_t last = std::min(first_ + room_, shown_.size()) - 1;
  selected_ = find_nearest(std::clamp(*selected_, first_, last), *selected_ < first_ ? 1 : -1);
  keep_selected_visible();
}

void PageView::set_search(std::string search) {
  search_ = std::move(search);
  release();
  spots_.clear();
  update_shown_rows();
  first_ = 0;
  selected_ = find_nearest(search_.empty() ? page_.first_choice : 0, 1);
  keep_selected_visible();
}

const PageView::Spot* PageView::find_spot(int x, int y) const {
  const auto found =
      std::find_if(spots_.begin(), spots_.end(), [&](const Spot& spot) { return spot.row.contains(x, y); });
  return found == spots_.end() ? nullptr : &*found;
}

bool PageView::point_at(int x, int y) {
  const Spot* const spot = find_spot(x, y);
  if (spot == nullptr || !row_at(spot->position).can_be_selected()) return false;
  return select(spot->position);
}

// Only the value column of a row is its slider; a press on the label activates the row.
PageView::Pressed PageView::press(int x, int y) {
  if (scroll_bar_.contains(x, y)) {
    bar_slides_ = true;
    slide_to(x, y);
    return Pressed::kSlider;
  }
  const Spot* const spot = find_spot(x, y);
  if (spot == nullptr || !row_at(spot->position).can_be_selected()) return Pressed::kNothing;
  select(spot->position);
  if (spot->slide.width <= 0 || !spot->value.contains(x, y)) return Pressed::kRow;
  sliding_ = selected_row();
  sliding_box_ = spot->slide;
  slide_to(x, y);
  return Pressed::kSlider;
}

// Follows the pointer even outside the slider, until release().
void PageView::slide_to(int x, int y) {
  const auto compute_fraction = [](int at, int from, int size) {
    return std::clamp(static_cast<double>(at - from) / std::max(size, 1), 0.0, 1.0);
  };
  if (sliding_ != nullptr) sliding_->slide(compute_fraction(x, sliding_box_.x, sliding_box_.width));
  if (!bar_slides_) return;
  const double fraction = compute_fraction(y, scroll_bar_.y, scroll_bar_.height);
  const auto wanted = static_cast<int>(fraction * static_cast<double>(max_first()) + 0.5);
  scroll(wanted - static_cast<int>(first_));
}

void PageView::release() {
  sliding_ = nullptr;
  bar_slides_ = false;
}

}  // namespace temblor::client
