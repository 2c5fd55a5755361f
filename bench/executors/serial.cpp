// Everything on the calling thread, in order; the others must give the same slots.
#include "bench/executors/chunks.hpp"

namespace pathrace::bench {
namespace {

class SerialExecutor final : public Executor {
 public:
  std::string_view name() const override { return "serial"; }
  int threads() const override { return 1; }

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    Chunks(count, grain, body, census_).run_inline();
  }
};

}  // namespace

std::unique_ptr<Executor> make_serial_executor(int /*threads*/) {
  return std::make_unique<SerialExecutor>();
}

}  // namespace pathrace::bench
