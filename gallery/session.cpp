// Makes scenes, steps them, and keeps what is needed to show them.
#include "gallery/session.hpp"

#include "scenes/registry.hpp"

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

Session::Session(std::string_view scene, const scenes::ParameterValues& values, std::uint64_t seed)
{
    take(scenes::make_scene(scene, values, seed));
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
}

void Session::make(const std::string& name, const scenes::ParameterValues& values, std::uint64_t seed)
{
    try
    {
        take(scenes::make_scene(name, values, seed));
    }
    catch (const std::exception& error)
    {
        say(error.what());
    }
}

void Session::open(const std::string& name) { make(name, {}, 1); }

void Session::open_neighbor(int steps)
{
    const auto& all = scenes::all_scenes();
    const auto is_this = [this](const scenes::SceneInfo& info) { return info.name == scene_->info().name; };
    const auto place = std::find_if(all.begin(), all.end(), is_this) - all.begin();
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    open(all[static_cast<std::size_t>(((place + steps) % count + count) % count)].name);
}

void Session::restart() { restart_with(seed()); }

void Session::restart_with(std::uint64_t seed) { make(scene_->info().name, scene_->parameters().values(), seed); }

void Session::set_parameter(const std::string& name, const scenes::ParameterValue& value)
{
    const scenes::ParameterValue old = scene_->parameters().value(name);
    try
    {
        scene_->set_parameter(name, value);
        if (scenes::find_parameter(scene_->parameters().infos(), name).applies == scenes::Applies::Live) return;
        take(scenes::restarted(*scene_));
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
