// Speaks to a person who sees the inside of a step for the first time.
#include "gallery/moment_words.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

namespace carom::gallery
{

namespace
{

const char* explanation_of(Stage stage)
{
    switch (stage)
    {
    case Stage::FindPairs:
        return "The broad phase looks for shapes whose fattened bounds overlap. Bounds are fattened so that a shape can move a little "
               "before it must be looked at again. New pairs are orange.";
    case Stage::UpdateManifolds:
        return "Each pair is collided exactly: up to two points where the shapes touch or nearly touch, and the normal along which they "
               "push. Points that were there in the step before keep their impulses.";
    case Stage::BuildRows:
        return "Each contact becomes a row of the solver. Contacts get a colour such that no two of one colour share a moving body: a "
               "whole colour can then be solved at once, in SIMD lanes. A line joins the bodies of each contact in its colour; bodies are "
               "tinted by their island.";
    case Stage::Restitution:
        return "What meets fast enough bounces, pair by pair, before the substeps: each gets back the part of its speed that its "
               "restitution says.";
    case Stage::IntegrateVelocities: return "Gravity, fields, forces and damping change the velocities. Arrows are 0.1 s of motion.";
    case Stage::WarmStart:
        return "The impulses of the substep before are applied again. They are nearly right already, so that the solver has little left to "
               "do.";
    case Stage::Solve:
        return "Row by row, impulses are added until nothing approaches. A soft spring pushes overlap out, which makes the velocities a "
               "little too fast until the rows are relaxed. Arrows are impulses.";
    case Stage::IntegratePositions: return "The bodies move by their velocities for a substep.";
    case Stage::Relax:
        return "The rows are solved once more without the push against overlap: the speed that it added is taken out again. Friction is "
               "solved here.";
    case Stage::StoreImpulses: return "The impulses are kept for the next step's warm start, and joints that were pulled too hard break.";
    case Stage::FinalizeBodies: return "Bodies get their new places, and bounds that left their fattened ones are marked.";
    case Stage::Continuous:
        return "Bodies that moved more than half their size are set back to where they first met something on their way.";
    case Stage::EmitEvents: return "What touches now is compared with what touched before: contacts that begin, go on, and end.";
    case Stage::Sleep:
        return "Islands, bodies that touch or are joined, go to sleep when all of them have been slow for long enough. Each has its "
               "colour.";
    }
    return "";
}

std::string count(std::size_t number, const char* one, const char* many)
{
    return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string with_unit(const char* what, double value, const char* unit)
{
    char text[64];
    std::snprintf(text, sizeof text, "%s %.3g %s", what, value, unit);
    return text;
}

double total_impulse(const Moment& moment)
{
    double sum = 0;
    for (const DebugContact& contact : moment.contacts) sum += static_cast<double>(contact.manifold.total_normal_impulse());
    return sum;
}

double top_speed(const Moment& moment)
{
    float top = 0;
    for (const DebugBody& body : moment.bodies) top = std::max(top, length(body.linear_velocity));
    return static_cast<double>(top);
}

std::string count_pairs(const Moment& moment)
{
    const auto is_new = [](const FilmPair& pair) { return pair.is_new; };
    const auto fresh = std::count_if(moment.pairs.begin(), moment.pairs.end(), is_new);
    return count(moment.pairs.size(), "pair", "pairs") + ", " + std::to_string(fresh) + " of them new";
}

std::string count_points(const Moment& moment)
{
    std::size_t points = 0;
    for (const DebugContact& contact : moment.contacts) points += static_cast<std::size_t>(contact.manifold.point_count);
    return count(moment.contacts.size(), "contact", "contacts") + " with " + count(points, "point", "points");
}

std::string count_colors(const Moment& moment)
{
    std::set<int> colors;
    for (const DebugContact& contact : moment.contacts)
        if (contact.color >= 0) colors.insert(contact.color);
    return count(moment.contacts.size(), "contact", "contacts") + " in " + count(colors.size(), "colour", "colours");
}

std::string count_islands(const Moment& moment)
{
    std::set<int> islands;
    std::size_t awake = 0;
    for (const DebugBody& body : moment.bodies)
    {
        if (body.island >= 0 && body.is_awake) islands.insert(body.island);
        awake += body.is_awake ? 1u : 0u;
    }
    return std::to_string(awake) + " of " + count(moment.bodies.size(), "body", "bodies") + " awake, in " +
           count(islands.size(), "island", "islands");
}

} // namespace

std::string title_of(const Moment& moment)
{
    if (moment.is_start) return "start of the step";
    std::string title(name_of(moment.when.stage));
    if (moment.when.substep >= 0)
        title += ", substep " + std::to_string(moment.when.substep + 1) + " of " + std::to_string(moment.when.substeps);
    return title;
}

std::string explanation_of(const Moment& moment)
{
    return moment.is_start ? "The world as the step before left it, with what was changed since." : explanation_of(moment.when.stage);
}

std::string counts_of(const Moment& moment)
{
    if (moment.is_start) return count_islands(moment);
    switch (moment.when.stage)
    {
    case Stage::FindPairs: return count_pairs(moment);
    case Stage::UpdateManifolds:
    case Stage::EmitEvents: return count_points(moment);
    case Stage::BuildRows: return count_colors(moment);
    case Stage::Restitution:
    case Stage::WarmStart:
    case Stage::Solve:
    case Stage::Relax:
    case Stage::StoreImpulses: return with_unit("impulses along normals add up to", total_impulse(moment), "N s");
    case Stage::IntegrateVelocities:
    case Stage::IntegratePositions:
    case Stage::FinalizeBodies:
    case Stage::Continuous: return with_unit("the fastest body moves at", top_speed(moment), "m/s");
    case Stage::Sleep: return count_islands(moment);
    }
    return {};
}

} // namespace carom::gallery
