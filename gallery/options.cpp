// Reads the command line.
#include "gallery/options.hpp"

#include "files/output_file.hpp"
#include "gallery/overlay_names.hpp"
#include "gallery/tab_names.hpp"
#include "scenes/text.hpp"

#include <CLI/CLI.hpp>
#include <carom/version.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ostream>

namespace carom::gallery
{

namespace
{

constexpr int largest_window = 16384; // [points]

const char* const notes = R"(
With --frames every frame is 1/60 s of the scene, however long it took, so that equal runs give equal pictures; at the end
the program prints what the parts of a frame took. Without a display, set SDL_VIDEODRIVER=offscreen.
A FILE may be -, standard output; what the program prints then goes to standard error.

Examples:
  carom-gallery
  carom-gallery --scene collisions --set circles=1000 --show contacts --show impulses
  carom-gallery my_level.json
  SDL_VIDEODRIVER=offscreen carom-gallery --scene arch --frames 240 --screenshot arch.png

Exit status: 0 done, 1 failed, 2 bad usage.)";

/// "1600x900"
void read_size(const std::string& text, Options& options)
{
    int width = 0;
    int height = 0;
    char end = 0;
    const bool is_read = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end) == 2;
    if (!is_read || width < 1 || height < 1 || width > largest_window || height > largest_window)
        throw BadUsage("--size: \"" + text + "\" does not fit; give WIDTHxHEIGHT, each from 1 to " + std::to_string(largest_window));
    options.width = width;
    options.height = height;
}

/// CLI11 by itself takes -1 for the largest unsigned number.
std::uint64_t read_seed(const std::string& text)
{
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size())
        throw BadUsage("--seed: \"" + text + "\" does not fit; give a whole number from 0 to " + std::to_string(UINT64_MAX));
    return seed;
}

/// @return whether the word is the second of two
bool is_second(const std::string& option, const std::string& word, const std::string& first, const std::string& second)
{
    if (word != first && word != second) throw BadUsage(option + ": \"" + word + "\" does not fit; give " + first + " or " + second);
    return word == second;
}

/// A picture is a PNG, whatever its name.
void check_screenshot(const std::filesystem::path& path)
{
    try
    {
        if (!path.empty()) files::require_ending("--screenshot", path, ".png");
    }
    catch (const files::BadTarget& error)
    {
        throw BadUsage(error.what());
    }
}

/// What is read by hand, since CLI11's own errors would say less.
struct Words
{
    std::string file;
    std::vector<std::string> settings;
    std::string size;
    std::string seed = "1";
    std::string theme = "dark";
    std::string palette = "scene";
    bool hides_panels = false;
};

void add_looks(CLI::App& app, Options& options, Words& words)
{
    app.add_option("--size", words.size, "Size of the window; 1600x900 unless the screen is smaller")->type_name("WxH");
    app.add_option("--theme", words.theme, "dark or light")->type_name("NAME")->capture_default_str();
    app.add_option("--palette", words.palette, "scene, or safe for colours that colour-blind people can tell apart")
        ->type_name("NAME")
        ->capture_default_str();
    app.add_option("--show", options.shown, "Draw more: " + overlay_names() + "; may be given again")
        ->type_name("NAME")
        ->take_all()
        ->allow_extra_args(false);
    app.add_flag("--no-panels", words.hides_panels, "Begin with the scene alone; Tab brings the panels");
    app.add_option("--tab", options.tab, "Begin with this tab of the panel on the right")
        ->type_name("NAME")
        ->check(CLI::IsMember(std::vector<std::string>(tab_names.begin(), tab_names.end())));
}

void add_all(CLI::App& app, Options& options, Words& words)
{
    app.set_version_flag("--version", std::string("carom-gallery ") + CAROM_VERSION);
    app.footer(notes);
    CLI::Option* const scene = app.add_option("--scene", options.scene, "The scene to open")->type_name("NAME")->capture_default_str();
    app.add_option("FILE", words.file, "A scene file to open instead; it is read again when it changes")->type_name("")->excludes(scene);
    app.add_option("--set", words.settings, "Set a parameter of the scene; may be given again")
        ->type_name("NAME=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    app.add_option("--seed", words.seed, "Equal seeds give equal scenes")->type_name("S")->capture_default_str();
    add_looks(app, options, words);
    app.add_option("--frames", options.frames, "End after so many frames")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000'000))
        ->option_text("N");
    app.add_option("--screenshot", options.screenshot, "Write the last frame; after 120 frames unless --frames is given")
        ->type_name("FILE.png");
    app.add_option("--inside", options.inside, "Look inside a step when the other frames have run, at its moment N from 0; needs --frames")
        ->type_name("N")
        ->check(CLI::Range(0, 10'000))
        ->option_text("N");
    app.add_flag("--json", options.is_json, "Print the times as one JSON object");
    app.add_option("--widgets", options.widgets, "Keep a map of where each widget lies, for programs that drive this one")
        ->type_name("FILE.json");
}

/// @throws BadUsage
SceneSource file_source(const std::string& file)
{
    try
    {
        return SceneSource::of_file(file);
    }
    catch (const std::exception& error)
    {
        const auto is_it = [&](const SceneSource& source) { return source.info().name == file; };
        const bool is_scene = std::any_of(catalogue().begin(), catalogue().end(), is_it);
        throw BadUsage(error.what() + (is_scene ? "; --scene " + file + " opens the scene of that name" : std::string()));
    }
}

/// @throws BadUsage, SceneError
void read_words(const Words& words, Options& options)
{
    options.seed = read_seed(words.seed);
    options.theme = is_second("--theme", words.theme, "dark", "light") ? ThemeKind::Light : ThemeKind::Dark;
    options.palette = is_second("--palette", words.palette, "scene", "safe") ? Palette::ColorBlindSafe : Palette::Scene;
    if (!words.size.empty()) read_size(words.size, options);
    if (!words.file.empty()) options.file = file_source(words.file);
    const scenes::SceneInfo& scene = options.file ? options.file->info() : find_source(options.scene).info();
    options.values = scenes::parsed_settings(scene.parameters, words.settings);
    options.has_panels = !words.hides_panels;
}

} // namespace

std::optional<Options> read_options(const std::vector<std::string>& arguments, std::ostream& out)
{
    Options options;
    options.scene = catalogue().front().info().name;
    Words words;
    CLI::App app("Carom's gallery: scenes to play with, and a look inside the engine.", "carom-gallery");
    add_all(app, options, words);
    try
    {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 wants them in reverse
    }
    catch (const CLI::Success& help_or_version)
    {
        app.exit(help_or_version, out, out);
        return std::nullopt;
    }
    catch (const CLI::ParseError& error)
    {
        throw BadUsage(std::string(error.what()) + "; --help tells more");
    }
    read_words(words, options);
    for (const std::string& name : options.shown) find_overlay(name); // refuses unknown ones before a window opens
    check_screenshot(options.screenshot);
    if (!options.screenshot.empty() && options.frames == 0) options.frames = 120;
    if (options.inside >= 0 && options.frames == 0) throw BadUsage("--inside needs --frames");
    return options;
}

} // namespace carom::gallery
