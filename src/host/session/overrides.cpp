#include "host/session/overrides.h"

namespace temblor::host {

base::Status Overrides::apply(const std::function<base::Status()>& set, command::Variables& io_variables) {
  // `set` may touch any variable, so compare all of them before and after.
  std::map<std::string, std::string> own;
  for (const command::Variable* variable : io_variables.all()) own.emplace(variable->name, variable->text);
  TRY_STATUS(set());
  entries_.clear();
  for (const auto& [name, text] : own) {
    if (io_variables.find(name)->text == text) continue;
    if (released_.contains(name))
      TRY_STATUS(io_variables.set(name, text));
    else
      entries_.emplace(name, Entry{text, io_variables.find(name)->version});
  }
  return base::Ok{};
}

void Overrides::release_changed(const command::Variables& variables) {
  for (const auto& [name, entry] : entries_)
    if (variables.find(name)->version != entry.version) released_.insert(name);
}

const std::string& Overrides::own_text(const command::Variable& variable) const {
  const auto found = entries_.find(variable.name);
  return found != entries_.end() && found->second.version == variable.version ? found->second.own_text
                                                                              : variable.text;
}

}  // namespace temblor::host
