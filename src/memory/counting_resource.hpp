// A memory resource that passes requests on and counts them.
#pragma once

#include <cstddef>
#include <memory_resource>

namespace carom::detail
{

/// Counts what goes through it to another resource. For one thread at a time.
class CountingResource final : public std::pmr::memory_resource
{
public:
    /// @param upstream outlives this
    explicit CountingResource(std::pmr::memory_resource& upstream) : upstream_(&upstream) {}

    std::size_t bytes() const { return bytes_; }             ///< in use now
    std::size_t peak_bytes() const { return peak_bytes_; }   ///< most that was ever in use
    std::size_t allocations() const { return allocations_; } ///< requests so far
    std::pmr::memory_resource& upstream() const { return *upstream_; }

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override
    {
        void* memory = upstream_->allocate(bytes, alignment);
        bytes_ += bytes;
        peak_bytes_ = bytes_ > peak_bytes_ ? bytes_ : peak_bytes_;
        ++allocations_;
        return memory;
    }

    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override
    {
        upstream_->deallocate(memory, bytes, alignment);
        bytes_ -= bytes;
    }

    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    std::pmr::memory_resource* upstream_;
    std::size_t bytes_ = 0;
    std::size_t peak_bytes_ = 0;
    std::size_t allocations_ = 0;
};

} // namespace carom::detail
