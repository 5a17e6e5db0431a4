// The tests, on Boost.Math's distributions.
#include "lab/comparison.hpp"

#include "lab/statistics.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

namespace carom::lab
{

namespace
{

struct Moments
{
    double count = 0;
    double mean = 0;
    double variance = 0; ///< of the population that the values are from
};

Moments moments_of(std::span<const double> values)
{
    if (values.size() < 2) throw std::invalid_argument("a t test needs at least two values of each side");
    Moments m;
    m.count = static_cast<double>(values.size());
    m.mean = std::accumulate(values.begin(), values.end(), 0.0) / m.count;
    for (const double value : values) m.variance += (value - m.mean) * (value - m.mean);
    m.variance /= m.count - 1;
    return m;
}

/// @param error of the difference, its standard deviation
TTest t_test(double difference, double error, double degrees, double confidence)
{
    TTest test;
    test.degrees_of_freedom = degrees;
    test.difference = difference;
    if (!(error > 0)) // no spread at all: equal, or surely different
    {
        test.t = difference == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), difference);
        test.p = difference == 0 ? 1 : 0;
        test.interval = {difference, difference};
        return test;
    }
    const boost::math::students_t distribution(degrees);
    test.t = difference / error;
    test.p = 2 * cdf(complement(distribution, std::abs(test.t)));
    const double reach = error * quantile(complement(distribution, 0.5 * (1 - confidence)));
    test.interval = {difference - reach, difference + reach};
    return test;
}

/// Number of ways in which m and n values can be ordered so that U is each of 0 to m n.
std::vector<double> ways_of_u(std::size_t m, std::size_t n)
{
    // f(m, n, u) = f(m - 1, n, u - n) + f(m, n - 1, u): the largest value is of the first list, above all n, or of the second.
    std::vector<std::vector<double>> row(n + 1, std::vector<double>{1});
    for (std::size_t i = 1; i <= m; ++i)
    {
        std::vector<std::vector<double>> next(n + 1);
        next[0] = {1};
        for (std::size_t j = 1; j <= n; ++j)
        {
            next[j].assign(i * j + 1, 0);
            for (std::size_t u = 0; u < row[j].size(); ++u) next[j][u + j] += row[j][u];
            for (std::size_t u = 0; u < next[j - 1].size(); ++u) next[j][u] += next[j - 1][u];
        }
        row = std::move(next);
    }
    return row[n];
}

double exact_p(double u, std::size_t m, std::size_t n)
{
    const std::vector<double> ways = ways_of_u(m, n);
    const double total = std::accumulate(ways.begin(), ways.end(), 0.0);
    const auto nearer_end = static_cast<std::size_t>(std::min(u, static_cast<double>(m * n) - u));
    const double tail = std::accumulate(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(nearer_end) + 1, 0.0);
    return std::min(1.0, 2 * tail / total);
}

/// @param ties sum of t^3 - t over the groups of t equal values
double approximate_p(double u, double m, double n, double ties)
{
    const double all = m + n;
    const double variance = m * n / 12 * (all + 1 - ties / (all * (all - 1)));
    if (!(variance > 0)) return 1;
    const double away = std::max(std::abs(u - 0.5 * m * n) - 0.5, 0.0); // u is a whole number, the distribution is not
    return std::min(1.0, 2 * cdf(complement(boost::math::normal(), away / std::sqrt(variance))));
}

double spread_of(std::span<const double> values)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    return 0.5 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / quantile(sorted, 0.5);
}

/// Ratios of medians of runs drawn again. Runs of one place are drawn together: what the machine did then hit both.
Interval bootstrap(std::span<const double> a, std::span<const double> b, const ComparisonOptions& options)
{
    std::mt19937_64 random(options.seed);
    const auto draw = [&random](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    std::vector<double> some_a(a.size());
    std::vector<double> some_b(b.size());
    std::vector<double> ratios(static_cast<std::size_t>(options.resamples));
    for (double& ratio : ratios)
    {
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            const std::size_t pick = draw(a.size());
            some_a[i] = a[pick];
            if (a.size() == b.size()) some_b[i] = b[pick];
        }
        if (a.size() != b.size()) std::generate(some_b.begin(), some_b.end(), [&] { return b[draw(b.size())]; });
        ratio = median(some_b) / median(some_a);
    }
    std::sort(ratios.begin(), ratios.end());
    const double tail = 0.5 * (1 - options.confidence);
    return {quantile(ratios, tail), quantile(ratios, 1 - tail)};
}

void check(std::span<const double> values)
{
    if (values.size() < 2) throw std::invalid_argument("a comparison needs at least two runs of each side");
    for (const double value : values)
        if (!(value > 0) || !std::isfinite(value)) throw std::invalid_argument("times of runs must be positive and finite");
}

Verdict judge(const Comparison& c, const ComparisonOptions& options)
{
    const bool is_told_apart = !c.interval.contains(1) && c.mann_whitney_p < 1 - options.confidence;
    if (!is_told_apart || std::abs(c.ratio - 1) < options.threshold) return Verdict::None;
    return c.ratio < 1 ? Verdict::Faster : Verdict::Slower;
}

} // namespace

std::string_view name_of(Verdict verdict)
{
    switch (verdict)
    {
    case Verdict::None: return "no difference";
    case Verdict::Faster: return "faster";
    case Verdict::Slower: return "slower";
    }
    return "?";
}

double median(std::span<const double> values)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : quantile(sorted, 0.5);
}

double geometric_mean(std::span<const double> values)
{
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return values.empty() ? 1 : std::exp(sum / static_cast<double>(values.size()));
}

TTest student_t_test(std::span<const double> a, std::span<const double> b, double confidence)
{
    const Moments ma = moments_of(a);
    const Moments mb = moments_of(b);
    const double degrees = ma.count + mb.count - 2;
    const double pooled = ((ma.count - 1) * ma.variance + (mb.count - 1) * mb.variance) / degrees;
    return t_test(mb.mean - ma.mean, std::sqrt(pooled * (1 / ma.count + 1 / mb.count)), degrees, confidence);
}

TTest welch_t_test(std::span<const double> a, std::span<const double> b, double confidence)
{
    const Moments ma = moments_of(a);
    const Moments mb = moments_of(b);
    const double va = ma.variance / ma.count;
    const double vb = mb.variance / mb.count;
    const double sum = va + vb;
    const double degrees = sum > 0 ? sum * sum / (va * va / (ma.count - 1) + vb * vb / (mb.count - 1)) : ma.count + mb.count - 2;
    return t_test(mb.mean - ma.mean, std::sqrt(sum), degrees, confidence);
}

RankTest mann_whitney(std::span<const double> a, std::span<const double> b)
{
    if (a.empty() || b.empty()) throw std::invalid_argument("a rank test needs values of both sides");
    RankTest test;
    for (const double x : a)
        for (const double y : b) test.u += x > y ? 1 : x == y ? 0.5 : 0;

    std::vector<double> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    std::sort(all.begin(), all.end());
    double ties = 0;
    for (auto group = all.begin(); group != all.end();)
    {
        const auto end = std::upper_bound(group, all.end(), *group);
        const auto count = static_cast<double>(end - group);
        ties += count * count * count - count;
        group = end;
    }
    constexpr std::size_t most_exact = 20;
    const bool is_exact = ties == 0 && a.size() <= most_exact && b.size() <= most_exact;
    test.p = is_exact ? exact_p(test.u, a.size(), b.size())
                      : approximate_p(test.u, static_cast<double>(a.size()), static_cast<double>(b.size()), ties);
    return test;
}

Comparison compare(std::span<const double> a, std::span<const double> b, const ComparisonOptions& options)
{
    check(a);
    check(b);
    Comparison c;
    c.median_a = median(a);
    c.median_b = median(b);
    c.ratio = c.median_b / c.median_a;
    c.interval = bootstrap(a, b, options);
    const RankTest ranks = mann_whitney(a, b);
    c.mann_whitney_u = ranks.u;
    c.mann_whitney_p = ranks.p;
    c.student = student_t_test(a, b, options.confidence);
    c.welch = welch_t_test(a, b, options.confidence);
    c.spread_a = spread_of(a);
    c.spread_b = spread_of(b);
    c.is_noisy = std::max(c.spread_a, c.spread_b) > options.noise;
    c.verdict = judge(c, options);
    return c;
}

} // namespace carom::lab
