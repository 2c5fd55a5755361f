// The ticker: how a single long trial gets on, in a line on stderr that renews itself twice a second, from
// the first second on. A thread of its own reads the meter's counts; nobody waits for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "core/meter.hpp"

namespace pathrace::bench {

/// "plans, 12 s gone, 3200 of 5000 evaluations, 16 iterations, best 31.41": what is counted or limited.
std::string describe_progress(const Meter& meter);

class Ticker {
 public:
  /// Silent unless `shown`, which is for terminals.
  explicit Ticker(bool shown);
  /// Wipes the line.
  ~Ticker();
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

  /// What is being done before there is a meter: "proves the optimum".
  void say(const std::string& what);

  /// While it lives, the line tells what this meter counts.
  class Watch {
   public:
    /// Without a ticker it does nothing.
    Watch(Ticker* ticker, const Meter& meter);
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch();

   private:
    Ticker* ticker_;
  };

 private:
  void tick();
  std::string line() const;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::string what_;
  std::chrono::steady_clock::time_point since_;
  const Meter* meter_ = nullptr;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace pathrace::bench
