// What the world holds, by category, and how that changed.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <carom/memory.hpp>

namespace carom::gallery
{

namespace
{

void category_table(const StageMeter& meter)
{
    const MemoryReport& memory = meter.latest().memory;
    if (!ImGui::BeginTable("memory", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("category", ImGuiTableColumnFlags_WidthStretch, 0.28f);
    ImGui::TableSetupColumn("in use", ImGuiTableColumnFlags_WidthStretch, 0.24f);
    ImGui::TableSetupColumn("peak", ImGuiTableColumnFlags_WidthStretch, 0.24f);
    ImGui::TableSetupColumn("history", ImGuiTableColumnFlags_WidthStretch, 0.24f);
    ImGui::TableHeadersRow();
    for (int i = 0; i < memory_category_count; ++i)
    {
        const auto category = static_cast<MemoryCategory>(i);
        const MemoryStats& stats = memory.of(category);
        ImGui::TableNextRow();
        cell(std::string(name_of(category)));
        right_cell(bytes_text(static_cast<double>(stats.bytes)));
        right_cell(bytes_text(static_cast<double>(stats.peak_bytes)));
        ImGui::TableNextColumn();
        ImGui::PushID(i);
        plot("##history", meter.bytes(category), ImGui::GetTextLineHeight());
        ImGui::PopID();
    }
    ImGui::EndTable();
}

} // namespace

void memory_tab(Gallery& gallery)
{
    const StageMeter& meter = gallery.session.meter();
    const MemoryStats& total = meter.latest().memory.total;
    heading("Memory of the world");
    ImGui::Text("%s in %zu blocks, peak %s", bytes_text(static_cast<double>(total.bytes)).c_str(), total.blocks,
                bytes_text(static_cast<double>(total.peak_bytes)).c_str());
    plot("##bytes", meter.bytes(), 4 * ImGui::GetFontSize());
    ImGui::Text("%zu allocations in the last step", meter.latest().allocations);
    category_table(meter);
    muted("Every byte of a world comes from one memory resource. Once a scene is warm, a step asks for none.");
}

} // namespace carom::gallery
