// A row for an action and the keys bound to it. Enter makes it wait for a key, which it then binds to the
// action in addition to the others.
#pragma once

#include <string>
#include <string_view>

#include "client/menu/menu_content.h"
#include "client/menu/rows/row.h"

namespace temblor::client {

class BindingRow : public Row {
 public:
  // `commands`: the console commands that the keys run.
  BindingRow(const MenuContent& content, std::string_view label, std::string_view commands)
      : content_(&content), label_(label), commands_(commands) {}
  bool has_value() const override { return true; }

  std::string_view label() const override { return label_; }
  std::string_view search_text() const override { return label_; }
  std::string help() const override;
  void draw(const Canvas& canvas, const RowPlace& place) const override;

  Outcome activate() override;              // waits for a key
  std::optional<Outcome> clear() override;  // unbinds all keys of the action

  bool is_waiting() const override { return waiting_; }
  bool wants_text() const override { return false; }
  bool handle(const platform::InputEvent& event, Outcome& out_outcome) override;
  void stop_waiting() override { waiting_ = false; }

 private:
  std::vector<platform::Key> keys() const;
  std::string join_key_names(std::string_view between) const;

  const MenuContent* content_;
  std::string label_, commands_;
  bool waiting_ = false;
};

}  // namespace temblor::client
