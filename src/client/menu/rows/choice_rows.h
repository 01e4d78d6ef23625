// Rows with one of several values at their right, which left and right change.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "client/menu/rows/row.h"

namespace temblor::client {

// "< value >", the arrows only where it is selected.
class ChoiceRow : public Row {
 public:
  std::string_view label() const override { return label_; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome activate() override { return adjust(1); }
  Outcome adjust(int steps) override;

 protected:
  explicit ChoiceRow(std::string label) : label_(std::move(label)) {}
  virtual std::string value() const = 0;
  virtual int count() const = 0;
  virtual int chosen() const = 0;  // below 0: none of them
  virtual void choose(int number) = 0;

 private:
  std::string label_;
};

// What is chosen is kept by who makes the row.
class LocalChoiceRow : public ChoiceRow {
 public:
  struct Parts {
    std::vector<std::string> names;
    std::function<int()> chosen;
    std::function<void(int)> choose;
    std::string help;
    bool refresh = false;  // other rows depend on it
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

// The label in the left column, `value` in the right one; `marked`: between arrows.
void draw_label_and_value(const Canvas& canvas, const RowPlace& place, std::string_view label,
                          std::string_view value, bool marked);
// The right column of a row.
Box value_box(const RowPlace& place);

}  // namespace temblor::client
