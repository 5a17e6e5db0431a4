// Sets every engine against the base.
#include "lab/report.hpp"

#include <algorithm>
#include <array>

namespace carom::lab
{

namespace
{

constexpr std::array all_metrics = {
    Metric{"deepest_penetration_m", "deepest penetration [m]", 0.005},
    Metric{"mean_penetration_m", "mean penetration [m]", 0.001},
    Metric{"joint_separation_m", "joint separation [m]", 0.002},
    Metric{"rest_energy_j_per_kg", "energy at rest [J/kg]", 0.001},
    Metric{"drift_m", "drift of what stands [m]", 0.01},
    Metric{"energy_error", "energy error", 0.01},
    Metric{"momentum_error", "momentum error", 0.001},
    Metric{"escapes", "escapes", 0.5},
    Metric{"tunnelled", "tunnelled", 0.5},
    Metric{"lost", "bodies lost to NaN", 0.5},
};

/// A metric counts as worse when it is half as large again and not too small to matter.
bool is_clearly_worse(const Metric& metric, double value, double other)
{
    constexpr double clearly = 1.5;
    return value > metric.floor && value > clearly * other;
}

std::vector<std::string> worse_in(const EngineResult& a, const EngineResult& b)
{
    std::vector<std::string> names;
    for (const Metric& metric : all_metrics)
    {
        const auto of_a = a.quality.find(metric.name);
        const auto of_b = b.quality.find(metric.name);
        const bool has_both = of_a != a.quality.end() && of_b != b.quality.end();
        if (has_both && is_clearly_worse(metric, of_a->second, of_b->second)) names.emplace_back(metric.name);
    }
    return names;
}

ReportRow row_of(const EngineResult& engine, const EngineResult* base, const ComparisonOptions& options)
{
    ReportRow row{.result = &engine, .median_ms = median(engine.run_ms), .comparison = {}, .worse_in = {}, .better_in = {}};
    const bool has_both = base && base != &engine && base->outcome == Outcome::Done && engine.outcome == Outcome::Done;
    if (!has_both) return row;
    if (base->run_ms.size() >= 2 && engine.run_ms.size() >= 2) row.comparison = compare(base->run_ms, engine.run_ms, options);
    row.worse_in = worse_in(engine, *base);
    row.better_in = worse_in(*base, engine);
    return row;
}

/// @param suite of the means to which a case is added
void add_to_means(const ReportCase& one, const std::string& suite, std::vector<ReportMean>& means, std::vector<std::vector<double>>& ratios)
{
    for (const ReportRow& row : one.rows)
    {
        if (!row.comparison) continue;
        const auto is_it = [&](const ReportMean& mean)
        { return mean.suite == suite && mean.engine == row.result->engine && mean.threads == one.result->threads; };
        auto place = std::find_if(means.begin(), means.end(), is_it);
        if (place == means.end())
        {
            means.push_back({.suite = suite, .engine = row.result->engine, .threads = one.result->threads, .cases = 0, .ratio = 1});
            ratios.emplace_back();
            place = means.end() - 1;
        }
        ratios[static_cast<std::size_t>(place - means.begin())].push_back(row.comparison->ratio);
    }
}

} // namespace

std::span<const Metric> metrics() { return all_metrics; }

Report evaluate(const Results& results, const std::string& base, const ComparisonOptions& options)
{
    Report report{.results = &results, .base = base, .cases = {}, .means = {}, .is_noisy = false};
    std::vector<std::vector<double>> ratios;
    for (const CaseResult& result : results.cases)
    {
        ReportCase one{.result = &result, .rows = {}};
        for (const EngineResult& engine : result.engines)
        {
            one.rows.push_back(row_of(engine, result.find(base), options));
            const std::optional<Comparison>& comparison = one.rows.back().comparison;
            report.is_noisy = report.is_noisy || (comparison && comparison->is_noisy);
        }
        report.cases.push_back(std::move(one));
    }
    for (const ReportCase& one : report.cases) add_to_means(one, "all", report.means, ratios);
    const auto is_other = [&](const CaseResult& one) { return one.suite != results.cases.front().suite; };
    const bool has_many_suites = std::any_of(results.cases.begin(), results.cases.end(), is_other);
    for (const ReportCase& one : report.cases)
        if (has_many_suites) add_to_means(one, one.result->suite, report.means, ratios);
    for (std::size_t i = 0; i < ratios.size(); ++i)
    {
        report.means[i].cases = static_cast<int>(ratios[i].size());
        report.means[i].ratio = geometric_mean(ratios[i]);
    }
    return report;
}

} // namespace carom::lab
