// The gallery's keys. Every other key is the scene's.
#pragma once

#include "gallery/gallery.hpp"

#include <SDL_keycode.h>
#include <span>
#include <string>

namespace carom::gallery
{

struct KeyAction
{
    SDL_Keycode key;
    bool needs_ctrl;
    const char* label; ///< as a person reads it on the key
    const char* what;
    void (*act)(Gallery&);
};

std::span<const KeyAction> key_actions();
/// The name by which scenes know a key: "a", "1", "up", "space"; empty for those that no scene can have.
std::string scene_key(SDL_Keycode key);

/// A key was pressed: does what it is for, in the gallery or in the scene.
/// @param is_repeat it has been held for a while
void press_key(Gallery& gallery, SDL_Keycode key, bool has_ctrl, bool is_repeat);

/// What the pointer does, for the help.
struct PointerHelp
{
    const char* input;
    const char* what;
};
std::span<const PointerHelp> pointer_help();

} // namespace carom::gallery
