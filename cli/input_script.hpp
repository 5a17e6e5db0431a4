// Pointer and key events that a file gives to a scene, step by step.
//
// The file is a JSON array. Each entry has the step before which it happens, counted from 0, and either a key or a pointer
// action at a place in the world [m]:
//
//     [
//         {"step": 10, "pointer": "down", "button": "left", "x": 1.0, "y": 2.0},
//         {"step": 12, "pointer": "up", "button": "left", "x": 1.0, "y": 2.0},
//         {"step": 20, "pointer": "move", "x": 3.0, "y": 2.5},
//         {"step": 25, "pointer": "wheel", "wheel": 2, "x": 3.0, "y": 2.5},
//         {"step": 40, "key": "b"}
//     ]
//
// Entries of one step happen in their order. Those past the end of a run are not reached; the command says how many.
#pragma once

#include "scenes/scene.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace carom::cli
{

class InputScript
{
public:
    InputScript() = default; ///< nothing happens
    /// @param scene its controls say which keys there are
    /// @throws BadUsage naming the line, or the entry and its field
    static InputScript read(const std::filesystem::path& path, const scenes::SceneInfo& scene);
    /// @param name of the source, for messages
    static InputScript parse(std::string_view text, const std::string& name, const scenes::SceneInfo& scene);

    /// Gives the scene what happens before a step.
    void apply(scenes::Scene& scene, int step) const;
    std::size_t size() const;               ///< number of events
    std::size_t count_from(int step) const; ///< number of events before this step or a later one

private:
    struct KeyPress
    {
        std::string name;
    };
    using Event = std::variant<scenes::PointerEvent, KeyPress>;

    std::map<int, std::vector<Event>> by_step_;
    friend class ScriptReader;
};

} // namespace carom::cli
