// The recorder: the one writer of a store.
//
// Trials hand their rows over from any thread; a thread of its own appends them in batches, one transaction a
// batch, at least once a second. When the store refuses (a full disk), the run is told to stop and `finish`
// says why; everything appended until then is kept.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "results/row.hpp"
#include "results/store.hpp"

namespace pathrace::bench {

class Recorder {
 public:
  static constexpr std::size_t batch_rows = 512;
  static constexpr std::size_t most_waiting = 4 * batch_rows;

  /// `stop` is set when writing fails; `written` is called after each batch with the number of rows so far.
  Recorder(results::Store& store, std::atomic<bool>& stop, std::function<void(std::size_t)> written);
  /// Appends what is left; swallows a failure that `finish` would have thrown.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Waits while the store is too far behind, so that rows do not pile up in memory. Once the store has
  /// refused, rows are dropped.
  void add(results::TrialRow row);
  /// Appends what is left. Throws what the store threw.
  void finish();

 private:
  void write_batches();
  void fail(std::exception_ptr failure);

  results::Store& store_;
  std::atomic<bool>& stop_;
  std::function<void(std::size_t)> written_;
  std::mutex mutex_;
  std::condition_variable wake_;  // the writer
  std::condition_variable room_;  // who waits to add
  std::vector<results::TrialRow> waiting_;
  bool finished_ = false;
  bool failed_ = false;
  std::exception_ptr failure_;
  std::thread writer_;
};

}  // namespace pathrace::bench
