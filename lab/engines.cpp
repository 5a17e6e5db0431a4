// Finds the engines' programs.
#include "lab/engines.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace carom::lab
{

namespace
{

constexpr std::string_view from_source = "box2d3-source";
constexpr std::array<std::string_view, 6> names = {"carom", "box2d3", from_source, "rapier", "box2d2", "origin"};

std::filesystem::path program_of(std::string_view name, const std::filesystem::path& peers)
{
    return peers / ("carom-peer-" + std::string(name));
}

bool is_there(const std::filesystem::path& program)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(program, ignored);
}

Engine engine_named(const std::string& name, const std::filesystem::path& carom, const std::filesystem::path& peers)
{
    if (name == "carom") return {.name = name, .command = {carom.string(), "lab", "step"}, .missing = ""};
    if (name == "origin") return {.name = name, .command = {carom.string(), "lab", "step", "--broadphase", "Quadtree"}, .missing = ""};
    const std::filesystem::path program = program_of(name, peers);
    if (is_there(program)) return {.name = name, .command = {program.string()}, .missing = ""};
    return {.name = name,
            .command = {},
            .missing =
                "there is no " + program.string() + "; `./dev peers" + (name == from_source ? " box2d3 --source DIR" : "") + "` builds it"};
}

} // namespace

std::span<const std::string_view> engine_names() { return names; }

std::vector<std::string> default_engines(const std::filesystem::path& peers)
{
    std::vector<std::string> some;
    for (const std::string_view name : names)
        if (name != from_source || is_there(program_of(name, peers))) some.emplace_back(name);
    return some;
}

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
