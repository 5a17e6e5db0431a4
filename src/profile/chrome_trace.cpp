// Finding the log of a thread, and handing all logs to the writer.
#include "profile/chrome_trace.hpp"

#include "profile/trace_json.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace carom::profile
{

namespace
{

std::atomic<std::uint64_t> recorders_made = 0;

std::int64_t to_ns(ChromeTrace::Clock::time_point time)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

/// The log that this thread has used last, and whose it is.
struct LastLog
{
    std::uint64_t recorder = 0;
    std::shared_ptr<ThreadLog> log;

    ~LastLog();
};

// Events may come from destructors that run after those of the thread's own variables. This has no destructor, so it can still be read.
thread_local bool has_thread_ended = false;
thread_local LastLog last_log;

LastLog::~LastLog() { has_thread_ended = true; }

} // namespace

ChromeTrace::ChromeTrace() : id_(recorders_made.fetch_add(1) + 1) {}

/// Null in a thread that is ending.
std::shared_ptr<ThreadLog> ChromeTrace::log_of_this_thread()
{
    if (has_thread_ended) return nullptr;
    if (last_log.recorder == id_) return last_log.log;
    const std::lock_guard lock(threads_mutex_);
    last_log.log = threads_.emplace_back(std::make_shared<ThreadLog>(++threads_seen_));
    last_log.recorder = id_;
    return last_log.log;
}

void ChromeTrace::add(const TraceEvent& event)
{
    if (has_thread_ended) return;
    if (last_log.recorder != id_) log_of_this_thread();
    last_log.log->add(event, budget_);
}

void ChromeTrace::name_thread(const char* name)
{
    if (const std::shared_ptr<ThreadLog> log = log_of_this_thread()) log->set_name(name);
}

void ChromeTrace::add_zone(const char* name, Clock::time_point start, Clock::time_point end)
{
    if (!is_recording()) return;
    const std::int64_t start_ns = to_ns(start);
    if (start_ns < start_ns_.load(std::memory_order_relaxed)) return; // it began before the recording
    add({name, start_ns, static_cast<std::uint64_t>(to_ns(end) - start_ns), EventKind::Zone});
}

void ChromeTrace::add_frame()
{
    if (!is_recording()) return;
    const Clock::time_point now = Clock::now();
    add({"frame", to_ns(now), 0, EventKind::Frame});
    note_pools(now);
}

void ChromeTrace::add_plot(const char* name, double value)
{
    if (!is_recording() || !std::isfinite(value)) return;
    add({name, to_ns(Clock::now()), std::bit_cast<std::uint64_t>(value), EventKind::Plot});
}

/// Also the most that was in use since the last time, so that a short peak shows.
void ChromeTrace::note_pools(Clock::time_point now)
{
    pools_.look([&](const PoolTotals::Change& change)
    {
        if (change.peak_bytes > std::max(change.bytes, change.bytes_before))
            add({change.pool, to_ns(change.peak_time), change.peak_bytes, EventKind::Memory});
        add({change.pool, to_ns(now), change.bytes, EventKind::Memory});
    });
}

/// A log that only this recorder still knows belongs to a thread that has ended.
void ChromeTrace::forget_ended_threads()
{
    std::erase_if(threads_, [](const std::shared_ptr<ThreadLog>& log) { return log.use_count() == 1; });
}

void ChromeTrace::start(const TraceOptions& options)
{
    const std::lock_guard control(control_);
    is_recording_ = false;
    {
        const std::lock_guard lock(threads_mutex_);
        for (const std::shared_ptr<ThreadLog>& log : threads_)
        {
            log->take();
            log->forget_dropped();
        }
        forget_ended_threads();
    }
    const std::uint64_t events = std::clamp<std::uint64_t>(options.max_events, EventList::Chunk::capacity, std::uint64_t{1} << 32);
    budget_ = static_cast<std::int64_t>((events + EventList::Chunk::capacity - 1) / EventList::Chunk::capacity);
    const Clock::time_point now = Clock::now();
    start_ns_ = to_ns(now);
    has_recording_ = true;
    is_recording_ = true;
    pools_.mark_all_changed();
    note_pools(now);
}

TraceResult ChromeTrace::write(const std::string& path)
{
    const std::lock_guard control(control_);
    if (!has_recording_) return {.problem = "nothing was recorded; call start_trace first"};
    if (is_recording()) note_pools(Clock::now());
    is_recording_ = false;

    TraceResult result;
    const std::lock_guard lock(threads_mutex_);
    std::vector<ThreadEvents> threads;
    for (const std::shared_ptr<ThreadLog>& log : threads_)
    {
        threads.push_back({log->number(), log->name(), log->take()});
        result.events += threads.back().events.size();
        result.dropped += log->dropped();
    }
    const std::string failure = write_trace_json(path, threads, start_ns_, result.dropped);
    if (!failure.empty())
    {
        for (std::size_t i = 0; i < threads.size(); ++i) threads_[i]->put_back(std::move(threads[i].events));
        return {.problem = "can't write \"" + path + "\": " + failure};
    }
    forget_ended_threads();
    has_recording_ = false;
    result.is_done = true;
    return result;
}

} // namespace carom::profile
