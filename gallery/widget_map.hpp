// Where each widget lies in the window, by name, so that a program that drives the gallery can find it.
#pragma once

#include "gallery/view.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace carom::gallery
{

class WidgetMap
{
public:
    /// Nothing is noted until it is wanted.
    void want(std::filesystem::path file) { file_ = std::move(file); }
    bool is_wanted() const { return !file_.empty(); }

    void begin_frame() { places_.clear(); }
    /// The widget that Dear ImGui laid out last, or as much of it as is in sight; one that is scrolled away is not noted.
    void note(const std::string& name);
    void note(const std::string& name, const Rect& place);
    /// Writes a JSON object of names to [left, top, right, bottom] in points, when anything has moved: replaces a regular file as a
    /// whole, and writes one line more to standard output, a FIFO or a device.
    /// @throws Failure
    void end_frame();

private:
    std::filesystem::path file_;
    std::map<std::string, Rect> places_;
    std::string written_;
};

} // namespace carom::gallery
