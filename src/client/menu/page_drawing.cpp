// Page layout and drawing: title, search line, rows, details of the selected row, help. Units are canvas
// pixels.
//
//   +----------------------------------+
//   |             TITLE                |
//   | Filter: ab_              3 of 40 |   searched pages
//   | > row      value     | | picture |   the scroll bar, and details of the selected row
//   |   row      value     | | text    |
//   | help for the selected row        |
//   +----------------------------------+
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>

#include "client/menu/lettering.h"
#include "client/menu/page_view.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {
namespace {

// Heights with the gap to the next line.
constexpr int kLine = kCharacterSide + 2;  // with the gap to the next line
constexpr int kLargeLine = 2 * kCharacterSide + 2;
constexpr int kCursor = 2 * kCharacterSide;  // room for the cursor, left of a row
constexpr int kScrollBar = 8;                // right of the rows
constexpr int kMargin = 8, kGap = 4;
constexpr int kHelpLines = 3;
constexpr std::uint8_t kTrackGray = 15;         // the palette's first row is gray
constexpr std::uint8_t kPictureBackground = 0;  // black

constexpr int kLargeChars = 13;  // the longest label on a large page
constexpr int kLargeWidth = kLargeChars * 2 * kCharacterSide;
// The width of the plaque with the gap to the rows.
constexpr int kPlaqueWidth = 56;

// The canvas heights from which on these parts are drawn.
constexpr int kRoomForTitle = 60, kRoomForLargeTitle = 120, kRoomForPicture = 160, kRoomForHelp = 130;

// Returns the largest size with the picture's proportions that fits, at least 1 x 1.
std::array<int, 2> fit_picture(const formats::Picture& picture, int width, int height) {
  const double scale =
      std::min(static_cast<double>(width) / picture.width, static_cast<double>(height) / picture.height);
  return {std::max(1, static_cast<int>(picture.width * scale)),
          std::max(1, static_cast<int>(picture.height * scale))};
}

// The height of each picture beside a list: pictures have 5/8 of their width, if some lines of text fit below
// them.
int compute_details_height(const Box& box, std::size_t pictures) {
  constexpr int kTextLines = 3;
  const int room = pictures == 1 ? box.height / 2 + kLine
                                 : (box.height - kTextLines * kLine) / static_cast<int>(pictures) - kGap;
  return std::clamp(room, 1, std::max(box.width * 5 / 8, 1));
}

// Centers the plaque and the rows of a large page together.
int compute_plaque_x(const Canvas& canvas) {
  return (canvas.width() - kPlaqueWidth - kCursor - kLargeWidth) / 2;
}

}  // namespace

// Records where rows were drawn; the pointer is compared with these places until the next frame.
void PageView::draw(const Canvas& canvas, double time_s) {
  spots_.clear();
  thumbnails_.clear();
  scroll_bar_ = {};
  int top = draw_title(canvas);
  if (is_text_only()) return draw_text(canvas, compute_layout(canvas, top));
  top = draw_question(canvas, draw_search(canvas, top));
  const Layout layout = compute_layout(canvas, top);
  if (find_nearest(0, 1) == std::nullopt && search_.empty()) draw_empty_text(canvas, layout.rows.y + kLine);
  draw_rows(canvas, layout, time_s);
  draw_details(canvas, layout);
  draw_picture_below(canvas, layout);
  draw_help(canvas, layout);
}

bool PageView::has_plaque(const Canvas& canvas) const {
  return page_.style == PageStyle::kLarge && canvas.height() >= kRoomForPicture &&
         canvas.width() >= kScreenWidth;
}

// A small canvas gets a small title, a tiny one none.
int PageView::draw_title(const Canvas& canvas) const {
  const bool has_room = canvas.height() >= kRoomForPicture;
  if (has_plaque(canvas)) canvas.draw_plaque("gfx/qplaque.lmp", compute_plaque_x(canvas), kGap);
  if (has_room)
    if (const int height = canvas.draw_title_picture(page_.title_picture, kGap); height > 0)
      return kGap + height + kGap;
  if (canvas.height() < kRoomForTitle) return 1;
  const int letters =
      canvas.height() >= kRoomForLargeTitle &&
              static_cast<int>(page_.title.size()) * 2 * kCharacterSide <= canvas.width() - 2 * kMargin
          ? 2
          : 1;
  canvas.draw_centered_text(
      to_second_color(truncate(page_.title, count_fitting_characters(canvas.width() / letters))), kGap + kGap,
      letters);
  return kGap + kGap + letters * kCharacterSide + kGap + kGap;
}

int PageView::draw_search(const Canvas& canvas, int top) const {
  if (!page_.has_search || page_.rows.empty()) return top;
  const Box line{kCursor, top, canvas.width() - kCursor - kMargin, kCharacterSide};
  const auto is_entry = [this](std::size_t row) {
    return row >= page_.first_entry && page_.rows[row]->can_be_selected();
  };
  const auto shown = std::ranges::count_if(shown_, is_entry);
  const auto all = std::ranges::count_if(std::views::iota(std::size_t{0}, page_.rows.size()), is_entry);
  if (search_.empty())
    draw_left_and_right(canvas, line, to_second_color("Type to filter"),
                        to_second_color(fmt::format("{}", shown)));
  else
    draw_left_and_right(canvas, line, to_second_color("Filter: ") + search_ + '_',
                        to_second_color(fmt::format("{} of {}", shown, all)));
  return top + kLine + kGap;
}

int PageView::draw_question(const Canvas& canvas, int top) const {
  // Long texts are cut so that they leave room for the rows.
  constexpr std::size_t kMinLines = 6;
  const int room = (canvas.height() - top) / kLine - static_cast<int>(page_.rows.size()) - 2;
  const std::size_t max_lines = std::max(kMinLines, static_cast<std::size_t>(std::max(room, 0)));
  int y = top;
  for (const std::string& line :
       wrap(page_.text, count_fitting_characters(canvas.width() - 2 * kCursor), max_lines)) {
    canvas.draw_text(line, kCursor, y);
    y += kLine;
  }
  return y > top ? y + kLine : top;
}

void PageView::draw_empty_text(const Canvas& canvas, int top) const {
  constexpr std::size_t kMaxLines = 4;
  int y = top;
  for (const std::string& line :
       wrap(page_.empty_text, count_fitting_characters(canvas.width() - 2 * kMargin), kMaxLines)) {
    canvas.draw_centered_text(line, y);
    y += kLine;
  }
}

Box PageView::compute_large_rows(const Canvas& canvas, int top) const {
  const int x = has_plaque(canvas) ? compute_plaque_x(canvas) + kPlaqueWidth + kCursor
                                   : (canvas.width() - kLargeWidth) / 2;
  return {x, top, kLargeWidth, canvas.height() - top};
}

// Large rows become small ones if they do not all fit. Details take the right 7/16 of the width.
PageView::Layout PageView::compute_layout(const Canvas& canvas, int top) const {
  Layout layout;
  const int width = canvas.width(), height = canvas.height();
  const bool is_large = page_.style == PageStyle::kLarge && width >= kLargeWidth + 2 * kCursor &&
                        height - top >= static_cast<int>(page_.rows.size()) * kLargeLine;
  layout.letters = is_large ? 2 : 1;
  layout.row_height = is_large ? kLargeLine : kLine;
  int bottom = height;
  if (has_help_ && height >= kRoomForHelp) {
    layout.help_y = height - kHelpLines * (kCharacterSide + 1) - kGap;
    bottom = layout.help_y - kGap;
  }
  const int left = kCursor + (has_plaque(canvas) ? compute_plaque_x(canvas) + kPlaqueWidth : 0);
  layout.rows = is_large ? compute_large_rows(canvas, top)
                         : Box{left, top, width - left - kScrollBar, std::max(bottom - top, kLine)};
  constexpr int kMinDetails = 200;
  if (page_.style == PageStyle::kDetails && width >= kMinDetails) {
    layout.rows.width = width * 9 / 16 - kCursor;  // a level's picture needs the rest
    const int x = layout.rows.right() + kScrollBar + kGap;
    layout.details = {x, top, width - kMargin - x, bottom - top};
  }
  // The label column takes 56 % of the row, at most 22 characters: 20 in a frame of 320 pixels.
  constexpr int kMaxLabel = 22, kLabelPercent = 56;
  const auto chars = static_cast<int>(count_fitting_characters(layout.rows.width));
  layout.value_x = layout.rows.x + std::min(kMaxLabel, chars * kLabelPercent / 100) * kCharacterSide;
  // In few columns there is no room for both, so the value goes below the label.
  constexpr int kMinSharedLine = 26;
  const auto has_value = [](const std::unique_ptr<Row>& row) { return row->has_value(); };
  if (chars < kMinSharedLine && layout.rows.height >= 2 * kLine &&
      std::any_of(page_.rows.begin(), page_.rows.end(), has_value)) {
    layout.row_height = 2 * kLine;
    layout.value_down = kLine;
    layout.value_x = layout.rows.x + kCharacterSide;
  }
  return layout;
}

// A page without rows scrolls its text.
void PageView::draw_text(const Canvas& canvas, const Layout& layout) {
  const std::vector<std::string> lines = wrap(page_.text, count_fitting_characters(layout.rows.width));
  set_lines(lines.size(), static_cast<std::size_t>(layout.rows.height / kLine));
  int y = layout.rows.y;
  for (std::size_t i = first_; i < std::min(lines.size(), first_ + room_); ++i, y += kLine) {
    const std::string_view line = lines[i];
    constexpr std::string_view kHeading = "# ";
    if (line.starts_with(kHeading))
      canvas.draw_text(to_second_color(line.substr(kHeading.size())), layout.rows.x, y);
    else
      canvas.draw_text(line, layout.rows.x, y);
  }
  draw_scroll_bar(canvas, layout.rows);
}

void PageView::draw_rows(const Canvas& canvas, const Layout& layout, double time_s) {
  set_lines(shown_.size(), static_cast<std::size_t>(layout.rows.height / layout.row_height));
  RowPlace place;
  place.value_x = layout.value_x;
  place.value_down = layout.value_down;
  place.letters = layout.letters;
  place.time_s = time_s;
  place.box = {layout.rows.x, layout.rows.y + 1, layout.rows.width, layout.row_height - 2};
  for (std::size_t i = first_; i < std::min(shown_.size(), first_ + room_); ++i) {
    place.selected = selected_ == i;
    draw_row(canvas, place, i);
    place.box.y += layout.row_height;
  }
  draw_scroll_bar(canvas, layout.rows);
}

void PageView::draw_row(const Canvas& canvas, const RowPlace& place, std::size_t position) {
  const Row& row = row_at(position);
  const Box& box = place.box;
  const Box whole{box.x - kCursor, box.y - 1, box.width + kCursor, box.height + 2};
  if (place.selected) {
    canvas.highlight(whole);
    canvas.draw_text(std::string_view(&glyph::kArrow, 1), box.x - (place.letters == 1 ? 10 : kCursor), box.y,
                     place.letters);
  }
  row.draw(canvas, place);
  Spot spot{position, canvas.to_frame(whole), {}, {}};
  if (const std::optional<Box> slide = row.slide_box(place)) {
    spot.slide = canvas.to_frame(*slide);
    spot.value = canvas.to_frame({place.value_x, whole.y, whole.right() - place.value_x, whole.height});
  }
  spots_.push_back(spot);
}

void PageView::draw_scroll_bar(const Canvas& canvas, const Box& beside) {
  if (lines_ <= room_) return;
  constexpr int kTrackWidth = 3, kMinThumb = 6;
  const Box track{beside.right() + kScrollBar - kTrackWidth - 1, beside.y, kTrackWidth, beside.height};
  Box thumb = track;
  thumb.height = std::clamp(static_cast<int>(static_cast<double>(track.height) * static_cast<double>(room_) /
                                             static_cast<double>(lines_)),
                            std::min(kMinThumb, track.height), track.height);
  thumb.y += static_cast<int>(static_cast<double>(track.height - thumb.height) * static_cast<double>(first_) /
                              static_cast<double>(max_first()));
  canvas.fill(track, kTrackGray, kFaintOpacity);
  canvas.fill(thumb, kTrackGray, kStrongOpacity);
  scroll_bar_ = canvas.to_frame({beside.right(), track.y, kScrollBar, track.height});
}

void PageView::draw_details(const Canvas& canvas, const Layout& layout) {
  const Row* const row = selected_row();
  if (row == nullptr || layout.details.width <= 0) return;
  RowDetails details = row->details();
  std::erase_if(details.pictures, [](const formats::Picture* picture) {
    return picture == nullptr || picture->width == 0 || picture->height == 0;
  });
  const Box& box = layout.details;
  int y = box.y;
  for (const formats::Picture* const picture : details.pictures) {
    const int height = compute_details_height(box, details.pictures.size());
    const Box picture_box{box.x, y, std::min(box.width, height * 8 / 5), height};
    canvas.fill(picture_box, kPictureBackground);
    draw_picture(canvas, *picture, picture_box);
    y = picture_box.bottom() + kGap;
  }
  for (const std::string& paragraph : details.paragraphs)
    for (const std::string& line :
         wrap(paragraph, std::max<std::size_t>(count_fitting_characters(box.width), 1))) {
      if (y + kCharacterSide > box.bottom()) return;
      canvas.draw_text(line, box.x, y);
      y += kLine;
    }
}

// Scales the picture to frame pixels by taking the nearest pixel, so that it is as sharp as the frame allows.
// The canvas would only scale it by whole numbers.
void PageView::draw_picture(const Canvas& canvas, const formats::Picture& picture, const Box& box) {
  const Box frame_box = canvas.to_frame(box);
  const auto [width, height] = fit_picture(picture, frame_box.width, frame_box.height);
  const auto to_u32 = [](int side) { return static_cast<std::uint32_t>(side); };
  formats::Picture& scaled = thumbnails_.emplace_back(formats::Picture{to_u32(width), to_u32(height), {}});
  for (std::uint64_t y = 0; y < scaled.height; ++y) {
    const std::uint64_t row = (2 * y + 1) * picture.height / (2 * scaled.height) * picture.width;
    for (std::uint64_t x = 0; x < scaled.width; ++x)
      scaled.pixels.push_back(picture.pixels[row + (2 * x + 1) * picture.width / (2 * scaled.width)]);
  }
  canvas.draw_unscaled(scaled, box);
}

// Draws nothing if there is no room for the whole picture.
void PageView::draw_picture_below(const Canvas& canvas, const Layout& layout) {
  const formats::Picture* const picture = page_.picture ? page_.picture() : nullptr;
  const Box& rows = layout.rows;
  const int used = static_cast<int>(std::min(lines_, room_)) * layout.row_height + kLine;
  if (picture == nullptr || rows.height - used < static_cast<int>(picture->height)) return;
  draw_picture(canvas, *picture, {rows.x, rows.y + used, rows.width, static_cast<int>(picture->height)});
}

void PageView::draw_help(const Canvas& canvas, const Layout& layout) const {
  if (layout.help_y == 0 || !selected_) return;
  int y = layout.help_y;
  const std::size_t chars = count_fitting_characters(canvas.width() - 2 * kMargin);
  for (const std::string& line : wrap(row_at(*selected_).help(), chars, kHelpLines)) {
    canvas.draw_text(to_second_color(line), kMargin, y);
    y += kCharacterSide + 1;
  }
}

}  // namespace temblor::client
