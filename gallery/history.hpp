// The last values of something that is measured in every step, for a plot.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace carom::gallery
{

class History
{
public:
    static constexpr std::size_t capacity = 240;

    /// The oldest goes when it is full.
    void add(double value)
    {
        values_[(first_ + size_) % capacity] = static_cast<float>(value);
        if (size_ < capacity)
            ++size_;
        else
            first_ = (first_ + 1) % capacity;
    }
    void clear() { first_ = size_ = 0; }

    std::size_t size() const { return size_; }
    /// @param i 0 is the oldest
    float operator[](std::size_t i) const { return values_[(first_ + i) % capacity]; }
    float latest() const { return size_ > 0 ? (*this)[size_ - 1] : 0; }
    float largest() const
    {
        float most = 0;
        for (std::size_t i = 0; i < size_; ++i) most = std::max(most, (*this)[i]);
        return most;
    }

private:
    std::array<float, capacity> values_ = {};
    std::size_t first_ = 0;
    std::size_t size_ = 0;
};

} // namespace carom::gallery
