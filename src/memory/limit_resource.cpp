// A hard budget.
#include "memory/memory_stats.hpp"

namespace carom
{

MemoryLimitError::MemoryLimitError(std::size_t asked, std::size_t in_use, std::size_t budget)
    : asked_(asked),
      in_use_(in_use),
      budget_(budget)
{
    std::snprintf(message_.data(), message_.size(),
                  "LimitResource: %zu bytes more do not fit into the budget of %zu bytes, of which %zu are in use; raise it or hold less",
                  asked, budget, in_use);
}

LimitResource::LimitResource(std::size_t budget, std::pmr::memory_resource* upstream)
    : upstream_(detail::or_default(upstream)),
      budget_(budget)
{
}

void* LimitResource::do_allocate(std::size_t bytes, std::size_t alignment)
{
    if (stats_.bytes > budget_ || bytes > budget_ - stats_.bytes) detail::raise<MemoryLimitError>(bytes, stats_.bytes, budget_);
    void* block = upstream_->allocate(bytes, alignment);
    detail::count_allocation(stats_, bytes);
    return block;
}

void LimitResource::do_deallocate(void* block, std::size_t bytes, std::size_t alignment)
{
    upstream_->deallocate(block, bytes, alignment);
    detail::count_deallocation(stats_, bytes);
}

} // namespace carom
