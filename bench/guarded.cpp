#include "bench/guarded.hpp"

#include <new>

#include "core/checkpoint.hpp"
#include "core/error.hpp"

namespace pathrace::bench {
namespace {

void fail(TrialRecord& record, Verdict verdict, std::string_view why) {
  record.verdict = verdict;
  record.note = std::string(why);
  record.answer.reset();
}

}  // namespace

void guarded(TrialRecord& record, const std::function<void()>& body) {
  try {
    body();
  } catch (const Interrupted&) {
    throw;
  } catch (const OutOfTime&) {
    fail(record, Verdict::budget, "");
  } catch (const std::bad_alloc&) {
    fail(record, Verdict::out_of_memory, "the planner ran out of memory");
  } catch (const Unsupported& reason) {
    fail(record, Verdict::unsupported, reason.what());
  } catch (const InvalidScenario& reason) {
    fail(record, Verdict::bad_scenario, reason.what());
  } catch (const std::exception& error) {
    fail(record, Verdict::crashed, error.what());
  } catch (...) {
    fail(record, Verdict::crashed, "the planner threw something that is no std::exception");
  }
}

}  // namespace pathrace::bench
