// Compares where results come from, setting by setting.
#include "lab/resume.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace carom::lab
{

namespace
{

struct Setting
{
    std::string name;
    std::string before;
    std::string now;
};

std::vector<Setting> settings_of(const Results& earlier, const Plan& plan, const Origin& here)
{
    const Origin& there = earlier.origin;
    return {{"commit", there.commit, here.commit},
            {"version", there.version, here.version},
            {"compiler", there.compiler, here.compiler},
            {"flags", there.flags, here.flags},
            {"processor", there.processor, here.processor},
            {"number of cores", std::to_string(there.cores), std::to_string(here.cores)},
            {"system", there.system, here.system},
            {"suite", earlier.suite, plan.suite},
            {"number of runs", std::to_string(earlier.runs), std::to_string(plan.runs)}};
}

std::string shown(const std::string& text) { return text.empty() ? "unknown" : "\"" + text + "\""; }

std::string names_of(const std::vector<EngineProgram>& engines)
{
    std::string names;
    for (const EngineProgram& engine : engines) names += (names.empty() ? "" : ",") + engine.name;
    return names;
}

/// What is not as it was; empty when all is.
std::string difference(const Results& earlier, const Plan& plan, const Origin& here)
{
    for (const Setting& setting : settings_of(earlier, plan, here))
        if (setting.before != setting.now) return "the " + setting.name + " was " + shown(setting.before) + " and is " + shown(setting.now);
    const std::vector<EngineProgram> engines = programs_of(plan.engines);
    if (names_of(earlier.engines) != names_of(engines))
        return "the engines were " + shown(names_of(earlier.engines)) + " and are " + shown(names_of(engines));
    for (std::size_t i = 0; i < engines.size(); ++i)
        if (engines[i].fingerprint != earlier.engines[i].fingerprint)
            return "the program of the engine " + engines[i].name + " is another one";
    return {};
}

bool has_failed(const CaseResult& one)
{
    return std::any_of(one.engines.begin(), one.engines.end(), [](const EngineResult& e) { return e.outcome == Outcome::Failed; });
}

/// Why a case can't stand for a planned one; empty when it can.
std::string difference(const CaseResult& earlier, const PlannedCase& planned)
{
    if (earlier.fingerprint != planned.fingerprint) return "the scene is another one now";
    return has_failed(earlier) ? "an engine failed on it" : "";
}

} // namespace

Resumption resume(const Results& earlier, const Plan& plan, const Origin& here)
{
    Resumption result;
    result.why_not = difference(earlier, plan, here);
    if (result.why_not.empty())
        for (const PlannedCase& planned : plan.cases)
        {
            const auto is_it = [&](const CaseResult& one) { return one.scene == planned.scene && one.threads == planned.threads; };
            const auto found = std::find_if(earlier.cases.begin(), earlier.cases.end(), is_it);
            if (found == earlier.cases.end()) continue;
            const std::string why = difference(*found, planned);
            if (why.empty())
                result.kept.push_back(*found);
            else
                result.why_not += (result.why_not.empty() ? "" : "; ") + planned.scene + ": " + why;
        }
    result.is_complete = result.kept.size() == earlier.cases.size();
    return result;
}

} // namespace carom::lab
