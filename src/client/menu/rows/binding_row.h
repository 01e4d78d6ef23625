// An action and the keys that do it: a row that waits for a key and binds it.
#pragma once

#include <string>
#include <string_view>

#include "client/menu/menu_content.h"
#include "client/menu/rows/row.h"

namespace temblor::client {

class BindingRow : public Row {
 public:
  // `commands`: what the keys run.
  BindingRow(const MenuContent& content, std::string_view label, std::string_view commands)
      : content_(&content), label_(label), commands_(commands) {}

  std::string_view label() const override { return label_; }
  std::string_view search_text() const override { return label_; }
  std::string help() const override;
  void draw(const Canvas& canvas, const RowPlace& place) const override;

  Outcome activate() override;
  std::optional<Outcome> clear() override;  // takes all keys off it

  bool is_waiting() const override { return waiting_; }
  bool wants_text() const override { return false; }
  bool take(const platform::InputEvent& event, Outcome& out_outcome) override;
  void stop_waiting() override { waiting_ = false; }

 private:
  std::vector<platform::Key> keys() const;
  std::string keys_in_words(std::string_view between) const;

  const MenuContent* content_;
  std::string label_, commands_;
  bool waiting_ = false;
};

}  // namespace temblor::client
