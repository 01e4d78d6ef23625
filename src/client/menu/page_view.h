// An open page: which rows are shown and selected, where they are on the frame, and what the pointer hits
// there.
//
// Layout (page_drawing.cpp), from top to bottom: title, search line or question text, rows with an optional
// scroll bar and details, a picture below the rows, help for the selected row. Small canvases drop help,
// picture and title, in that order.
//
//   positions: 0 .. shown_.size()-1, indices into shown_, which lists the rows that match the search
//   first_:    the position at the top; room_ positions are visible
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "client/menu/canvas.h"
#include "client/menu/page.h"

namespace temblor::client {

// Owns its page. Positions and scrolling are in rows, or in lines of text on a page without rows.
class PageView {
 public:
  explicit PageView(Page page);

  // Replaces the page with a newer version of itself. The selection stays on the row with the same label, or
  // else at the same place.
  void replace(Page page);

  const Page& page() const { return page_; }
  Row* selected_row();  // null if no row can be selected

  // Move the selection, or scroll a page without rows; they return whether anything has moved. move() goes to
  // the next selectable row and wraps around at the ends.
  bool move(int steps);
  bool move_pages(int pages);
  bool go_to_start();
  bool go_to_end();
  // Scrolls rows or text. The selection moves so that it stays visible.
  void scroll(int lines);

  // Shows only rows that contain this text; empty shows all.
  const std::string& search() const { return search_; }
  void set_search(std::string search);

  // Draws on the whole canvas. The draw list may refer to pictures in this object until the next call.
  void draw(const Canvas& canvas, double time_s);

  // Pointer input, in frame pixels, compared with the page as it was last drawn. point_at() selects the row
  // under the pointer.
  bool point_at(int x, int y);
  // The part of the page that a press has hit.
  enum class Pressed { kNothing, kRow, kSlider };
  // Presses the pointer's button. After kSlider, slide_to() moves the slider until release().
  Pressed press(int x, int y);
  void slide_to(int x, int y);
  bool is_sliding() const { return sliding_ != nullptr || bar_slides_; }
  void release();

 private:
  static constexpr std::size_t kUnknownRoom = std::size_t{1} << 30;  // until first drawn: room for all rows
  // Where a row was drawn, in frame pixels.
  struct Spot {
    std::size_t position = 0;
    // `slide` is empty if the row has no slider.
    Box row, value, slide;
  };
  struct Layout {
    // `details` is empty if the page has none.
    Box rows, details;
    int row_height = 0, letters = 1, value_x = 0, value_down = 0;
    int help_y = 0;  // 0: no help
  };

  Layout compute_layout(const Canvas& canvas, int top) const;
  Box compute_large_rows(const Canvas& canvas, int top) const;
  bool has_plaque(const Canvas& canvas) const;
  // Draw at `top` and return the y below what they have drawn.
  int draw_title(const Canvas& canvas) const;
  int draw_search(const Canvas& canvas, int top) const;
  int draw_question(const Canvas& canvas, int top) const;
  void draw_text(const Canvas& canvas, const Layout& layout);
  void draw_empty_text(const Canvas& canvas, int top) const;
  void draw_rows(const Canvas& canvas, const Layout& layout, double time_s);
  void draw_row(const Canvas& canvas, const RowPlace& place, std::size_t position);
  void draw_scroll_bar(const Canvas& canvas, const Box& beside);
  void draw_details(const Canvas& canvas, const Layout& layout);
  void draw_picture_below(const Canvas& canvas, const Layout& layout);
  void draw_help(const Canvas& canvas, const Layout& layout) const;
  void draw_picture(const Canvas& canvas, const formats::Picture& picture, const Box& box);

  bool is_text_only() const { return page_.rows.empty() && !page_.text.empty(); }
  const Row& row_at(std::size_t position) const { return *page_.rows[shown_[position]]; }
  void update_shown_rows();
  void select_first_choice();
  bool select(std::size_t position);
  // The first selectable position from `position` on in that direction, or else in the other one.
  std::optional<std::size_t> find_nearest(std::size_t position, int direction) const;
  void set_lines(std::size_t lines, std::size_t room);
  void keep_selected_visible();
  std::size_t max_first() const { return lines_ > room_ ? lines_ - room_ : 0; }
  const Spot* find_spot(int x, int y) const;

  Page page_;
  bool has_help_ = false;
  std::string search_;
  // Indices of the rows that match the search.
  std::vector<std::size_t> shown_;
  std::optional<std::size_t> selected_;  // a position
  // The position, or line of text, at the top; how many there are; and how many are visible.
  std::size_t first_ = 0;
  std::size_t lines_ = 0;
  std::size_t room_ = kUnknownRoom;
  std::vector<Spot> spots_;
  Box scroll_bar_;  // frame pixels
  // The row whose slider the pointer holds, and the slider's box in frame pixels.
  Row* sliding_ = nullptr;
  Box sliding_box_;
  bool bar_slides_ = false;  // the pointer holds the scroll bar
  // The pictures of the last draw(), scaled to frame pixels; the draw list refers to them.
  std::deque<formats::Picture> thumbnails_;
};

}  // namespace temblor::client
