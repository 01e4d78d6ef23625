#include "app/lab/book/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/check.h"

namespace temblor::app {
namespace {

Range find_range(const BookFigures& figures, base::FunctionRef<double(const LevelFigures&)> value) {
  Range range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (const LevelFigures& level : figures.levels) {
    const double found = value(level);
    range.low = std::min(range.low, found);
    range.high = std::max(range.high, found);
  }
  return range;
}

double median_ms(const LevelFigures& level, std::size_t technique) {
  return level.techniques[technique].measurement.frame_ms.p50;
}

}  // namespace

std::string Range::text(int decimals) const {
  const std::string from = fmt::format("{:.{}f}", low, decimals), to = fmt::format("{:.{}f}", high, decimals);
  return from == to ? from : from + " to " + to;
}

Range Evidence::time_ratios(std::size_t other) const {
  return find_range(figures_, [&](const LevelFigures& level) {
    return median_ms(level, technique_) / median_ms(level, other);
  });
}

Range Evidence::levelness() const {
  return over_levels([](const TechniqueFigures& figures) {
    return figures.measurement.frame_ms.p99 / figures.measurement.frame_ms.p50;
  });
}

Range Evidence::wrong_shares() const {
  return over_levels([](const TechniqueFigures& figures) {
    const oracle::Tally& tally = figures.views.tally;
    return tally.pixels == 0 ? 0 : static_cast<double>(tally.wrong_face) / static_cast<double>(tally.pixels);
  });
}

Range Evidence::different_shares() const {
  return find_range(figures_, [&](const LevelFigures& level) { return level.different_shares[technique_]; });
}

Range Evidence::over_levels(base::FunctionRef<double(const TechniqueFigures&)> value) const {
  return find_range(figures_, [&](const LevelFigures& level) { return value(level.techniques[technique_]); });
}

Evidence Evidence::of(std::string_view label) const {
  const auto found = std::ranges::find(figures_.choices, label, &lab::Choice::label);
  CHECK(found != figures_.choices.end(), "the book has no technique {}", label);
  return {figures_, static_cast<std::size_t>(found - figures_.choices.begin())};
}

}  // namespace temblor::app
