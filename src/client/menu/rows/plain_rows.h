// Rows without a value: actions, entries of lists, headings.
#pragma once

#include <functional>
#include <string>

#include "client/menu/rows/row.h"

namespace temblor::client {

// A button.
class ActionRow : public Row {
 public:
  using Action = std::function<Outcome()>;
  // `letter`: the key that activates the row, lower case; 0 for none.
  ActionRow(std::string label, Action action, std::string help = {}, char letter = 0)
      : label_(std::move(label)), action_(std::move(action)), help_(std::move(help)), letter_(letter) {}

  std::string_view label() const override { return label_; }
  std::string help() const override { return help_; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome activate() override;
  char letter() const override { return letter_; }

 private:
  std::string label_;
  Action action_;
  std::string help_;
  char letter_;
};

// The text and the action of a ListRow.
struct ListEntry {
  std::string left;
  // Left out if the row has no room for it.
  std::string middle = {};
  // Right-aligned.
  std::string right = {};
  std::function<RowDetails()> details = {};
  std::function<Outcome()> choose = {};
  std::string help = {};
};

// An entry of a list, in up to three columns.
class ListRow : public Row {
 public:
  explicit ListRow(ListEntry entry);

  std::string_view label() const override { return entry_.left; }
  std::string_view search_text() const override { return search_text_; }
  std::string help() const override { return entry_.help; }
  RowDetails details() const override { return entry_.details ? entry_.details() : RowDetails{}; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome activate() override;

 private:
  ListEntry entry_;
  std::string search_text_;
};

// A heading; it cannot be selected.
class HeadingRow : public Row {
 public:
  explicit HeadingRow(std::string left, std::string right = {})
      : left_(std::move(left)), right_(std::move(right)) {}

  bool can_be_selected() const override { return false; }
  std::string_view label() const override { return left_; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;

 private:
  std::string left_, right_;
};

// Draws `right` right-aligned in the box and `left` in the room that remains.
void draw_left_and_right(const Canvas& canvas, const Box& box, std::string_view left, std::string_view right);
// How many characters fit in a width, in canvas pixels.
std::size_t count_fitting_characters(int width);

}  // namespace temblor::client
