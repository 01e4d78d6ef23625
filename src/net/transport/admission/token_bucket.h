// Token bucket rate limiter. The bucket starts with `burst` tokens, refills with `per_second`, and holds at
// most `burst`; every event spends tokens. The caller passes the rate and the time, so a bucket is three
// numbers.
#pragma once

#include <algorithm>

namespace temblor::net {

struct Rate {
  double burst = 0, per_second = 0;  // tokens, tokens per second
};

class TokenBucket {
 public:
  // Spends `cost` tokens and returns true, or spends nothing and returns false if there are too few. The
  // bucket is full at the first call. `now_s`: seconds, never going back.
  bool spend(double cost, const Rate& rate, double now_s) {
    refill(rate, now_s);
    if (cost > tokens_) return false;
    tokens_ -= cost;
    return true;
  }
  // Returns whether spend() would succeed, and spends nothing.
  bool can_spend(double cost, const Rate& rate, double now_s) {
    refill(rate, now_s);
    return cost <= tokens_;
  }

 private:
  void refill(const Rate& rate, double now_s) {
    tokens_ = started_ ? std::min(rate.burst, tokens_ + (now_s - refilled_s_) * rate.per_second) : rate.burst;
    started_ = true;
    refilled_s_ = now_s;
  }

  double tokens_ = 0, refilled_s_ = 0;
  bool started_ = false;
};

}  // namespace temblor::net
