// Which measurements of an earlier run of the laboratory can stand in a new one.
#pragma once

#include "lab/experiment.hpp"

#include <string>
#include <vector>

namespace carom::lab
{

struct Resumption
{
    std::vector<CaseResult> kept; ///< for Plan::finished
    /// Why nothing is kept, or why some scenes are measured again: "the commit was 1234567890 and is abcdef0123". Empty when all is kept.
    std::string why_not;
    bool is_complete = true; ///< whether every case of the earlier results is kept
};

/// Measurements are kept when they were made on this machine, by the same build (commit, compiler, flags) and the same engine programs, with
/// the same number of runs, on a scene file with the same bytes, and no engine failed.
Resumption resume(const Results& earlier, const Plan& plan, const Origin& here);

} // namespace carom::lab
