// Memory resources on which a world, or anything else that takes a std::pmr::memory_resource, can live.
//
//     carom::HeapResource heap;                          // the heap, counted
//     carom::LimitResource limit(8 << 20, &heap);        // and no more of it than 8 MiB
//     carom::World world({.memory = &limit});
//
// None of them needs a world. Each counts what it has given out, and is used by one thread at a time. A resource outlives whatever came from it.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory_resource>
#include <new>
#include <span>

namespace carom
{

/// What has been asked of a memory resource.
struct MemoryStats
{
    std::size_t bytes = 0;       ///< in use now, as they were asked for
    std::size_t blocks = 0;      ///< in use now
    std::size_t peak_bytes = 0;  ///< most that were ever in use
    std::size_t allocations = 0; ///< so far
    std::size_t total_bytes = 0; ///< asked for so far

    friend bool operator==(const MemoryStats&, const MemoryStats&) = default;
};

/// The C++ heap: operator new and operator delete.
class HeapResource final : public std::pmr::memory_resource
{
public:
    MemoryStats stats() const { return stats_; }

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    MemoryStats stats_;
};

/// A bump allocator: a block costs the addition of its size, and all go at once. Freeing a block gives its bytes back only if it is the last one that
/// was taken.
class LinearResource final : public std::pmr::memory_resource
{
public:
    /// Grows in chunks: the first is of `first_chunk` bytes, or as large as the first block needs, and each further one as large as all before it together.
    /// @param upstream where chunks come from; null is the default resource
    explicit LinearResource(std::size_t first_chunk, std::pmr::memory_resource* upstream = nullptr);
    /// Stays within a buffer, which outlives this; throws std::bad_alloc when that is full.
    explicit LinearResource(std::span<std::byte> buffer);
    LinearResource(const LinearResource&) = delete;
    LinearResource& operator=(const LinearResource&) = delete;
    ~LinearResource() override;

    /// Takes everything back. When more than one chunk was in use, they go, and the next block brings one that holds as much as was ever in use
    /// between two resets and half as much again: what repeats itself is soon served by one chunk.
    void reset();

    /// Takes everything back, and returns all chunks to where they came from: as if it were new. A fixed buffer stays.
    void release();

    /// Takes a chunk now unless so many bytes are left in the one in use.
    /// @throws std::bad_alloc when a fixed buffer has not as many
    void reserve(std::size_t bytes);

    MemoryStats stats() const { return stats_; }       ///< `bytes` and `blocks` since the last reset
    std::size_t used() const;                          ///< bytes of the chunks that blocks, and gaps for their alignment, take up
    std::size_t high_water() const;                    ///< most that was ever used between two resets [bytes]
    std::size_t capacity() const { return capacity_; } ///< of all chunks [bytes]

private:
    struct Chunk;

    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
    void add_chunk(std::size_t least_bytes);
    void free_chunks();

    std::pmr::memory_resource* upstream_; ///< null: a fixed buffer
    Chunk* chunk_ = nullptr;              ///< the newest; each knows the one before
    std::byte* begin_ = nullptr;          ///< of the newest chunk's bytes, or of the buffer
    std::byte* next_ = nullptr;           ///< the first free byte
    std::byte* end_ = nullptr;
    std::size_t first_chunk_;     ///< as it was asked for [bytes]
    std::size_t next_chunk_;      ///< bytes of the next chunk
    std::size_t used_before_ = 0; ///< of the chunks before the newest one
    std::size_t capacity_ = 0;
    std::size_t high_water_ = 0;
    MemoryStats stats_;
};

/// Which of the free blocks that are large enough a FreeListResource takes.
enum class FreeListFit
{
    First, ///< that was freed last: quick
    Best   ///< the smallest one: looks at all of them, and wastes less
};

struct FreeListOptions
{
    FreeListFit fit = FreeListFit::First;
    std::size_t chunk_bytes = 64 * 1024; ///< least that is taken from upstream at a time
    /// Freeing a block twice, or one that is not from here, or with the wrong size, ends the program with a message. By default in debug builds of what includes
    /// this header.
#ifdef NDEBUG
    bool checks = false;
#else
    bool checks = true;
#endif
};

/// A general allocator over a few large pieces of memory: a list of free blocks, which are divided when they are too large and united with their free
/// neighbours when they are given back. Any order of sizes and any alignment; 16 bytes are spent on each block.
///
///     | size, previous | bytes of a block in use ...... | size, previous | next free, previous free, unused ...... | end |
class FreeListResource final : public std::pmr::memory_resource
{
public:
    /// Grows by chunks, which go back when this is destroyed.
    /// @param upstream where chunks come from; null is the default resource
    explicit FreeListResource(const FreeListOptions& options = {}, std::pmr::memory_resource* upstream = nullptr);
    /// Stays within a buffer, which outlives this; throws std::bad_alloc when no free block is large enough.
    explicit FreeListResource(std::span<std::byte> buffer, const FreeListOptions& options = {});
    FreeListResource(const FreeListResource&) = delete;
    FreeListResource& operator=(const FreeListResource&) = delete;
    ~FreeListResource() override;

    MemoryStats stats() const { return stats_; }
    std::size_t capacity() const { return capacity_; }     ///< of all chunks, with what is spent on blocks [bytes]
    std::size_t free_bytes() const { return free_bytes_; } ///< that blocks could still be made of
    std::size_t free_blocks() const;                       ///< into which they are divided; looks at all of them
    /// The most that one block could still be given without growing [bytes]: over `free_bytes` it tells how fragmented the memory is. Looks at all of them.
    std::size_t largest_free_block() const;

private:
    struct Block;
    struct Chunk;

    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    static std::size_t block_size(std::size_t bytes);
    Block* find_free(std::size_t size, std::size_t alignment) const;
    void add_chunk(std::size_t size, std::size_t alignment);
    void add_memory(std::byte* begin, std::size_t bytes);
    void link(Block* block);
    void unlink(Block* block);
    Block* cut_front(Block* block, std::byte* place);
    void cut_back(Block* block, std::size_t size);
    void check(void* memory, std::size_t bytes) const;
    bool holds(const void* memory) const;

    FreeListOptions options_;
    std::pmr::memory_resource* upstream_ = nullptr; ///< null: a fixed buffer
    Chunk* chunks_ = nullptr;
    std::span<std::byte> buffer_;
    Block* free_ = nullptr; ///< the block that was freed last
    std::size_t capacity_ = 0;
    std::size_t free_bytes_ = 0;
    MemoryStats stats_;
};

/// Passes requests on and counts them, by category and together. The resource itself counts as its first category. In an engine that is built with a
/// profiler each block is an event of the pool with its category's name.
///
///     carom::TrackingResource memory({"game", "sound"});
///     std::pmr::vector<Enemy> enemies(&memory.category(0));
class TrackingResource final : public std::pmr::memory_resource
{
public:
    static constexpr std::size_t max_categories = 16;

    /// @param categories names, of which only the addresses are kept: string literals
    /// @param upstream   null is the default resource
    /// @throws UsageError unless there are 1 to 16 names
    explicit TrackingResource(std::initializer_list<const char*> categories = {"memory"}, std::pmr::memory_resource* upstream = nullptr);
    TrackingResource(std::span<const char* const> categories, std::pmr::memory_resource* upstream = nullptr);
    TrackingResource(const TrackingResource&) = delete;
    TrackingResource& operator=(const TrackingResource&) = delete;

    std::pmr::memory_resource& category(std::size_t index) { return categories_[index]; } ///< lives as long as this
    std::size_t category_count() const { return count_; }
    const char* name(std::size_t category) const { return categories_[category].name; }
    MemoryStats stats() const { return total_; } ///< of all together
    MemoryStats stats(std::size_t category) const { return categories_[category].stats; }
    std::pmr::memory_resource& upstream() const { return *upstream_; }

private:
    struct Category final : std::pmr::memory_resource
    {
        void* do_allocate(std::size_t bytes, std::size_t alignment) override;
        void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override;
        bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

        TrackingResource* all = nullptr;
        const char* name = "";
        MemoryStats stats;
    };

    void* do_allocate(std::size_t bytes, std::size_t alignment) override { return categories_[0].allocate(bytes, alignment); }
    void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override
    {
        categories_[0].deallocate(block, bytes, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    std::pmr::memory_resource* upstream_;
    std::size_t count_;
    MemoryStats total_;
    std::array<Category, max_categories> categories_;
};

/// More memory was asked of a LimitResource than its budget allows.
class MemoryLimitError : public std::bad_alloc
{
public:
    MemoryLimitError(std::size_t asked, std::size_t in_use, std::size_t budget);
    /// "LimitResource: 4096 bytes more do not fit into the budget of 1048576 bytes, of which 1046000 are in use; raise it or hold less"
    const char* what() const noexcept override { return message_.data(); }

    std::size_t asked() const { return asked_; }   ///< [bytes]
    std::size_t in_use() const { return in_use_; } ///< [bytes]
    std::size_t budget() const { return budget_; } ///< [bytes]

private:
    std::size_t asked_;
    std::size_t in_use_;
    std::size_t budget_;
    std::array<char, 192> message_;
};

/// A hard budget: passes requests on, and throws MemoryLimitError on one that would take the bytes in use above it.
class LimitResource final : public std::pmr::memory_resource
{
public:
    /// @param budget   [bytes]
    /// @param upstream null is the default resource
    explicit LimitResource(std::size_t budget, std::pmr::memory_resource* upstream = nullptr);

    MemoryStats stats() const { return stats_; }
    std::size_t budget() const { return budget_; }
    /// May be less than what is in use: then nothing more is given out until enough has come back.
    void set_budget(std::size_t bytes) { budget_ = bytes; }

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    std::pmr::memory_resource* upstream_;
    std::size_t budget_;
    MemoryStats stats_;
};

} // namespace carom
