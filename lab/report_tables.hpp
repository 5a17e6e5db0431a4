// The tables and lines of which reports are made, whatever their format.
#pragma once

#include "lab/report.hpp"
#include "lab/table.hpp"

namespace carom::lab
{

Table time_table(const Report& report);
Table parts_table(const Report& report); ///< of the cases that have events or rays; empty when there are none
Table quality_table(const Report& report);
Table mean_table(const Report& report);

std::string time_words(const Report& report); ///< how to read the tables
std::string parts_words();
std::string quality_words();
/// What was measured, how often, and with what.
std::string origin_line(const Origin& origin, const std::string& suite, int runs);
std::string origin_line(const Results& results);
std::string interval_text(const Interval& interval, int digits = 3);
/// "faster", "no difference, noisy".
std::string verdict_text(const Comparison& comparison);
std::string noise_line(const Report& report); ///< empty when it was quiet
/// "carom 0.1.0, avx2; box2d3 3.2.0 (1234567), AVX2": of every engine that ran, in the order of the results, what it said that it is.
std::string engines_line(const Report& report);
std::vector<std::string> difference_lines(const Report& report);
std::string joined(const std::vector<std::string>& words, const std::string& between);

} // namespace carom::lab
