// Reads the file, prints the table, draws the picture.
#include "cli/trace_command.hpp"

#include "cli/errors.hpp"
#include "cli/memory_picture.hpp"
#include "cli/pending_file.hpp"
#include "lab/trace.hpp"
#include "scenes/text.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace carom::cli
{

namespace
{

lab::Trace read(const std::string& path)
{
    const auto refuse = [&](const std::string& why) { throw BadUsage("trace: can't read \"" + path + "\": " + why); };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) refuse("it is a folder; give a file");
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(std::strerror(errno));
    try
    {
        return lab::read_trace(file);
    }
    catch (const lab::TraceError& error)
    {
        refuse(error.what());
    }
    return {};
}

std::string counted(std::size_t count, const std::string& thing) { return std::to_string(count) + " " + thing + (count == 1 ? "" : "s"); }

std::string summary(const lab::Trace& trace)
{
    std::string text = counted(trace.zones.size(), "zone") + ", " + counted(trace.frames_us.size(), "frame") + ", " +
                       counted(trace.plots.size(), "plot") + ", " + counted(trace.memory.size(), "pool") + " of memory\n";
    if (trace.dropped > 0) text += counted(trace.dropped, "event") + " found no room when it was recorded: the end is missing\n";
    return text;
}

/// What the picture shows: the pools, or, of a trace without memory events, what the world itself says.
lab::Trace with_memory(lab::Trace trace, const std::string& path)
{
    const auto plot = trace.plots.find("bytes in use");
    if (trace.memory.empty() && plot != trace.plots.end()) trace.memory["bytes in use"] = plot->second;
    if (trace.memory.empty())
        throw BadUsage("--memory: \"" + path + "\" tells nothing of memory; record one of a program that steps a world");
    return trace;
}

void draw(const lab::Trace& trace, const std::string& path)
{
    PendingFile picture("--memory", path);
    draw_memory(trace, picture.temporary());
    picture.commit();
}

} // namespace

void trace_command(const TraceRequest& request, const Surroundings& surroundings)
{
    if (request.memory && scenes::lower_case(std::filesystem::path(*request.memory).extension().string()) != ".png")
        throw BadUsage("--memory: \"" + *request.memory + "\" has an unknown format; give a name that ends in .png");
    const lab::Trace trace = read(request.trace);
    if (trace.zones.empty()) throw BadUsage("trace: \"" + request.trace + "\" holds no zone; record one of a program that steps a world");
    if (request.memory) draw(with_memory(trace, request.trace), *request.memory);
    surroundings.out << summary(trace) << "\n" << lab::zone_table(trace);
}

} // namespace carom::cli
