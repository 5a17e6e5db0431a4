// Growing a thread's log, and taking it from under the thread's feet.
#include "profile/thread_log.hpp"

#include <thread>

namespace carom::profile
{

EventList::~EventList()
{
    while (first_) std::free(std::exchange(first_, first_->next));
}

bool EventList::add_chunk()
{
    // Not cleared: a page that no event has reached yet takes no memory.
    auto* const chunk = static_cast<Chunk*>(std::malloc(sizeof(Chunk)));
    if (!chunk) return false;
    chunk->next = nullptr;
    chunk->size = 0;
    (last_ ? last_->next : first_) = chunk;
    last_ = chunk;
    return true;
}

void EventList::append(EventList&& other)
{
    if (!other.first_) return;
    (last_ ? last_->next : first_) = std::exchange(other.first_, nullptr);
    last_ = std::exchange(other.last_, nullptr);
}

std::uint64_t EventList::size() const
{
    std::uint64_t size = 0;
    for (const Chunk* chunk = first_; chunk; chunk = chunk->next) size += chunk->size;
    return size;
}

void ThreadLog::lock()
{
    while (is_locked_.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
}

bool ThreadLog::has_room(ChunkBudget& budget)
{
    if (!events_.is_full()) return true;
    if (budget.fetch_sub(1, std::memory_order_relaxed) > 0 && events_.add_chunk()) return true;
    budget.fetch_add(1, std::memory_order_relaxed);
    return false;
}

void ThreadLog::add(const TraceEvent& event, ChunkBudget& budget)
{
    bool is_kept = false;
    if (!is_locked_.test_and_set(std::memory_order_acquire))
    {
        is_kept = has_room(budget);
        if (is_kept) events_.add(event);
        is_locked_.clear(std::memory_order_release);
    }
    if (!is_kept) dropped_.fetch_add(1, std::memory_order_relaxed);
}

EventList ThreadLog::take()
{
    lock();
    EventList events = std::move(events_);
    is_locked_.clear(std::memory_order_release);
    return events;
}

void ThreadLog::put_back(EventList events)
{
    lock();
    events.append(std::move(events_));
    events_ = std::move(events);
    is_locked_.clear(std::memory_order_release);
}

} // namespace carom::profile
