// Reads the file, prints the table, draws the picture.
#include "cli/trace_command.hpp"

#include "cli/errors.hpp"
#include "cli/memory_picture.hpp"
#include "cli/outputs.hpp"
#include "files/input_file.hpp"
#include "files/text.hpp"
#include "lab/trace.hpp"

#include <fstream>

namespace carom::cli
{

namespace
{

lab::Trace read(const std::string& path)
{
    try
    {
        std::ifstream file = files::open_input(path);
        return lab::read_trace(file);
    }
    catch (const files::CannotRead& error)
    {
        throw BadUsage(std::string("trace: ") + error.what());
    }
    catch (const lab::TraceError& error)
    {
        throw BadUsage("trace: can't read " + files::quoted(path) + ": " + error.what());
    }
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
        throw BadUsage("--memory: " + files::quoted(path) + " tells nothing of memory; record one of a program that steps a world");
    return trace;
}

} // namespace

void trace_command(const TraceRequest& request, const Surroundings& surroundings)
{
    if (request.memory) files::require_ending("--memory", *request.memory, ".png");
    const lab::Trace trace = read(request.trace);
    if (trace.zones.empty())
        throw BadUsage("trace: " + files::quoted(request.trace) + " holds no zone; record one of a program that steps a world");
    Outputs outputs(surroundings);
    if (request.memory)
    {
        const lab::Trace drawn = with_memory(trace, request.trace);
        files::OutputFile& picture = outputs.open("--memory", *request.memory);
        draw_memory(drawn, picture.stream());
        picture.commit();
    }
    outputs.words() << files::printable(summary(trace) + "\n" + lab::zone_table(trace));
}

} // namespace carom::cli
