// The bump allocator.
#include "memory/memory_stats.hpp"

#include <cstdint>
#include <limits>

namespace carom
{

/// Stands before the bytes of a chunk.
struct alignas(std::max_align_t) LinearResource::Chunk
{
    Chunk* before;
    std::size_t bytes; ///< with this header
};

namespace
{

constexpr std::size_t least_chunk = 256;

/// How far a pointer is from the next aligned one. Alignments are powers of two.
std::size_t gap_to_alignment(const std::byte* p, std::size_t alignment) { return -reinterpret_cast<std::uintptr_t>(p) & (alignment - 1); }

} // namespace

LinearResource::LinearResource(std::size_t first_chunk, std::pmr::memory_resource* upstream)
    : upstream_(detail::or_default(upstream)),
      first_chunk_(std::max(first_chunk, least_chunk)),
      next_chunk_(first_chunk_)
{
}

LinearResource::LinearResource(std::span<std::byte> buffer)
    : upstream_(nullptr),
      begin_(buffer.data()),
      next_(buffer.data()),
      end_(buffer.data() + buffer.size()),
      first_chunk_(0),
      next_chunk_(0),
      capacity_(buffer.size())
{
}

LinearResource::~LinearResource() { free_chunks(); }

void LinearResource::release()
{
    stats_.bytes = stats_.blocks = 0;
    high_water_ = used_before_ = 0;
    next_chunk_ = first_chunk_;
    free_chunks();
    next_ = begin_;
}

std::size_t LinearResource::used() const { return used_before_ + static_cast<std::size_t>(next_ - begin_); }

std::size_t LinearResource::high_water() const { return std::max(high_water_, used()); }

void LinearResource::reset()
{
    high_water_ = high_water();
    stats_.bytes = stats_.blocks = 0;
    if (chunk_ && chunk_->before)
    {
        free_chunks();
        next_chunk_ = high_water_ + high_water_ / 2;
    }
    used_before_ = 0;
    next_ = begin_;
}

void LinearResource::reserve(std::size_t bytes)
{
    if (bytes <= static_cast<std::size_t>(end_ - next_)) return;
    if (!upstream_) detail::raise<std::bad_alloc>();
    add_chunk(bytes);
}

void* LinearResource::do_allocate(std::size_t bytes, std::size_t alignment)
{
    std::size_t gap = gap_to_alignment(next_, alignment);
    const auto room = static_cast<std::size_t>(end_ - next_);
    if (gap > room || bytes > room - gap || !next_)
    {
        if (!upstream_ || bytes > std::numeric_limits<std::size_t>::max() / 4) detail::raise<std::bad_alloc>();
        add_chunk(bytes + alignment);
        gap = gap_to_alignment(next_, alignment);
    }
    std::byte* block = next_ + gap;
    next_ = block + bytes;
    detail::count_allocation(stats_, bytes);
    return block;
}

void LinearResource::do_deallocate(void* block, std::size_t bytes, std::size_t)
{
    detail::count_deallocation(stats_, bytes);
    auto* begin = static_cast<std::byte*>(block);
    if (begin + bytes != next_) return;
    high_water_ = high_water();
    next_ = begin;
}

void LinearResource::add_chunk(std::size_t least_bytes)
{
    const std::size_t bytes = sizeof(Chunk) + std::max(next_chunk_, least_bytes);
    auto* chunk = ::new (upstream_->allocate(bytes, alignof(Chunk))) Chunk{chunk_, bytes};
    used_before_ = used();
    chunk_ = chunk;
    begin_ = next_ = reinterpret_cast<std::byte*>(chunk + 1);
    end_ = reinterpret_cast<std::byte*>(chunk) + bytes;
    capacity_ += bytes - sizeof(Chunk);
    next_chunk_ = capacity_;
}

void LinearResource::free_chunks()
{
    while (chunk_)
    {
        Chunk* chunk = chunk_;
        chunk_ = chunk->before;
        upstream_->deallocate(chunk, chunk->bytes, alignof(Chunk));
        begin_ = next_ = end_ = nullptr;
        capacity_ = 0;
    }
}

} // namespace carom
