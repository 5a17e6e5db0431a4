// Counting by category.
#include "memory/memory_stats.hpp"

#include <carom/error.hpp>
#include <carom/profile.hpp>

#include <string>

namespace carom
{

TrackingResource::TrackingResource(std::initializer_list<const char*> categories, std::pmr::memory_resource* upstream)
    : TrackingResource(std::span<const char* const>(categories.begin(), categories.size()), upstream)
{
}

TrackingResource::TrackingResource(std::span<const char* const> categories, std::pmr::memory_resource* upstream)
    : upstream_(detail::or_default(upstream)),
      count_(categories.size())
{
    if (count_ < 1 || count_ > max_categories)
        detail::raise<UsageError>("TrackingResource", "categories", std::to_string(count_), "give 1 to 16 names");
    for (std::size_t i = 0; i < count_; ++i)
    {
        categories_[i].all = this;
        categories_[i].name = categories[i];
    }
}

void* TrackingResource::Category::do_allocate(std::size_t bytes, std::size_t alignment)
{
    void* block = all->upstream_->allocate(bytes, alignment);
    detail::count_allocation(stats, bytes);
    detail::count_allocation(all->total_, bytes);
    CAROM_ALLOCATED(block, bytes, name);
    return block;
}

void TrackingResource::Category::do_deallocate(void* block, std::size_t bytes, std::size_t alignment)
{
    CAROM_FREED(block, name);
    all->upstream_->deallocate(block, bytes, alignment);
    detail::count_deallocation(stats, bytes);
    detail::count_deallocation(all->total_, bytes);
}

} // namespace carom
