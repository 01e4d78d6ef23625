// Rows without a value: what can be chosen, entries of lists, headings.
#pragma once

#include <functional>
#include <string>

#include "client/menu/rows/row.h"

namespace temblor::client {

class ActionRow : public Row {
 public:
  using Action = std::function<Outcome()>;
  // `letter`: in lower case.
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

struct ListEntry {
  std::string left;
  std::string middle = {};  // left out where there is no room for it
  std::string right = {};   // right-aligned
  std::function<RowDetails()> details = {};
  std::function<Outcome()> choose = {};
  std::string help = {};
};

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

// Cannot be selected.
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

// `right` at the right of the box, `left` in what that leaves.
void draw_left_and_right(const Canvas& canvas, const Box& box, std::string_view left, std::string_view right);
// How many characters stand in so many pixels.
std::size_t characters_in(int width);

}  // namespace temblor::client
