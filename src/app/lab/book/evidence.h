// The results of the measurements for one technique, for the verdicts of the laboratory's book.
#pragma once

#include <string>

#include "app/lab/book/book_figures.h"
#include "base/function_ref.h"

namespace temblor::app {

// The smallest and largest value over the levels.
struct Range {
  double low = 0, high = 0;
  // "1.2 to 1.5", or "1.2" if both look the same.
  std::string text(int decimals) const;
};

class Evidence {
 public:
  // `figures` must outlive the evidence.
  Evidence(const BookFigures& figures, std::size_t technique) : figures_(figures), technique_(technique) {}

  const BookFigures& figures() const { return figures_; }
  // Frame time, divided by that of another technique; the first is the engine.
  Range time_ratios(std::size_t other = 0) const;
  // The 99th percentile of frame times, divided by the median.
  Range levelness() const;
  // Shares of the pixels that were compared with the oracle.
  Range wrong_shares() const;
  // Shares of pixels, in the view of each level that differs most from the engine's.
  Range different_shares() const;
  // Any figure of a level's views.
  Range over_levels(base::FunctionRef<double(const TechniqueFigures&)> value) const;
  // The evidence for the first other technique with that name and parameters. There must be one.
  Evidence of(std::string_view label) const;
  std::size_t number() const { return technique_; }

 private:
  const BookFigures& figures_;
  std::size_t technique_;
};

}  // namespace temblor::app
