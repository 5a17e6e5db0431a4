// The events of one thread, in the order in which they ended.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace carom::profile
{

enum class EventKind : std::uint64_t
{
    Zone,  ///< value is its length in nanoseconds
    Frame, ///< value means nothing
    Plot,  ///< value is the bits of a double
    Memory ///< value is the bytes in use of the pool `name`
};

struct TraceEvent
{
    const char* name;
    std::int64_t start_ns; ///< of the steady clock
    std::uint64_t value;
    EventKind kind;
};
static_assert(sizeof(TraceEvent) == 32);

/// A list that grows at its end, in chunks from malloc. It does not use operator new: the recorder does not show in the counts of who
/// watches the heap, and a lack of memory costs an event, not the program.
class EventList
{
public:
    struct Chunk
    {
        static constexpr std::size_t capacity = 2048;

        Chunk* next;
        std::size_t size;
        TraceEvent events[capacity];
    };

    EventList() = default;
    EventList(EventList&& other) noexcept : first_(std::exchange(other.first_, nullptr)), last_(std::exchange(other.last_, nullptr)) {}
    EventList& operator=(EventList&& other) noexcept
    {
        std::swap(first_, other.first_);
        std::swap(last_, other.last_);
        return *this;
    }
    ~EventList();

    bool is_full() const { return !last_ || last_->size == Chunk::capacity; } ///< the next event needs a chunk
    /// Adds room; false when there is no memory.
    bool add_chunk();
    /// @param event there must be room
    void add(const TraceEvent& event) { last_->events[last_->size++] = event; }
    /// Moves all chunks of another list to the end of this one.
    void append(EventList&& other);

    std::uint64_t size() const;
    /// Calls `each(const TraceEvent&)` for every event in order.
    template <class Each>
    void for_each(const Each& each) const
    {
        for (const Chunk* chunk = first_; chunk; chunk = chunk->next)
            for (std::size_t i = 0; i < chunk->size; ++i) each(chunk->events[i]);
    }

private:
    Chunk* first_ = nullptr;
    Chunk* last_ = nullptr;
};

/// How many chunks all logs of a recording may still take.
using ChunkBudget = std::atomic<std::int64_t>;

/// One thread writes; another may take what was written. The writer never waits: an event that comes while the log is taken is dropped.
class ThreadLog
{
public:
    explicit ThreadLog(std::uint32_t number) : number_(number) {}

    std::uint32_t number() const { return number_; } ///< 1 is the first thread that was seen
    const char* name() const { return name_.load(std::memory_order_relaxed); }
    void set_name(const char* name) { name_.store(name, std::memory_order_relaxed); }
    std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }
    void forget_dropped() { dropped_.store(0, std::memory_order_relaxed); }

    /// By the owner alone.
    void add(const TraceEvent& event, ChunkBudget& budget);
    /// Takes all events away and leaves an empty log.
    EventList take();
    /// Puts events that were taken back before those that came since.
    void put_back(EventList events);

private:
    bool has_room(ChunkBudget& budget);
    void lock();

    std::uint32_t number_;
    std::atomic<const char*> name_ = nullptr;
    std::atomic<std::uint64_t> dropped_ = 0;
    std::atomic_flag is_locked_;
    EventList events_;
};

} // namespace carom::profile
