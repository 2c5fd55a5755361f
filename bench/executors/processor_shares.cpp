#include "bench/executors/processor_shares.hpp"

namespace pathrace::bench {

ProcessorShares::ProcessorShares(int threads) {
  cpu_set_t processors;
  CPU_ZERO(&processors);
  if (sched_getaffinity(0, sizeof processors, &processors) != 0 || CPU_COUNT(&processors) < threads) return;
  cpu_set_t none;
  CPU_ZERO(&none);
  shares_.assign(static_cast<std::size_t>(threads), none);
  std::size_t next = 0;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor) {
    if (CPU_ISSET(processor, &processors)) CPU_SET(processor, &shares_[next++ % shares_.size()]);
  }
}

bool ProcessorShares::here(int k) const {
  const int processor = sched_getcpu();
  return exist() && processor >= 0 && CPU_ISSET(processor, &share(k));
}

void ProcessorShares::settle(int k) const {
  if (exist()) sched_setaffinity(0, sizeof share(k), &share(k));
}

void ProcessorShares::go_to(int k) const {
  cpu_set_t before;
  if (!exist() || here(k) || sched_getaffinity(0, sizeof before, &before) != 0) return;
  settle(k);
  sched_setaffinity(0, sizeof before, &before);
}

}  // namespace pathrace::bench
