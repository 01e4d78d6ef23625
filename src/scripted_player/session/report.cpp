#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scripted_player/session/run.h"

namespace temblor::player {

std::string as_json(const RunReport& report) {
  const nlohmann::json json = {{"reached_exit", report.reached_exit},
                               {"exit", report.exit},
                               {"frags", report.frags},
                               {"time_s", report.time_s},
                               {"kills", report.kills},
                               {"monsters", report.monsters},
                               {"found_secrets", report.found_secrets},
                               {"secrets", report.secrets},
                               {"deaths", report.deaths},
                               {"problems", report.problems},
                               {"stuck_monsters", report.stuck_monsters},
                               {"idle_monsters", report.idle_monsters},
                               {"closed_doors", report.closed_doors},
                               {"unreached_items", report.unreached_items},
                               {"errors", report.errors},
                               {"places", report.places},
                               {"links", report.links}};
  return json.dump(2) + "\n";
}

namespace {

std::string outcome(const RunReport& report) {
  if (report.is_deathmatch) return "ended";
  return report.reached_exit ? fmt::format("exit to {} reached", report.exit) : "NO EXIT";
}

}  // namespace

std::string as_text(const RunReport& report) {
  std::string text = fmt::format(
      "{} after {:.1f} s, {} of {} monsters, {} of {} secrets, {} frags, {} deaths; {} places, {} links\n",
      outcome(report), report.time_s, report.kills, report.monsters, report.found_secrets, report.secrets,
      report.frags, report.deaths.size(), report.places, report.links);
  const auto add = [&](const char* what, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) text += fmt::format("  {}: {}\n", what, line);
  };
  add("problem", report.problems);
  add("died", report.deaths);
  add("in a wall", report.stuck_monsters);
  add("idle", report.idle_monsters);
  add("never opened", report.closed_doors);
  add("out of reach", report.unreached_items);
  add("error", report.errors);
  return text;
}

}  // namespace temblor::player
