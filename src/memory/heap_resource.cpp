// The C++ heap, counted.
#include "memory/memory_stats.hpp"

namespace carom
{

void* HeapResource::do_allocate(std::size_t bytes, std::size_t alignment)
{
    void* block = ::operator new(bytes, std::align_val_t(alignment));
    detail::count_allocation(stats_, bytes);
    return block;
}

void HeapResource::do_deallocate(void* block, std::size_t bytes, std::size_t alignment)
{
    ::operator delete(block, bytes, std::align_val_t(alignment));
    detail::count_deallocation(stats_, bytes);
}

} // namespace carom
