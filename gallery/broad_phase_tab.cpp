// Switches the broad phase of the running scene, and shows what that changes.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <cstdio>

namespace carom::gallery
{

namespace
{

const char* story_of(BroadPhaseType type)
{
    switch (type)
    {
    case BroadPhaseType::BruteForce:
        return "Every shape is tested against every other: the reference, whose cost grows with the square of their number.";
    case BroadPhaseType::QuadtreeNaive:
        return "A shape lies in every square that it touches, and a hash set keeps pairs from coming twice: what one writes first.";
    case BroadPhaseType::QuadtreeWithSet:
        return "A shape lies once, in the deepest square that holds it whole, so that no pair comes twice; the hash set is still asked.";
    case BroadPhaseType::Quadtree:
        return "A shape lies once, in the deepest square that holds it whole. A full square divides into four. No set is needed.";
    case BroadPhaseType::Tree: return "A wide tree of bounding boxes, of which four are tested at once. It is walked against itself.";
    }
    return "";
}

void choose(Gallery& gallery)
{
    const BroadPhaseType now = gallery.session.scene().world().broad_phase();
    for (const BroadPhaseType type : all_broad_phases)
    {
        const std::string name(name_of(type));
        if (ImGui::RadioButton(name.c_str(), type == now)) gallery.session.set_parameter("broad_phase", name);
        gallery.widgets.note(name);
        if (type == BroadPhaseType::BruteForce || type == BroadPhaseType::QuadtreeWithSet) ImGui::SameLine(11 * ImGui::GetFontSize());
    }
    muted(story_of(now));
}

/// A row whose two values stand side by side, with the ratio of the new to the old where that says something about the broad phase.
void row(const char* name, const char* format, double now, const StepMeans* before, double old, bool has_ratio = true)
{
    ImGui::TableNextRow();
    cell(name);
    if (before)
        number_cell(format, old);
    else
        cell("");
    number_cell(format, now);
    if (has_ratio && before && old > 0)
        number_cell("%.2f", now / old);
    else
        cell("");
}

/// A table whose columns are before, now, and their ratio.
bool begin_comparison(const char* what, const StepMeans& now, const StepMeans* before)
{
    if (!ImGui::BeginTable(what, 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return false;
    ImGui::TableSetupColumn(what, ImGuiTableColumnFlags_WidthStretch, 0.38f);
    ImGui::TableSetupColumn(before ? name_of(before->broad_phase).data() : "before", ImGuiTableColumnFlags_WidthStretch, 0.26f);
    ImGui::TableSetupColumn(name_of(now.broad_phase).data(), ImGuiTableColumnFlags_WidthStretch, 0.22f);
    ImGui::TableSetupColumn("ratio", ImGuiTableColumnFlags_WidthStretch, 0.14f);
    ImGui::TableHeadersRow();
    return true;
}

void comparison(const StageMeter& meter)
{
    const StepMeans& now = meter.now();
    const StepMeans* before = meter.before() ? &*meter.before() : nullptr;
    if (begin_comparison("counts of a step", now, before))
    {
        row("pairs tested", "%.0f", now.pairs_tested, before, before ? before->pairs_tested : 0);
        row("pairs found", "%.1f", now.pairs_found, before, before ? before->pairs_found : 0, false);
        row("nodes", "%.0f", now.nodes, before, before ? before->nodes : 0);
        ImGui::EndTable();
    }
    if (!begin_comparison("times [us]", now, before)) return;
    row("step", "%.1f", 1000 * now.step_ms, before, before ? 1000 * before->step_ms : 0);
    for (std::size_t i = 0; i < stage_count; ++i)
        row(name_of(static_cast<Stage>(i)).data(), "%.1f", 1000 * now.stage_ms[i], before, before ? 1000 * before->stage_ms[i] : 0);
    ImGui::EndTable();
}

} // namespace

void broad_phase_tab(Gallery& gallery)
{
    heading("Broad phase");
    choose(gallery);
    heading("Before and after the switch");
    comparison(gallery.session.meter());
    char words[224];
    std::snprintf(
        words, sizeof words,
        "Means over up to %d steps before the switch and %d after it; the scene has moved on in between. All broad phases find the same "
        "pairs: it goes on to the same bits.",
        StageMeter::window, gallery.session.meter().now().steps);
    muted(words);
}

} // namespace carom::gallery
