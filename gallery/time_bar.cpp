// The bar below the scene: pause, step, speed, rates, restart, and the way into a step.
#include "gallery/keys.hpp"
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <cstdio>
#include <string>

namespace carom::gallery
{

namespace
{

/// @param letters width of the slider before its label
void flow_to_slider(float letters, const char* label)
{
    flow(letters * ImGui::GetFontSize() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label).x);
}

void run_buttons(Gallery& gallery)
{
    const bool is_paused = gallery.session.clock().is_paused();
    if (button(gallery, is_paused ? "Go on##pause" : "Pause##pause", "P")) press_key(gallery, SDLK_p, false, false);
    flow("Step");
    if (button(gallery, "Step", "a single step (O)")) press_key(gallery, SDLK_o, false, false);
    flow("Look inside");
    if (button(gallery, "Look inside", "walk through the stages of the next step (I)")) press_key(gallery, SDLK_i, false, false);
    flow("Restart");
    if (button(gallery, "Restart", "with the same seed (R)")) gallery.session.restart();
    flow("New seed");
    if (button(gallery, "New seed", "restart with other random numbers")) gallery.session.restart_with(gallery.session.seed() + 1);
    char seed[32];
    std::snprintf(seed, sizeof seed, "seed %llu", static_cast<unsigned long long>(gallery.session.seed()));
    flow(seed);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", seed);
}

void speed_slider(Gallery& gallery)
{
    Clock& clock = gallery.session.clock();
    auto speed = static_cast<float>(clock.speed());
    ImGui::PushItemWidth(8 * ImGui::GetFontSize());
    if (slider("speed", speed, static_cast<float>(Clock::slowest), static_cast<float>(Clock::fastest), "%.2f x",
               ImGuiSliderFlags_Logarithmic))
        clock.set_speed(static_cast<double>(speed));
    gallery.widgets.note("speed");
    tip_of_last("simulated seconds in a second: slow motion below 1 (, and .)");
    ImGui::PopItemWidth();
}

void rates(Gallery& gallery)
{
    const scenes::Scene& scene = gallery.session.scene();
    const scenes::ParameterInfo& rate = scenes::find_parameter(scene.info().parameters, "step_rate");
    const scenes::ParameterInfo& parts = scenes::find_parameter(scene.info().parameters, "substeps");
    float hertz = scene.parameters().real(rate.name);
    int substeps = scene.parameters().integer(parts.name);
    ImGui::PushItemWidth(7 * ImGui::GetFontSize());
    if (slider("hertz", hertz, static_cast<float>(rate.min), static_cast<float>(rate.max), "%.0f /s", ImGuiSliderFlags_Logarithmic))
        gallery.session.set_parameter(rate.name, static_cast<double>(hertz));
    gallery.widgets.note("hertz");
    tip_of_last("steps in a second of simulated time");
    flow_to_slider(5, "substeps");
    ImGui::PushItemWidth(5 * ImGui::GetFontSize());
    if (slider("substeps", substeps, static_cast<int>(parts.min), static_cast<int>(parts.max), "%d"))
        gallery.session.set_parameter(parts.name, static_cast<std::int64_t>(substeps));
    gallery.widgets.note("substeps");
    tip_of_last("parts into which the solver divides a step: more make piles stiffer");
    ImGui::PopItemWidth();
    ImGui::PopItemWidth();
}

void engine_switch(Gallery& gallery, const char* label, EngineSwitch which, const char* tip)
{
    bool is_on = gallery.session.is_on(which);
    flow_to_slider(1.5f, label);
    if (checkbox(gallery, label, is_on, tip)) gallery.session.set_switch(which, is_on);
}

std::string time_words(const Session& session)
{
    char words[64];
    if (session.clock().is_paused())
        std::snprintf(words, sizeof words, "paused at %.2f s", session.scene().time());
    else
        std::snprintf(words, sizeof words, "%.1f s, %.2f x real time", session.scene().time(), session.real_time_factor());
    return words;
}

} // namespace

void time_bar(Gallery& gallery)
{
    run_buttons(gallery);
    flow_to_slider(8, "speed");
    speed_slider(gallery);
    flow_to_slider(7, "hertz");
    rates(gallery);
    flow_to_slider(1.5f, "smooth");
    checkbox(gallery, "smooth", gallery.draw.is_blended,
             "show motion between steps, so that it does not depend on the rates of steps and frames");
    engine_switch(gallery, "sleeping", EngineSwitch::Sleep, "bodies that have come to rest cost nothing until something wakes them");
    engine_switch(gallery, "continuous", EngineSwitch::Continuous, "fast bodies are stopped at what they would pass through");
    engine_switch(gallery, "warm starting", EngineSwitch::WarmStarting,
                  "a step begins with the impulses of the last one; without that, tall piles sink in");
    const std::string words = time_words(gallery.session);
    flow(words.c_str());
    ImGui::TextDisabled("%s", words.c_str());
}

} // namespace carom::gallery
