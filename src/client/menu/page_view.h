// An open page: which of its rows are shown and which is selected, where they stand on the frame, and what
// a pointer finds there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "client/menu/canvas.h"
#include "client/menu/page.h"

namespace temblor::client {

class PageView {
 public:
  explicit PageView(Page page);

  // The same page made anew: what is selected stays so, as far as it is still there.
  void replace(Page page);

  const Page& page() const { return page_; }
  Row* selected_row();  // null where none can be selected

  // Each returns whether something has changed.
  bool move(int steps);  // to the next row that can be selected, round the ends; text scrolls
  bool move_pages(int pages);
  bool go_to_begin();
  bool go_to_end();
  // What is selected stays in sight.
  void scroll(int lines);

  // Rows that hold this are shown; empty: all.
  const std::string& search() const { return search_; }
  void set_search(std::string search);

  // On the menu's whole place. A picture that it draws is kept here until the next call.
  void draw(const Canvas& canvas, double time_s);

  // Where things were last drawn, in pixels of the frame.
  bool point_at(int x, int y);  // selects the row that is there
  enum class Pressed { kNothing, kRow, kSlider };
  Pressed press(int x, int y);  // kSlider: follows slide_to() until let_go()
  void slide_to(int x, int y);
  bool is_sliding() const { return sliding_ != nullptr || bar_slides_; }
  void let_go();

 private:
  static constexpr std::size_t kUnknownRoom = std::size_t{1} << 30;  // before it is drawn: for all
  struct Spot {                                                      // where a row was drawn
    std::size_t position = 0;
    Box row, value, slide;  // of the frame; slide: empty where nothing slides
  };
  struct Layout {
    Box rows, details;  // details: empty for none
    int row_height = 0, letters = 1, value_x = 0;
    int help_y = 0;  // 0: no help
  };

  Layout lay_out(const Canvas& canvas, int top) const;
  Box large_rows(const Canvas& canvas, int top) const;
  bool has_plaque(const Canvas& canvas) const;
  int draw_title(const Canvas& canvas) const;  // returns where it ends
  int draw_search(const Canvas& canvas, int top) const;
  int draw_question(const Canvas& canvas, int top) const;
  void draw_text(const Canvas& canvas, const Layout& layout);
  void draw_rows(const Canvas& canvas, const Layout& layout, double time_s);
  void draw_row(const Canvas& canvas, const RowPlace& place, std::size_t position);
  void draw_scroll_bar(const Canvas& canvas, const Box& beside);
  void draw_details(const Canvas& canvas, const Layout& layout);
  void draw_picture_below(const Canvas& canvas, const Layout& layout);
  void draw_help(const Canvas& canvas, const Layout& layout) const;
  void draw_picture(const Canvas& canvas, const formats::Picture& picture, const Box& box);

  bool is_text_alone() const { return page_.rows.empty() && !page_.text.empty(); }
  const Row& row_at(std::size_t position) const { return *page_.rows[shown_[position]]; }
  void list_rows();
  void select_first_choice();
  bool select(std::size_t position);
  // The first that can be selected from `position` on in that direction, or else in the other.
  std::optional<std::size_t> nearest(std::size_t position, int direction) const;
  void set_lines(std::size_t lines, std::size_t room);
  void keep_selected_visible();
  std::size_t last_first() const { return lines_ > room_ ? lines_ - room_ : 0; }
  const Spot* spot_at(int x, int y) const;

  Page page_;
  bool has_help_ = false;
  std::string search_;
  std::vector<std::size_t> shown_;       // rows that fit the search
  std::optional<std::size_t> selected_;  // position in shown_
  std::size_t first_ = 0;                // the position, or line of text, at the top
  std::size_t lines_ = 0;                // how many there are
  std::size_t room_ = kUnknownRoom;      // how many are visible
  std::vector<Spot> spots_;
  Box scroll_bar_;  // of the frame
  Row* sliding_ = nullptr;
  Box sliding_box_;
  bool bar_slides_ = false;
  formats::Picture thumbnail_;
};

}  // namespace temblor::client
