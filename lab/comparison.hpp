// Whether one program is faster than another: the tests that answer it, from times of whole runs.
//
// The unit is the run, not the frame: frames of one run are correlated, and a test that takes them for independent finds differences that are not
// there. Runs of both sides alternate, so that what the machine does hits both.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace carom::lab
{

/// A value with the interval in which it lies with a confidence.
struct Interval
{
    double low = 0;
    double high = 0;

    bool contains(double value) const { return low <= value && value <= high; }
};

/// A t test of two means. The difference is that of B minus A.
struct TTest
{
    double t = 0;
    double degrees_of_freedom = 0;
    double p = 1; ///< two-sided
    double difference = 0;
    Interval interval; ///< of the difference
};

enum class Verdict
{
    None,   ///< no difference that can be told from noise, or one below the threshold
    Faster, ///< B takes less time
    Slower  ///< B takes more time
};

/// "no difference", "faster", "slower".
std::string_view name_of(Verdict verdict);

struct ComparisonOptions
{
    double confidence = 0.95;
    double threshold = 0.02; ///< a ratio nearer to 1 is called no difference
    double noise = 0.05;     ///< a larger spread of the runs of one side is worth a warning
    int resamples = 10'000;
    std::uint64_t seed = 1;
};

struct Comparison
{
    double median_a = 0;
    double median_b = 0;
    double ratio = 1;  ///< median of B over median of A: below 1 when B takes less time
    Interval interval; ///< of the ratio, by the bootstrap
    double mann_whitney_u = 0;
    double mann_whitney_p = 1; ///< two-sided
    TTest student;             ///< takes both spreads for equal, as the origin engine's author did
    TTest welch;               ///< does not
    double spread_a = 0;       ///< of the runs of A: half the distance between their quartiles over their median
    double spread_b = 0;
    bool is_noisy = false;
    Verdict verdict = Verdict::None;
};

/// @param a, b times of runs, each > 0; those of one place were made one after the other. At least two each
/// @throws std::invalid_argument on fewer, or times that are not positive and finite
Comparison compare(std::span<const double> a, std::span<const double> b, const ComparisonOptions& options = {});

/// Student's t test, for equal spreads.
/// @throws std::invalid_argument on fewer than two values of either
TTest student_t_test(std::span<const double> a, std::span<const double> b, double confidence = 0.95);
/// Welch's t test, for any spreads.
TTest welch_t_test(std::span<const double> a, std::span<const double> b, double confidence = 0.95);

struct RankTest
{
    double u = 0; ///< of A: pairs in which A is larger, ties count half
    double p = 1; ///< two-sided; exact for up to 20 values a side without ties
};
RankTest mann_whitney(std::span<const double> a, std::span<const double> b);

double median(std::span<const double> values);
/// @param values each > 0
double geometric_mean(std::span<const double> values);

} // namespace carom::lab
