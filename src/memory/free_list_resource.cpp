// The free list. A block knows its size and the block before it; the one after it begins where it ends. So a block that is given back finds its
// neighbours at once. The memory of a chunk ends with a block of no size that is always in use.
//
// @source D. Knuth, "The Art of Computer Programming", volume 1, section 2.5 (boundary tags)
#include "memory/memory_stats.hpp"

#include <cstdint>
#include <limits>

namespace carom
{

namespace
{

/// Sizes and places of blocks are multiples of this [bytes].
constexpr std::size_t unit = 16;

/// @param to a power of two
std::size_t round_up(std::size_t bytes, std::size_t to) { return (bytes + to - 1) & ~(to - 1); }

std::uintptr_t address(const void* p) { return reinterpret_cast<std::uintptr_t>(p); }

} // namespace

struct alignas(unit) FreeListResource::Block
{
    static constexpr std::size_t header = unit; // what stands before the user's bytes
    static constexpr std::size_t free_bit = 1;

    std::size_t size_and_state;     ///< bytes with the header, a multiple of `unit`; the lowest bit is set while it is free
    Block* before;                  ///< in memory; null for the first of a chunk
    alignas(unit) Block* next_free; ///< from here on: bytes of the user while it is in use
    Block* previous_free;

    std::size_t size() const { return size_and_state & ~free_bit; }
    bool is_free() const { return (size_and_state & free_bit) != 0; }
    std::byte* place() { return reinterpret_cast<std::byte*>(this); }
    Block* after() { return reinterpret_cast<Block*>(place() + size()); }
    static Block* of(void* memory) { return reinterpret_cast<Block*>(static_cast<std::byte*>(memory) - header); }

    /// Where an aligned block could begin in this one: at its own place, or far enough behind it that what is cut off can be a block.
    std::byte* aligned_place(std::size_t alignment)
    {
        if (alignment <= unit) return place();
        std::uintptr_t bytes = round_up(address(place()) + header, alignment);
        if (bytes != address(place()) + header) bytes = round_up(address(place()) + sizeof(Block) + header, alignment);
        return place() + (bytes - header - address(place()));
    }
    bool fits(std::size_t size, std::size_t alignment) { return aligned_place(alignment) + size <= place() + this->size(); }
};

struct alignas(unit) FreeListResource::Chunk
{
    Chunk* before;
    std::size_t bytes; ///< with this header
};

FreeListResource::FreeListResource(const FreeListOptions& options, std::pmr::memory_resource* upstream)
    : options_(options),
      upstream_(detail::or_default(upstream))
{
}

FreeListResource::FreeListResource(std::span<std::byte> buffer, const FreeListOptions& options) : options_(options), buffer_(buffer)
{
    const std::size_t gap = round_up(address(buffer.data()), unit) - address(buffer.data());
    if (buffer.size() > gap) add_memory(buffer.data() + gap, (buffer.size() - gap) / unit * unit);
}

FreeListResource::~FreeListResource()
{
    while (chunks_)
    {
        Chunk* chunk = chunks_;
        chunks_ = chunk->before;
        upstream_->deallocate(chunk, chunk->bytes, alignof(Chunk));
    }
}

void* FreeListResource::do_allocate(std::size_t bytes, std::size_t alignment)
{
    if (bytes > std::numeric_limits<std::size_t>::max() / 4) detail::raise<std::bad_alloc>();
    const std::size_t size = block_size(bytes);
    Block* block = find_free(size, alignment);
    if (!block)
    {
        if (!upstream_) detail::raise<std::bad_alloc>();
        add_chunk(size, alignment);
        block = find_free(size, alignment);
    }
    unlink(block);
    block = cut_front(block, block->aligned_place(alignment));
    cut_back(block, size);
    detail::count_allocation(stats_, bytes);
    return block->place() + Block::header;
}

void FreeListResource::do_deallocate(void* memory, std::size_t bytes, std::size_t)
{
    if (options_.checks) check(memory, bytes);
    detail::count_deallocation(stats_, bytes);
    Block* block = Block::of(memory);
    Block* after = block->after();
    if (after->is_free())
    {
        unlink(after);
        block->size_and_state += after->size();
    }
    Block* before = block->before;
    if (before && before->is_free())
    {
        unlink(before);
        before->size_and_state += block->size();
        block = before;
    }
    block->after()->before = block;
    link(block);
}

std::size_t FreeListResource::block_size(std::size_t bytes)
{
    return std::max(Block::header + round_up(bytes, unit), sizeof(Block)); // a free one must be able to hold its links
}

FreeListResource::Block* FreeListResource::find_free(std::size_t size, std::size_t alignment) const
{
    Block* best = nullptr;
    for (Block* block = free_; block; block = block->next_free)
    {
        if (!block->fits(size, alignment)) continue;
        if (options_.fit == FreeListFit::First) return block;
        if (!best || block->size() < best->size()) best = block;
    }
    return best;
}

void FreeListResource::add_chunk(std::size_t size, std::size_t alignment)
{
    const std::size_t for_alignment = alignment > unit ? alignment + sizeof(Block) : 0;
    const std::size_t least = sizeof(Chunk) + size + for_alignment + Block::header;
    const std::size_t bytes = round_up(std::max(options_.chunk_bytes, least), unit);
    chunks_ = ::new (upstream_->allocate(bytes, alignof(Chunk))) Chunk{chunks_, bytes};
    add_memory(reinterpret_cast<std::byte*>(chunks_ + 1), bytes - sizeof(Chunk));
}

/// One free block, and the end.
void FreeListResource::add_memory(std::byte* begin, std::size_t bytes)
{
    capacity_ += bytes;
    if (bytes < sizeof(Block) + Block::header) return; // too small for any
    Block* block = reinterpret_cast<Block*>(begin);
    block->size_and_state = bytes - Block::header;
    block->before = nullptr;
    Block* end = block->after();
    end->size_and_state = 0;
    end->before = block;
    link(block);
}

void FreeListResource::link(Block* block)
{
    block->size_and_state |= Block::free_bit;
    block->previous_free = nullptr;
    block->next_free = free_;
    if (free_) free_->previous_free = block;
    free_ = block;
    free_bytes_ += block->size() - Block::header;
}

void FreeListResource::unlink(Block* block)
{
    free_bytes_ -= block->size() - Block::header;
    block->size_and_state &= ~Block::free_bit;
    if (block->next_free) block->next_free->previous_free = block->previous_free;
    (block->previous_free ? block->previous_free->next_free : free_) = block->next_free;
}

/// Frees what lies before `place`.
/// @return the block that begins there
FreeListResource::Block* FreeListResource::cut_front(Block* block, std::byte* place)
{
    const auto bytes = static_cast<std::size_t>(place - block->place());
    if (bytes == 0) return block;
    Block* rest = reinterpret_cast<Block*>(place);
    rest->size_and_state = block->size() - bytes;
    rest->before = block;
    rest->after()->before = rest;
    block->size_and_state = bytes;
    link(block);
    return rest;
}

/// Frees what is beyond `size`, if that is enough for a block.
void FreeListResource::cut_back(Block* block, std::size_t size)
{
    const std::size_t bytes = block->size() - size;
    if (bytes < sizeof(Block)) return;
    block->size_and_state = size;
    Block* rest = block->after();
    rest->size_and_state = bytes;
    rest->before = block;
    rest->after()->before = rest;
    link(rest);
}

std::size_t FreeListResource::free_blocks() const
{
    std::size_t count = 0;
    for (const Block* block = free_; block; block = block->next_free) ++count;
    return count;
}

std::size_t FreeListResource::largest_free_block() const
{
    std::size_t largest = 0;
    for (const Block* block = free_; block; block = block->next_free) largest = std::max(largest, block->size() - Block::header);
    return largest;
}

bool FreeListResource::holds(const void* memory) const
{
    const auto is_in = [&](const void* begin, std::size_t bytes)
    { return address(memory) >= address(begin) && address(memory) - address(begin) < bytes; };
    if (is_in(buffer_.data(), buffer_.size())) return true;
    for (const Chunk* chunk = chunks_; chunk; chunk = chunk->before)
        if (is_in(chunk, chunk->bytes)) return true;
    return false;
}

/// Ends the program unless a block of that size begins there and is in use.
void FreeListResource::check(void* memory, std::size_t bytes) const
{
    const auto fail = [&](const char* fault)
    {
        std::fprintf(stderr, "FreeListResource: %p %s\n", memory, fault);
        std::abort();
    };
    if (!holds(memory) || address(memory) % unit != 0) fail("was not allocated here");
    Block* block = Block::of(memory);
    if (block->is_free()) fail("is free already");
    const bool is_after_right = block->size() >= sizeof(Block) && holds(block->after()) && block->after()->before == block;
    const bool is_before_right = !block->before || (holds(block->before) && block->before->after() == block);
    if (!is_after_right || !is_before_right) fail("is free already, or was not allocated here, or what stands before it was overwritten");
    const std::size_t size = block_size(bytes);
    if (block->size() < size || block->size() >= size + sizeof(Block)) fail("was allocated with another size");
}

} // namespace carom
