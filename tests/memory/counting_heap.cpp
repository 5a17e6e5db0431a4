// Every form of operator new and operator delete, over malloc, with the size kept in front of the block.
#include "tests/memory/counting_heap.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{

std::atomic<std::size_t> allocations = 0;
std::atomic<std::size_t> bytes_in_use = 0;
std::atomic<std::size_t> peak = 0;

void raise_peak(std::size_t in_use)
{
    std::size_t most = peak;
    while (in_use > most && !peak.compare_exchange_weak(most, in_use))
    {
    }
}

/// Stands right before the user's bytes.
struct Header
{
    void* block; // what malloc gave
    std::size_t bytes;
};

void* take(std::size_t bytes, std::size_t alignment)
{
    if (alignment < alignof(std::max_align_t)) alignment = alignof(std::max_align_t);
    void* block = std::malloc(sizeof(Header) + alignment + bytes);
    if (!block) throw std::bad_alloc();
    const auto first = reinterpret_cast<std::size_t>(block) + sizeof(Header);
    const std::size_t place = (first + alignment - 1) / alignment * alignment;
    *(reinterpret_cast<Header*>(place) - 1) = {block, bytes};
    ++allocations;
    raise_peak(bytes_in_use += bytes);
    return reinterpret_cast<void*>(place);
}

void give_back(void* memory) noexcept
{
    if (!memory) return;
    const Header header = *(static_cast<Header*>(memory) - 1);
    bytes_in_use -= header.bytes;
    std::free(header.block);
}

} // namespace

namespace carom
{

std::size_t heap_allocations() { return allocations; }
std::size_t heap_bytes() { return bytes_in_use; }
void watch_heap_peak() { peak = bytes_in_use.load(); }
std::size_t heap_peak() { return peak; }

} // namespace carom

void* operator new(std::size_t bytes) { return take(bytes, 1); }
void* operator new[](std::size_t bytes) { return take(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) { return take(bytes, static_cast<std::size_t>(alignment)); }
void* operator new[](std::size_t bytes, std::align_val_t alignment) { return take(bytes, static_cast<std::size_t>(alignment)); }
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
