#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "base/check.h"

#ifdef TEMBLOR_HAVE_ONETBB
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace temblor::base {

struct Jobs::Pool {
  virtual ~Pool() = default;
  virtual void run(std::size_t count, FunctionRef<void(std::size_t)> body) = 0;
};

namespace {

// Workers sleep on a condition variable between calls. run() publishes the loop under the mutex, increments
// generation_, and wakes them; an atomic counter then distributes the indices without the lock. The caller
// takes part, and waits until every worker has finished, because `body` lives on its stack.
class ThreadPool {
 public:
  explicit ThreadPool(int helpers) {
    for (int i = 0; i < helpers; ++i) threads_.emplace_back([this] { work(); });
  }
  ~ThreadPool() {
    {
      std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void run(std::size_t count, FunctionRef<void(std::size_t)> body) {
    {
      std::lock_guard lock(mutex_);
      body_ = &body;
      count_ = count;
      next_.store(0, std::memory_order_relaxed);
      busy_ = threads_.size();
      ++generation_;
    }
    wake_.notify_all();
    take_indices(body, count);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
  }

 private:
  void take_indices(const FunctionRef<void(std::size_t)>& body, std::size_t count) {
    for (std::size_t i = next_.fetch_add(1); i < count; i = next_.fetch_add(1)) body(i);
  }

  void work() {
    std::size_t seen = 0;  // generation of the last loop that this worker ran
    std::unique_lock lock(mutex_);
    while (true) {
      wake_.wait(lock, [&] { return stop_ || generation_ != seen; });
      if (stop_) return;
      seen = generation_;
      const FunctionRef<void(std::size_t)>& body = *body_;
      const std::size_t count = count_;
      lock.unlock();
      take_indices(body, count);
      lock.lock();
      if (--busy_ == 0) done_.notify_one();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_, done_;
  std::vector<std::thread> threads_;
  const FunctionRef<void(std::size_t)>* body_ = nullptr;
  std::size_t count_ = 0, generation_ = 0, busy_ = 0;
  std::atomic<std::size_t> next_{0};
  bool stop_ = false;
};

}  // namespace

struct StdThreadBackend final : Jobs::Pool {
  explicit StdThreadBackend(int threads) : pool(threads - 1) {}
  void run(std::size_t count, FunctionRef<void(std::size_t)> body) override { pool.run(count, body); }
  ThreadPool pool;
};

#ifdef TEMBLOR_HAVE_ONETBB
struct OneTbbBackend final : Jobs::Pool {
  // oneTBB warns on standard error if more workers than cores are requested.
  explicit OneTbbBackend(int threads) : arena(std::min(threads, oneapi::tbb::info::default_concurrency())) {}
  void run(std::size_t count, FunctionRef<void(std::size_t)> body) override {
    arena.execute([&] {
      oneapi::tbb::parallel_for(
          oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
          },
          // One index per task: jobs are few and of very different length.
          oneapi::tbb::simple_partitioner());
    });
  }
  oneapi::tbb::task_arena arena;
};
#endif

Jobs::Jobs(int threads, [[maybe_unused]] JobBackend backend) : threads_(threads) {
  CHECK(threads >= 1);
  if (threads == 1) return;
#ifdef TEMBLOR_HAVE_ONETBB
  if (backend == JobBackend::kOneTbb) {
    pool_ = std::make_unique<OneTbbBackend>(threads);
    return;
  }
#endif
  pool_ = std::make_unique<StdThreadBackend>(threads);
}

Jobs::~Jobs() = default;
Jobs::Jobs(Jobs&&) noexcept = default;
Jobs& Jobs::operator=(Jobs&&) noexcept = default;

void Jobs::parallel_for(std::size_t count, FunctionRef<void(std::size_t)> body) {
  if (!pool_ || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  pool_->run(count, body);
}

}  // namespace temblor::base
