#include "command/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "command/text.h"

namespace temblor::command {

Console::Console(Variables& io_variables, Output output)
    : variables_(io_variables), output_(std::move(output)) {
  CHECK(output_ != nullptr);
  add_built_in_commands();
  add_variable_commands();
  add_list_commands();
}

void Console::add_command(std::string_view name, std::string_view help, Command command) {
  CHECK(command != nullptr, "{}", name);
  const bool is_new =
      commands_
          .emplace(base::to_lower(name), RegisteredCommand{std::string(help), std::move(command), nullptr})
          .second;
  CHECK(is_new, "{}", name);
}

void Console::set_argument_list(std::string_view command, ArgumentList list) {
  const auto found = commands_.find(base::to_lower(command));
  CHECK(found != commands_.end(), "{}", command);
  found->second.arguments = std::move(list);
}

void Console::add_member(std::string_view name, std::string_view help, Member member, Kinds arguments) {
  add_command(name, help, [this, member](Arguments words) { (this->*member)(words); });
  if (arguments.commands || arguments.aliases || arguments.variables)
    set_argument_list(name, [this, arguments] { return candidates_of(arguments, ""); });
}

bool Console::has_room_for(std::string_view text) const {
  if (text_.size() - done_ + text.size() + 1 <= kMaxPendingChars) return true;
  print(fmt::format("too many commands are waiting: {} characters refused", text.size()));
  return false;
}

void Console::append(std::string_view text) {
  if (has_room_for(text)) text_ += fmt::format("{}\n", text);
}

void Console::insert(std::string_view text) {
  if (!has_room_for(text)) return;
  text_.replace(0, done_, fmt::format("{}\n", text));
  done_ = 0;
}

void Console::run() {
  waiting_ = false;
  expansions_ = 0;
  expanded_chars_ = 0;
  while (has_pending() && !waiting_) {
    const std::string_view pending = std::string_view(text_).substr(done_);
    const std::string command(pending.substr(0, command_length(pending)));
    done_ = std::min(done_ + command.size() + 1, text_.size());
    execute(command);
  }
  // Only now and then, so that a text of many waits is not moved for each of them.
  if (done_ * 2 < text_.size()) return;
  text_.erase(0, done_);
  done_ = 0;
}

void Console::execute(std::string_view command) {
  const std::vector<std::string> words = split_words(command);
  if (words.empty()) return;
  const std::string name = base::to_lower(words[0]);
  if (const auto found = commands_.find(name); found != commands_.end()) {
    found->second.run(words);
  } else if (const auto alias = aliases_.find(name); alias != aliases_.end()) {
    if (may_expand(words[0], alias->second)) insert(alias->second);
  } else if (const Variable* variable = variables_.find(name); variable != nullptr) {
    variable_command(*variable, words);
  } else {
    print(fmt::format("unknown command \"{}\"", base::quotable(words[0])));
  }
}

bool Console::may_expand(std::string_view name, std::string_view text) {
  expanded_chars_ += text.size();
  if (++expansions_ <= kMaxExpansions && expanded_chars_ <= kMaxExpandedChars) return true;
  const std::string what = expansions_ > kMaxExpansions ? fmt::format("{} aliases and files", kMaxExpansions)
                                                        : fmt::format("{} characters", kMaxExpandedChars);
  print(fmt::format("\"{}\": more than {} in a row, one must call itself; the rest is dropped",
                    base::quotable(name), what));
  text_.clear();
  done_ = 0;
  return false;
}

void Console::print_if_error(const base::Status& status) const {
  if (!status.ok()) print(status.error().message());
}

}  // namespace temblor::command
