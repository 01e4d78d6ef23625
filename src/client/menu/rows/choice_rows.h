// Rows that show one of several values on the right. Left and right change it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "client/menu/rows/row.h"

namespace temblor::client {

// Shows "< value >", with the arrows only while the row is selected. Values are numbered 0 to count() - 1;
// changing them wraps around.
class ChoiceRow : public Row {
 public:
  std::string_view label() const override { return label_; }
  bool has_value() const override { return true; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome activate() override { return adjust(1); }
  Outcome adjust(int steps) override;

 protected:
  explicit ChoiceRow(std::string label) : label_(std::move(label)) {}
  virtual std::string value() const = 0;
  virtual int count() const = 0;
  // The number of the current value; negative if the value is not among the choices.
  virtual int chosen() const = 0;
  virtual void choose(int number) = 0;

 private:
  std::string label_;
};

// A choice whose value the page stores; the row reads and sets it through functions.
class LocalChoiceRow : public ChoiceRow {
 public:
  struct Parts {
    std::vector<std::string> names;
    std::function<int()> chosen;
    std::function<void(int)> choose;
    std::string help;
    // Rebuild the page after a change, as other rows depend on the choice.
    bool refresh = false;
  };
  LocalChoiceRow(std::string label, Parts parts) : ChoiceRow(std::move(label)), parts_(std::move(parts)) {}
  std::string help() const override { return parts_.help; }
  Outcome adjust(int steps) override;

 protected:
  std::string value() const override;
  int count() const override { return static_cast<int>(parts_.names.size()); }
  int chosen() const override { return parts_.chosen(); }
  void choose(int number) override { parts_.choose(number); }

 private:
  Parts parts_;
};

// Draws the label in the left column and `value` in the right one, between arrows if `marked`.
void draw_label_and_value(const Canvas& canvas, const RowPlace& place, std::string_view label,
                          std::string_view value, bool marked);
// The right column of a row.
Box value_box(const RowPlace& place);

}  // namespace temblor::client
