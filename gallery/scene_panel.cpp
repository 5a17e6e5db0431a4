// The panel on the left: which scene, what it is about, and its parameters.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"
#include "scenes/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

namespace carom::gallery
{

namespace
{

using scenes::Applies;
using scenes::Control;
using scenes::ParameterInfo;
using scenes::ParameterKind;
using scenes::ParameterValue;
using scenes::SceneInfo;

bool is_found(const SceneInfo& info, const std::string& search)
{
    const std::string all = scenes::lower_case(info.name + " " + info.title + " " + info.group + " " + info.description);
    return all.find(scenes::lower_case(search)) != std::string::npos;
}

/// The scenes of the list: what is built in, and the files that were opened.
std::vector<const SceneSource*> listed_sources(const Gallery& gallery)
{
    std::vector<const SceneSource*> sources;
    for (const std::vector<SceneSource>& list : {std::cref(catalogue()), std::cref(gallery.session.opened_files())})
        for (const SceneSource& source : list)
            if (is_found(source.info(), gallery.search)) sources.push_back(&source);
    return sources;
}

void scene_row(Gallery& gallery, const SceneSource& source, bool scrolls_here)
{
    const SceneInfo& info = source.info();
    const bool is_open = info.name == gallery.session.source().info().name;
    ImGui::PushID(info.name.c_str());
    const bool is_clicked = ImGui::Selectable(info.title.c_str(), is_open);
    ImGui::PopID();
    gallery.widgets.note("scene " + info.name);
    tip_of_last(source.file().empty() ? info.description : source.file().string());
    if (is_open && scrolls_here && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
    if (!is_clicked) return;
    gallery.listed = info.name; // it is in view already
    source.file().empty() ? gallery.session.open(source) : gallery.session.open_file(source.file());
}

/// The title of a group with an arrow; a click folds the group. A search shows what it finds all the same.
bool group_title(Gallery& gallery, const std::string& group)
{
    const bool is_searching = !gallery.search.empty();
    ImGui::SetNextItemOpen(is_searching || !gallery.folded.contains(group));
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool is_open = ImGui::TreeNodeEx(group.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    ImGui::PopStyleColor();
    gallery.widgets.note("group " + group);
    if (is_searching) return true;
    is_open ? static_cast<void>(gallery.folded.erase(group)) : static_cast<void>(gallery.folded.insert(group));
    return is_open;
}

void scene_groups(Gallery& gallery, bool scrolls)
{
    const std::vector<const SceneSource*> sources = listed_sources(gallery);
    std::vector<std::string> groups; // in the order in which the list names them first
    for (const SceneSource* source : sources)
        if (std::find(groups.begin(), groups.end(), source->info().group) == groups.end()) groups.push_back(source->info().group);
    for (const std::string& group : groups)
    {
        if (!group_title(gallery, group)) continue;
        ImGui::Indent(0.9f * ImGui::GetFontSize());
        for (const SceneSource* source : sources)
            if (source->info().group == group) scene_row(gallery, *source, scrolls);
        ImGui::Unindent(0.9f * ImGui::GetFontSize());
    }
    if (sources.empty()) muted("No scene has \"" + gallery.search + "\" in its title, group or description.");
}

/// How the gallery's pointer reaches what the scene does with it.
std::string input_text(const Control& control)
{
    if (control.kind == Control::Kind::Key)
        return control.input.size() == 1 ? std::string(1, static_cast<char>(std::toupper(control.input[0]))) : control.input;
    if (control.input == "wheel") return "Shift wheel";
    return control.input == "move" ? "pointer" : control.input + " click";
}

/// These have places of their own in other panels.
bool has_own_place(const std::string& name)
{
    constexpr std::array<std::string_view, 5> names = {"broad_phase", "step_rate", "substeps", "show_squares", "show_bounds"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// "planet_mass" reads "planet mass".
std::string label_of(const ParameterInfo& info)
{
    std::string label = info.name;
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

std::string format_of(const ParameterInfo& info)
{
    std::string unit = info.unit;
    for (std::size_t i = unit.find('%'); i != std::string::npos; i = unit.find('%', i + 2)) unit.insert(i, "%");
    return (info.kind == ParameterKind::Integer ? "%lld" : "%.4g") + (unit.empty() ? std::string() : " " + unit);
}

bool number_widget(const ParameterInfo& info, ParameterValue& value)
{
    const std::string format = format_of(info);
    ImGuiSliderFlags flags = 0;
    const bool spans_magnitudes = info.min > 0 && info.max / info.min > 500;
    if (spans_magnitudes) flags |= ImGuiSliderFlags_Logarithmic;
    if (info.kind == ParameterKind::Real)
        return slider("##value", ImGuiDataType_Double, &std::get<double>(value), &info.min, &info.max, format.c_str(), flags);
    const auto min = static_cast<std::int64_t>(info.min);
    const auto max = static_cast<std::int64_t>(info.max);
    return slider("##value", ImGuiDataType_S64, &std::get<std::int64_t>(value), &min, &max, format.c_str(), flags);
}

bool choice_widget(const ParameterInfo& info, ParameterValue& value)
{
    auto& chosen = std::get<std::string>(value);
    bool is_changed = false;
    if (!ImGui::BeginCombo("##value", chosen.c_str())) return false;
    for (const std::string& choice : info.choices)
    {
        if (!ImGui::Selectable(choice.c_str(), choice == chosen)) continue;
        chosen = choice;
        is_changed = true;
    }
    ImGui::EndCombo();
    return is_changed;
}

std::string tip_of(const ParameterInfo& info)
{
    std::string tip = info.description + "\n" + scenes::allowed_values(info);
    const bool is_number = info.kind == ParameterKind::Real || info.kind == ParameterKind::Integer;
    if (is_number) tip += "; Ctrl and a click let you type it";
    if (info.applies == Applies::OnRestart) tip += "\nThe scene starts again with it.";
    return tip;
}

/// A number that acts by a restart waits until the person lets go of it: a slider would restart the scene in every frame.
void parameter_widget(Gallery& gallery, const ParameterInfo& info)
{
    Session& session = gallery.session;
    const bool is_pending = gallery.edited && gallery.edited->first == info.name;
    ParameterValue value = is_pending ? gallery.edited->second : session.scene().parameters().value(info.name);
    ImGui::PushID(info.name.c_str());
    ImGui::PushItemWidth(-FLT_MIN);
    bool is_changed = false;
    const bool is_number = info.kind == ParameterKind::Real || info.kind == ParameterKind::Integer;
    if (info.kind == ParameterKind::Boolean)
        is_changed = ImGui::Checkbox("##value", &std::get<bool>(value));
    else if (info.kind == ParameterKind::Choice)
        is_changed = choice_widget(info, value);
    else
        is_changed = number_widget(info, value);
    const bool is_let_go = ImGui::IsItemDeactivatedAfterEdit();
    const bool acts = is_meant(is_changed);
    gallery.widgets.note("parameter " + info.name);
    tip_of_last(tip_of(info));
    ImGui::PopItemWidth();
    ImGui::PopID();

    const bool waits = is_number && info.applies == Applies::OnRestart;
    if (waits && is_changed) gallery.edited = {info.name, value};
    if (waits ? is_let_go : acts)
    {
        gallery.edited.reset();
        session.set_parameter(info.name, value);
    }
}

} // namespace

void scene_list(Gallery& gallery, float height)
{
    const std::string open = gallery.session.source().info().name; // a click below may open another
    const bool is_other = gallery.listed != open;
    if (is_other) gallery.folded.erase(gallery.session.source().info().group);
    if (is_other) gallery.listed = open;
    ImGui::BeginChild("scenes", {0, height});
    scene_groups(gallery, is_other);
    ImGui::EndChild();
}

void scene_story(const Gallery& gallery)
{
    const SceneInfo& info = gallery.session.scene().info();
    heading(info.title.c_str());
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(info.description.c_str());
    ImGui::PopTextWrapPos();
}

void scene_controls(const Gallery& gallery)
{
    const SceneInfo& info = gallery.session.scene().info();
    if (!ImGui::BeginTable("controls", 2, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("input", ImGuiTableColumnFlags_WidthFixed, 5.5f * ImGui::GetFontSize());
    ImGui::TableSetupColumn("action");
    for (const Control& control : info.controls)
    {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", input_text(control).c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", control.action.c_str());
    }
    ImGui::EndTable();
}

void parameter_list(Gallery& gallery)
{
    heading("Parameters");
    if (ImGui::BeginTable("parameters", 2, ImGuiTableFlags_SizingStretchProp))
    {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.45f);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.55f);
        for (const ParameterInfo& info : gallery.session.scene().info().parameters)
        {
            if (has_own_place(info.name)) continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::AlignTextToFramePadding();
            ImGui::TextWrapped("%s", label_of(info).c_str());
            tip_of_last(tip_of(info));
            ImGui::TableNextColumn();
            parameter_widget(gallery, info);
        }
        ImGui::EndTable();
    }
    if (button(gallery, "Defaults", "all parameters as they were at first; the scene starts again"))
        gallery.session.open(SceneSource(gallery.session.source()));
}

} // namespace carom::gallery
