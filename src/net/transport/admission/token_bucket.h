// How often something may happen: a number of times at once, and so many a second in the long run.
#pragma once

#include <algorithm>

namespace temblor::net {

struct Rate {
  double burst = 0, per_second = 0;
};

class TokenBucket {
 public:
  // Whether `cost` could be taken; it was, then. Full at the first call.
  bool take(double cost, const Rate& rate, double now_s) {
    fill(rate, now_s);
    if (cost > tokens_) return false;
    tokens_ -= cost;
    return true;
  }
  bool has(double cost, const Rate& rate, double now_s) {
    fill(rate, now_s);
    return cost <= tokens_;
  }

 private:
  void fill(const Rate& rate, double now_s) {
    tokens_ = started_ ? std::min(rate.burst, tokens_ + (now_s - filled_s_) * rate.per_second) : rate.burst;
    started_ = true;
    filled_s_ = now_s;
  }

  double tokens_ = 0, filled_s_ = 0;
  bool started_ = false;
};

}  // namespace temblor::net
