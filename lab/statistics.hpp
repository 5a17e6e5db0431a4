// Summaries of a list of measurements.
#pragma once

#include <span>

namespace carom::lab
{

struct Summary
{
    double mean = 0;
    double median = 0;
    double p99 = 0; ///< 99 of 100 are at most this
    double max = 0;
};

/// The value below which a share of the sorted numbers lies, between two of them by their distance.
/// @param sorted ascending, not empty
/// @param share  0 to 1
double quantile(std::span<const double> sorted, double share);

/// All zero for an empty list.
Summary summarize(std::span<const double> values);

} // namespace carom::lab
