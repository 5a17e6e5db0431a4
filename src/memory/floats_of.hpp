// Records of floats as passes see them.
#pragma once

#include <vector>

namespace carom::detail
{

/// The first float of the first record; not to be read where there is none.
template <class Record, class Allocator>
float* floats_of(std::vector<Record, Allocator>& records)
{
    return reinterpret_cast<float*>(records.data());
}

template <class Record, class Allocator>
const float* floats_of(const std::vector<Record, Allocator>& records)
{
    return reinterpret_cast<const float*>(records.data());
}

} // namespace carom::detail
