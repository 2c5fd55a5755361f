#include "bench/executors/processor_shares.hpp"

namespace pathrace::bench {

ProcessorShares::ProcessorShares(int threads) : threads_(threads) {
  CPU_ZERO(&processors_);
  exist_ = sched_getaffinity(0, sizeof processors_, &processors_) == 0 && CPU_COUNT(&processors_) >= threads;
}

bool ProcessorShares::here(int k) const {
  const cpu_set_t mine = share(k);
  const int processor = sched_getcpu();
  return processor >= 0 && CPU_ISSET(processor, &mine);
}

void ProcessorShares::settle(int k) const {
  if (!exist_) return;
  const cpu_set_t mine = share(k);
  sched_setaffinity(0, sizeof mine, &mine);
}

void ProcessorShares::go_to(int k) const {
  cpu_set_t before;
  if (!exist_ || here(k) || sched_getaffinity(0, sizeof before, &before) != 0) return;
  settle(k);
  sched_setaffinity(0, sizeof before, &before);
}

cpu_set_t ProcessorShares::share(int k) const {
  cpu_set_t share;
  CPU_ZERO(&share);
  int count = 0;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor) {
    if (!CPU_ISSET(processor, &processors_)) continue;
    if (count++ % threads_ == k) CPU_SET(processor, &share);
  }
  return share;
}

}  // namespace pathrace::bench
