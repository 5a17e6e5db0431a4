// Makes scenes, steps them, and keeps what is needed to show them.
#include "gallery/session.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <numeric>
#include <utility>

namespace carom::gallery
{

namespace
{

using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point start) { return std::chrono::duration<double>(SteadyClock::now() - start).count(); }

/// Looking back is worth a few steps, but films of a large world take much memory.
constexpr std::size_t most_films = 4;
constexpr std::size_t most_film_bytes = 500'000'000; // of all together, but that the last one stays

/// Starts a film of the world as it is when its own step begins, after the scene's code has run.
class FilmStarter : public scenes::StepObserver
{
public:
    FilmStarter(const World& world, StepFilm& film) : world_(world), film_(film) {}
    void world_step_begins() override { film_ = StepFilm(world_); }

private:
    const World& world_;
    StepFilm& film_;
};

} // namespace

Session::Session(const SceneSource& source, const scenes::ParameterValues& values, std::uint64_t seed) : source_(source), seed_(seed)
{
    take(source.make(values, seed));
    remember(source);
}

void Session::take(std::unique_ptr<scenes::Scene> scene)
{
    scene_ = std::move(scene);
    ++generation_;
    meter_.clear();
    films_.clear();
    has_before_ = false;
    watched_ = {};
    say({});
    apply_switches();
}

bool Session::make(const SceneSource& source, const scenes::ParameterValues& values, std::uint64_t seed)
{
    try
    {
        const bool is_other = source.info().name != source_.info().name;
        std::unique_ptr<scenes::Scene> scene = source.make(values, seed);
        if (is_other) switches_ = {};
        source_ = source;
        seed_ = seed;
        take(std::move(scene));
        return true;
    }
    catch (const std::exception& error)
    {
        say(error.what());
        return false;
    }
}

void Session::open(const SceneSource& source)
{
    const SceneSource chosen = source; // it may be one of opened_
    if (make(chosen, {}, 1)) remember(chosen);
}

void Session::open(const std::string& name)
{
    try
    {
        open(find_source(name));
    }
    catch (const std::exception& error)
    {
        say(error.what());
    }
}

void Session::open_file(const std::filesystem::path& file)
{
    try
    {
        open(SceneSource::of_file(file));
    }
    catch (const std::exception& error)
    {
        say(error.what());
    }
}

/// Keeps a file for the list of scenes, and looks after it.
void Session::remember(const SceneSource& source)
{
    watch_.reset();
    if (source.file().empty()) return;
    watch_.emplace(source.file());
    const auto is_it = [&](const SceneSource& opened) { return opened.file() == source.file(); };
    if (const auto old = std::find_if(opened_.begin(), opened_.end(), is_it); old != opened_.end())
        *old = source;
    else
        opened_.push_back(source);
}

void Session::reload_when_changed()
{
    constexpr std::chrono::milliseconds between_looks{100};
    if (!watch_ || SteadyClock::now() < next_look_) return;
    next_look_ = SteadyClock::now() + between_looks;
    if (watch_->has_changed()) reload();
}

/// A file that is broken now leaves the scene as it is.
void Session::reload()
{
    scenes::ParameterValues changed;
    for (const scenes::ParameterInfo& info : scene_->parameters().infos())
        if (const scenes::ParameterValue& value = scene_->parameters().value(info.name); value != info.initial)
            changed.emplace_back(info.name, value);
    try
    {
        const SceneSource source = SceneSource::of_file(watch_->file());
        if (!make(source, changed, seed_)) return;
        remember(source);
        mention("Read " + source.file().string() + " again");
    }
    catch (const std::exception& error)
    {
        say(error.what());
    }
}

void Session::open_neighbor(int steps)
{
    const std::vector<SceneSource>& all = catalogue();
    const auto is_this = [this](const SceneSource& source) { return source.info().name == source_.info().name; };
    // A file lies behind the end of the list.
    const auto place = std::find_if(all.begin(), all.end(), is_this) - all.begin();
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const std::ptrdiff_t start = place == count && steps > 0 ? -1 : place;
    open(all[static_cast<std::size_t>(((start + steps) % count + count) % count)]);
}

void Session::restart() { restart_with(seed()); }

void Session::restart_with(std::uint64_t seed) { make(source_, scene_->parameters().values(), seed); }

bool Session::is_on(EngineSwitch which) const
{
    const World& world = scene_->world();
    switch (which)
    {
    case EngineSwitch::Sleep: return world.sleep_tuning().is_enabled;
    case EngineSwitch::Continuous: return world.is_continuous();
    case EngineSwitch::WarmStarting: break;
    }
    return world.solver_tuning().warm_starting;
}

void Session::set_switch(EngineSwitch which, bool is_on)
{
    const char* const name = which == EngineSwitch::Sleep ? "sleep" : which == EngineSwitch::Continuous ? "continuous" : "warm_starting";
    const auto infos = scene_->parameters().infos();
    const bool is_parameter = std::any_of(infos.begin(), infos.end(), [&](const scenes::ParameterInfo& info) { return info.name == name; });
    if (is_parameter) return set_parameter(name, is_on); // the scene's own switch shows the same
    switches_[static_cast<std::size_t>(which)] = is_on;
    try
    {
        apply_switches();
    }
    catch (const std::exception& error)
    {
        say(error.what()); // a step that failed has stopped the world
    }
}

void Session::apply_switches()
{
    World& world = scene_->world();
    const auto wanted = [&](EngineSwitch which) { return switches_[static_cast<std::size_t>(which)].value_or(is_on(which)); };
    if (const bool sleeps = wanted(EngineSwitch::Sleep); sleeps != is_on(EngineSwitch::Sleep))
    {
        SleepTuning tuning = world.sleep_tuning();
        tuning.is_enabled = sleeps;
        world.set_sleep_tuning(tuning);
    }
    if (const bool continuous = wanted(EngineSwitch::Continuous); continuous != world.is_continuous()) world.set_continuous(continuous);
    if (const bool warm = wanted(EngineSwitch::WarmStarting); warm != is_on(EngineSwitch::WarmStarting))
    {
        SolverTuning tuning = world.solver_tuning();
        tuning.warm_starting = warm;
        world.set_solver_tuning(tuning);
    }
}

void Session::set_parameter(const std::string& name, const scenes::ParameterValue& value)
{
    const scenes::ParameterValue old = scene_->parameters().value(name);
    try
    {
        scene_->set_parameter(name, value);
        if (scenes::find_parameter(scene_->parameters().infos(), name).applies == scenes::Applies::Live) return;
        take(source_.make(scene_->parameters().values(), seed_));
    }
    catch (const std::exception& error)
    {
        say(error.what());
        if (scene_->parameters().value(name) != old) scene_->set_parameter(name, old);
    }
}

bool Session::step(StepFilm* film)
{
    const BroadPhaseType broad_phase = scene_->world().broad_phase();
    try
    {
        if (film)
        {
            FilmStarter starter(scene_->world(), *film);
            meter_.add(scene_->step(&starter, film), broad_phase);
        }
        else
            meter_.add(scene_->step(), broad_phase);
        return true;
    }
    catch (const std::exception& error)
    {
        clock_.set_paused(true);
        say(std::string("The scene stopped: ") + error.what() + ". Press R to restart it.");
        return false;
    }
}

/// The picture moves from here to where the next step ends.
void Session::keep_before()
{
    picture_.clear();
    scene_->draw(picture_);
    before_.note(picture_);
    has_before_ = true;
    const std::optional<BodyView> body = std::as_const(*scene_).world().find_body(watched_);
    watched_before_ = body ? std::optional(body->position()) : std::nullopt;
}

void Session::advance(double elapsed)
{
    constexpr double longest = 0.05; // what a frame may spend on steps [s]: the window must stay usable
    const SteadyClock::time_point start = SteadyClock::now();
    reload_when_changed();
    const double time_before = scene_->time();
    step_seconds_ = 0;
    const int due = is_inside() ? 0 : clock_.advance(elapsed, static_cast<double>(scene_->time_step()));
    for (int i = 0; i < due; ++i)
    {
        if (i > 0 && seconds_since(start) > longest)
        {
            clock_.drop();
            has_before_ = false;
            break;
        }
        if (i + 1 == due) keep_before();
        const SteadyClock::time_point step_start = SteadyClock::now();
        const bool has_stepped = step(nullptr);
        step_seconds_ += seconds_since(step_start);
        if (!has_stepped) break;
    }
    measure(elapsed, scene_->time() - time_before);
}

void Session::measure(double elapsed, double simulated)
{
    constexpr double share = 0.05; // of the latest frame in the mean
    if (elapsed > 0) factor_ += share * (simulated / elapsed - factor_);
}

scenes::DrawList& Session::picture(const DrawOptions& options, float height)
{
    constexpr float jump = 0.2f; // of the picture's height: whatever goes so far in a step is not seen as moving
    picture_.clear();
    if (is_inside())
    {
        draw_moment(film(), moment_, height, picture_);
        return picture_;
    }
    scene_->draw(picture_);
    if (has_before_ && options.is_blended) blend(before_, clock_.blend(), jump * height, picture_);
    if (!options.shapes) picture_.layer(scenes::Layer::Bodies).shapes.clear();
    draw_overlay(scene_->world(), options, height, picture_);
    return picture_;
}

std::optional<Vec2> Session::watched_place() const
{
    const std::optional<BodyView> body = std::as_const(*scene_).world().find_body(watched_);
    if (!body) return std::nullopt;
    if (!has_before_ || !watched_before_ || clock_.blend() >= 1) return body->position();
    return lerp(*watched_before_, body->position(), clock_.blend());
}

const std::string& Session::message() const
{
    static const std::string nothing;
    return message_until_ && SteadyClock::now() >= *message_until_ ? nothing : message_;
}

void Session::say(std::string message)
{
    message_ = std::move(message);
    message_until_.reset();
}

void Session::mention(std::string message)
{
    message_ = std::move(message);
    message_until_ = SteadyClock::now() + std::chrono::seconds(4);
}

void Session::look_inside()
{
    clock_.set_paused(true);
    keep_before(); // when time goes on, motion is shown from here
    StepFilm film(scene_->world());
    if (!step(&film)) return;
    films_.push_back(std::move(film));
    const auto add = [](std::size_t sum, const StepFilm& each) { return sum + each.bytes(); };
    while (films_.size() > 1 &&
           (films_.size() > most_films || std::accumulate(films_.begin(), films_.end(), std::size_t{0}, add) > most_film_bytes))
        films_.pop_front();
    film_ = films_.size() - 1;
    moment_ = 0;
}

void Session::next_moment()
{
    if (moment_ + 1 < film().moments().size())
        ++moment_;
    else if (film_ + 1 < films_.size())
    {
        ++film_;
        moment_ = 0;
    }
    else
        look_inside();
}

void Session::previous_moment()
{
    if (moment_ > 0)
        --moment_;
    else if (film_ > 0)
    {
        --film_;
        moment_ = film().moments().size() - 1;
    }
}

void Session::show_moment(std::size_t index) { moment_ = std::min(index, film().moments().size() - 1); }

} // namespace carom::gallery
