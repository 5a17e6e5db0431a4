// The operators new and delete of the program, with a counter.
#include "cli/heap_counter.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{

std::atomic<std::uint64_t> allocations = 0;

/// @param alignment a power of two, or 0 for whatever malloc gives
void* allocate(std::size_t size, std::size_t alignment)
{
    allocations.fetch_add(1, std::memory_order_relaxed);
    const std::size_t wanted = size > 0 ? size : 1; // each allocation has an address of its own
    while (true)
    {
        // aligned_alloc wants a multiple of the alignment.
        const std::size_t whole = alignment > 0 ? (wanted + alignment - 1) / alignment * alignment : wanted;
        void* const memory = alignment > 0 ? std::aligned_alloc(alignment, whole) : std::malloc(whole);
        if (memory) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (!handler) throw std::bad_alloc();
        handler();
    }
}

} // namespace

namespace carom::cli
{

std::uint64_t heap_allocations() { return allocations.load(std::memory_order_relaxed); }

} // namespace carom::cli

// The forms for arrays and the ones that do not throw call these.
void* operator new(std::size_t size) { return allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, static_cast<std::size_t>(alignment)); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
