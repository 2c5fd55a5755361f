#include "bench/recorder.hpp"

#include <chrono>
#include <utility>

namespace pathrace::bench {
namespace {

constexpr std::size_t batch_rows = 512;
constexpr std::chrono::milliseconds batch_delay{500};

}  // namespace

Recorder::Recorder(results::Store& store, std::atomic<bool>& stop, std::function<void(std::size_t)> written)
    : store_(store), stop_(stop), written_(std::move(written)), writer_([this] { write_batches(); }) {}

Recorder::~Recorder() {
  try {
    finish();
  } catch (...) {  // already told through finish, or the run is failing for another reason
  }
}

void Recorder::add(results::TrialRow row) {
  std::size_t count = 0;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(row));
    count = waiting_.size();
  }
  if (count >= batch_rows) wake_.notify_one();
}

void Recorder::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  wake_.notify_one();
  if (writer_.joinable()) writer_.join();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Recorder::write_batches() {
  std::size_t total = 0;
  bool last = false;
  while (!last) {
    std::vector<results::TrialRow> batch;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, batch_delay, [this] { return finished_ || waiting_.size() >= batch_rows; });
      batch.swap(waiting_);
      last = finished_;
    }
    if (batch.empty()) continue;
    try {
      store_.append(batch);
    } catch (...) {
      failure_ = std::current_exception();
      stop_.store(true);
      return;
    }
    total += batch.size();
    written_(total);
  }
}

}  // namespace pathrace::bench
