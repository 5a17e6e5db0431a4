// Opens in this order: SDL's video, the window, OpenGL, Dear ImGui; closes in the opposite one.
#include "gallery/window.hpp"

#include "gallery/failure.hpp"
#include "gallery/leak_check.hpp"

#include <SDL.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <epoxy/gl.h>
#include <imgui.h>
#if __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h> // its name from Dear ImGui 1.89 on
#else
#include <backends/imgui_impl_sdl.h>
#endif
#include <backends/imgui_impl_opengl3.h>

namespace carom::gallery
{

namespace
{

constexpr int needed_version = 33;

constexpr const char* driver_remedy = "Install a driver for your graphics card, or libgl1-mesa-dri, which draws without one.";

void set_attributes(bool needs_version)
{
    SDL_GL_ResetAttributes();
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_ALPHA_SIZE, 0); // a desktop would blend the window with what is behind it
    if (!needs_version) return;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, needed_version / 10);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, needed_version % 10);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
}

/// What OpenGL there is, for the message that it is not enough.
std::string found_opengl(SDL_Window* window)
{
    set_attributes(false);
    SDL_GLContext context = SDL_GL_CreateContext(window);
    if (!context) return "none was found";
    const auto word = [](GLenum name)
    {
        const auto* const text = reinterpret_cast<const char*>(glGetString(name));
        return std::string(text ? text : "?");
    };
    const std::string found = "found " + word(GL_VERSION) + " on " + word(GL_RENDERER);
    SDL_GL_DeleteContext(context);
    return found;
}

/// Whether SDL draws where nobody sees it.
bool is_offscreen()
{
    const char* const driver = SDL_GetCurrentVideoDriver();
    return driver && (std::strcmp(driver, "offscreen") == 0 || std::strcmp(driver, "dummy") == 0);
}

/// As much of the size as the screen has room for; without a screen all of it.
SDL_Point fitted(int width, int height)
{
    SDL_Rect screen{};
    const bool is_known = !is_offscreen() && SDL_GetDisplayUsableBounds(0, &screen) == 0 && screen.w > 0 && screen.h > 0;
    if (!is_known) return {std::max(width, 1), std::max(height, 1)};
    return {std::clamp(width, 1, screen.w), std::clamp(height, 1, screen.h)};
}

/// @throws Failure
SDL_Window* open_window(const WindowOptions& options)
{
    set_attributes(true);
    const Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    const SDL_Point size = fitted(options.width, options.height);
    SDL_Window* const window =
        SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.x, size.y, flags);
    if (!window) throw Failure(std::string("can't open a window with OpenGL: ") + SDL_GetError() + ". " + driver_remedy);
    return window;
}

/// @throws Failure
SDL_GLContext open_gl(SDL_Window* window)
{
    SDL_GLContext context = SDL_GL_CreateContext(window);
    const std::string reason = context ? "" : SDL_GetError();
    keep_libraries_loaded();
    if (!context) throw Failure("OpenGL 3.3 is needed; " + found_opengl(window) + " (" + reason + "). " + driver_remedy);
    if (epoxy_gl_version() < needed_version)
    {
        const std::string found = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        SDL_GL_DeleteContext(context);
        throw Failure("OpenGL 3.3 is needed; found " + found + ". " + driver_remedy);
    }
    return context;
}

float pixels_in_a_point(SDL_Window* window)
{
    int points = 0;
    int pixels = 0;
    SDL_GetWindowSize(window, &points, nullptr);
    SDL_GL_GetDrawableSize(window, &pixels, nullptr);
    if (points < 1 || pixels < 1) return 1; // as a window that is put away may say
    return std::clamp(static_cast<float>(pixels) / static_cast<float>(points), 1.0f, 4.0f);
}

/// Screens tell their size in millimetres, and some of them lie: a value beyond what is built counts as none.
float letter_scale(SDL_Window* window)
{
    float dots_per_inch = 0;
    const int display = SDL_GetWindowDisplayIndex(window);
    if (is_offscreen() || display < 0 || SDL_GetDisplayDPI(display, &dots_per_inch, nullptr, nullptr) != 0) return 1;
    if (!(dots_per_inch >= 60 && dots_per_inch <= 400)) return 1;
    const float scale = dots_per_inch / 96 / pixels_in_a_point(window);
    return std::clamp(0.25f * std::floor(4 * scale), 1.0f, 3.0f);
}

} // namespace

Window::Video::Video()
{
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0"); // other windows go on as they are
    SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");           // the click that raises the window counts
    const bool is_open = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
    std::string reason = is_open ? "" : SDL_GetError();
    const char* const asked = SDL_GetHint(SDL_HINT_VIDEODRIVER); // which holds the variable too
    if (is_open && is_offscreen() && !asked)
    {
        SDL_QuitSubSystem(SDL_INIT_VIDEO); // SDL's last resort, but a program that nobody sees is not what was meant
        reason = "neither X11 nor Wayland answers";
    }
    if (!reason.empty())
        throw Failure("no display: " + reason +
                      ". Set DISPLAY to an X server's name, or SDL_VIDEODRIVER=offscreen to draw without a display.");
    SDL_EnableScreenSaver();
}

Window::Video::~Video() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

void Window::Release::operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }

void Window::Release::operator()(void* gl_context) const { SDL_GL_DeleteContext(gl_context); }

void Window::Release::operator()(ImGuiContext* context) const
{
    ImGui::SetCurrentContext(context);
    ImGuiIO& io = ImGui::GetIO();
    if (io.BackendRendererUserData) ImGui_ImplOpenGL3_Shutdown();
    if (io.BackendPlatformUserData) ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext(context);
}

Window::Window(const WindowOptions& options) : window_(open_window(options)), gl_(open_gl(window_.get())), imgui_(ImGui::CreateContext())
{
    SDL_GL_SetSwapInterval(options.vsync ? 1 : 0); // a driver without it presents at once
    ui_scale_ = letter_scale(window_.get());

    ImGui::SetCurrentContext(imgui_.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // panels are where the program puts them; no file is left behind
    io.LogFilename = nullptr;
    if (!ImGui_ImplSDL2_InitForOpenGL(window_.get(), gl_.get()) || !ImGui_ImplOpenGL3_Init("#version 330 core"))
        throw Failure(std::string("Dear ImGui can't start on this OpenGL. ") + driver_remedy);
    load_letters();
}

Window::~Window() = default;

void Window::load_letters()
{
    letters_for_ = pixels_per_point();
    fonts_ = load_fonts(ui_scale_, letters_for_);
    ImGui_ImplOpenGL3_DestroyDeviceObjects(); // the next frame makes them anew, with these letters
}

scenes::Viewport Window::size() const
{
    scenes::Viewport size;
    SDL_GetWindowSize(window_.get(), &size.width, &size.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

scenes::Viewport Window::pixels() const
{
    scenes::Viewport size;
    SDL_GL_GetDrawableSize(window_.get(), &size.width, &size.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

float Window::pixels_per_point() const { return pixels_in_a_point(window_.get()); }

float Window::ui_scale() const { return ui_scale_; }

ImFont* Window::title_font() const { return fonts_.title; }

void Window::handle(const SDL_Event& event) { ImGui_ImplSDL2_ProcessEvent(&event); }

void Window::begin_frame()
{
    if (pixels_per_point() != letters_for_) load_letters(); // the window went to another screen
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
}

void Window::end_panels()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::present() { SDL_GL_SwapWindow(window_.get()); }

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(window_.get(), title.c_str()); }

void Window::set_full_screen(bool full_screen)
{
    SDL_SetWindowFullscreen(window_.get(), full_screen ? static_cast<Uint32>(SDL_WINDOW_FULLSCREEN_DESKTOP) : 0u);
}

bool Window::is_full_screen() const { return (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0; }

Picture Window::read_back() const
{
    const scenes::Viewport size = pixels();
    Picture picture{.width = size.width, .height = size.height};
    const std::size_t row = 4 * static_cast<std::size_t>(size.width);
    const auto rows = static_cast<std::size_t>(size.height);
    picture.rgba.resize(row * rows);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);

    // OpenGL begins at the bottom.
    for (std::size_t y = 0; y < rows / 2; ++y)
    {
        const auto top = picture.rgba.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto bottom = picture.rgba.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    }
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    return picture;
}

} // namespace carom::gallery
