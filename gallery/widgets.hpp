// Small widgets that several panels share.
#pragma once

#include "gallery/gallery.hpp"
#include "gallery/history.hpp"

#include <exception>
#include <imgui.h>
#include <string>

namespace carom::gallery
{

/// A checkbox that is noted in the map of widgets.
bool checkbox(Gallery& gallery, const char* label, bool& value, const char* tip = nullptr);
bool button(Gallery& gallery, const char* label, const char* tip = nullptr);
/// A slider whose number is always readable: the value is marked on the lower edge, where no letters are. Ctrl and a click let it be typed.
bool slider(const char* label, ImGuiDataType type, void* value, const void* min, const void* max, const char* format,
            ImGuiSliderFlags flags);
bool slider(const char* label, float& value, float min, float max, const char* format, ImGuiSliderFlags flags = 0);
bool slider(const char* label, int& value, int min, int max, const char* format);
/// For words that say what is wrong.
ImVec4 warning_color(ThemeKind theme);
/// Goes on in the line of the widget before when the next one fits there.
/// @param width that it takes [points]
void flow(float width);
/// For a button of this label, and for a text.
void flow(const char* label);
/// Words that appear while the pointer rests on the widget before.
void tip_of_last(const std::string& words);
/// Whether a number acts now: at once when it is dragged, but only when it is complete when it is typed ("1" and "10" are no wishes of who types 100).
/// @param is_changed what the widget said, which must come right before
bool is_meant(bool is_changed);
/// A line of a history.
void plot(const char* id, const History& history, float height);
/// A cell of a table: to the left, to the right, a number to the right.
void cell(const std::string& text);
void right_cell(const std::string& text);
void number_cell(const char* format, double value);
/// "1.86 MB".
std::string bytes_text(double bytes);
void heading(const char* text);
void muted(const std::string& text);
/// Calls an edit of the world; what it refuses is said.
template <class Edit>
void try_edit(Gallery& gallery, const Edit& edit)
{
    try
    {
        edit();
    }
    catch (const std::exception& error)
    {
        gallery.session.say(error.what());
    }
}

} // namespace carom::gallery
