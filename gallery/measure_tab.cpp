// What steps and frames cost, and what they count.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace carom::gallery
{

namespace
{

void step_plot(const StageMeter& meter)
{
    char words[64];
    std::snprintf(words, sizeof words, "step %.3f ms, at most %.3f", meter.now().step_ms, static_cast<double>(meter.step_ms().largest()));
    ImGui::TextUnformatted(words);
    plot("##step", meter.step_ms(), 3.2f * ImGui::GetFontSize());
}

void stage_table(const StageMeter& meter)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("stages", 3, flags)) return;
    ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthStretch, 0.48f);
    ImGui::TableSetupColumn("us", ImGuiTableColumnFlags_WidthStretch, 0.17f);
    ImGui::TableSetupColumn("history", ImGuiTableColumnFlags_WidthStretch, 0.35f);
    ImGui::TableHeadersRow();
    for (int i = 0; i < stage_count; ++i)
    {
        const auto stage = static_cast<Stage>(i);
        ImGui::TableNextRow();
        cell(std::string(name_of(stage)));
        number_cell("%.1f", 1000 * meter.now().stage_ms[static_cast<std::size_t>(i)]);
        ImGui::TableNextColumn();
        ImGui::PushID(i);
        plot("##history", meter.stage_ms(stage), ImGui::GetTextLineHeight());
        ImGui::PopID();
    }
    ImGui::EndTable();
}

void counters(const StepReport& report)
{
    const std::array<std::pair<const char*, double>, 12> rows = {{
        {"bodies", report.bodies},
        {"awake", report.awake_bodies},
        {"islands awake", report.islands},
        {"shapes", report.shapes},
        {"pairs", report.pairs},
        {"contacts", report.contacts},
        {"rows", report.rows},
        {"colours", report.colors},
        {"overflow rows", report.overflow_rows},
        {"pairs tested", static_cast<double>(report.broad_phase.pairs_tested)},
        {"pairs found", static_cast<double>(report.broad_phase.pairs_found)},
        {"allocations", static_cast<double>(report.allocations)},
    }};
    if (!ImGui::BeginTable("counters", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    for (const auto& [name, value] : rows)
    {
        cell(name);
        number_cell("%.0f", value);
    }
    ImGui::EndTable();
    if (report.is_too_long) ImGui::TextWrapped("Substeps are too long for the contacts' stiffness: piles may sink. Raise substeps.");
}

void frame_table(const FrameMeter& frames)
{
    const FrameTimes& t = frames.recent();
    if (!ImGui::BeginTable("frame", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("part of a frame");
    ImGui::TableSetupColumn("CPU ms");
    ImGui::TableSetupColumn("GPU ms");
    ImGui::TableHeadersRow();
    const auto row = [](const char* name, double cpu, double gpu)
    {
        ImGui::TableNextRow();
        cell(name);
        number_cell("%.2f", cpu);
        if (gpu >= 0)
            number_cell("%.2f", gpu);
        else
            cell("");
    };
    row("steps", t.step, -1);
    row("draw", t.draw, t.draw_gpu);
    row("panels", t.panels, t.panels_gpu);
    row("present", t.present, -1);
    tip_of_last("handing the frame to the screen and waiting for it; a renderer without a graphics card draws here");
    row("frame to frame", t.whole, -1);
    ImGui::EndTable();
}

} // namespace

void measure_tab(Gallery& gallery)
{
    const StageMeter& meter = gallery.session.meter();
    heading("Step");
    step_plot(meter);
    stage_table(meter);
    heading("Counts");
    counters(meter.latest());
    heading("Frame");
    frame_table(gallery.frames);
}

} // namespace carom::gallery
