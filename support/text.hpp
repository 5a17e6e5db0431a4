// Words for messages: lists, and a guess at which name was meant, by how many letters differ.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom::support
{

/// How many letters must be changed, added or taken away to make one word of the other (Levenshtein's distance).
inline std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const std::size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// "a, b, c".
inline std::string joined(std::span<const std::string> words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

inline std::string lower_case(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

/// Of the candidates the one that `name` is likely a slip of; empty when none is close.
inline std::string closest(std::string_view name, std::span<const std::string> candidates)
{
    constexpr std::size_t longest = 64; // nobody mistypes a name into more; bounds the work on hostile input
    if (name.size() > longest) return {};
    const std::string wanted = lower_case(name);
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(1, name.size() / 2);
    for (const std::string& candidate : candidates)
    {
        const std::size_t distance = edit_distance(wanted, lower_case(candidate));
        if (distance < best_distance || (distance == best_distance && best.empty()))
        {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

/// What to try instead of a name that does not exist: "did you mean circles?", or all that there are.
inline std::string suggestion(std::string_view name, std::span<const std::string> candidates)
{
    const std::string near = closest(name, candidates);
    return near.empty() ? "there are " + joined(candidates) : "did you mean " + near + "?";
}

} // namespace carom::support
