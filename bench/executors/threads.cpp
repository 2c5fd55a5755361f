// A pool of plain std::thread, for the thread sanitizer: it sees every lock here, and none inside libgomp
// or a packaged TBB.
//
// A call puts its job on a list and works on it; idle workers join. The caller first finishes what nobody
// has taken and then waits for the helpers that are still in one of its chunks. A chunk can only wait for
// jobs that it started itself, which are nested deeper, so no two threads wait for each other. Who has
// nothing to do sleeps.
#include <fmt/format.h>

#include <condition_variable>
#include <system_error>
#include <thread>
#include <vector>

#include "bench/executors/chunks.hpp"
#include "core/error.hpp"

namespace pathrace::bench {
namespace {

// Lives on the caller's stack; `helpers` is guarded by the pool's mutex.
struct Job {
  explicit Job(Chunks& its_chunks) : chunks(its_chunks) {}

  Chunks& chunks;
  std::atomic<std::size_t> next{0};
  int helpers = 0;
  std::condition_variable left;

  void work() {
    for (std::size_t k = next++; k < chunks.size(); k = next++) chunks.run(k);
  }
};

class ThreadsExecutor final : public Executor {
 public:
  explicit ThreadsExecutor(int threads) : threads_(threads) {
    try {
      for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { serve(); });
    } catch (const std::system_error& error) {
      dismiss();
      throw EnvironmentError(
          fmt::format("cannot start thread {} of {}: {}", workers_.size() + 2, threads, error.what()));
    }
  }
  ~ThreadsExecutor() override { dismiss(); }

  std::string_view name() const override { return "threads"; }
  int threads() const override { return threads_; }

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    Chunks chunks(count, grain, body, census_);
    if (threads_ == 1 || chunks.size() == 1) return chunks.run_inline();
    Job job(chunks);
    offer(job);
    job.work();
    {
      std::unique_lock lock(mutex_);
      std::erase(jobs_, &job);
      job.left.wait(lock, [&job] { return job.helpers == 0; });
    }
    chunks.rethrow();
  }

  void offer(Job& job) {
    const std::size_t useful = std::min(job.chunks.size() - 1, workers_.size());
    {
      const std::scoped_lock lock(mutex_);
      jobs_.push_back(&job);
    }
    for (std::size_t i = 0; i < useful; ++i) work_offered_.notify_one();
  }

  // A worker's life: join the newest job, the innermost of nested ones, until nothing of it is left.
  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      work_offered_.wait(lock, [this] { return dismissed_ || !jobs_.empty(); });
      if (dismissed_) return;
      Job& job = *jobs_.back();
      ++job.helpers;
      lock.unlock();
      job.work();
      lock.lock();
      std::erase(jobs_, &job);
      if (--job.helpers == 0) job.left.notify_one();  // under the lock: the job dies once its caller wakes
    }
  }

  void dismiss() {
    {
      const std::scoped_lock lock(mutex_);
      dismissed_ = true;
    }
    work_offered_.notify_all();
    for (std::thread& worker : workers_) worker.join();
  }

  int threads_;
  std::mutex mutex_;
  std::condition_variable work_offered_;
  std::vector<Job*> jobs_;  // those with chunks that nobody has taken
  bool dismissed_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace

std::unique_ptr<Executor> make_threads_executor(int threads) {
  return std::make_unique<ThreadsExecutor>(threads);
}

}  // namespace pathrace::bench
