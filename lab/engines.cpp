// Finds the engines' programs.
#include "lab/engines.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace carom::lab
{

namespace
{

constexpr std::array<std::string_view, 5> names = {"carom", "box2d3", "rapier", "box2d2", "origin"};

Engine engine_named(const std::string& name, const std::filesystem::path& carom, const std::filesystem::path& peers)
{
    if (name == "carom") return {.name = name, .command = {carom.string(), "lab", "step"}, .missing = ""};
    if (name == "origin") return {.name = name, .command = {carom.string(), "lab", "step", "--broadphase", "Quadtree"}, .missing = ""};
    const std::filesystem::path program = peers / ("carom-peer-" + name);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(program, ignored)) return {.name = name, .command = {program.string()}, .missing = ""};
    return {.name = name, .command = {}, .missing = "there is no " + program.string() + "; `./dev peers` builds it"};
}

} // namespace

std::span<const std::string_view> engine_names() { return names; }

std::vector<Engine> find_engines(std::span<const std::string> wanted, const std::filesystem::path& carom,
                                 const std::filesystem::path& peers)
{
    std::vector<Engine> engines;
    for (const std::string& name : wanted)
    {
        if (std::find(names.begin(), names.end(), name) == names.end())
        {
            std::string known;
            for (const std::string_view one : names) known += (known.empty() ? "" : ", ") + std::string(one);
            throw std::invalid_argument("engine \"" + name + "\" is not known; give some of " + known);
        }
        engines.push_back(engine_named(name, carom, peers));
    }
    return engines;
}

} // namespace carom::lab
