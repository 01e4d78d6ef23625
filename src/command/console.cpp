#include "command/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
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
    set_argument_list(name, [this, arguments] { return find_candidates(arguments, ""); });
}

bool Console::check_room_for(std::string_view text) {
  if (text_.size() - done_ + text.size() + 1 <= kMaxPendingChars) return true;
  print_error(fmt::format("too many pending commands: {} dropped", base::counted(text.size(), "character")));
  return false;
}

void Console::append(std::string_view text, Source source) {
  if (!check_room_for(text)) return;
  text_ += fmt::format("{}\n", text);
  // Many lines in a row make one part.
  if (parts_.empty() || parts_.front().place.source != source || !parts_.front().place.file.empty())
    parts_.insert(parts_.begin(), Part{.place = {.source = source}});
  parts_.front().left_chars += text.size() + 1;
}

void Console::insert(std::string_view text, Part part) {
  if (!check_room_for(text)) return;
  // Replace the text that was run already, so that the buffer does not grow with each expansion.
  text_.replace(0, done_, fmt::format("{}\n", text));
  done_ = 0;
  // Drop parts that are complete. So an alias that calls itself in its last command does not accumulate
  // parts.
  while (!parts_.empty() && parts_.back().left_chars == 0) parts_.pop_back();
  part.left_chars = text.size() + 1;
  parts_.push_back(std::move(part));
}

// Consumes a command and the newline or ';' after it. The place of the command is that of the first part with
// text left.
std::string Console::take_command() {
  const std::string_view pending = std::string_view(text_).substr(done_);
  const std::size_t length = command_length(pending);
  std::string command(pending.substr(0, length));
  const bool ends_line = length < pending.size() && pending[length] == '\n';
  const std::size_t taken = std::min(length + 1, pending.size());
  done_ += taken;
  while (!parts_.empty() && parts_.back().left_chars == 0) parts_.pop_back();
  Part& part = parts_.back();
  place_ = part.place;
  part.left_chars -= taken;
  if (part.has_lines && ends_line) ++part.place.line;
  return command;
}

void Console::run() {
  waiting_ = false;
  expansions_ = 0;
  expanded_chars_ = 0;
  while (has_pending() && !waiting_) {
    const std::string command = take_command();
    if (place_.source == Source::kPlayer) finish_server_commands();
    execute(command);
  }
  finish_server_commands();
  place_ = {};
  // Erase only when at least half is done, so that a text with many waits is not moved for each of them.
  if (done_ * 2 < text_.size()) return;
  text_.erase(0, done_);
  done_ = 0;
}

void Console::drop_server_text() {
  std::string kept_text;
  std::vector<Part> kept_parts;  // the next one first
  std::size_t begin = done_;
  for (auto part = parts_.rbegin(); part != parts_.rend(); begin += (part++)->left_chars) {
    if (part->place.source == Source::kServer) continue;
    kept_text.append(text_, begin, part->left_chars);
    kept_parts.push_back(*part);
  }
  text_ = std::move(kept_text);
  done_ = 0;
  parts_.assign(kept_parts.rbegin(), kept_parts.rend());
}

void Console::finish_server_commands() {
  if (std::exchange(runs_server_commands_, false) && server_rules_.finish) server_rules_.finish();
}

// Commands take precedence over aliases, and aliases over variables; alias_command() refuses names that are
// taken, but a command or variable may be registered later.
void Console::execute(std::string_view command) {
  const std::vector<std::string> words = split_words(command);
  if (words.empty()) return;
  if (place_.source == Source::kServer) {
    runs_server_commands_ = true;
    if (server_rules_.may_run && !server_rules_.may_run(words)) return;
  }
  const std::string name = base::to_lower(words[0]);
  if (const auto found = commands_.find(name); found != commands_.end()) {
    found->second.run(words);
  } else if (const auto alias = aliases_.find(name); alias != aliases_.end()) {
    const auto& [text, source] = alias->second;
    Place place = place_;
    place.source = std::max(place.source, source);
    if (count_expansion(words[0], text)) insert(text, {.place = std::move(place)});
  } else if (const Variable* variable = variables_.find(name); variable != nullptr) {
    variable_command(*variable, words);
  } else if (!unknown_handler_ || !unknown_handler_(words)) {
    print_error(fmt::format("unknown command or variable \"{}\"", base::quotable(words[0])));
  }
}

// An alias or file that calls itself would never end. The stack cannot overflow, because expansions are
// inserted instead of executed; counting them ends the loop.
bool Console::count_expansion(std::string_view name, std::string_view text) {
  expanded_chars_ += text.size();
  if (++expansions_ <= kMaxExpansions && expanded_chars_ <= kMaxExpandedChars) return true;
  const std::string limit = expansions_ > kMaxExpansions ? fmt::format("{} aliases and files", kMaxExpansions)
                                                         : fmt::format("{} characters", kMaxExpandedChars);
  print_error(fmt::format(
      "\"{}\": more than {} expanded at once; does one call itself? Dropped the remaining commands",
      base::quotable(name), limit));
  text_.clear();
  done_ = 0;
  parts_.clear();
  return false;
}

void Console::print_error(std::string_view line) {
  if (!is_in_file()) return print(line);
  ++errors_in_files_[place_.file];
  print(fmt::format("{}:{}: {}", base::quotable(place_.file), place_.line, line));
}

std::size_t Console::errors_in_file(std::string_view file) const {
  const auto found = errors_in_files_.find(file);
  return found == errors_in_files_.end() ? 0 : found->second;
}

void Console::print_if_error(const base::Status& status) {
  if (!status.ok()) print_error(status.error().message());
}

}  // namespace temblor::command
