#include "bench/recorder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace pathrace::bench {
namespace {

constexpr std::chrono::milliseconds batch_delay{500};

}  // namespace

Recorder::Recorder(results::Store& store, std::atomic<bool>& stop, std::function<void(std::size_t)> written)
    : store_(store), stop_(stop), written_(std::move(written)) {
  try {
    writer_ = std::thread([this] { write_batches(); });
  } catch (const std::system_error& error) {
    throw EnvironmentError(fmt::format("{}: the system refuses a thread to write it ({})",
                                       store.file().string(), error.code().message()));
  }
}

Recorder::~Recorder() {
  try {
    finish();
  } catch (...) {  // already told through finish, or the run is failing for another reason
  }
}

void Recorder::add(results::TrialRow row) {
  std::size_t count = 0;
  {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return failed_ || waiting_.size() < most_waiting; });
    if (failed_) return;
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

void Recorder::fail(std::exception_ptr failure) {
  stop_.store(true);
  {
    const std::lock_guard lock(mutex_);
    failure_ = std::move(failure);
    failed_ = true;
  }
  room_.notify_all();
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
    room_.notify_all();
    if (batch.empty()) continue;
    try {
      store_.append(batch);
    } catch (...) {
      fail(std::current_exception());
      return;
    }
    total += batch.size();
    written_(total);
  }
}

}  // namespace pathrace::bench
